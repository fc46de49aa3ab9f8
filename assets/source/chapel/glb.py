"""Writes meshes and nodes as a binary glTF 2.0 file with external textures."""
import json
import struct

import numpy as np

import atlas
from materials import AO, MATERIALS
from mesh import unit


class Writer:
    def __init__(self):
        self.blob = bytearray()
        self.g = dict(asset=dict(version="2.0", generator="assets/source/chapel"), scene=0, scenes=[dict(name="chapel", nodes=[])], nodes=[], meshes=[],
                      materials=[], textures=[], images=[], samplers=[dict(magFilter=9729, minFilter=9987, wrapS=10497, wrapT=10497)],
                      accessors=[], bufferViews=[], extensionsUsed=[])
        self.images, self.material_index = {}, {}

    def view(self, data, target):
        while len(self.blob) % 4:
            self.blob += b"\0"
        self.g["bufferViews"].append(dict(buffer=0, byteOffset=len(self.blob), byteLength=len(data), target=target))
        self.blob += data
        return len(self.g["bufferViews"]) - 1

    def accessor(self, array, kind, component, target, bounds=False):
        a = dict(bufferView=self.view(array.tobytes(), target), componentType=component, count=len(array), type=kind)
        if bounds:
            a["min"], a["max"] = array.min(0).tolist(), array.max(0).tolist()
        self.g["accessors"].append(a)
        return len(self.g["accessors"]) - 1

    def texture(self, uri):
        if uri not in self.images:
            self.g["images"].append(dict(uri=uri))
            self.g["textures"].append(dict(sampler=0, source=len(self.g["images"]) - 1))
            self.images[uri] = len(self.g["textures"]) - 1
        return dict(index=self.images[uri])

    def extension(self, material, name, value):
        material.setdefault("extensions", {})[name] = value
        if name not in self.g["extensionsUsed"]:
            self.g["extensionsUsed"].append(name)

    def material(self, name):
        if name in self.material_index:
            return self.material_index[name]
        d = MATERIALS[name]
        pbr = dict(metallicFactor=float(d.get("metallic", 1)), roughnessFactor=float(d.get("roughness", 1)))
        m = dict(name=name, pbrMetallicRoughness=pbr)
        if "maps" in d:
            base = f"textures/{d['maps']}"
            pbr["baseColorTexture"] = self.texture(base + "_color.jpg")
            pbr["metallicRoughnessTexture"] = self.texture(base + "_orm.jpg")
            m["normalTexture"] = self.texture(base + "_normal.jpg") | dict(scale=d["normal_scale"])
            m["occlusionTexture"] = self.texture(AO) | dict(texCoord=1) if d["ao"] else self.texture(base + "_orm.jpg")
        if "base" in d:
            pbr["baseColorFactor"] = list(map(float, d["base"]))
        if "emissive" in d:
            m["emissiveFactor"] = list(d["emissive"])
        if "glass" in d:
            pbr["baseColorTexture"] = self.texture(d["glass"])
            pbr["baseColorFactor"] = [.12, .12, .12, 1.0]
            m["emissiveTexture"] = self.texture(d["glass"])
        if "strength" in d:
            self.extension(m, "KHR_materials_emissive_strength", dict(emissiveStrength=d["strength"]))
        if "transmission" in d:
            self.extension(m, "KHR_materials_transmission", dict(transmissionFactor=d["transmission"]))
            self.extension(m, "KHR_materials_ior", dict(ior=d["ior"]))
        if "normal" in d:
            m["normalTexture"] = self.texture(d["normal"])
            self.extension(m["normalTexture"], "KHR_texture_transform", dict(scale=[1.6, 1.6]))
        if d.get("double_sided"):
            m["doubleSided"] = True
        self.g["materials"].append(m)
        self.material_index[name] = len(self.g["materials"]) - 1
        return self.material_index[name]

    def primitive(self, mesh):
        p, n, uv, uv1, tri = gather(mesh)
        tangent = tangents(p, n, uv, tri)
        su, sv = MATERIALS[mesh.material]["tile"]
        uv = np.stack([uv[:, 0] / su, 1 - uv[:, 1] / sv], -1)
        uv[:, :] -= np.floor(uv.min(0)) if MATERIALS[mesh.material].get("maps") else 0
        f = np.float32
        attributes = dict(POSITION=self.accessor(p.astype(f), "VEC3", 5126, 34962, True), NORMAL=self.accessor(n.astype(f), "VEC3", 5126, 34962),
                          TANGENT=self.accessor(tangent.astype(f), "VEC4", 5126, 34962), TEXCOORD_0=self.accessor(uv.astype(f), "VEC2", 5126, 34962))
        if MATERIALS[mesh.material].get("ao"):
            attributes["TEXCOORD_1"] = self.accessor(uv1.astype(f), "VEC2", 5126, 34962)
        small = len(p) < 65536
        index = tri.reshape(-1).astype(np.uint16 if small else np.uint32)
        return dict(attributes=attributes, indices=self.accessor(index, "SCALAR", 5123 if small else 5125, 34963), material=self.material(mesh.material))

    def save(self, path):
        while len(self.blob) % 4:
            self.blob += b"\0"
        self.g["buffers"] = [dict(byteLength=len(self.blob))]
        text = json.dumps(self.g, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        total = 12 + 8 + len(text) + 8 + len(self.blob)
        with open(path, "wb") as out:
            out.write(struct.pack("<4sII", b"glTF", 2, total))
            out.write(struct.pack("<I4s", len(text), b"JSON") + text)
            out.write(struct.pack("<I4s", len(self.blob), b"BIN\0") + bytes(self.blob))


def gather(mesh):
    """Concatenates a primitive's patches, welding vertices that agree in everything and dropping unused ones."""
    parts, tris, base = [], [], 0
    for q in mesh.patches:
        parts.append(np.concatenate([q["p"], q["n"], q["uv"], q["uv1"]], 1))
        tris.append(q["tri"] + base)
        base += len(q["p"])
    v, tri = np.concatenate(parts), np.concatenate(tris)
    used, tri = np.unique(tri, return_inverse=True)
    v, tri = v[used], tri.reshape(-1, 3)
    _, first, inverse = np.unique(np.round(v, 5), axis=0, return_index=True, return_inverse=True)
    order = np.argsort(np.argsort(first))  # keep the order of first appearance for cache locality
    v, tri = v[np.sort(first)], order[inverse.reshape(-1)][tri]
    tri = tri[(tri[:, 0] != tri[:, 1]) & (tri[:, 1] != tri[:, 2]) & (tri[:, 2] != tri[:, 0])]
    return v[:, :3], v[:, 3:6], v[:, 6:8], v[:, 8:10], tri


def tangents(p, n, uv, tri):
    """Per-vertex tangents from the UV gradients; w says which way the bitangent (up in the image) goes."""
    e1, e2 = p[tri[:, 1]] - p[tri[:, 0]], p[tri[:, 2]] - p[tri[:, 0]]
    d1, d2 = uv[tri[:, 1]] - uv[tri[:, 0]], uv[tri[:, 2]] - uv[tri[:, 0]]
    det = d1[:, 0] * d2[:, 1] - d1[:, 1] * d2[:, 0]
    sign = np.where(det < 0, -1.0, 1.0)[:, None]
    t = (e1 * d2[:, 1:] - e2 * d1[:, 1:]) * sign
    b = (e2 * d1[:, :1] - e1 * d2[:, :1]) * sign
    ts, bs = np.zeros_like(p), np.zeros_like(p)
    for k in range(3):
        np.add.at(ts, tri[:, k], t)
        np.add.at(bs, tri[:, k], b)
    ts = ts - n * (ts * n).sum(1, keepdims=True)
    lost = np.linalg.norm(ts, axis=1) < 1e-10
    ts[lost] = np.cross(n[lost], [0.36, 0.48, 0.8])
    ts = unit(ts)
    w = np.where((np.cross(n, ts) * bs).sum(1) < 0, -1.0, 1.0)
    return np.concatenate([ts, w[:, None]], 1)


def write(meshes, nodes, path):
    scale = atlas.pack(meshes, {name for name, d in MATERIALS.items() if d.get("ao")})
    writer = Writer()
    index = {}
    for name, prims in meshes.items():
        index[name] = len(writer.g["meshes"])
        writer.g["meshes"].append(dict(name=name, primitives=[writer.primitive(p) for p in prims]))
    for name, mesh, m in nodes:
        node = dict(name=name, mesh=index[mesh])
        half = np.arctan2(m[0, 2], m[0, 0]) / 2  # every placement is a turn about +Y
        if abs(half) > 1e-9:
            node["rotation"] = [0.0, float(np.sin(half)), 0.0, float(np.cos(half))]
        if np.abs(m[:3, 3]).max() > 1e-9:
            node["translation"] = m[:3, 3].tolist()
        writer.g["scenes"][0]["nodes"].append(len(writer.g["nodes"]))
        writer.g["nodes"].append(node)
    writer.save(path)
    return scale
