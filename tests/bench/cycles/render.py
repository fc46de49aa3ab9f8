"""Renders one of Tyndall's reference scenes with Blender's Cycles, to compare time at equal error.

    blender --background --factory-startup --python tests/bench/cycles/render.py -- SCENE --samples N --out FILE.exr [--threads T] [--seed S]

SCENE: s1_fog_spot, s3_potato_matched, s4_hetero, the scenes of assets/scenes of these names (single scattering for s1 and s4). Blender is
z-up: its (x, y, z) is Tyndall's (x, -z, y). Prints "cycles SECONDS" for the render alone.
"""
import argparse
import math
import sys
import time

import bpy
from mathutils import Vector

BLOBS = [((0, 0, 0), .14, 1), ((-.22, .05, .12), .09, .8), ((.2, -.1, -.15), .10, .9), ((.12, .15, .22), .07, 1)]


def look(thing, target):
    direction = Vector(target) - thing.location
    thing.rotation_mode = "QUATERNION"
    thing.rotation_quaternion = direction.to_track_quat("-Z", "Y")


def camera(eye, target, vertical_fov_deg, size, clip):
    data = bpy.data.cameras.new("camera")
    data.sensor_fit = "VERTICAL"
    data.angle_y = math.radians(vertical_fov_deg)
    data.clip_start, data.clip_end = clip
    thing = bpy.data.objects.new("camera", data)
    thing.location = eye
    look(thing, target)
    bpy.context.collection.objects.link(thing)
    scene = bpy.context.scene
    scene.camera = thing
    scene.render.resolution_x, scene.render.resolution_y = size


