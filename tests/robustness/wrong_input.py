#!/usr/bin/env python3
"""Wrong input gives one clear message and exit code 1. usage: wrong_input.py PROGRAM"""
import json
import os

from harness import ROOT, Tests

SCENES = ROOT / "assets" / "scenes"
GOOD = str(SCENES / "shadows.json")
CONFIG = (ROOT / "config" / "color" / "tyndall.ocio").read_bytes()


def scene(*entities, **top):
    camera = {"name": "Camera", "camera": {}}
    return json.dumps({"tyndall": 1, **top, "entities": [camera, *entities]}, indent=2)


def mesh(file):
    return {"name": "Thing", "mesh": {"file": file}}


def textured(file):
    return {"name": "Thing", "mesh": {"primitive": "box"}, "material": {"base_colour_texture": file}}


def command_line(t):
    small = ("--size", "32x18", "--out", t.folder / "out")
    t.refused("missing scene", ["capture", "no/such.json"], "no/such.json")
    t.refused("a folder", ["capture", SCENES], "scenes")
    t.refused("missing scene, validate", ["validate", "no/such.json"], "no/such.json")
    for size in ("640", "0x10", "10x", "x", "-3x4", "1e3x5", "99999x99999", "640x360x2"):
        t.refused(f"size {size}", ["capture", GOOD, f"--size={size}"], f"'{size}'", "WIDTHxHEIGHT")
    t.refused("camera", ["capture", GOOD, *small, "--camera", "Camra"], "'Camra'", "did you mean 'Camera'", "shadows.json")
    t.refused("view", ["capture", GOOD, *small, "--view", "gbufer_normal"], "'gbufer_normal'", "did you mean 'gbuffer_normal'")
    t.refused("path", ["capture", GOOD, *small, "--path", "defered"], "'defered'", "did you mean 'deferred'")
    t.refused("set without value", ["capture", GOOD, "--set", "/render/path"], "/render/path", "expected")
    t.refused("set without pointer", ["capture", GOOD, "--set", "render=1"], "render=1", "expected")
    t.refused("set nowhere", ["capture", GOOD, *small, "--set", "/entities/Snu/directional_light/illuminance_lux=3"], "Snu", "did you mean 'Sun'")
    t.refused("set beyond the list", ["capture", GOOD, *small, "--set", "/entities/99/camera/ev100=3"], "99")
    t.refused("set to an unknown field", ["capture", GOOD, *small, "--set", "/entities/Sun/directional_light/lux=3"], "'lux'", "shadows.json")
    t.refused("set out of range", ["capture", GOOD, *small, "--set", "/entities/Spot/spot_light/outer_angle_deg=95"], "95", "outer_angle_deg", "89.9")
    t.refused("set to half a value", ["capture", GOOD, *small, "--set", "/entities/Sun/transform/translation=[1, 2"], "translation")
    t.refused("out is a file", ["capture", GOOD, "--size", "32x18", "--out", t.file("taken", "")], "taken")
    t.refused("missing OCIO", ["capture", GOOD, *small, "--ocio", "no/such.ocio"], "no/such.ocio")
    t.refused("missing $OCIO", ["capture", GOOD, *small], "no/such.ocio", OCIO="no/such.ocio")


