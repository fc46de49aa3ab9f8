"""The figure: an angel at prayer under a veil, 45 cm tall, out of signed distances in centimetres. y = 0 is the foot of the plinth; it faces +z."""
import numpy as np

import figure_head
import figure_wing
from sdf import boxed, capsule, chain, curve, ellipsoid, ridges, smooth_max, smooth_min, step, triangle, turned

LOW, HIGH = np.array([-14.5, -0.6, -11.5]), np.array([14.5, 46.0, 9.5])
HEIGHTS = np.array([2.0, 4.5, 8.0, 13.0, 18.0, 22.0, 26.0, 30.0, 33.0, 35.2, 37.0])
WIDE = np.array([6.9, 6.1, 5.3, 4.75, 4.6, 4.5, 3.35, 3.9, 4.9, 4.3, 1.5])
DEEP = np.array([6.0, 5.2, 4.5, 4.0, 3.8, 3.6, 2.6, 2.9, 2.7, 2.2, 1.4])


def radius(angle, y, more=0.0):
    wide, deep = curve(y, HEIGHTS, WIDE) + more, curve(y, HEIGHTS, DEEP) + more
    return wide * deep / np.sqrt((deep * np.sin(angle)) ** 2 + (wide * np.cos(angle)) ** 2)


def around(p):
    """Angle about the body's axis (0 in front, positive to +x) and distance from it; the axis sways as the weight rests on one leg."""
    y = p[:, 1]
    x = p[:, 0] + 0.55 * np.exp(-((y - 20) / 7) ** 2) - 0.25 * np.exp(-((y - 33) / 5) ** 2)
    z = p[:, 2] + 0.25 * np.exp(-((y - 22) / 6) ** 2)
    return np.arctan2(x, z), np.hypot(x, z)


def gown(p):
    """The long skirt, falling in folds from the waist to the ground, and the leg that bears no weight."""
    y = p[:, 1]
    angle, rho = around(p)
    knee = chain(p, [(1.6, 22.5, 0.4), (2.35, 13.8, 3.3), (2.9, 4.4, 1.6)], [2.5, 1.75, 1.6], 0.5)
    deep = (0.2 + 0.8 * step(25, 18, y) + 1.5 * step(19, 4, y)) * (1 - 0.7 * step(2.0, 0.2, knee))
    a = angle + 0.22 * np.sin(2 * angle + 0.6) + 0.10 * np.sin(5 * angle + 0.11 * y)
    first = ridges(4.5 * a + 0.35 * np.sin(0.16 * y + 1.0), 0.04)
    second = ridges(8.5 * a + 0.5 * np.sin(0.21 * y), 0.06)
    share = 0.5 + 0.5 * np.sin(2.0 * angle + 0.09 * y)
    fold = deep * (first * (0.55 + 0.45 * share) + 0.5 * second * (1 - 0.6 * share) - 0.7)
    hem = 0.5 * step(5.5, 2.5, y)
    d = 0.8 * (rho - radius(angle, y) - fold - hem)
    d = smooth_min(d, knee - 0.25 * ridges(2.2 * p[:, 0] - 0.35 * y, 0.2), 1.3)
    d = smooth_max(d, y - 27.0, 0.5)
    return smooth_max(d, 2.4 - y, 0.2)


def bodice(p):
    """The upper garment: girded, its overfold ending at the hips in a thin waved lip."""
    y = p[:, 1]
    angle, rho = around(p)
    a = angle + 0.15 * np.sin(3 * angle + 1.0)
    hem = 19.6 + 0.55 * np.sin(5 * a + 0.5) + 0.35 * np.sin(9 * a) - 0.9 * np.cos(angle)
    low = step(25.6, 19.5, y)
    fold = (0.2 + 0.8 * low) * (ridges(5.5 * a + 0.2 * np.sin(0.3 * y), 0.05) - 0.6) + 0.16 * (ridges(11 * a - 0.25 * y, 0.08) - 0.5) * step(36, 33, y)
    d = 0.85 * (rho - radius(angle, y, 0.30) - fold - 0.75 * low ** 1.5)
    d = smooth_max(d, hem - y, 0.22)
    under = 0.85 * (rho - radius(angle, y, 0.30) - fold - 0.75 * low ** 1.5 + 0.42)                  # hollow behind the lip
    d = smooth_max(d, -np.maximum(under, y - hem - 1.3), 0.15)
    cord = np.hypot(rho - radius(angle, y, 0.22), y - 26.0 + 0.15 * np.cos(angle)) - 0.30
    d = smooth_min(smooth_max(d, y - 36.0, 0.6), cord, 0.08)
    q = figure_head.mirrored(p)
    return smooth_min(d, ellipsoid(q, (1.75, 30.4, 2.0), (1.5, 1.6, 1.35)), 0.8)


