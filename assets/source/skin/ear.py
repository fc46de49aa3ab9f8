"""The ears, in the frame of the head: a bent sheet with a rolled rim, worked out on a grid of its own (u backwards, v up, w outwards, in centimetres)."""
import numpy as np
from scipy import ndimage

from common import capsule, chain, ellipsoid, in_batches, length, smooth_max, smooth_min, step

OUTLINE = np.array([(0.62, 0.15), (0.3, 0.75), (0.2, 1.5), (0.42, 2.3), (1.0, 2.86), (1.75, 3.0), (2.45, 2.72), (2.92, 2.1), (3.08, 1.3), (2.98, 0.45), (2.68, -0.45),
                    (2.22, -1.3), (1.85, -2.05), (1.55, -2.75), (1.1, -3.2), (0.6, -3.22), (0.25, -2.85), (0.12, -2.2), (0.1, -1.4), (0.2, -0.6)])
ROOT, BACK, LEAN, SWING = np.array([6.85, -0.35, -1.2]), 30.0, 10.0, 1.0


def closed(points, each=6):
    """A smooth closed curve through points."""
    t = np.arange(each)[:, None] / each
    a, b, c, d = (np.roll(points, k, 0)[:, None] for k in (1, 0, -1, -2))
    return (0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t ** 2 + (3 * b - a - 3 * c + d) * t ** 3)).reshape(-1, points.shape[1])


def inside_outline(uv, ring):
    """Distance to a closed curve in the plane, negative inside."""
    best, wind = np.full(len(uv), 1e9, np.float32), np.zeros(len(uv), bool)
    for a, b in zip(ring, np.roll(ring, -1, 0)):
        edge, to = b - a, uv - a
        h = np.clip(to @ edge / (edge @ edge), 0, 1)
        best = np.minimum(best, length(to - h[:, None] * edge))
        cut = (a[1] > uv[:, 1]) != (b[1] > uv[:, 1])
        wind ^= cut & (uv[:, 0] < (b[0] - a[0]) * (uv[:, 1] - a[1]) / (b[1] - a[1] + 1e-9) + a[0])
    return np.where(wind, -best, best)


def ear_frame():
    out, lean = np.radians(BACK), np.radians(LEAN)
    u = np.array([np.sin(out), 0, -np.cos(out)])
    w = np.array([np.cos(out), 0, np.sin(out)])
    v = np.array([0.0, 1, 0])
    u, v = np.cos(lean) * u - np.sin(lean) * v * 1, np.cos(lean) * v + np.sin(lean) * u
    return np.stack([u, v, w], -1)


FRAME = ear_frame()


def along(uv, points):
    """Distance in the plane to a line through points."""
    points = np.asarray(points, np.float32)
    return np.min([capsule(uv, a, b, 0) for a, b in zip(points[:-1], points[1:])], 0)


CELL, LOW, SIZE = 0.03, np.array([-0.6, -3.9, -1.5]), np.array([4.4, 7.6, 2.9])


def relief(uv):
    """How far the middle of the sheet stands out, and its thickness."""
    u, v = uv[:, 0], uv[:, 1]
    rim = -inside_outline(uv, closed(OUTLINE).astype(np.float32))
    fold = along(uv, [(1.0, -1.5), (1.5, -1.35), (2.0, -0.75), (2.22, 0.1), (2.12, 0.9), (1.85, 1.6), (1.55, 2.2)])
    fork = along(uv, [(2.12, 0.85), (1.6, 1.05), (1.0, 1.2), (0.6, 1.2)])
    bowl = length((uv - np.array([1.15, -0.3], np.float32)) / np.array([0.95, 1.12], np.float32))
    upper = length((uv - np.array([1.3, 0.7], np.float32)) / np.array([0.78, 0.4], np.float32))
    crus = along(uv, [(0.5, 0.3), (1.0, 0.2), (1.4, 0.22)])
    h = 0.22 * np.exp(-(fold / 0.25) ** 2) + 0.12 * np.exp(-(fork / 0.2) ** 2) - 0.75 * step(1.08, 0.5, bowl) - 0.4 * step(1.1, 0.4, upper) * step(0.7, 1.1, bowl)
    h += 0.28 * np.exp(-(crus / 0.2) ** 2) + 0.14 * step(0.45, 0.05, rim) * step(-2.3, -1.2, v) + 0.12 * (u - 1.5) * step(-1, -2.5, v)
    return h, 0.22 + 0.13 * step(-1.6, -2.6, v) + 0.12 * step(0.8, 0.2, u) + 0.12 * step(1.0, 0.6, bowl), rim


