"""The whole bust as a signed distance."""
import numpy as np

import bust
import features
from base import Base
from common import boxed, smooth_max, smooth_min, step
from ear import Ear
from mri import Head

LOW, HIGH = (-24, -29.5, -13), (24, 14, 14)


def uneven(p):
    """Nobody is the same on both sides: points moved by a millimetre, smoothly, below the eyes."""
    x, y, z = p.T
    low = step(0.5, -3.0, y)
    move = np.stack([0.09 * np.sin(0.42 * y + 0.6) + 0.05 * np.sin(0.5 * z + 1), 0.05 * np.sin(0.45 * x + 0.4) + 0.018 * x, 0.06 * np.sin(0.4 * x)], -1)
    return (p + low[:, None] * move).astype(np.float32)


class Shape:
    def __init__(self, path):
        self.mri = Head(path)
        self.base = Base(self.mri)
        self.ear = Ear()

    def share(self, p):
        """How much of the MRI holds: all above the cheeks, but for the ears and the nose."""
        y = p[:, 1]
        side = np.degrees(np.abs(np.arctan2(p[:, 0], p[:, 2])))
        low = -0.75 + 0.55 * np.exp(-(p[:, 0] / 1.2) ** 2) * step(6, 8, p[:, 2]) + 1.9 * step(32, 45, side)
        above = step(low, low + 0.9 + 0.8 * step(32, 45, side), y)
        ear = step(56, 68, side) * step(142, 132, side) * step(4.2, 3.2, y)
        return above * (1 - ear)

    def head(self, p):
        d = self.base(p)
        front = step(6.5, 8.0, p[:, 2])
        d = d - front * (features.lips(p) + features.fold(p)) * 0.9
        floor = -10.75 + np.maximum(9.4 - p[:, 2], 0) * 0.34 - p[:, 1]
        d = smooth_max(d, floor * 0.92, 1.3)
        share = self.share(p)
        some = share > 0
        d[some] += share[some] * (self.mri(p[some]) - d[some])
        eyes = np.flatnonzero(front * step(-1, -0.4, p[:, 1]) * step(2.4, 1.8, p[:, 1]) > 0)
        d[eyes] -= features.lids(p[eyes])
        return d

    def groove(self, p):
        """Small in the folds between ears and head."""
        return 2 * (np.abs(self.ear(features.mirrored(p.astype(np.float32)))[0]) + np.abs(self.head(p.astype(np.float32))))

    def __call__(self, p):
        p = uneven(p)
        q = features.mirrored(p)
        d = np.full(len(p), 9.0, np.float32)
        near = np.flatnonzero((p[:, 1] > -13) & (np.abs(p[:, 0]) < 9.5))
        d[near] = np.minimum(self.head(p[near]), 9)
        below = np.flatnonzero(p[:, 1] < 3)
        d[below] = smooth_min(d[below], bust.bust(q[below]), 1.6)
        face = np.flatnonzero((q[:, 0] < 3) & (p[:, 2] > 8) & (np.abs(p[:, 1] + 1.5) < 4.5))
        d[face] = features.nose(d[face], p[face])
        side = np.flatnonzero((q[:, 0] > 5) & (np.abs(q[:, 0] - 8) < 4) & (np.abs(p[:, 1]) < 5) & (np.abs(p[:, 2] + 2) < 4.5))
        ear, hollow = self.ear(q[side])
        d[side] = smooth_min(smooth_max(d[side], -hollow, 0.2), ear, 0.32)
        return d


def detail(p):
    """How fine the triangles shall be, 0 to 1: the face and the ears more than the skull, the shoulders least."""
    q = np.abs(p[:, 0])
    face = step(4.5, 7.5, p[:, 2]) * step(-11.5, -10, p[:, 1]) * step(4.5, 3, p[:, 1])
    ear = step(6.6, 7.2, q) * step(-4.3, -3.6, p[:, 1]) * step(3.3, 2.8, p[:, 1]) * step(-5.5, -4.5, p[:, 2]) * step(0.5, -0.5, p[:, 2])
    lips = np.exp(-(((p[:, 1] + 6.3) / 0.8) ** 2 + (q / 3.2) ** 8)) * (p[:, 2] > 8)
    eyes = np.exp(-(((p[:, 1] - 0.4) / 1.2) ** 2 + ((q - 3.2) / 2.2) ** 4)) * (p[:, 2] > 7)
    head = 0.25 * step(-14, -11, p[:, 1])
    level = np.maximum.reduce([head, 0.72 * face, 0.85 * ear, 1.0 * lips, 0.95 * eyes, np.full(len(p), 0.06)])
    return np.round(level * 24) / 24
