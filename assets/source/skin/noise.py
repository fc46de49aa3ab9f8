"""Noise at points in space, and cells around scattered points."""
import numpy as np
from scipy import ndimage
from scipy.spatial import cKDTree

PERIOD = 96


class Noise:
    """Smooth noise of unit variance, about one bump to a unit of length."""

    def __init__(self, seed):
        random = np.random.default_rng(seed)
        self.grid = random.standard_normal((PERIOD,) * 3).astype(np.float32)
        turn = np.linalg.qr(random.standard_normal((3, 3)))[0]
        self.turn, self.shift = turn.astype(np.float32), random.uniform(0, PERIOD, 3).astype(np.float32)

    def __call__(self, p, turned=True):
        q = p.astype(np.float32) @ self.turn if turned else p.astype(np.float32)
        return ndimage.map_coordinates(self.grid, (q + self.shift).T % PERIOD, order=2, prefilter=False, mode="grid-wrap") * 3.3


def octaves(p, size, count, seed, gain=0.55):
    """Noise whose largest bumps have a size, in the unit of p."""
    total, weight, sum2 = 0.0, 1.0, 0.0
    for i in range(count):
        total = total + weight * Noise(seed + i)(p * (2 ** i / size))
        sum2 += weight ** 2
        weight *= gain
    return total / np.sqrt(sum2)


def scattered(random, corners, chance):
    """Points on triangles [n, 3, 3]; chance is how many to a square unit, for each."""
    area = 0.5 * np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    many = random.poisson(area * chance)
    face = np.repeat(np.arange(len(corners)), many)
    s, t = random.random((2, len(face)))
    over = s + t > 1
    s[over], t[over] = 1 - s[over], 1 - t[over]
    c = corners[face]
    return c[:, 0] + s[:, None] * (c[:, 1] - c[:, 0]) + t[:, None] * (c[:, 2] - c[:, 0])


def thinned(points, least, random):
    """Points of which none is nearer to another than least (for each its own)."""
    tree = cKDTree(points)
    order = random.permutation(len(points))
    keep = np.ones(len(points), bool)
    near = tree.query_ball_point(points, least)
    for i in order:
        if keep[i]:
            for j in near[i]:
                if j != i:
                    keep[j] = False
    return points[keep]


def cells(points, p, count=2):
    """Distances to the nearest scattered points, and which the nearest is."""
    d, index = cKDTree(points).query(p, k=count)
    return d.astype(np.float32), index
