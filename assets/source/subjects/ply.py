"""Binary PLY of triangles with normals, and perhaps UVs, in metres."""
import numpy as np

VERTEX = np.dtype([("place", "<f4", 3), ("normal", "<f4", 3)])
FACE = np.dtype([("count", "u1"), ("corner", "<i4", 3)])


def write(path, points, faces, normals, uvs=None):
    kind = VERTEX if uvs is None else np.dtype(VERTEX.descr + [("uv", "<f4", 2)])
    vertex, face = np.empty(len(points), kind), np.empty(len(faces), FACE)
    vertex["place"], vertex["normal"] = points, normals
    if uvs is not None:
        vertex["uv"] = uvs
    face["count"], face["corner"] = 3, faces
    names = "".join(f"property float {name}\n" for name in ("x", "y", "z", "nx", "ny", "nz", "u", "v")[:len(kind.descr) * 3 - (uvs is not None)])
    header = f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\n{names}element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n"
    with open(path, "wb") as out:
        out.write(header.encode() + vertex.tobytes() + face.tobytes())


def read(path):
    """Points and faces of a file that `write` made without UVs."""
    with open(path, "rb") as f:
        text = f.read()
    end = text.index(b"end_header\n") + len(b"end_header\n")
    counts = [int(line.split()[2]) for line in text[:end].decode().splitlines() if line.startswith("element")]
    vertex = np.frombuffer(text, VERTEX, counts[0], end)
    face = np.frombuffer(text, FACE, counts[1], end + vertex.nbytes)
    return vertex["place"].copy(), face["corner"].copy()


def face_normals(points, faces):
    """At points: the mean of the faces around, weighted by their angle."""
    p = points[faces].astype(float)
    n = np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])
    n /= np.maximum(np.linalg.norm(n, axis=1, keepdims=True), 1e-30)
    total = np.zeros((len(points), 3))
    for i in range(3):
        u, v = p[:, (i + 1) % 3] - p[:, i], p[:, (i + 2) % 3] - p[:, i]
        angle = np.arctan2(np.linalg.norm(np.cross(u, v), axis=1), (u * v).sum(1))
        for axis in range(3):
            total[:, axis] += np.bincount(faces[:, i], n[:, axis] * angle, len(points))
    return total / np.maximum(np.linalg.norm(total, axis=1, keepdims=True), 1e-30)
