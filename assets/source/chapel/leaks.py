"""Looks for holes: rays from inside may leave the building through glass only. Usage: blender -b -P leaks.py -- CHAPEL_DIRECTORY [RAYS]"""
import pathlib
import sys

import bpy
import numpy as np
from mathutils import Vector
from mathutils.bvhtree import BVHTree

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import plan  # noqa: E402
import stage  # noqa: E402

folder, *rest = stage.arguments()
rays = int(rest[0]) if rest else 60000
scene = stage.load(folder)
points, faces = [], []
for thing in scene.objects:
    if thing.type != "MESH" or thing.name.startswith("flame_"):
        continue
    base, matrix = len(points), thing.matrix_world
    points += [matrix @ v.co for v in thing.data.vertices]
    for f in thing.data.polygons:
        faces.append([base + i for i in f.vertices])
tree = BVHTree.FromPolygons(points, faces)
rng = np.random.default_rng(6)
to_sun = -plan.sun_direction()
escaped = []
for k in range(rays):
    p = rng.uniform([-3.2, .5, -9.6], [3.2, 9.0, 9.6])
    d = to_sun if k % 2 else plan.unit(rng.normal(size=3))
    start, direction = stage.TO_BLENDER.to_3x3() @ Vector(p), stage.TO_BLENDER.to_3x3() @ Vector(d)
    hit = tree.ray_cast(start, direction)
    if hit[0] is None:
        escaped.append((p.round(3).tolist(), np.round(d, 3).tolist()))
print(len(faces), "triangles,", rays, "rays,", len(escaped), "escaped", escaped[:5])
assert not escaped
