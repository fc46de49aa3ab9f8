"""Renders the indoor light probe by Cycles and writes it as raw linear data. Usage: blender -b -P probe.py -- CHAPEL_DIRECTORY [SAMPLES]"""
import pathlib
import sys

import bpy
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import stage  # noqa: E402

WIDTH, HEIGHT = 256, 128
PLACE = (0.0, 3.0, 0.0)

folder, *rest = stage.arguments()
scene = stage.load(folder)
stage.light(scene)
eye = stage.camera(scene, PLACE, (PLACE[0], PLACE[1], PLACE[2] - 1))  # the middle of the panorama looks to -Z
eye.data.type = "PANO"
eye.data.cycles.panorama_type = "EQUIRECTANGULAR"
scene.render.resolution_x, scene.render.resolution_y = WIDTH, HEIGHT
scene.cycles.samples = int(rest[0]) if rest else 384
scene.cycles.use_adaptive_sampling = False
scene.cycles.max_bounces, scene.cycles.diffuse_bounces = 8, 8
scene.cycles.sample_clamp_indirect = 12
scene.cycles.caustics_reflective = scene.cycles.caustics_refractive = False
view = scene.view_layers[0]
view.use_pass_normal = view.use_pass_diffuse_color = True
scene.render.image_settings.file_format = "OPEN_EXR"
scene.render.image_settings.color_depth = "32"
scene.render.filepath = str(pathlib.Path(folder).resolve() / "probe_raw.exr")
for thing in scene.objects:  # nothing may hang in front of the probe
    if thing.name.startswith(("chandelier", "flame_chandelier")):
        thing.hide_render = True
bpy.ops.render.render(write_still=True)
