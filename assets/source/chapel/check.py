"""Checks what was made: counts, sizes, closed references, normals, light leaks. Usage: check.py CHAPEL_DIRECTORY"""
import json
import pathlib
import struct
import sys

import numpy as np

import imageio


def read_glb(path):
    data = path.read_bytes()
    length = struct.unpack_from("<I", data, 12)[0]
    g = json.loads(data[20:20 + length])
    blob = data[20 + length + 8:]

    def accessor(i):
        a = g["accessors"][i]
        v = g["bufferViews"][a["bufferView"]]
        kind = {5126: np.float32, 5123: np.uint16, 5125: np.uint32}[a["componentType"]]
        width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}[a["type"]]
        return np.frombuffer(blob, kind, a["count"] * width, v["byteOffset"]).reshape(a["count"], width)

    return g, accessor


def main(folder):
    g, accessor = read_glb(folder / "chapel.glb")
    triangles = primitives = against = 0
    for node in g["nodes"]:
        for p in g["meshes"][node["mesh"]]["primitives"]:
            triangles += g["accessors"][p["indices"]]["count"] // 3
            primitives += 1
    for mesh in g["meshes"]:
        for p in mesh["primitives"]:
            a = {k: accessor(i) for k, i in p["attributes"].items()}
            tri = accessor(p["indices"]).reshape(-1, 3)
            for k, v in a.items():
                assert np.isfinite(v).all(), (mesh["name"], k)
            assert np.allclose(np.linalg.norm(a["NORMAL"], axis=1), 1, atol=1e-3), mesh["name"]
            assert np.allclose(np.linalg.norm(a["TANGENT"][:, :3], axis=1), 1, atol=1e-3), mesh["name"]
            assert np.abs((a["TANGENT"][:, :3] * a["NORMAL"]).sum(1)).max() < 0.02, mesh["name"]
            q = a["POSITION"][tri]
            face = np.cross(q[:, 1] - q[:, 0], q[:, 2] - q[:, 0])
            area = np.linalg.norm(face, axis=1)
            wrong = ((face * a["NORMAL"][tri].mean(1)).sum(1) < 0) & (area > 1e-6)
            against += wrong.sum()
            if wrong.mean() > .02:
                print("  winding against normals:", mesh["name"], g["materials"][p["material"]]["name"], wrong.sum(), "of", len(tri))
    missing = [i["uri"] for i in g["images"] if not (folder / i["uri"]).exists()]
    size = sum(f.stat().st_size for f in folder.rglob("*") if f.is_file()) / 1e6
    print(f"{triangles} triangles in {primitives} primitives, {len(g['materials'])} materials, {against} triangles against their normals, {size:.1f} MB in all")
    assert not missing, missing
    assert 100_000 <= triangles <= 400_000 and primitives <= 150 and size <= 30 and against < triangles * .002
    scene = json.loads((folder / "chapel.json").read_text())
    for text in (folder / "chapel.json").read_text().split('"'):
        if text.endswith((".exr", ".png", ".glb")):
            assert (folder / text).exists(), text
    for name in ("probe_nave.exr", "probe_outside.exr"):
        p = imageio.load(folder / name)
        assert p.shape == (128, 256, 3) and np.isfinite(p).all() and p.min() >= 0, name
    print(len(scene["entities"]), "entities; every file they name is there")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
