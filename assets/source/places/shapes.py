"""Small meshes as arrays, and a writer of binary glTF. A mesh is (positions [n,3], triangles [m,3]); parts are lists of them."""
import json
import struct

import numpy as np


def merged(parts):
    """One mesh of many."""
    points, faces, base = [], [], 0
    for p, t in parts:
        points.append(np.asarray(p, float))
        faces.append(np.asarray(t, int) + base)
        base += len(p)
    return np.concatenate(points), np.concatenate(faces)


def box(low, high):
    """Six faces with corners of their own, so that they shade flat."""
    low, high = np.asarray(low, float), np.asarray(high, float)
    points, faces = [], []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for side in (0, 1):
            base = len(points)
            for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
                p = np.empty(3)
                p[axis] = (low, high)[side][axis]
                p[u], p[v] = (low, high)[a][u], (low, high)[b][v]
                points.append(p)
            order = (0, 1, 2, 3) if side else (0, 3, 2, 1)
            faces += [[base + order[0], base + order[1], base + order[2]], [base + order[0], base + order[2], base + order[3]]]
    return np.array(points), np.array(faces)


def tube(rings):
    """A skin over rings [k, n, 3], closed around, open at the ends; outward when rings run counter-clockwise seen from the last."""
    rings = np.asarray(rings, float)
    k, n, _ = rings.shape
    faces = []
    for i in range(k - 1):
        for j in range(n):
            a, b = i * n + j, i * n + (j + 1) % n
            faces += [[a, b, b + n], [a, b + n, a + n]]
    return rings.reshape(-1, 3), np.array(faces)


def lathe(profile, segments, centre=(0, 0, 0)):
    """Turns a profile of (radius, height) around the y axis."""
    angle = -np.arange(segments) * 2 * np.pi / segments
    rings = [np.stack([r * np.cos(angle), np.full(segments, h), r * np.sin(angle)], -1) + centre for r, h in profile]
    return tube(rings)


def grid(size, cells, height):
    """A ground over size x size metres around the origin; height(x, z) takes arrays."""
    line = (np.arange(cells + 1) / cells - 0.5) * size
    x, z = np.meshgrid(line, line)
    points = np.stack([x, height(x, z), z], -1).reshape(-1, 3)
    faces = []
    for i in range(cells):
        for j in range(cells):
            a = i * (cells + 1) + j
            faces += [[a, a + cells + 1, a + 1], [a + 1, a + cells + 1, a + cells + 2]]
    return points, np.array(faces)


def normals_of(points, faces):
    """Means of the faces around each point, weighed by their areas."""
    normals = np.zeros_like(points)
    across = np.cross(points[faces[:, 1]] - points[faces[:, 0]], points[faces[:, 2]] - points[faces[:, 0]])
    for corner in range(3):
        np.add.at(normals, faces[:, corner], across)
    return normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)


def value_noise(p, seed=0):
    """Smooth noise in [0, 1] at points [..., d] from hashed lattice values."""
    p = np.asarray(p, float)
    cell = np.floor(p).astype(np.int64)
    t = p - cell
    t = t * t * (3 - 2 * t)
    total = 0.0
    for corner in range(2 ** p.shape[-1]):
        bits = np.array([corner >> d & 1 for d in range(p.shape[-1])])
        key = ((cell + bits) * np.array([374761393, 668265263, 974634559])[:p.shape[-1]]).sum(-1) + seed * 362437
        key = ((key & 0xFFFFFFFF) ^ key >> 13 & 0x7FFFF) * 1274126177 & 0xFFFFFFFF
        weight = np.where(bits, t, 1 - t).prod(-1)
        total = total + weight * ((key ^ key >> 16) & 0xFFFF) / 0xFFFF
    return total


def fractal(p, octaves, seed=0):
    p = np.asarray(p, float)
    return sum(value_noise(p * 2 ** o, seed + o) / 2 ** o for o in range(octaves)) / (2 - 2.0 ** (1 - octaves))


def write_glb(path, parts):
    """parts: name -> (mesh, material of glTF). Normals have 8 bits a component."""
    blob, views, accessors, meshes, nodes, materials = bytearray(), [], [], [], [], []

    def add(array, kind, component, target, **more):
        view = dict(buffer=0, byteOffset=len(blob), byteLength=array.nbytes, target=target)
        views.append(view | (dict(byteStride=array.strides[0]) if array.dtype == np.int8 else {}))
        blob.extend(array.tobytes() + b"\0" * (-array.nbytes % 4))
        accessors.append(dict(bufferView=len(views) - 1, componentType=component, count=len(array), type=kind, **more))
        return len(accessors) - 1

    for name, ((points, faces), material) in parts.items():
        p, n = points.astype(np.float32), np.round(normals_of(points, faces) * 127).astype(np.int8)
        wide = len(points) > 65535
        attributes = dict(POSITION=add(p, "VEC3", 5126, 34962, min=p.min(0).tolist(), max=p.max(0).tolist()),
                          NORMAL=add(np.pad(n, ((0, 0), (0, 1))), "VEC3", 5120, 34962, normalized=True))
        index = add(faces.reshape(-1).astype(np.uint32 if wide else np.uint16), "SCALAR", 5125 if wide else 5123, 34963)
        materials.append(dict(name=name, **material))
        meshes.append(dict(name=name, primitives=[dict(attributes=attributes, indices=index, material=len(materials) - 1)]))
        nodes.append(dict(name=name, mesh=len(meshes) - 1))
    gltf = dict(asset=dict(version="2.0", generator="assets/source/places"), scene=0, scenes=[dict(nodes=list(range(len(nodes))))], nodes=nodes,
                meshes=meshes, materials=materials, accessors=accessors, bufferViews=views, buffers=[dict(byteLength=len(blob))],
                extensionsUsed=["KHR_materials_specular", "KHR_mesh_quantization"], extensionsRequired=["KHR_mesh_quantization"])
    text = json.dumps(gltf, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    with open(path, "wb") as out:
        out.write(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(blob)))
        out.write(struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(blob), b"BIN\0") + bytes(blob))


def matte(colour, double_sided=False):
    """A rough surface without gloss."""
    material = dict(pbrMetallicRoughness=dict(baseColorFactor=[*colour, 1.0], metallicFactor=0.0, roughnessFactor=1.0),
                    extensions=dict(KHR_materials_specular=dict(specularFactor=0.0)))
    return material | (dict(doubleSided=True) if double_sided else {})
