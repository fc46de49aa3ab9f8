"""Signed distances of simple shapes at points [n, 3], negative inside, in the unit of the points. They are exact or nearly so close to the surface, which is all
that contouring needs."""
import numpy as np


def smooth_min(a, b, k):
    """Union whose seam is rounded over a width k."""
    h = np.clip(0.5 + 0.5 * (b - a) / k, 0, 1)
    return b + (a - b) * h - k * h * (1 - h)


def smooth_max(a, b, k):
    return -smooth_min(-a, -b, k)


def step(low, high, x):
    """0 below low, 1 above high, smooth between."""
    t = np.clip((x - low) / (high - low), 0, 1)
    return t * t * (3 - 2 * t)


def length(v):
    return np.sqrt((v * v).sum(-1))


def capsule(p, a, b, ra, rb=None):
    """A rod from a to b with round ends, its radius running from ra to rb."""
    a, b = np.asarray(a, np.float32), np.asarray(b, np.float32)
    axis = b - a
    h = np.clip((p - a) @ axis / (axis @ axis), 0, 1)
    return length(p - a - h[:, None] * axis) - (ra + ((ra if rb is None else rb) - ra) * h)


def chain(p, points, radii, k):
    """Capsules through points, smoothly joined."""
    d = None
    for i in range(len(points) - 1):
        rod = capsule(p, points[i], points[i + 1], radii[i], radii[i + 1])
        d = rod if d is None else smooth_min(d, rod, k)
    return d


def ellipsoid(p, centre, radii):
    q = (p - np.asarray(centre, np.float32)) / np.asarray(radii, np.float32)
    k = length(q)
    return k * (k - 1) / np.maximum(length(q / np.asarray(radii, np.float32)), 1e-6)


def triangle(p, a, b, c):
    """Unsigned distance to a triangle."""
    a, b, c = (np.asarray(v, np.float32) for v in (a, b, c))
    n = np.cross(b - a, a - c)
    edges = ((a, b), (b, c), (c, a))
    beside = sum(np.sign((p - u) @ np.cross(v - u, n)) for u, v in edges) < 2
    to_edge = np.min([capsule(p, u, v, 0.0) for u, v in edges], 0)
    return np.where(beside, to_edge, np.abs((p - a) @ n) / np.sqrt(n @ n))


def ridges(phase, sharp=0.05):
    """Waves of cloth in [0, 1]: round crests and narrow valleys, one to each pi of phase."""
    return np.sqrt(np.sin(phase) ** 2 + sharp) / np.sqrt(1 + sharp)


def turned(p, pivot, pitch=0.0, yaw=0.0, roll=0.0):
    """Points in the frame of a part that was turned about a pivot: nodding (pitch), shaking (yaw), leaning (roll) in degrees."""
    x, y, z = np.radians([pitch, yaw, roll])
    rx = np.array([[1, 0, 0], [0, np.cos(x), -np.sin(x)], [0, np.sin(x), np.cos(x)]])
    ry = np.array([[np.cos(y), 0, np.sin(y)], [0, 1, 0], [-np.sin(y), 0, np.cos(y)]])
    rz = np.array([[np.cos(z), -np.sin(z), 0], [np.sin(z), np.cos(z), 0], [0, 0, 1]])
    return ((p - np.asarray(pivot)) @ (ry @ rx @ rz)).astype(np.float32)


def curve(x, at, values):
    """A smooth curve through values given at rising places: cubic pieces, level beyond the ends."""
    at, values = np.asarray(at, np.float32), np.asarray(values, np.float32)
    slope = np.gradient(values, at)
    slope[[0, -1]] = 0
    i = np.clip(np.searchsorted(at, x) - 1, 0, len(at) - 2)
    size = at[i + 1] - at[i]
    t = np.clip((x - at[i]) / size, 0, 1)
    a, b = values[i], values[i + 1]
    return a + t * t * (3 - 2 * t) * (b - a) + size * t * (1 - t) * ((1 - t) * slope[i] - t * slope[i + 1])


def boxed(shape, p, low, high, margin=1.0):
    """A shape that lies in a box, evaluated there only: farther away the distance to the box serves."""
    low, high = np.asarray(low, np.float32), np.asarray(high, np.float32)
    away = length(np.maximum(np.maximum(low - p, p - high), 0))
    d = away + 0.5 * margin
    near = np.flatnonzero(away < margin)
    if len(near):
        d[near] = shape(p[near])
    return d
