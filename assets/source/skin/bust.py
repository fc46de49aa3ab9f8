"""Neck and shoulders, in the frame of the head."""
import numpy as np
from common import capsule, chain, ellipsoid, smooth_max, smooth_min

BOTTOM = -28.5


def neck(q):
    d = capsule(q, (0, -3, -0.75), (0, -19, -2.2), 5.5, 6.0)
    cord = chain(q, [(6.2, -3.2, -2.6), (4.9, -9, 0.2), (2.6, -14.5, 2.6), (1.0, -17.6, 3.6)], [0.9, 1.0, 0.8, 0.5], 0.4)
    d = smooth_min(d, cord, 1.1)
    d = smooth_min(d, ellipsoid(q, (0, -13.3, 2.9), (0.9, 1.3, 1.2)), 1.1)
    return d


def shoulders(q):
    d = ellipsoid(q, (0, -28, -2.2), (17, 12, 9.2))
    d = smooth_min(d, capsule(q * np.array([0.62, 1, 1], np.float32), (0, -29, -2.2), (0, -45, -2.2), 9.4, 9.4), 2.0)
    d = smooth_min(d, capsule(q, (0, -23.5, 2.0), (10.5, -23.5, 1.0), 4.4, 4.0), 2.5)
    d = smooth_min(d, capsule(q, (16, -21.4, -2.8), (18.2, -38, -2.5), 4.4, 4.2), 2.5)
    d = smooth_min(d, chain(q, [(2.0, -5, -4.4), (3.4, -11, -4.2), (5.0, -15, -4.4), (9, -17.2, -4.0), (15, -18.8, -3.2)], [1.7, 1.9, 2.4, 2.4, 2.0], 1.0), 2.2)
    bone = chain(q, [(1.4, -18.5, 3.3), (5, -18.2, 3.4), (9, -17.8, 2.2), (14, -17.6, -0.8)], [0.6, 0.5, 0.5, 0.6], 0.4)
    return smooth_min(d, bone, 2.0)


def bust(q):
    q = q.copy()
    q[:, 0] = np.sqrt(q[:, 0] ** 2 + 0.7)  # without a crease down the middle
    d = smooth_min(neck(q), shoulders(q), 2.4)
    return smooth_max(d, BOTTOM - q[:, 1], 0.5)
