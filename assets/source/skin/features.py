"""Nose, mouth and ears, in the frame of the head (centimetres, x to the side, y up, z to the face)."""
import numpy as np
from common import capsule, chain, curve, ellipsoid, length, smooth_max, smooth_min, step


def mirrored(p):
    q = p.copy()
    q[:, 0] = np.abs(q[:, 0])
    return q


# ---- the mouth: borders of the lips over x
def line_between(x):
    return curve(x, [0, 0.35, 0.9, 1.8, 2.55, 3.2], [-6.36, -6.30, -6.24, -6.30, -6.33, -6.40])


def border_above(x):
    return curve(x, [0, 0.3, 0.62, 1.1, 1.8, 2.3, 2.6], [-5.66, -5.58, -5.55, -5.72, -6.02, -6.24, -6.36])


def border_below(x):
    return curve(x, [0, 0.7, 1.3, 1.9, 2.35, 2.6], [-7.22, -7.18, -7.0, -6.74, -6.48, -6.38])


def lips(p):
    """How far the lips rise from the sheet beneath."""
    x, y = np.abs(p[:, 0]), p[:, 1]
    middle, above, below = line_between(x), border_above(x), border_below(x)
    up, down = (y - middle) / np.maximum(above - middle, 0.05), (middle - y) / np.maximum(middle - below, 0.05)
    full = np.clip(1 - (x / 2.7) ** 2, 0, 1)
    upper = curve(up, [0, 0.18, 0.45, 0.8, 1.0, 1.25, 2.0, 3.2], [0.13, 0.24, 0.33, 0.32, 0.265, 0.16, 0.05, 0.0])
    lower = curve(down, [0, 0.15, 0.42, 0.75, 1.0, 1.3, 1.9], [0.15, 0.29, 0.42, 0.36, 0.2, 0.05, 0.0])
    rise = np.where(y > middle, upper, lower) * full
    crease = 0.095 * np.exp(-((y - middle) / 0.085) ** 2) * step(2.35, 1.2, x)
    corner = 0.09 * np.exp(-(((x - 2.62) / 0.3) ** 2 + ((y + 6.36) / 0.3) ** 2)) - 0.06 * np.exp(-(((x - 3.2) / 0.45) ** 2 + ((y + 6.4) / 0.7) ** 2))
    groove = 0.085 * np.exp(-(x / 0.28) ** 2) * step(-5.65, -5.25, y) * step(-4.2, -4.6, y)
    ridges = 0.05 * np.exp(-((x - 0.58) / 0.2) ** 2) * step(-5.8, -5.4, y) * step(-4.2, -4.7, y)
    return rise - crease - corner - groove + ridges


def fold(p):
    """Folds from the wings of the nose to beside the mouth."""
    x, y = np.abs(p[:, 0]), p[:, 1]
    at = curve(-y, [3.0, 3.8, 4.8, 6.0, 7.2], [1.95, 2.2, 2.75, 3.3, 3.6])
    side = x - at
    strength = step(-7.2, -5.2, y) * step(-3.0, -3.9, y)
    return strength * (0.06 * np.exp(-((side - 0.6) / 0.6) ** 2) - 0.05 * np.exp(-((side + 0.05) / 0.35) ** 2))


# ---- the nose
def nose(d, p):
    """The nose onto the face d."""
    q = mirrored(p)
    flank = chain(q, [(0.25, -0.9, 9.6), (0.45, -1.9, 9.9), (0.78, -2.9, 10.25)], [0.42, 0.55, 0.64], 0.3)
    bridge = chain(q, [(0, 0.7, 9.55), (0, -0.4, 10.0), (0, -1.8, 10.9), (0, -2.9, 11.5)], [0.55, 0.54, 0.52, 0.6], 0.3)
    d = smooth_min(d, smooth_min(bridge, flank, 0.8), 1.1)
    tip = smooth_min(bridge, ellipsoid(q, (0, -3.28, 11.66), (0.86, 0.68, 0.8)), 0.5)
    n = smooth_min(tip, capsule(q, (0, -3.75, 11.7), (0, -4.3, 10.4), 0.33, 0.34), 0.3)              # between the nostrils
    n = smooth_min(n, ellipsoid(q, (1.14, -3.56, 10.72), (0.56, 0.58, 0.92)), 0.42)                  # wing
    d = smooth_min(d, n, 0.4)
    crease = chain(q, [(1.52, -2.75, 11.0), (1.70, -3.1, 10.55), (1.82, -3.6, 10.15), (1.78, -4.0, 10.05), (1.66, -4.3, 10.3)], [0.03, 0.07, 0.09, 0.07, 0.03], 0.05)
    d = smooth_max(d, -crease, 0.3)
    lean = np.clip(q[:, 2:3] - 10.9, -1, 1) * np.array([-0.3, 0.1, 0], np.float32)
    hole = ellipsoid(q - lean.astype(np.float32), (0.74, -4.26, 10.88), (0.33, 0.6, 0.62))
    hole = smooth_min(hole, ellipsoid(q, (1.02, -3.78, 10.72), (0.36, 0.42, 0.62)), 0.12)            # the wing is thin
    return smooth_max(d, -hole, 0.16)


# ---- the eyes, shut
def lash_line(x):
    return curve(x, [1.35, 1.8, 2.5, 3.3, 4.1, 4.8, 5.2], [0.55, 0.28, 0.08, 0.0, 0.08, 0.32, 0.52])


def lid_fold(x):
    return curve(x, [1.6, 2.2, 3.0, 3.8, 4.6, 5.2], [0.85, 1.15, 1.32, 1.3, 1.08, 0.8])


def lids(p):
    """Where the lids meet, and the fold above the upper one."""
    x, y = np.abs(p[:, 0]), p[:, 1]
    side = y - lash_line(x)
    ends = step(1.3, 1.7, x) * step(5.25, 4.9, x)
    meet = 0.03 * step(-0.04, 0.06, side) * step(0.5, 0.1, side) - 0.045 * np.exp(-((side + 0.01) / 0.06) ** 2)
    above = -0.025 * np.exp(-((y - lid_fold(x)) / 0.1) ** 2) * step(1.6, 2.2, x) * step(5.2, 4.6, x)
    return meet * ends + above
