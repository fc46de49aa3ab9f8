"""The chapel at dusk: the same building under a low sun. Makes textures/sun_gobo_dusk.png and chapel_dusk.json.

Usage: dusk.py OUTPUT_DIRECTORY
"""
import json
import pathlib
import sys

import plan

plan.SUN_ELEVATION, plan.SUN_AZIMUTH = 13.0, 38.0
plan.SUN_LUX, plan.SUN_COLOUR = 3600.0, (1.0, 0.50, 0.20)

import gobo  # noqa: E402: after the sun is set
import imageio  # noqa: E402
import scene  # noqa: E402

gobo.WIDTH, gobo.HEIGHT = 1024, 512
EV = {"Nave": 5.3, "Altar": 4.0, "Aisle": 4.6, "Window": 6.0, "Basin": 4.6, "Statue": 5.0, "Altar still life": 4.0, "Vault": 4.6, "Fly-through": 5.0}
GLOW = [dict(nodes="glass_south*", factor=[0.10, 0.056, 0.03]), dict(nodes="glass_*", factor=[0.030, 0.036, 0.055])]
CANDLES = 3.0  # all candles are lit


def entities():
    found = scene.entities()
    named = {entity["name"]: entity for entity in found}
    named["Chapel"]["gltf"]["glow"] = GLOW
    named["Sun"]["directional_light"]["gobo"] = "textures/sun_gobo_dusk.png"
    named["Sky"]["sky"]["intensity"] = 0.06
    named["Indoor light"]["light_probe"]["intensity"] = 0.05
    named["Dust"]["medium"].update(scattering_per_m=[0.02, 0.02, 0.02], absorption_per_m=[0.002, 0.002, 0.002])
    for entity in found:
        if "point_light" in entity:
            entity["point_light"]["intensity_cd"] = round(CANDLES * entity["point_light"]["intensity_cd"], 2)
        if "camera" in entity:
            entity["camera"]["ev100"] = EV[entity["name"]]
    return found


if __name__ == "__main__":
    folder = pathlib.Path(sys.argv[1])
    picture, metres = gobo.project(folder / "textures")
    imageio.save(folder / "textures" / "sun_gobo_dusk.png", imageio.to_srgb(picture))
    print("sun_gobo_dusk.png covers", metres.tolist(), "m")
    scene.write(folder / "chapel_dusk.json", entities())
