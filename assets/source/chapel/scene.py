"""Writes chapel.json, the scene file. Usage: scene.py OUTPUT_DIRECTORY"""
import json
import pathlib
import re
import sys

import numpy as np

import gobo
import plan
import things
import views


def numbers(values, digits=5):
    return [round(float(v), digits) + 0.0 for v in values]


def entities():
    found = [dict(name="Chapel", gltf=dict(file="chapel.glb", cast_shadow_exclude=["glass_*", "flame_*"]), collider={})]
    found.append(dict(name="Sun", transform=dict(translation=numbers(gobo.origin()), rotation=numbers(gobo.light_quaternion(), 7)),
                      directional_light=dict(illuminance_lux=plan.SUN_LUX, colour=list(plan.SUN_COLOUR), angular_diameter_deg=0.53,
                                             gobo="textures/sun_gobo.png", gobo_size_m=numbers(gobo.extent()),
                                             shadow=dict(size=2048, cascades=1, distance_m=26))))
    found.append(dict(name="Sky", sky=dict(probe="probe_outside.exr", intensity=1.0)))
    found.append(dict(name="Indoor light", transform=dict(translation=[0, 3, 0]),
                      light_probe=dict(file="probe_nave.exr", intensity=1.0, extent_m=[6, 13, 12])))
    found.append(dict(name="Dust", transform=dict(translation=[0, 5.4, 0], scale=[7.98, 10.8, 19.98]),
                      medium=dict(bounds=dict(box={}), scattering_per_m=[0.016, 0.016, 0.016], absorption_per_m=[0.002, 0.002, 0.002],
                                  phase=dict(henyey_greenstein=dict(g=0.55)))))
    warm = [1.0, 0.66, 0.32]
    for i, (x, y, z) in enumerate(things.CHANDELIERS):
        found.append(dict(name=f"Chandelier {i + 1}", transform=dict(translation=numbers([x, y + .3, z])),
                          point_light=dict(intensity_cd=14, colour=warm, range_m=5.0)))
    top = things.ALTAR_TOP + .75
    for side, x in (("north", -.8), ("south", .8)):
        found.append(dict(name=f"Altar candles {side}", transform=dict(translation=numbers([x, top + .1, things.ALTAR_Z - .1])),
                          point_light=dict(intensity_cd=4, colour=warm, range_m=4.0)))
    for side, x in (("north", -1.65), ("south", 1.65)):
        found.append(dict(name=f"Standing candle {side}", transform=dict(translation=numbers([x, things.ALTAR_FLOOR + 1.83, things.ALTAR_Z + .75])),
                          point_light=dict(intensity_cd=2.5, colour=warm, range_m=4.0)))
    found.append(dict(name="Altar flame", transform=dict(translation=numbers(np.array(things.PILLAR) + [0, .128, 0])),
                      point_light=dict(intensity_cd=1.2, colour=warm, range_m=1.2, shadow=dict(size=256))))
    found += translucent()
    for name, (eye, target, fov, ev) in views.CAMERAS.items():
        found.append(dict(name=name, transform=dict(translation=list(eye), look_at=list(target)), camera=dict(vertical_fov_deg=fov, ev100=ev, near_m=0.1)))
    eye, target = views.FLY[0]
    found.append(dict(name="Fly-through", transform=dict(translation=list(eye), look_at=list(target)), camera=dict(vertical_fov_deg=58, ev100=8.0, near_m=0.1),
                      camera_path=dict(duration_s=40, points=[dict(position=list(p), look_at=list(q)) for p, q in views.FLY])))
    return found


def translucent():
    """What light passes through: it shines as `tyndall trace` says, and plainly where no module does better."""
    plain = dict(marble=[0.8, 0.77, 0.73], wax=[0.83, 0.76, 0.62], jade=[0.27, 0.46, 0.36])

    def thing(name, mesh, place, interior, **more):
        return dict(name=name, transform=dict(translation=numbers(place)) | more, mesh=dict(file=f"assets:subjects/{mesh}.ply"),
                    material=dict(base_colour=plain[interior["preset"]], roughness=interior["roughness"]), interior=interior)

    found = []
    for side, x in (("north", -1.65), ("south", 1.65)):
        foot = [x, things.ALTAR_FLOOR + things.STANDING_CANDLE, things.ALTAR_Z + .75]
        found.append(thing(f"Wax {side}", "tall_candle", foot, dict(preset="wax", roughness=0.4)))
    found.append(thing("Wax pillar", "candle", things.PILLAR, dict(preset="wax", roughness=0.4)))
    x, y, z = things.STATUE
    turn = numbers([0, np.sin(things.STATUE_TURN / 2), 0, np.cos(things.STATUE_TURN / 2)], 7)
    found.append(dict(name="Pedestal", transform=dict(translation=numbers([x, plan.CHANCEL_FLOOR, z]), rotation=turn), mesh=dict(file="assets:subjects/pedestal.ply"),
                      material=dict(base_colour_texture="textures/dressed_color.jpg", normal_texture="textures/dressed_normal.jpg",
                                    metallic_roughness_texture="textures/dressed_orm.jpg", occlusion_texture="textures/dressed_orm.jpg",
                                    roughness=1.0, metallic=1.0, uv_scale=[0.5, 0.5])))
    found.append(thing("Marble figure", "figure", [x, plan.CHANCEL_FLOOR + y, z], dict(preset="marble", roughness=0.45), rotation=turn))
    found.append(thing("Jade bowl", "bowl", things.BOWL, dict(preset="jade", roughness=0.25)))
    return found


def pretty(value, depth=0, width=150):
    """JSON with two spaces, short things on one line."""
    flat = json.dumps(value)
    if len(flat) + depth * 2 <= width and not (isinstance(value, dict) and depth <= 1 and len(flat) > 90):
        return re.sub(r"\}", " }", re.sub(r"\{(?!\})", "{ ", flat)).replace("{ }", "{}")
    pad, end = "  " * (depth + 1), "  " * depth
    if isinstance(value, dict):
        body = ",\n".join(f"{pad}{json.dumps(k)}: {pretty(v, depth + 1)}" for k, v in value.items())
        return "{\n" + body + "\n" + end + "}"
    body = ",\n".join(pad + pretty(v, depth + 1) for v in value)
    return "[\n" + body + "\n" + end + "]"


def write(target, found):
    scene = dict(tyndall=1, modules=["participating_media", "translucency"], render=dict(path="deferred", view="ACES 1.0 SDR", camera="Nave", participating_media=dict(resolution="half", steps=16, temporal=True), translucency=dict(points=dict(levels=12))), entities=found)
    text = pretty(scene) + "\n"
    assert json.loads(text) == scene
    target.write_text(text)
    print(target, len(found), "entities")


if __name__ == "__main__":
    write(pathlib.Path(sys.argv[1]) / "chapel.json", entities())
