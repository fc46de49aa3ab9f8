#!/usr/bin/env python3
"""Makes assets/skin/: the bust of a person, with the maps of its skin. Needs Debian's python3-numpy, python3-scipy, python3-pil, blender and mricron-data; the results are
committed.

usage: assets/source/skin/make.py [--mri ch2.nii.gz] [--cell CM] [--size TEXELS]
"""
import argparse
import pathlib
import subprocess
import sys
import tempfile
import time

import numpy as np
from PIL import Image

HERE = pathlib.Path(__file__).resolve().parent
FOLDER = HERE.parents[1] / "skin"
BLENDER = ["blender", "-b", "-noaudio", "--python-exit-code", "1", "-P"]
TRIANGLES = 42000
sys.path.insert(0, str(HERE))
import bust  # noqa: E402
import common  # noqa: E402,F401
import features  # noqa: E402
import maps  # noqa: E402
import ply  # noqa: E402
import shape as shapes  # noqa: E402
import surface  # noqa: E402
import texels  # noqa: E402
import unwrap  # noqa: E402

START = time.time()


def log(text):
    print(f"{time.time() - START:6.0f} s  {text}", flush=True)


def blender(script, *arguments):
    subprocess.run([*BLENDER, str(HERE.parent / "subjects" / script), "--", *map(str, arguments)], check=True)


def meshed(shape, cell, folder):
    """The closed mesh: points in centimetres and faces."""
    points, faces = surface.largest(*surface.contoured(shape, shapes.LOW, shapes.HIGH, cell, rounds=4))
    log(f"contoured: {len(faces)} triangles")
    np.savez(folder / "raw.npz", points=points, faces=faces, fine=shapes.detail(points))
    blender("simplify.py", folder / "raw.npz", folder / "small.npz", TRIANGLES)
    made = np.load(folder / "small.npz")
    points, faces = made["points"].astype(float), made["faces"].astype(int)
    ply.write(folder / "head.ply", points / 100, faces, ply.face_normals(points, faces))
    blender("checks.py", folder / "head.ply")
    return points, faces


def smooth_normals(shape, points, faces):
    """Those of the distance, but where the mesh is too coarse to follow it."""
    flat = ply.face_normals(points, faces)
    fine = maps.gradient(shape, points.astype(np.float32)).astype(float)
    return np.where(((flat * fine).sum(1) < 0.5)[:, None], flat, fine)


def saved(name, picture, **how):
    image = Image.fromarray((picture * 255 + 0.5).clip(0, 255).astype(np.uint8)).convert("RGB")
    image.save(FOLDER / name, **how)
    log(f"{name}: {(FOLDER / name).stat().st_size / 1e6:.2f} MB")


def encoded(linear):
    """As sRGB."""
    x = np.clip(linear, 0, 1)
    return np.where(x <= 0.0031308, x * 12.92, 1.055 * x ** (1 / 2.4) - 0.055)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--mri", default="/usr/share/mricron/templates/ch2.nii.gz", help="the MRI of Debian's mricron-data")
    options.add_argument("--cell", type=float, default=0.07, help="grid that the surface is contoured on, cm")
    options.add_argument("--size", type=int, default=2048, help="texels along the maps' edges")
    given = options.parse_args()
    FOLDER.mkdir(exist_ok=True)
    shape = shapes.Shape(given.mri)
    log("shape")
    with tempfile.TemporaryDirectory() as folder:
        points, faces = meshed(shape, given.cell, pathlib.Path(folder))
    normals = smooth_normals(shape, points, faces)
    uv, corners, source = unwrap.unwrapped(points, faces, bust.BOTTOM, shape.groove, log)
    twice = texels.overlaps(uv, corners)
    if twice:
        sys.exit(f"{twice} texels lie in two triangles")
    ply.write(FOLDER / "head.ply", points[source] / 100, corners, normals[source], uv)
    pictures = maps.made(shape, points, normals, uv, corners, source, given.size, log)
    saved("colour.jpg", encoded(pictures["colour"]), quality=93, subsampling=0)
    saved("roughness.jpg", pictures["roughness"], quality=88)
    saved("specular.jpg", pictures["specular"], quality=88)
    saved("normal.png", pictures["normal"], optimize=True)


if __name__ == "__main__":
    main()