def rolled(e):
    """The rim, from the bowl over the top and down to the lobule."""
    ring, centre = closed(OUTLINE), np.array([1.5, 0.2])
    ring = (ring + (centre - ring) * 0.1)[:int(len(ring) * 0.7)]
    place = np.linspace(0, 1, len(ring))
    high = 0.1 + 0.2 * np.sin(np.pi * np.clip(place * 1.15, 0, 1)) - 0.05 * step(0.75, 1, place)
    size = 0.15 + 0.08 * np.sin(np.pi * np.clip(place * 1.1, 0, 1)) - 0.05 * step(0.7, 1, place)
    line = [(1.3, 0.15, -0.4), (0.95, 0.1, -0.12)] + [(*ring[i], high[i]) for i in range(0, len(ring), 3)]
    return chain(e, line, [0.12, 0.15] + [size[i] for i in range(0, len(ring), 3)], 0.03)


def whole(e):
    d = rolled(e)
    d = smooth_min(d, ellipsoid(e, (0.14, -0.5, 0.1), (0.36, 0.48, 0.2)), 0.16)          # tragus
    d = smooth_min(d, ellipsoid(e, (1.15, -1.42, 0.08), (0.42, 0.24, 0.22)), 0.16)      # antitragus
    return smooth_min(d, ellipsoid(e, (0.85, -2.5, 0.06), (0.62, 0.66, 0.19)), 0.2)     # lobule


class Ear:
    def __init__(self):
        count = np.ceil(SIZE / CELL).astype(int)
        place = np.stack(np.meshgrid(*(np.arange(n) * CELL for n in count), indexing="ij"), -1).reshape(-1, 3) + LOW
        flat = place.reshape(*count, 3)[:, :, 0, :2].reshape(-1, 2).astype(np.float32)
        h, thick, rim = (a.reshape(count[:2]) for a in relief(flat))
        sheet = np.ones(count, bool)
        for i in range(-12, 13):  # the middle as voxels without gaps: each column reaches halfway to its neighbours
            for axis in (0, 1):
                other = h + (np.roll(h, 1 if i < 0 else -1, axis) - h) * abs(i) / 24
                k = np.rint((other - LOW[2]) / CELL).astype(int)
                u, v = np.indices(k.shape)
                good = rim > 0.12
                sheet[u[good], v[good], np.clip(k[good], 0, count[2] - 1)] = False
        d = ndimage.distance_transform_edt(sheet).astype(np.float32) * CELL - 0.5 * thick[:, :, None]
        d = ndimage.gaussian_filter(d, 1.5)
        more = in_batches(whole, place.astype(np.float32)).reshape(count)
        self.grid = smooth_min(d, more, 0.12).astype(np.float32)

    def __call__(self, q):
        """Distance to the ear at points of the right half, and to what it hollows out of the head."""
        e = ((q - ROOT.astype(np.float32)) @ FRAME.astype(np.float32)).astype(np.float32)
        at = (e - LOW) / CELL
        beyond = length(np.maximum(np.maximum(-at, at - (np.array(self.grid.shape) - 1)), 0)) * CELL
        d = ndimage.map_coordinates(self.grid, at.T, order=1, mode="nearest") + beyond
        hollow = ellipsoid(e, (1.15, -0.2, 0.2), (0.95, 1.12, 0.75))
        return d.astype(np.float32), np.minimum(hollow, ellipsoid(e, (0.6, -0.45, -0.7), (0.28, 0.32, 0.8)))
