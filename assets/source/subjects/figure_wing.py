"""A wing of the figure in its own frame: a along its spread, b upwards, c its thickness, centimetres from the shoulder. Feathers lie like shingles."""
import numpy as np

from sdf import chain, smooth_max, smooth_min

ARM = np.array([(0, 0), (1.2, 3.6), (3.6, 7.4), (6.6, 9.6), (8.8, 8.6), (10.0, 6.2)])
TIPS = np.array([(0.4, -7.5), (1.4, -11.5), (2.8, -15.4), (4.4, -18.6), (6.4, -21.0), (8.6, -20.2), (10.6, -15.5), (11.8, -8.0)])
MIDDLE = np.array([(0.4, -3.2), (1.8, -3.6), (4.0, -3.0), (6.4, -2.4), (8.4, -2.0), (10.2, -1.2), (11.2, 0.4), (11.6, 2.2)])
SHORT = np.array([(0.3, -0.9), (1.7, 0.4), (3.6, 2.0), (5.8, 3.4), (8.0, 3.6), (9.8, 3.0), (10.9, 3.6), (11.1, 4.6)])


def along(points, t):
    """A smooth curve through points, t in [0, 1]."""
    x = t * (len(points) - 1)
    i = int(min(x, len(points) - 2))
    u = x - i
    p = points[[max(i - 1, 0), i, i + 1, min(i + 2, len(points) - 1)]]
    return 0.5 * (2 * p[1] + (p[2] - p[0]) * u + (2 * p[0] - 5 * p[1] + 4 * p[2] - p[3]) * u ** 2 + (3 * (p[1] - p[2]) + p[3] - p[0]) * u ** 3)


def feather(q, root, tip, half, thick, lift, bend):
    """One vane: q [n, 3]; half is its half-width, lift its height above the wing's middle, bend how far its tip sways."""
    root, tip = np.asarray(root), np.asarray(tip)
    size = np.linalg.norm(tip - root)
    out = (tip - root) / size
    local = q[:, :2] - root
    u = local @ out / size
    s = local @ np.array([-out[1], out[0]]) - bend * np.sin(np.pi * np.clip(u, 0, 1)) * size
    uc = np.clip(u, 0, 1)
    width = half * (0.6 + 0.4 * np.minimum(uc / 0.3, 1)) * np.sqrt(np.maximum(1 - (np.maximum(uc - 0.7, 0) / 0.3) ** 2.4, 0))
    flat = np.maximum(np.abs(s) - width, np.maximum(-u, u - 1) * size)
    c = q[:, 2] - lift - 0.2 * s / half
    vane = thick * (1 - 0.25 * uc - 0.25 * np.minimum((s / half) ** 2, 1)) + 0.05 * np.exp(-(s / 0.1) ** 2) * (1 - 0.5 * uc)
    return smooth_max(0.85 * flat, np.abs(c) - vane, 0.1)


def row(d, q, roots, tips, count, half, thick, lift, bend, seam):
    for i in range(count):
        t = (i + 0.5) / count
        root, tip = np.asarray(roots(t)), along(tips, t)
        wide = half * (0.85 + 0.3 * np.sin(2.2 * t + 0.4))
        axis = (tip - root) / np.linalg.norm(tip - root)
        local = q[:, :2] - root
        size = np.linalg.norm(tip - root)
        u, s = local @ axis, local @ np.array([-axis[1], axis[0]])
        near = np.flatnonzero((np.abs(s) < wide + 1.0) & (u > -0.8) & (u < size + 0.8))
        if len(near):
            d[near] = smooth_min(d[near], feather(q[near], root, tip, wide, thick, lift, bend), seam)
    return d


def camber(a, b):
    """How far the wing's middle lies before its plane: cupped, its tips swept back."""
    return 0.010 * (a - 5) ** 2 - 0.0022 * np.minimum(b - 4, 0) ** 2 + 0.2


def wing(q):
    """Signed distance; both faces are alike."""
    q = q.copy()
    q[:, 2] = np.abs(q[:, 2] - camber(q[:, 0], q[:, 1]))
    near = np.flatnonzero(q[:, 2] < 1.6)
    d = q[:, 2] - 0.8
    d[near] = _feathered(q[near])
    return d


def _arm(t):
    return along(ARM, 0.12 + 0.88 * t)


def _feathered(q):
    d = np.full(len(q), 0.8, np.float32)
    d = row(d, q, _arm, TIPS, 15, 0.95, 0.17, 0.0, 0.015, 0.10)
    d = row(d, q, _arm, MIDDLE, 14, 0.85, 0.16, 0.27, 0.02, 0.10)
    d = row(d, q, _arm, SHORT, 13, 0.72, 0.15, 0.54, 0.02, 0.10)
    bones = [np.append(along(ARM, t), 0) for t in np.linspace(0, 1, 9)]
    bone = chain(q, bones, [1.0, 0.95, 0.9, 0.85, 0.8, 0.75, 0.66, 0.55, 0.4], 0.1)
    scale = 0.07 * np.abs(np.sin(4.2 * (q[:, 0] + 0.4 * q[:, 1])) * np.sin(3.1 * (q[:, 1] - 0.5 * q[:, 0])))
    return smooth_min(d, bone - scale, 0.12)