def arms(p):
    """Arms bent to joined hands, in wide sleeves that hang."""
    q = figure_head.mirrored(p)
    elbow, wrist = (5.0, 27.0, 1.0), (0.85, 30.2, 5.1)
    wrinkle = 0.2 * (ridges(1.3 * (q[:, 1] + 0.7 * q[:, 0] - 0.9 * q[:, 2]) + 0.5 * np.sin(q[:, 0] + q[:, 2]), 0.1) - 0.5)
    upper = capsule(q, (3.9, 33.4, -0.2), elbow, 1.4, 1.75) - wrinkle
    lower = capsule(q, elbow, (2.2, 29.2, 4.0), 1.7, 1.5) - wrinkle
    bare = capsule(q, (2.4, 29.0, 3.8), wrist, 0.95, 0.62)
    fan = np.arctan2(elbow[1] - q[:, 1], np.hypot(q[:, 0] - elbow[0], q[:, 2] - elbow[2]) + 0.6)
    hanging = np.minimum(triangle(q, elbow, (1.9, 29.5, 4.3), (2.5, 22.2, 4.9)), triangle(q, elbow, (2.5, 22.2, 4.9), (4.3, 21.0, 3.4)))
    hanging = hanging - 0.40 - 0.5 * (ridges(6.2 * fan + 0.4, 0.04) - 0.4)
    sleeve = smooth_min(smooth_min(upper, lower, 0.5), hanging, 0.7)
    mouth = capsule(q, (2.0, 29.3, 4.3), (0.2, 30.6, 5.8), 0.98, 1.5)
    sleeve = smooth_max(sleeve, -mouth, 0.15)
    palm = ellipsoid(turned(q, (0.34, 32.0, 5.5), pitch=-12), (0, 0, 0), (0.36, 1.75, 0.85))
    d = smooth_min(bare, palm, 0.5)
    for i, (z, top) in enumerate(((-0.5, 1.9), (-0.16, 2.45), (0.2, 2.55), (0.54, 2.1))):
        h = turned(q, (0.26, 32.2, 5.55), pitch=-12)
        d = smooth_min(d, capsule(h, (0.06, 0.4, z * 1.15), (0.0, top, z), 0.25, 0.17), 0.06)
    h = turned(q, (0.26, 32.2, 5.55), pitch=-12)
    d = smooth_min(d, capsule(h, (0.2, -0.6, -0.75), (0.05, 1.0, -0.95), 0.26, 0.19), 0.1)
    return smooth_min(sleeve, d, 0.06)


def veil(p):
    """The cloth that falls from the head over the shoulders and down the back."""
    y = p[:, 1]
    heights = [17, 21, 25, 29, 32, 34, 36, 38, 40]
    wide = curve(y, heights, [7.4, 7.2, 7.1, 6.95, 6.7, 6.1, 4.5, 3.2, 2.3])
    deep = curve(y, heights, [5.4, 5.0, 4.6, 4.3, 4.1, 3.7, 3.2, 2.7, 2.1])
    x, z = p[:, 0], p[:, 2] + 0.5
    angle, rho = np.arctan2(x / wide, z / deep), np.hypot(x / wide, z / deep)
    size = wide * deep / np.hypot(deep * np.sin(angle), wide * np.cos(angle))
    a = angle + 0.10 * np.sin(4 * angle + 0.5) + 0.05 * np.sin(0.35 * y)
    fold = (0.10 + 1.0 * step(37, 24, y)) * (ridges(7.5 * a + 0.25 * np.sin(0.3 * y), 0.05) - 0.55 + 0.4 * (ridges(13.5 * a + 0.2 * y * 0.3, 0.1) - 0.5))
    d = 0.8 * ((rho - 1) * size - fold)
    d = smooth_max(d, y - 39.3, 1.5)
    hem = 22.4 + 3.6 * np.cos(angle) + 0.35 * np.sin(15 * a)
    d = smooth_max(d, hem - y, 0.12)
    d = smooth_max(d, -np.maximum(d + 0.45, y - hem - 2.0), 0.15)  # hollow below: the hem is cloth
    cloth = smooth_min(d, boxed(lambda q: figure_head.hood(in_head(q)), p, (-4.5, 33, -5), (4.5, 44.5, 6)), 1.3)
    slit = capsule(p, (0, 38.8, 4.4), (0, 24.0, 7.6), 2.0, 5.4)
    window = boxed(lambda q: figure_head.opening(in_head(q)), p, (-4, 32, 0), (4, 43, 8))
    return smooth_max(smooth_max(cloth, -slit, 0.18), -window, 0.12)


