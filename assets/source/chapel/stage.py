"""Cycles' view of the chapel, shared by the bake, the probe and the check renders. One Cycles unit of radiance is 1000 cd/m2."""
import math
import pathlib
import sys

import bpy
import numpy
from mathutils import Matrix, Vector

if not hasattr(numpy, "bool"):  # Blender 3.4's glTF importer still uses the alias that newer NumPy dropped
    numpy.bool = bool

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import materials  # noqa: E402
import plan  # noqa: E402

UNIT = 1000.0
TO_BLENDER = Matrix(((1, 0, 0, 0), (0, 0, -1, 0), (0, 1, 0, 0), (0, 0, 0, 1)))  # +Y up to +Z up


def arguments():
    return sys.argv[sys.argv.index("--") + 1:]


def load(folder, threads=2):
    """An empty scene holding chapel.glb, with Cycles ready."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=str(pathlib.Path(folder) / "chapel.glb"))
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.device, scene.cycles.use_denoising = "CPU", False
    scene.render.threads_mode, scene.render.threads = "FIXED", threads
    scene.world = bpy.data.worlds.new("world")
    scene.view_settings.view_transform = "Standard"
    return scene


def light(scene):
    """The sun, glass that glows to the eye and tints shadow rays, candle flames."""
    sun = bpy.data.lights.new("sun", "SUN")
    sun.energy, sun.color, sun.angle = plan.SUN_LUX / UNIT, plan.SUN_COLOUR, math.radians(0.53)
    lamp = bpy.data.objects.new("sun", sun)
    travel = TO_BLENDER.to_3x3() @ Vector(plan.sun_direction())
    lamp.rotation_mode, lamp.rotation_quaternion = "QUATERNION", travel.to_track_quat("-Z", "Y")
    scene.collection.objects.link(lamp)
    for m in bpy.data.materials:
        if m.name.startswith("glass_"):
            _glass(m, materials.MATERIALS[m.name])
        elif m.name == "flame":
            m.node_tree.nodes["Principled BSDF"].inputs["Emission Strength"].default_value = materials.MATERIALS["flame"]["strength"] / UNIT
        elif m.name == "water":
            m.node_tree.nodes["Principled BSDF"].inputs["Transmission"].default_value = 0


def _glass(m, described):
    tree = m.node_tree
    image = next(n for n in tree.nodes if n.type == "TEX_IMAGE")
    out = next(n for n in tree.nodes if n.type == "OUTPUT_MATERIAL")
    emit, clear, path, mix = (tree.nodes.new(t) for t in ("ShaderNodeEmission", "ShaderNodeBsdfTransparent", "ShaderNodeLightPath", "ShaderNodeMixShader"))
    emit.inputs["Strength"].default_value = described["strength"] / UNIT
    tint = tree.nodes.new("ShaderNodeVectorMath")
    tint.operation, tint.inputs[1].default_value = "MULTIPLY", described["emissive"]
    tree.links.new(image.outputs["Color"], tint.inputs[0])
    tree.links.new(tint.outputs[0], emit.inputs["Color"])
    tree.links.new(image.outputs["Color"], clear.inputs["Color"])
    tree.links.new(path.outputs["Is Shadow Ray"], mix.inputs[0])
    tree.links.new(emit.outputs[0], mix.inputs[1])
    tree.links.new(clear.outputs[0], mix.inputs[2])
    tree.links.new(mix.outputs[0], out.inputs["Surface"])


def camera(scene, eye, target, fov=60.0):
    data = bpy.data.cameras.new("camera")
    data.sensor_fit, data.angle = "VERTICAL", math.radians(fov)
    data.clip_start = 0.05
    thing = bpy.data.objects.new("camera", data)
    eye, target = TO_BLENDER.to_3x3() @ Vector(eye), TO_BLENDER.to_3x3() @ Vector(target)
    thing.location = eye
    thing.rotation_mode, thing.rotation_quaternion = "QUATERNION", (target - eye).to_track_quat("-Z", "Y")
    scene.collection.objects.link(thing)
    scene.camera = thing
    return thing
