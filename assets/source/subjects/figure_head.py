"""The head of the figure, in its own frame: centimetres, the face towards +z, chin at -2.7, crown at 2.8. And the veil over it."""
import numpy as np

from sdf import capsule, chain, ellipsoid, smooth_max, smooth_min, step


def mirrored(p):
    q = p.copy()
    q[:, 0] = np.abs(q[:, 0])
    return q


def face(p):
    q = mirrored(p)
    d = ellipsoid(q, (0, 0.6, -0.2), (1.9, 2.15, 2.35))
    d = smooth_min(d, ellipsoid(q, (0, -0.75, 0.65), (1.42, 1.95, 1.5)), 0.6)
    d = smooth_min(d, ellipsoid(q, (0, -2.2, 1.55), (0.5, 0.42, 0.45)), 0.5)          # chin
    d = smooth_min(d, ellipsoid(q, (0.85, -0.55, 1.25), (0.55, 0.65, 0.6)), 0.5)      # cheek
    d = smooth_max(d, -ellipsoid(q, (0.72, 0.12, 2.35), (0.55, 0.36, 0.42)), 0.35)    # socket
    d = smooth_min(d, chain(q, [(0.12, 0.52, 2.02), (0.6, 0.68, 1.92), (1.2, 0.5, 1.4)], [0.16, 0.17, 0.14], 0.1), 0.3)  # brow
    eye = ellipsoid(q, (0.72, 0.10, 1.62), (0.42, 0.34, 0.40))
    d = smooth_min(d, eye, 0.1)
    lid = [(0.38, 0.02, 1.99), (0.55, -0.09, 2.05), (0.74, -0.12, 2.05), (0.95, -0.07, 1.95), (1.1, 0.05, 1.78)]
    d = smooth_min(d, chain(q, lid, [0.05, 0.07, 0.07, 0.06, 0.04], 0.03), 0.06)      # closed lids
    d = smooth_min(d, capsule(q, (0, 0.6, 1.98), (0, -0.42, 2.5), 0.19, 0.25), 0.22)  # nose
    d = smooth_min(d, ellipsoid(q, (0, -0.5, 2.5), (0.24, 0.21, 0.24)), 0.1)
    d = smooth_min(d, ellipsoid(q, (0.24, -0.56, 2.24), (0.17, 0.16, 0.24)), 0.12)
    d = smooth_min(d, ellipsoid(q, (0, -1.25, 1.85), (0.75, 0.55, 0.42)), 0.3)        # muzzle
    d = smooth_min(d, chain(q, [(0, -1.12, 2.26), (0.16, -1.08, 2.24), (0.5, -1.24, 1.98)], [0.1, 0.12, 0.05], 0.05), 0.1)
    d = smooth_min(d, chain(q, [(0, -1.44, 2.2), (0.22, -1.42, 2.15), (0.46, -1.28, 2.0)], [0.16, 0.14, 0.05], 0.05), 0.1)
    d = smooth_max(d, -chain(q, [(0, -1.26, 2.36), (0.25, -1.25, 2.28), (0.52, -1.27, 2.05)], [0.035, 0.035, 0.03], 0.02), 0.08)  # between the lips
    return d


def hair(p):
    """Parted in the middle, in waves over the temples."""
    q = mirrored(p)
    d = ellipsoid(q, (0, 0.62, -0.3), (2.2, 2.4, 2.6))
    around = np.arctan2(q[:, 0], np.maximum(q[:, 1] + 1.0, 0.05))
    wave = np.sin(9 * around + 1.1 * np.sin(2.2 * q[:, 2])) * 0.11 * step(0.1, 0.9, q[:, 0])
    d = d - wave + 0.3 * np.exp(-(q[:, 0] / 0.18) ** 2)
    window = ellipsoid(q, (0, -0.75, 2.4), (1.42, 2.25, 2.1))
    return smooth_max(d, -window, 0.25)


def hood(p):
    """Cloth over the head, open around the face, a little pointed above the brow."""
    q = mirrored(p)
    around = np.arctan2(q[:, 0], q[:, 1] + 1.5)
    fold = 0.10 * np.sin(7 * around + 1.6 * q[:, 2]) * step(0.5, 1.6, q[:, 0])
    d = ellipsoid(q, (0, 0.55, -0.35), (2.55, 2.75, 2.95)) - fold
    d = smooth_min(d, capsule(q, (0, -0.3, -0.6), (0, -3.2, -0.9), 2.4, 2.7) - fold, 0.8)
    d = smooth_min(d, capsule(q, (0, 2.35, 1.3), (0, 2.3, -1.6), 0.55, 0.8), 1.2)
    return d


def opening(p):
    """What the hood leaves free: the face and the throat."""
    q = mirrored(p)
    d = ellipsoid(q, (0, -0.55, 2.9), (1.72, 2.75, 2.6))
    return smooth_min(d, capsule(q, (0, -2.0, 2.6), (0, -4.8, 3.4), 1.35, 1.1), 0.6)


def head(p):
    return smooth_min(face(p), hair(p), 0.06)


def rim(p):
    """The rolled edge of the hood."""
    return np.abs(opening(p)) + 0.6 * np.maximum(np.abs(hood(p)) - 0.05, 0) - 0.16