def diffuse(albedo):
    material = bpy.data.materials.new("diffuse")
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    bsdf = nodes.new("ShaderNodeBsdfDiffuse")
    bsdf.inputs["Color"].default_value = (*albedo, 1)
    links.new(bsdf.outputs[0], nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
    return material


def box(low, high, material):
    bpy.ops.mesh.primitive_cube_add(size=1, location=[(a + b) / 2 for a, b in zip(low, high)])
    thing = bpy.context.object
    thing.scale = [b - a for a, b in zip(low, high)]
    thing.data.materials.append(material)


def plane(corners, albedo):
    mesh = bpy.data.meshes.new("plane")
    mesh.from_pydata(corners, [], [[0, 1, 2, 3]])
    mesh.materials.append(diffuse(albedo))
    bpy.context.collection.objects.link(bpy.data.objects.new("plane", mesh))


def medium(sigma_s, sigma_a, g, density=None):
    """Per channel: Cycles' scatter node has colour x density for sigma_s, its absorption node (1 - colour) x density."""
    material = bpy.data.materials.new("medium")
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    out = nodes.new("ShaderNodeOutputMaterial")
    add = nodes.new("ShaderNodeAddShader")
    most_s, most_a = max(sigma_s), max(max(sigma_a), 1e-9)
    scatter = nodes.new("ShaderNodeVolumeScatter")
    scatter.inputs["Color"].default_value = (*[s / most_s for s in sigma_s], 1)
    scatter.inputs["Anisotropy"].default_value = g
    absorb = nodes.new("ShaderNodeVolumeAbsorption")
    absorb.inputs["Color"].default_value = (*[1 - a / most_a for a in sigma_a], 1)
    for node, most in ((scatter, most_s), (absorb, most_a)):
        node.inputs["Density"].default_value = most
        if density is not None:
            scale = nodes.new("ShaderNodeMath")
            scale.operation = "MULTIPLY"
            scale.inputs[1].default_value = most
            links.new(density(nodes, links), scale.inputs[0])
            links.new(scale.outputs[0], node.inputs["Density"])
    links.new(scatter.outputs[0], add.inputs[0])
    links.new(absorb.outputs[0], add.inputs[1])
    links.new(add.outputs[0], out.inputs["Volume"])
    material.cycles.homogeneous_volume = density is None
    material.cycles.volume_sampling = "MULTIPLE_IMPORTANCE"
    return material


def blob_density(nodes, links):
    position = nodes.new("ShaderNodeNewGeometry").outputs["Position"]
    total = None
    for centre, radius, weight in BLOBS:
        distance = nodes.new("ShaderNodeVectorMath")
        distance.operation = "DISTANCE"
        distance.inputs[1].default_value = centre
        links.new(position, distance.inputs[0])
        square = nodes.new("ShaderNodeMath")
        square.operation = "MULTIPLY"
        links.new(distance.outputs["Value"], square.inputs[0])
        links.new(distance.outputs["Value"], square.inputs[1])
        power = nodes.new("ShaderNodeMath")
        power.operation = "MULTIPLY"
        power.inputs[1].default_value = -1 / (2 * radius * radius)
        links.new(square.outputs[0], power.inputs[0])
        blob = nodes.new("ShaderNodeMath")
        blob.operation = "POWER"
        blob.inputs[0].default_value = math.e
        links.new(power.outputs[0], blob.inputs[1])
        scaled = nodes.new("ShaderNodeMath")
        scaled.operation = "MULTIPLY_ADD"
        scaled.inputs[1].default_value = weight
        links.new(blob.outputs[0], scaled.inputs[0])
        if total is None:
            scaled.inputs[2].default_value = 0
        else:
            links.new(total, scaled.inputs[2])
        total = scaled.outputs[0]
    return total


def sun(travel, irradiance):
    data = bpy.data.lights.new("sun", "SUN")
    data.energy = irradiance
    data.angle = 0
    thing = bpy.data.objects.new("sun", data)
    look(thing, travel)
    bpy.context.collection.objects.link(thing)


def s1_fog_spot(scene):
    camera((0, -8, 2.6), (0, 1, 2.6), 40, (320, 180), (.05, 100))
    plane([(-8, -10, 0), (8, -10, 0), (8, 6, 0), (-8, 6, 0)], (.5, .5, .5))
    plane([(-8, 6, 0), (8, 6, 0), (8, 6, 8), (-8, 6, 8)], (.3, .3, .3))
    brown = diffuse((.6, .5, .4))
    for low, high in [((-1.7, .3, 4.2), (-.5, 1.5, 4.4)), ((.9, .6, 0), (1.3, 1, 4.4)), ((-.4, 2, 0), (0, 2.4, 3.6)),
                      ((.2, .2, 4.9), (.8, .5, 5)), ((-2.6, -.9, 0), (-1.6, .1, 1))]:
        box(low, high, brown)
    box((-7.9, -9.9, -.1), (7.9, 6.1, 8), medium((.1,) * 3, (.01,) * 3, 0))
    data = bpy.data.lights.new("spot", "SPOT")
    data.energy = 100 * 4 * math.pi
    data.spot_size = math.radians(70)
    data.spot_blend = .2
    data.shadow_soft_size = 0
    # Cycles' spots are discs: their intensity falls with the cosine to the axis, ours does not
    data.use_nodes = True
    nodes, links = data.node_tree.nodes, data.node_tree.links
    split = nodes.new("ShaderNodeSeparateXYZ")
    links.new(nodes.new("ShaderNodeNewGeometry").outputs["Incoming"], split.inputs[0])
    size = nodes.new("ShaderNodeMath")
    size.operation = "ABSOLUTE"
    links.new(split.outputs["Z"], size.inputs[0])
    inverse = nodes.new("ShaderNodeMath")
    inverse.operation = "DIVIDE"
    inverse.inputs[0].default_value = 1
    links.new(size.outputs[0], inverse.inputs[1])
    links.new(inverse.outputs[0], nodes["Emission"].inputs["Strength"])
    thing = bpy.data.objects.new("spot", data)
    thing.location = (0, 1, 6.5)
    bpy.context.collection.objects.link(thing)
    scene.cycles.max_bounces = scene.cycles.volume_bounces = 0


def s3_potato_matched(scene):
    camera((0, -60, 0), (0, 0, 0), 24, (192, 192), (1, 200))
    bpy.ops.mesh.primitive_uv_sphere_add(segments=512, ring_count=256, radius=10)
    bpy.context.object.data.materials.append(medium((.68, .70, .55), (.0024, .0090, .12), 0))
    sun((-1, .2, -.4), math.pi)
    scene.cycles.max_bounces = scene.cycles.volume_bounces = 1024


def s4_hetero(scene):
    camera((0, -3.2, .55), (0, 0, -.05), 28, (256, 256), (.01, 100))
    plane([(-3, -3, -.52), (3, -3, -.52), (3, 3, -.52), (-3, 3, -.52)], (.3, .35, .4))
    box((-.5,) * 3, (.5,) * 3, medium((20,) * 3, (1,) * 3, .6, blob_density))
    sun((-.6, .35, -1), math.pi)
    scene.cycles.max_bounces = scene.cycles.volume_bounces = 0


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("scene", choices=["s1_fog_spot", "s3_potato_matched", "s4_hetero"])
    parser.add_argument("--samples", type=int, default=16)
    parser.add_argument("--out", required=True)
    parser.add_argument("--threads", type=int, default=0)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--step-rate", type=float, default=1)
    options = parser.parse_args(sys.argv[sys.argv.index("--") + 1:])
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.samples, cycles.seed = options.samples, options.seed
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    cycles.caustics_reflective = cycles.caustics_refractive = True
    cycles.blur_glossy = 0
    cycles.transparent_max_bounces = 64
    cycles.light_sampling_threshold = 0
    cycles.pixel_filter_type = "BOX"
    cycles.volume_step_rate = options.step_rate
    cycles.volume_max_steps = 4096
    if options.threads:
        scene.render.threads_mode, scene.render.threads = "FIXED", options.threads
    scene.world = bpy.data.worlds.new("black")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (0, 0, 0, 1)
    scene.view_settings.view_transform = "Raw"
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.filepath = options.out
    scene.render.resolution_percentage = 100
    globals()[options.scene](scene)
    start = time.perf_counter()
    bpy.ops.render.render(write_still=True)
    print(f"cycles {time.perf_counter() - start:.3f}")


main()
