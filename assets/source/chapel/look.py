"""Quick Cycles pictures of bookmarks, to look at. Usage: blender -b -P look.py -- CHAPEL_DIRECTORY VIEW[+VIEW...] OUT_DIRECTORY [SAMPLES] [dust] [WIDTHxHEIGHT]"""
import math
import pathlib
import sys

import bpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import stage  # noqa: E402
import views  # noqa: E402

folder, view, out, *rest = stage.arguments()
scene = stage.load(folder)
stage.light(scene)
size = next((r for r in rest if "x" in r), "640x360").split("x")
scene.render.resolution_x, scene.render.resolution_y = int(size[0]), int(size[1])
scene.cycles.samples = next((int(r) for r in rest if r.isdigit()), 24)
scene.cycles.use_denoising = False
scene.cycles.use_adaptive_sampling = False
scene.cycles.max_bounces, scene.cycles.diffuse_bounces = 5, 4
scene.cycles.sample_clamp_indirect = 3
scene.cycles.caustics_reflective = False
if "fast" in rest:  # ambient light times occlusion instead of bounces, as the engine does it
    scene.cycles.use_fast_gi, scene.cycles.fast_gi_method, scene.cycles.ao_bounces_render = True, "REPLACE", 1
    scene.world.light_settings.distance = 4
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs[0].default_value = (.20, .185, .18, 1)
if "dust" in rest:
    bpy.ops.mesh.primitive_cube_add(size=1, location=(0, 0, 5.4), scale=(7.98, 19.98, 10.8))
    m = bpy.data.materials.new("dust")
    m.use_nodes = True
    m.node_tree.nodes.clear()
    volume, output = m.node_tree.nodes.new("ShaderNodeVolumeScatter"), m.node_tree.nodes.new("ShaderNodeOutputMaterial")
    volume.inputs["Density"].default_value, volume.inputs["Anisotropy"].default_value = 0.02, 0.55
    m.node_tree.links.new(volume.outputs[0], output.inputs["Volume"])
    bpy.context.object.data.materials.append(m)
    scene.cycles.volume_bounces = 0
# Exposure: display 1.0 is 1.2 * 2^EV100 cd/m2; Filmic stands in for the ACES view.
scene.view_settings.view_transform = "Filmic"
scene.view_settings.look = "Medium High Contrast"
for name in view.split("+"):
    if name in views.CAMERAS:
        eye, target, fov, ev = views.CAMERAS[name]
    else:  # seven numbers: eye, target, EV
        numbers = [float(x) for x in name.split(",")]
        eye, target, fov, ev = numbers[:3], numbers[3:6], 60, numbers[6]
    stage.camera(scene, eye, target, fov)
    scene.view_settings.exposure = math.log2(stage.UNIT / (1.2 * 2 ** ev))
    scene.render.filepath = str(pathlib.Path(out).resolve() / f"{name}.png")
    bpy.ops.render.render(write_still=True)
