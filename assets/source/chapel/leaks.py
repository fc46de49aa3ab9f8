"""Looks for holes: rays from inside may leave the building through glass only, and must meet the fronts of faces. Usage: blender -b -P leaks.py -- CHAPEL_DIRECTORY [RAYS]"""
import pathlib
import sys

import bpy
import numpy as np
from mathutils import Vector
from mathutils.bvhtree import BVHTree

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import materials  # noqa: E402
import plan  # noqa: E402
import stage  # noqa: E402

folder, *rest = stage.arguments()
rays = int(rest[0]) if rest else 60000
scene = stage.load(folder)
points, faces, one_sided, owners = [], [], [], []
for thing in scene.objects:
    if thing.type != "MESH" or thing.name.startswith("flame_"):
        continue
    base, matrix = len(points), thing.matrix_world
    points += [matrix @ v.co for v in thing.data.vertices]
    for f in thing.data.polygons:
        faces.append([base + i for i in f.vertices])
        owners.append(thing.name)
        one_sided.append(not materials.MATERIALS[thing.data.materials[f.material_index].name].get("double_sided"))
tree = BVHTree.FromPolygons(points, faces)
rng = np.random.default_rng(6)
to_sun = -plan.sun_direction()
escaped, behind = [], {}
for k in range(rays):
    p = rng.uniform([-.6, 1.2, -6.4], [.6, 9.0, 9.6])  # the open air above the aisle
    d = to_sun if k % 2 else plan.unit(rng.normal(size=3))
    start, direction = stage.TO_BLENDER.to_3x3() @ Vector(p), stage.TO_BLENDER.to_3x3() @ Vector(d)
    hit = tree.ray_cast(start, direction)
    if hit[0] is None:
        escaped.append((p.round(3).tolist(), np.round(d, 3).tolist()))
    elif one_sided[hit[2]] and hit[1].dot(direction) > 0.02:
        name = owners[hit[2]]
        behind.setdefault(name, []).append(tuple(round(c, 2) for c in stage.TO_BLENDER.to_3x3().transposed() @ hit[0]))
print(len(faces), "triangles,", rays, "rays,", len(escaped), "escaped", escaped[:5])
for name, places in sorted(behind.items(), key=lambda i: -len(i[1])):
    print("  seen from behind:", name, len(places), places[:3])
assert not escaped and sum(map(len, behind.values())) < rays * 2e-4
