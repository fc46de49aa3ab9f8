#!/usr/bin/env python3
"""Makes assets/subjects/: things for light to pass through, as closed meshes. Needs Debian's python3-numpy and blender; the results are committed.

usage: assets/source/subjects/make.py [NAME...]
"""
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
FOLDER = HERE.parents[1] / "subjects"
BLENDER = ["blender", "-b", "-noaudio", "--python-exit-code", "1", "-P"]
FIGURE_CELL_CM, FIGURE_TRIANGLES, BOWL_TRIANGLES = 0.09, 80000, 40000
sys.path.insert(0, str(HERE))
import figure  # noqa: E402
import ply  # noqa: E402
import surface  # noqa: E402
import vessels  # noqa: E402


def simplified(points, faces, count, **more):
    with tempfile.TemporaryDirectory() as folder:
        raw, small = pathlib.Path(folder) / "raw.npz", pathlib.Path(folder) / "small.npz"
        np.savez(raw, points=points, faces=faces, **more)
        subprocess.run([*BLENDER, str(HERE / "simplify.py"), "--", str(raw), str(small), str(count)], check=True, stdout=subprocess.DEVNULL)
        made = np.load(small)
        return made["points"], made["faces"]


def bowl():
    points, faces = vessels.bowl()
    points, faces = simplified(points * 100, faces, BOWL_TRIANGLES)
    return points / 100, faces


def statue():
    points, faces = surface.largest(*surface.contoured(figure.distance, figure.LOW, figure.HIGH, FIGURE_CELL_CM))
    points, faces = simplified(points, faces, FIGURE_TRIANGLES, fine=figure.detail(points))
    return points / 100, faces


MADE = dict(torus=vessels.torus, candle=vessels.candle, tall_candle=vessels.tall_candle, bowl=bowl, figure=statue, pedestal=vessels.pedestal)
OPEN = ["pedestal"]

FOLDER.mkdir(exist_ok=True)
names = sys.argv[1:] or list(MADE)
for name in names:
    points, faces, *more = MADE[name]()
    ply.write(FOLDER / f"{name}.ply", points, faces, *(more or [ply.face_normals(points, faces)]))
subprocess.run([*BLENDER, str(HERE / "checks.py"), "--", *(str(FOLDER / f"{n}.ply") for n in names if n not in OPEN)], check=True)
