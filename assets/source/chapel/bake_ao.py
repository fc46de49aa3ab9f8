"""Bakes ambient occlusion into the light-map atlas. Usage: blender -b -P bake_ao.py -- CHAPEL_DIRECTORY [SIZE] [SAMPLES]

Each mesh is baked once, in the placement nearest to the middle of the nave, among all the others. Rays reach 2.5 m; glass and flames are left out.
"""
import pathlib
import sys

import bpy
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import materials  # noqa: E402
import stage  # noqa: E402

folder, *rest = stage.arguments()
size, samples = (int(rest[0]) if rest else 2048), (int(rest[1]) if len(rest) > 1 else 64)
REACH = 2.5

scene = stage.load(folder)
scene.cycles.samples, scene.cycles.use_denoising = samples, False
scene.world.light_settings.distance = REACH
image = bpy.data.images.new("ambient_occlusion", size, size, alpha=False, float_buffer=True)
spare = bpy.data.images.new("spare", 8, 8)
for m in bpy.data.materials:
    m.use_nodes = True
    m.node_tree.nodes.clear()  # occlusion needs no textures
    node = m.node_tree.nodes.new("ShaderNodeTexImage")
    node.image = image if materials.MATERIALS[m.name].get("ao") else spare
    m.node_tree.nodes.active = node

placements = {}
for thing in scene.objects:
    if thing.type == "MESH":
        thing.hide_render = thing.name.startswith(("glass_", "flame_"))
        placements.setdefault(thing.data.name, []).append(thing)
bpy.ops.object.select_all(action="DESELECT")
for things in placements.values():
    thing = min(things, key=lambda t: t.matrix_world.translation.length)
    if thing.hide_render or not any(materials.MATERIALS[m.name].get("ao") for m in thing.data.materials):
        continue
    thing.data = thing.data.copy()
    layers = thing.data.uv_layers
    while len(layers) > 1:  # only the light map's
        layers.remove(layers[0])
    if layers:
        layers[0].name = "light map"
    thing.select_set(True)
    bpy.context.view_layer.objects.active = thing
bpy.ops.object.join()  # one object is one pass through Cycles instead of fifty
bpy.ops.object.bake(type="AO", margin=4, use_clear=True, target="IMAGE_TEXTURES")

pixels = np.empty(size * size * 4, np.float32)
image.pixels.foreach_get(pixels)
np.save(pathlib.Path(folder) / "ambient_occlusion.npy", pixels.reshape(size, size, 4)[::-1, :, 0])
