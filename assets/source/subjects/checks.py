"""What must hold of a closed mesh, found by Blender's search tree: blender -b -P checks.py -- FILE.ply..."""
import pathlib
import sys

import numpy as np
from mathutils.bvhtree import BVHTree

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import ply  # noqa: E402


def edges_wrong(faces):
    """Edges without exactly one face on each side."""
    a, b = faces.reshape(-1), faces[:, [1, 2, 0]].reshape(-1)
    size = faces.max() + 1
    there, count = np.unique(a.astype(np.int64) * size + b, return_counts=True)
    back = np.isin(b.astype(np.int64) * size + a, there)
    return int((count != 1).sum() + (~back).sum())


def points_wrong(faces):
    """Points whose faces make more than one fan."""
    follows = {}
    for face in faces.tolist():
        for i in range(3):
            follows.setdefault(face[i], {})[face[(i + 1) % 3]] = face[(i + 2) % 3]
    wrong = 0
    for fan in follows.values():
        start = place = next(iter(fan))
        for steps in range(1, len(fan) + 1):
            place = fan.get(place)
            if place == start or place is None:
                break
        wrong += steps != len(fan) or place != start
    return wrong


def crossings(points, faces):
    """Pairs of faces that cross and share no point."""
    tree = BVHTree.FromPolygons(points.tolist(), faces.tolist(), epsilon=0.0)
    return [(a, b) for a, b in tree.overlap(tree) if a < b and not set(faces[a]) & set(faces[b])]


def report(path):
    points, faces = ply.read(path)
    p = points[faces].astype(float)
    cross = np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])
    volume = (p[:, 0] * np.cross(p[:, 1], p[:, 2])).sum() / 6
    found = dict(edges=edges_wrong(faces), points=points_wrong(faces), crossings=len(crossings(points.astype(float) * 100, faces)), flat=int((np.linalg.norm(cross, axis=1) == 0).sum()))
    size = np.ptp(points, 0) * 1000
    print(f"{pathlib.Path(path).name}: {len(faces)} triangles, {size[0]:.1f} x {size[1]:.1f} x {size[2]:.1f} mm, {volume * 1e6:.1f} cm3, "
          f"{np.linalg.norm(cross, axis=1).sum() / 2 * 1e4:.0f} cm2, wrong {found}")
    return volume > 0 and not any(found.values())


if __name__ == "__main__":
    good = [report(f) for f in sys.argv[sys.argv.index("--") + 1:]]
    sys.exit(not all(good))
