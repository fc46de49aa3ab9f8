"""Neck and shoulders, in the frame of the head."""
import numpy as np
from common import capsule, chain, ellipsoid, smooth_max, smooth_min

BOTTOM = -25.0


def neck(q):
    d = capsule(q * np.array([1.0, 1, 0.93], np.float32), (0, -3, -1.6), (0, -19, -2.6), 5.5, 5.9)
    cord = chain(q, [(6.2, -3.2, -2.6), (4.9, -9, 0.2), (2.6, -14.5, 2.6), (1.0, -17.6, 3.6)], [0.9, 1.0, 0.8, 0.5], 0.4)
    d = smooth_min(d, cord, 1.1)
    d = smooth_min(d, ellipsoid(q, (0, -13.3, 2.9), (0.9, 1.3, 1.2)), 1.1)
    return d


def shoulders(q):
    d = ellipsoid(q, (0, -28, -2.2), (17, 12, 9.2))
    d = smooth_min(d, capsule(q, (0, -22.5, 1.7), (11, -22.5, 0.4), 4.2, 3.6), 2.5)
    d = smooth_min(d, capsule(q, (16, -21.4, -2.8), (17.8, -30, -2.5), 4.4, 4.4), 2.5)
    d = smooth_min(d, chain(q, [(2.2, -6, -5.2), (4.2, -14, -4.8), (9, -17.2, -4.0), (15, -18.8, -3.2)], [2.2, 2.6, 2.4, 2.0], 1.0), 2.2)
    bone = chain(q, [(1.4, -18.3, 3.7), (5, -18.0, 4.0), (9, -17.7, 2.8), (14, -17.5, -0.4)], [0.6, 0.5, 0.5, 0.6], 0.4)
    return smooth_min(d, bone, 2.0)


def bust(q):
    d = smooth_min(neck(q), shoulders(q), 2.4)
    return smooth_max(d, BOTTOM - q[:, 1], 0.5)