def scene_files(t):
    def wrong(name, text, *expected):
        file = t.file(name.replace(" ", "_") + ".json", text)
        t.refused(name + ", validate", ["validate", file], file.name, *expected)
        t.refused(name + ", capture", ["capture", file, "--size", "32x18", "--out", t.folder / "out"], file.name, *expected)

    whole = open(GOOD).read()
    wrong("empty file", "")
    wrong("truncated", whole[: len(whole) // 2], ":")
    wrong("not JSON", "hello", ":1:")
    wrong("binary", bytes(range(256)))
    wrong("a list", "[]", "expected")
    wrong("no version", '{ "entities": [] }', "tyndall")
    wrong("later version", '{ "tyndall": 99, "entities": [] }', "/tyndall")
    wrong("deep nesting", '{ "tyndall": 1, "entities": ' + "[" * 5000 + "]" * 5000 + " }")
    wrong("unknown component", scene({"name": "A", "spotlight": {}}), "/entities/1/spotlight", "did you mean 'spot_light'")
    wrong("unknown field", scene({"spot_light": {"intensity": 3}}), "/entities/1/spot_light/intensity", "intensity_cd")
    wrong("unknown enum", scene({"mesh": {"primitive": "spere"}}), "/entities/1/mesh/primitive", "did you mean 'sphere'")
    wrong("wrong kind", scene({"spot_light": {"intensity_cd": "much"}}), "/entities/1/spot_light/intensity_cd", "number")
    wrong("out of range", scene({"material": {"roughness": 2}}), "/entities/1/material/roughness", "0 to 1")
    wrong("unknown preset", scene({"material": {"preset": "gould"}}), "gould", "did you mean 'gold'")
    wrong("unknown parent", scene({"parent": "Camra"}), "Camra", "did you mean 'Camera'")
    evening = "assets:scenes/textures/evening.hdr"
    for count, expected in ((-1, "0 to 128"), (1000, "0 to 128"), (2.5, "whole number"), ("many", "whole number")):
        wrong(f"{count} lights", scene({"sky": {"probe": evening, "lights": {"count": count}}}), "/entities/1/sky/lights/count", expected)
    wrong("lights of a box", scene({"light_probe": {"file": evening, "extent_m": [1, 1, 1], "lights": {"count": 4}}}), "/entities/1/light_probe/lights", "extent_m")
    wrong("unknown setting", scene(render={"imege": {}}), "/render/imege", "did you mean 'image'")


def drawing(t):
    """What only shows when the scene is drawn."""
    def wrong(name, text, *expected):
        file = t.file(name.replace(" ", "_") + ".json", text)
        t.refused(name, ["capture", file, "--size", "32x18", "--out", t.folder / "out"], *expected)

    wrong("no camera", '{ "tyndall": 1, "entities": [{ "name": "A" }] }', "camera", "no_camera.json")
    wrong("unknown module", scene(modules=["participating_medium"]), "participating_medium", "did you mean 'participating_media'")
    wrong("module outside", scene(modules=["../../x"]), "../../x")
    wrong("unknown path", scene(render={"path": "forward"}), "forward", "deferred")
    wrong("unknown OCIO view", scene(render={"view": "sRBG"}), "sRBG", "did you mean 'sRGB'")
    wrong("unknown OCIO display", scene(render={"display": "sRBG"}), "sRBG", "did you mean 'sRGB'")
    wrong("unknown scene camera", scene(render={"camera": "Camra"}), "Camra", "did you mean 'Camera'")
    wrong("missing mesh", scene(mesh("no.obj")), "no.obj")
    outside = t.file("outside.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    (t.folder / "inside").mkdir(exist_ok=True)
    os.symlink(outside, t.folder / "inside" / "link.obj")
    for label, name in (("dots", "../outside.obj"), ("absolute", str(outside)), ("system", "../../../../../../etc/passwd"), ("link", "link.obj")):
        file = t.file(f"inside/{label}.json", scene(mesh(name)))
        t.refused(f"traversal by {label}", ["capture", file, "--size", "32x18", "--out", t.folder / "out"], name)
        file = t.file(f"inside/{label}_texture.json", scene(textured(name)))
        t.refused(f"traversal by {label}, texture", ["capture", file, "--size", "32x18", "--out", t.folder / "out"], name)
    broken = {
        "half.png": (SCENES / "textures" / "tiles.png").read_bytes()[:300],
        "no.png": b"\x89PNG\r\n\x1a\nnonsense",
        "empty.png": b"",
        "half.hdr": (SCENES / "textures" / "evening.hdr").read_bytes()[:200],
        "no.exr": b"\x76\x2f\x31\x01nonsense",
        "no.obj": b"v 0 0 0\nf 1 2 99\n",
        "half.gltf": (SCENES / "sample.gltf").read_bytes()[:1500],
        "no.glb": b"glTF\x02\0\0\0\xff\xff\xff\x7fnonsense",
        "text.gltf": b"hello",
    }
    for name, content in broken.items():
        t.file(name, content)
        kind = name.split(".")[1]
        entity = mesh(name) if kind == "obj" else {"gltf": {"file": name}} if kind in ("gltf", "glb") else textured(name)
        wrong(f"broken {name}", scene(entity), name)
        if kind in ("exr", "hdr"):
            wrong(f"broken probe {name}", scene({"light_probe": {"file": name}}), name)


def media(t):
    """Media that cannot be: what is wrong and where, and no picture without them."""
    def wrong(name, medium, *expected, **entity):
        text = scene({"name": "Murk", "medium": medium, **entity}, modules=["participating_media"])
        file = t.file(name.replace(" ", "_") + ".json", text)
        t.refused(name, ["capture", file, "--size", "32x18", "--out", t.folder / "out"], *expected)

    wrong("negative scattering", {"scattering_per_m": [-1, 0, 0]}, "/entities/1/medium/scattering_per_m", "0 to")
    wrong("g of 1", {"phase": {"henyey_greenstein": {"g": 1}}}, "/entities/1/medium/phase/henyey_greenstein/g", "0.99")
    wrong("no mean free path", {"optics": {"albedo": {"mean_free_path_m": [0, 1, 1]}}}, "mean_free_path_m")
    wrong("unknown bounds", {"bounds": {"elipsoid": {}}}, "did you mean 'ellipsoid'")
    wrong("flat medium", {}, "Murk", "scaled by 0", transform={"scale": [1, 0, 1]})
    t.file("sheet.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nf 1 2 3\nf 2 4 3\n")
    wrong("open mesh", {"bounds": {"mesh": {"file": "sheet.obj"}}}, "Murk", "sheet.obj", "not closed", "4 open edges")
    wrong("mesh without a file", {"bounds": {"mesh": {}}}, "Murk", "a file or a primitive")
    wrong("no particles", {"bounds": {"particles": {}}}, "Murk", "particles")
    t.file("drops.txt", "0 0 0\n0 x 0\n")
    t.file("none.txt", "# nothing\n")
    wrong("broken particles", {"bounds": {"particles": {"file": "drops.txt"}}}, "drops.txt:2", "'x'")
    wrong("particle file without any", {"bounds": {"particles": {"file": "none.txt"}}}, "none.txt", "no particles")
    wrong("weightless particles", {"bounds": {"particles": {"particles": [{"weight": 0}]}}}, "Murk", "no particles")
    wrong("gradient inside out", {"density": {"radial_gradient": {"inner_radius": 0.5, "outer_radius": 0.2}}}, "Murk", "outer_radius")
    wrong("temperature of nothing", {"black_body": {"grid": "temperature"}}, "Murk", "temperature")
    for name, values in (("nan", b"\0\0\xc0\x7f"), ("infinite", b"\0\0\x80\x7f")):
        t.file(f"{name}.raw", values * 8)
        t.file(f"{name}.json", json.dumps({"raw": f"{name}.raw", "type": "f32", "size": [2, 2, 2]}))
        wrong(f"{name} density", {"density": {"volume": {"file": f"{name}.json"}}}, f"{name}.json", "not finite")
    t.file("giant.json", json.dumps({"raw": "nan.raw", "type": "u8", "size": [60000, 60000, 60000]}))
    wrong("giant volume", {"density": {"volume": {"file": "giant.json"}}}, "giant.json", "60000 x 60000 x 60000")
    wrong("sequence without files", {"density": {"volume": {"file": "s_##.json"}}}, "s_01.json")
    wrong("sequence backwards", {"density": {"volume": {"file": "s_##.json", "sequence": {"first": 3, "last": 2}}}}, "last", "first")


def colour_configurations(t):
    for i, config in enumerate((CONFIG[:200], CONFIG[: len(CONFIG) // 2], CONFIG.replace(b"scene_linear:", b"scene_linnear:"), b"", b"ocio_profile_version: 99\n",
                                CONFIG.replace(b"!<ColorSpace>", b"!<ColourSpice>"), bytes(range(256)))):
        file = t.file(f"wrong{i}.ocio", config)
        t.refused(file.name, ["capture", GOOD, "--size", "32x18", "--out", t.folder / "out", "--ocio", file], file.name)


def capture_files(t):
    def wrong(name, content, *expected):
        file = t.file(name.replace(" ", "_") + ".json", content)
        t.refused(name, ["capture", file, "--out", t.folder / "out"], file.name, *expected)

    good = {"tyndall_capture": 1, "scene": GOOD, "size": [32, 18], "variants": [{"name": "plain"}]}
    wrong("capture without scene", json.dumps({"tyndall_capture": 1}), "/scene")
    lost = t.file("lost.json", json.dumps({**good, "scene": "no.json"}))
    t.refused("capture of a missing scene", ["capture", lost, "--out", t.folder / "out"], "no.json")
    wrong("capture with an unknown key", json.dumps({**good, "expects": []}), "expects")
    wrong("capture with an unknown variant", json.dumps({**good, "expect": [{"of": "plan"}]}), "/expect/0", "did you mean 'plain'")
    wrong("capture cut short", json.dumps(good)[:40])
    failing = t.file("failing.json", json.dumps({**good, "expect": [{"of": "plain", "mean_between": [5, 6]}]}))
    done = t.run("capture", failing, "--out", t.folder / "out")
    t.check(done is not None and done.returncode == 1 and "FAILED" in done.stdout, "a failed expectation ends with 1")


def profiles(t):
    """Of skin, as text of its own."""
    t.refused("unknown preset of a profile", ["profile", "--preset", "skin_3"], "'skin_3'", "did you mean 'skin_1'")
    t.refused("missing profile", ["profile", "no/such.json"], "no/such.json")
    for name, content, *expected in (
            ("profile of an unknown kind", {"berley": {}}, "did you mean 'burley'"),
            ("profile without lobes", {"profile": {"gaussians": {}}}, "no lobe"),
            ("profile without layers", {"layers": {}}, "no layer"),
            ("profile of a negative variance", {"gaussians": {"lobes": [{"variance_mm2": -1}]}}, "/gaussians/lobes/0/variance_mm2"),
            ("profile without weight", {"gaussians": {"lobes": [{"weight": [1, 0, 1]}]}}, "sum to 0"),
            ("profile with a layer without end on top", {"layers": {"layers": [{}, {}]}}, "layer 0", "thickness_mm")):
        t.refused(name, ["profile", t.file(name.replace(" ", "_") + ".json", json.dumps(content))], *expected)


with Tests() as t:
    profiles(t)
    command_line(t)
    scene_files(t)
    drawing(t)
    media(t)
    colour_configurations(t)
    capture_files(t)
