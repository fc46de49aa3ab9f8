"""Triangle meshes built from patches, each of which knows its surface UV (metres) and its chart in the light-map atlas."""
import numpy as np


def unit(v):
    v = np.asarray(v, float)
    return v / np.maximum(np.linalg.norm(v, axis=-1, keepdims=True), 1e-12)


class Mesh:
    """One primitive: a single material. UVs are kept in metres until export divides them by the material's tile."""

    def __init__(self, material):
        self.material = material
        self.patches = []  # dict(p, n, uv, tri, chart)

    def add(self, p, n, uv, tri, chart):
        """p, n: [k,3]; uv, chart: [k,2] in metres; tri: [t,3] counter-clockwise seen from outside."""
        p = np.asarray(p, float)
        tri = np.asarray(tri, int)
        a, b, c = p[tri[:, 0]], p[tri[:, 1]], p[tri[:, 2]]
        area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
        tri = tri[area > 1e-9]
        if len(tri):
            self.patches.append(dict(p=p, n=unit(n), uv=np.asarray(uv, float), tri=tri, chart=np.asarray(chart, float)))

    def grid(self, p, uv=None, normals=None, out=None, away=None, chart_scale=1.0):
        """A grid p[i,j,3]. `out` (a direction) or `away` (a point) says which side is outside; without either, dP/di x dP/dj.

        Normals are finite differences unless given. Without uv, arc lengths in metres are used.
        """
        p = np.asarray(p, float)
        ni, nj = p.shape[:2]
        li, lj = _lengths(p)
        if uv is None:
            uv = np.stack([li, lj], -1)
        given = normals is not None
        if not given:
            normals = _grid_normals(p)
        idx = np.arange(ni * nj).reshape(ni, nj)
        a, b, c, d = idx[:-1, :-1], idx[1:, :-1], idx[1:, 1:], idx[:-1, 1:]
        tri = np.concatenate([np.stack([a, b, c], -1).reshape(-1, 3), np.stack([a, c, d], -1).reshape(-1, 3)])
        flat = p.reshape(-1, 3)
        face = np.cross(flat[tri[:, 1]] - flat[tri[:, 0]], flat[tri[:, 2]] - flat[tri[:, 0]])
        if out is not None:
            side = (face @ np.asarray(out, float)).sum()
        elif away is not None:
            side = (face * (flat[tri].mean(1) - np.asarray(away, float))).sum()
        elif given:
            side = (face * normals.reshape(-1, 3)[tri].mean(1)).sum()
        else:
            side = 1.0
        if side < 0:
            tri = tri[:, [0, 2, 1]]
            if not given:
                normals = -normals
        chart = np.stack([li, lj], -1) * chart_scale
        self.add(flat, normals.reshape(-1, 3), np.asarray(uv, float).reshape(-1, 2), tri, chart.reshape(-1, 2))

    def sweep(self, section, section_normals, path, x_axis, y_axis, uv0=(0, 0), closed=False, caps=False, chart_scale=1.0):
        """Sweeps a 2D section (points and normals, in the frame x_axis/y_axis given per path point) along a path; u runs along the path."""
        path, x_axis, y_axis = (np.asarray(v, float) for v in (path, x_axis, y_axis))
        s, sn = np.asarray(section, float), np.asarray(section_normals, float)
        if closed:
            s, sn = np.vstack([s, s[:1]]), np.vstack([sn, sn[:1]])
        p = path[:, None] + s[None, :, :1] * x_axis[:, None] + s[None, :, 1:] * y_axis[:, None]
        n = sn[None, :, :1] * x_axis[:, None] + sn[None, :, 1:] * y_axis[:, None]
        length = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(path, axis=0), axis=1))])
        around = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(s, axis=0), axis=1))])
        uv = np.stack(np.broadcast_arrays(length[:, None] + uv0[0], around[None] + uv0[1]), -1)
        self.grid(p, uv, n, chart_scale=chart_scale)
        if caps:
            for i, sign in ((0, -1), (-1, 1)):
                direction = unit(path[1] - path[0]) if i == 0 else unit(path[-1] - path[-2])
                self.fan(p[i], direction * sign, uv0, chart_scale)

    def fan(self, ring, normal, uv0=(0, 0), chart_scale=1.0):
        """A flat, star-shaped face bounded by ring[k,3]."""
        ring = np.asarray(ring, float)
        normal = unit(normal)
        x = unit(np.cross([0.31, 0.95, 0.05] if abs(normal[1]) < 0.9 else [1, 0, 0.1], normal))
        y = np.cross(normal, x)
        p = np.vstack([ring.mean(0), ring])
        k = len(ring)
        tri = np.array([[0, 1 + i, 1 + (i + 1) % k] for i in range(k)])
        face = np.cross(p[tri[:, 1]] - p[tri[:, 0]], p[tri[:, 2]] - p[tri[:, 0]]).sum(0)
        if face @ normal < 0:
            tri = tri[:, [0, 2, 1]]
        q = np.stack([p @ x, p @ y], -1)
        self.add(p, np.tile(normal, (k + 1, 1)), q + np.asarray(uv0), tri, (q - q.min(0)) * chart_scale)

    def transformed(self, matrix, flip=False):
        """Copies of the patches under a rigid 4x4 matrix."""
        m = Mesh(self.material)
        for q in self.patches:
            p = q["p"] @ matrix[:3, :3].T + matrix[:3, 3]
            n = q["n"] @ matrix[:3, :3].T
            tri = q["tri"][:, [0, 2, 1]] if flip else q["tri"]
            m.patches.append(dict(p=p, n=n, uv=q["uv"], tri=tri, chart=q["chart"]))
        return m

    def extend(self, other):
        self.patches += other.patches

    def triangles(self):
        return sum(len(q["tri"]) for q in self.patches)


