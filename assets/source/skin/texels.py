"""From triangles to texels: what lies where in the chart, and fields over it. Row 0 is the top, v = 1."""
import numpy as np
from scipy import ndimage


def covered(uv, faces, size):
    """For each texel its face (-1: none) and the weights of its corners."""
    face = np.full((size, size), -1, np.int32)
    weight = np.zeros((size, size, 3), np.float32)
    place = np.stack([uv[:, 0] * size - 0.5, (1 - uv[:, 1]) * size - 0.5], -1)[faces]
    low = np.maximum(np.ceil(place.min(1) - 0.01).astype(int), 0)
    high = np.minimum(np.floor(place.max(1) + 0.01).astype(int), size - 1)
    for f in range(len(faces)):
        (x0, y0), (x1, y1) = low[f], high[f]
        if x1 < x0 or y1 < y0:
            continue
        (ax, ay), (bx, by), (cx, cy) = place[f]
        area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
        if area == 0:
            continue
        x, y = np.arange(x0, x1 + 1)[None], np.arange(y0, y1 + 1)[:, None]
        wb = ((x - ax) * (cy - ay) - (cx - ax) * (y - ay)) / area
        wc = ((bx - ax) * (y - ay) - (x - ax) * (by - ay)) / area
        inside = (wb >= -1e-4) & (wc >= -1e-4) & (wb + wc <= 1 + 1e-4)
        face[y0:y1 + 1, x0:x1 + 1][inside] = f
        weight[y0:y1 + 1, x0:x1 + 1][inside] = np.stack([1 - wb - wc, wb, wc], -1)[inside]
    return face, weight


def overlaps(uv, faces, size=2048):
    """How many texels lie in more than one triangle, well inside of each."""
    count = np.zeros((size, size), np.uint8)
    centre = uv[faces].mean(1, keepdims=True)
    small = (uv[faces] - centre) * 0.9 + centre
    place = np.stack([small[..., 0] * size - 0.5, (1 - small[..., 1]) * size - 0.5], -1)
    low, high = np.ceil(place.min(1)).astype(int), np.floor(place.max(1)).astype(int)
    for f in np.flatnonzero((high >= low).all(1)):
        (x0, y0), (x1, y1) = low[f], high[f]
        (ax, ay), (bx, by), (cx, cy) = place[f]
        area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
        x, y = np.arange(x0, x1 + 1)[None], np.arange(y0, y1 + 1)[:, None]
        wb = ((x - ax) * (cy - ay) - (cx - ax) * (y - ay)) / area
        wc = ((bx - ax) * (y - ay) - (x - ax) * (by - ay)) / area
        count[y0:y1 + 1, x0:x1 + 1] += (wb >= 0) & (wc >= 0) & (wb + wc <= 1)
    return int((count > 1).sum())


class Chart:
    """The texels that are covered, as a list, and their way back into a picture."""

    def __init__(self, uv, faces, size):
        self.size = size
        face, weight = covered(uv, faces, size)
        self.mask = face >= 0
        self.face, self.weight = face[self.mask], weight[self.mask]
        self.corners, self.uv = faces, uv
        self.near = ndimage.distance_transform_edt(~self.mask, return_distances=False, return_indices=True)

    def field(self, values):
        """Values of the points at the texels."""
        v = values[self.corners[self.face]]
        return (v * self.weight.reshape(self.weight.shape + (1,) * (v.ndim - 2))).sum(1)

    def picture(self, values):
        """A picture of values at the texels; beyond the chart each pixel takes the nearest one's."""
        out = np.zeros((self.size, self.size) + values.shape[1:], values.dtype)
        out[self.mask] = values
        return out[tuple(self.near)]

    def slopes(self, height, points):
        """The gradient on the surface of heights at the texels."""
        h = self.picture(height.astype(np.float32))
        du, dv = np.zeros_like(h), np.zeros_like(h)
        du[:, 1:-1] = (h[:, 2:] - h[:, :-2]) * 0.5 * self.size
        dv[1:-1] = (h[:-2] - h[2:]) * 0.5 * self.size
        du, dv = du[self.mask], dv[self.mask]
        p, t = points[self.corners], self.uv[self.corners]
        e1, e2, a, b = p[:, 1] - p[:, 0], p[:, 2] - p[:, 0], t[:, 1] - t[:, 0], t[:, 2] - t[:, 0]
        det = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
        pu = (e1 * b[:, 1:] - e2 * a[:, 1:]) / det[:, None]
        pv = (e2 * a[:, :1] - e1 * b[:, :1]) / det[:, None]
        uu, uv, vv = (pu * pu).sum(1), (pu * pv).sum(1), (pv * pv).sum(1)
        g = np.maximum(uu * vv - uv * uv, 1e-20)
        f = self.face
        along_u = (vv[f] * du - uv[f] * dv) / g[f]
        along_v = (uu[f] * dv - uv[f] * du) / g[f]
        return along_u[:, None] * pu[f] + along_v[:, None] * pv[f]


def tangents(points, normals, uv, faces):
    """As the engine makes them: at each point the mean over its faces of the direction in which u grows, weighted by the angle."""
    flat = lambda v, n: v - n * (v * n).sum(1, keepdims=True)
    unit = lambda v: v / np.maximum(np.linalg.norm(v, axis=1, keepdims=True), 1e-20)
    p, t = points[faces], uv[faces]
    e1, e2, a, b = p[:, 1] - p[:, 0], p[:, 2] - p[:, 0], t[:, 1] - t[:, 0], t[:, 2] - t[:, 0]
    area = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    direction = unit((e1 * b[:, 1:] - e2 * a[:, 1:]) * np.sign(area)[:, None])
    total = np.zeros_like(points)
    for i in range(3):
        n, q = normals[faces[:, i]], p[:, i]
        u, v = unit(flat(p[:, (i + 1) % 3] - q, n)), unit(flat(p[:, (i + 2) % 3] - q, n))
        angle = np.arccos(np.clip((u * v).sum(1), -1, 1))
        np.add.at(total, faces[:, i], unit(flat(direction, n)) * angle[:, None])
    return unit(flat(total, normals))
