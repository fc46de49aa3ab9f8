"""Fewer triangles by edge collapse, in Blender: blender -b -P simplify.py -- FROM.npz TO.npz TRIANGLES"""
import pathlib
import sys

import bpy
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from checks import crossings  # noqa: E402


def untangled(points, faces):
    """Where faces cross, points go halfway to the mean of those around until none does."""
    a, b = faces.reshape(-1), faces[:, [1, 2, 0]].reshape(-1)
    for _ in range(50):
        pairs = crossings(points, faces)
        if not pairs:
            break
        mean = np.stack([np.bincount(a, points[b, i], len(points)) for i in range(3)], -1) / np.bincount(a, minlength=len(points))[:, None]
        moved = np.unique(faces[np.unique(pairs)])
        points[moved] = 0.5 * (points[moved] + mean[moved])
    return points


source, target, wanted = sys.argv[sys.argv.index("--") + 1:]
given = np.load(source)
mesh = bpy.data.meshes.new("mesh")
mesh.from_pydata(given["points"].tolist(), [], given["faces"].tolist())
thing = bpy.data.objects.new("thing", mesh)
bpy.context.scene.collection.objects.link(thing)
bpy.context.view_layer.objects.active = thing
group = thing.vertex_groups.new(name="fine")
if "fine" in given:
    for level in np.unique(given["fine"]):
        group.add(np.flatnonzero(given["fine"] == level).tolist(), float(level), "REPLACE")
collapse = thing.modifiers.new("collapse", "DECIMATE")
collapse.ratio = int(wanted) / len(mesh.polygons)
if "fine" in given:
    collapse.vertex_group, collapse.invert_vertex_group, collapse.vertex_group_factor = "fine", True, 1.0
collapse.use_collapse_triangulate = True
bpy.ops.object.modifier_apply(modifier="collapse")
points = np.empty(3 * len(mesh.vertices), np.float32)
mesh.vertices.foreach_get("co", points)
faces = np.empty(3 * len(mesh.polygons), np.int32)
mesh.polygons.foreach_get("vertices", faces)
points, faces = points.reshape(-1, 3), faces.reshape(-1, 3)
np.savez(target, points=untangled(points, faces), faces=faces)
