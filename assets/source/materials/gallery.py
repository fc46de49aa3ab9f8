#!/usr/bin/env python3
"""Makes docs/materials.md: every preset of an interior, traced beside rendered.

Needs a build (build/release/bin/tyndall) and oiiotool. A picture that is there already is kept; remove it to make it anew.
"""
import argparse
import json
import pathlib
import re
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
PRESETS = ROOT / "config/presets/interior"
PICTURES = ROOT / "docs/images/materials"
SIDE = 64

HEAD = """# Materials

What an [`interior`](components.md#interior) can be by its preset: the 47 materials that Jensen et al. 2001 and Narasimhan et al. 2006 measured, and two estimates.
Each is shown as a torus 5 cm wide behind a rough boundary, lit from behind at the left by a disc 30 degrees wide and by a grey sky: left as `tyndall trace` finds it (its noise filtered by a median of 3x3 pixels), right as
[translucency](../modules/translucency/README.md) renders it in real time by what `auto` takes: `points`, or `htsm` where most light is scattered once, as in many drinks.

Scattering is reduced, so what it is without `g` is larger by 1 / (1 - g). Made by `assets/source/materials/gallery.py`.

| preset | traced, rendered | scattering, 1/mm | absorption, 1/mm | g | index | measured by |
|---|---|---|---|---|---|---|
"""


def scene(preset):
    lamp = {"translation": [-0.8, 0.5, -0.6], "look_at": [0, 0, 0]}
    return {
        "tyndall": 1,
        "modules": ["translucency"],
        "render": {"path": "deferred", "view": "sRGB"},
        "entities": [
            {"name": "Camera", "transform": {"translation": [0, 0.012, 0.15], "look_at": [0, 0, 0]},
             "camera": {"vertical_fov_deg": 22, "exposure": 1, "near_m": 0.01}},
            {"name": "Lamp", "transform": lamp,
             "directional_light": {"illuminance_lux": 4, "angular_diameter_deg": 30,
                                   "shadow": {"size": 1024, "cascades": 1, "distance_m": 1}}},
            {"name": "Sky", "sky": {"radiance_cd_m2": [0.12, 0.13, 0.14]}},
            {"name": "Solid",
             "transform": {"scale": 0.694, "rotation": [0.686103, 0.171065, -0.171065, 0.686103]},
             "mesh": {"file": "assets:subjects/torus.ply"},
             "interior": {"preset": preset, "roughness": 0.6}},
        ],
    }


def make_picture(preset, tyndall, spp):
    target = PICTURES / f"{preset}.jpg"
    if target.exists():
        return
    with tempfile.TemporaryDirectory() as folder:
        at = pathlib.Path(folder)
        (at / "scene.json").write_text(json.dumps(scene(preset)))
        run = lambda *words: subprocess.run([str(w) for w in words], check=True, stdout=subprocess.DEVNULL)
        size = f"{2 * SIDE}x{2 * SIDE}"
        run(tyndall, "trace", at / "scene.json", "--size", size, "--spp", spp, "--out", at / "traced.exr")
        run(tyndall, "capture", at / "scene.json", "--size", size, "--supersample", 3, "--exr", "--out", at)
        small = ["--ch", "R,G,B", "--resize:filter=box", f"{SIDE}x{SIDE}"]
        run("oiiotool", at / "traced.exr", *small, "--median", "3x3", at / "scene.exr", *small, "--mosaic:pad=2", "2x1",
            "--colorconvert", "linear", "sRGB", "--nosoftwareattrib", "--eraseattrib", ".*", "--compression", "jpeg:92", "-o", target)


def words(numbers):
    return ", ".join(f"{n:.4g}" for n in numbers)


def row(path):
    preset = json.loads(path.read_text())
    optics = preset["optics"]["coefficients_per_mm"]
    g = preset.get("phase", {}).get("henyey_greenstein", {}).get("g", 0)
    source = re.search(r"(Jensen|Narasimhan).*?(\d{4})", preset["doc"])
    return (f"| `{path.stem}` | ![{path.stem}](images/materials/{path.stem}.jpg) | {words(optics['scattering'])} "
            f"| {words(optics['absorption'])} | {g:.3g} | {preset['ior']:.3g} "
            f"| {source[1] + ' ' + source[2] if source else 'an estimate'} |\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--tyndall", default=ROOT / "build/release/bin/tyndall")
    parser.add_argument("--spp", type=int, default=160)
    options = parser.parse_args()
    PICTURES.mkdir(parents=True, exist_ok=True)
    presets = sorted(PRESETS.glob("*.json"))
    for path in presets:
        make_picture(path.stem, options.tyndall, options.spp)
    (ROOT / "docs/materials.md").write_text(HEAD + "".join(row(path) for path in presets))


if __name__ == "__main__":
    main()