def wings(p):
    q = figure_head.mirrored(p)
    out, back = np.cos(np.radians(24)), np.sin(np.radians(24))
    x, y, z = q[:, 0] - 1.6, q[:, 1] - 32.8, q[:, 2] + 3.6
    lean = np.radians(7)
    y, z = np.cos(lean) * y - np.sin(lean) * z, np.sin(lean) * y + np.cos(lean) * z
    local = np.stack([out * x - back * z, y, back * x + out * z], -1)
    return figure_wing.wing(local.astype(np.float32))


def plinth(p):
    """An octagon with rounded edges and a moulding."""
    q = np.abs(p[:, [0, 2]] * np.array([0.93, 1.0], np.float32))
    away = np.maximum(np.maximum(q[:, 0], q[:, 1]), (q[:, 0] + q[:, 1]) / np.sqrt(2))
    y = p[:, 1]
    step_in = 8.6 - 0.7 * step(1.0, 1.25, y) + 0.45 * step(1.95, 2.15, y)
    return smooth_max(away - step_in, np.abs(y - 1.4) - 1.4, 0.25)


def foot(p):
    return smooth_min(capsule(p, (2.6, 3.5, 4.0), (3.1, 3.15, 6.6), 1.0, 0.62), ellipsoid(p, (3.2, 3.0, 7.1), (0.65, 0.42, 0.6)), 0.3)


def in_head(p):
    """The head's frame: nodding, and a little turned."""
    return turned(p, (0, 36.0, 0.0), pitch=16, yaw=9, roll=3) - np.array([0, 3.6, 0.5], np.float32)


def head(p):
    q = in_head(p)
    return smooth_min(figure_head.head(q), figure_head.rim(q), 0.1)


def shoulders(p):
    d = chain(figure_head.mirrored(p), [(0, 35.4, -0.5), (3.9, 33.9, -0.4)], [1.5, 1.5], 0.3)
    return smooth_min(d, capsule(p, (0, 34.5, -0.2), (0, 38.5, 0.6), 1.3, 1.25), 0.5)


def distance(p):
    d = smooth_min(boxed(gown, p, (-9, 2, -8), (9, 27.5, 8)), boxed(bodice, p, (-7, 17, -7), (7, 37, 7)), 0.12)
    d = smooth_min(d, boxed(shoulders, p, (-6, 32, -3), (6, 40, 3)), 0.6)
    d = smooth_min(d, boxed(arms, p, (-8, 20, -3), (8, 36, 7.5)), 0.15)
    d = smooth_min(d, smooth_min(boxed(veil, p, (-8.5, 17, -7.5), (8.5, 44.5, 6)), boxed(head, p, (-4.5, 33, -4), (4.5, 44.5, 6)), 0.1), 0.10)
    d = smooth_min(d, boxed(wings, p, (-15, 7, -12), (15, 45.5, -1)), 0.3)
    d = smooth_min(d, boxed(foot, p, (1, 2, 2), (5, 5, 8)), 0.1)
    return smooth_min(d, boxed(plinth, p, (-9.5, -0.2, -9), (9.5, 3, 9)), 0.25).astype(np.float32)


def detail(points):
    """How much of its triangles a place keeps, in [0, 1]: the face and the hands most, then the wings."""
    face, hands = points - np.array([0.6, 39.0, 2.5]), points - np.array([0, 32.4, 5.4])
    near = np.minimum(np.sqrt((face ** 2).sum(-1)) - 3.0, np.sqrt((hands ** 2).sum(-1)) - 2.6)
    return np.where(near < 0, 0.95, np.where(np.abs(points[:, 0]) > 7.5, 0.45, 0.25))