def _lengths(p):
    """Arc lengths along both grid directions, averaged so that the chart is a rectangle."""
    di = np.linalg.norm(np.diff(p, axis=0), axis=2)
    dj = np.linalg.norm(np.diff(p, axis=1), axis=2)
    li = np.concatenate([[0], np.cumsum(np.maximum(di.mean(1), 1e-5))])
    lj = np.concatenate([[0], np.cumsum(np.maximum(dj.mean(0), 1e-5))])
    return np.broadcast_arrays(li[:, None], lj[None, :])


def _grid_normals(p):
    def diff(axis):
        closed = np.allclose(np.take(p, 0, axis), np.take(p, -1, axis), atol=1e-6)
        if closed and p.shape[axis] > 3:
            q = np.concatenate([np.take(p, [-2], axis), p, np.take(p, [1], axis)], axis)
            a = np.take(q, range(2, q.shape[axis]), axis)
            b = np.take(q, range(0, q.shape[axis] - 2), axis)
            return a - b
        return np.gradient(p, axis=axis)

    n = np.cross(diff(0), diff(1))
    length = np.linalg.norm(n, axis=2, keepdims=True)
    bad = length[..., 0] < 1e-12
    n = n / np.maximum(length, 1e-12)
    if bad.any():
        for i, j in zip(*np.nonzero(bad)):
            for k in list(range(1, max(p.shape[:2]))):
                near = n[max(i - k, 0):i + k + 1, max(j - k, 0):j + k + 1].reshape(-1, 3).sum(0)
                if np.linalg.norm(near) > 1e-6:
                    n[i, j] = unit(near)
                    break
    return n


def translation(x, y, z):
    m = np.eye(4)
    m[:3, 3] = x, y, z
    return m


def rotation_y(degrees, x=0.0, y=0.0, z=0.0):
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    m = np.eye(4)
    m[:3, :3] = [[c, 0, s], [0, 1, 0], [-s, 0, c]]
    m[:3, 3] = x, y, z
    return m


def rounded_rect(w, h, r, steps=2):
    """Section of a plank: a w x h rectangle with rounded corners, counter-clockwise, with normals that keep the flats flat."""
    pts, nrm = [], []
    for cx, cy, start in ((w / 2 - r, h / 2 - r, 0), (-w / 2 + r, h / 2 - r, 90), (-w / 2 + r, -h / 2 + r, 180), (w / 2 - r, -h / 2 + r, 270)):
        for k in range(steps):
            a = np.radians(start + 90 * k / (steps - 1))
            pts.append((cx + r * np.cos(a), cy + r * np.sin(a)))
            nrm.append((np.cos(a), np.sin(a)))
    return np.array(pts), np.array(nrm)


