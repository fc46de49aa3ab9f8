"""The lower half of the head without nose, lips and ears: how far the skin is from the head's axis, a smooth sheet through points on cheeks, jaw and chin, which
joins the MRI above without a step. In centimetres."""
import numpy as np
from scipy import ndimage, sparse
from scipy.sparse import linalg

COLUMNS, ROWS = 240, 80
LOW, STEP = -15.0, 0.25                 # the lowest row, and from row to row
KNOWN = -0.9                            # rows above are the MRI's

# The skin of the right half, x to the side, y up, z to the face: from the midline to the nape.
POINTS = np.array([
    (0, -4.3, 10.45), (0, -5.0, 10.65), (0, -5.6, 10.75), (0, -6.3, 10.65), (0, -7.0, 10.45), (0, -7.7, 10.1), (0, -8.4, 10.35), (0, -9.2, 10.6), (0, -10.0, 10.4),
    (0, -10.6, 9.8), (0, -12, 9.2), (1.6, -2.0, 9.5), (2.0, -3.5, 9.75), (3.0, -3.5, 9.3), (4.5, -3.3, 8.35), (6.0, -3.3, 6.4), (6.75, -3.3, 4.0), (7.0, -3.3, 2.0),
    (5.2, -1.2, 7.95), (6.3, -1.2, 6.6), (7.05, -1.0, 4.0), (7.2, -1.0, 2.0), (1.5, -4.5, 10.2), (2.6, -4.6, 9.6), (3.6, -4.6, 8.9), (4.6, -4.6, 7.7), (5.65, -4.6, 5.9),
    (6.4, -4.6, 4.0), (6.7, -4.6, 2.0), (6.7, -4.6, 0), (1.4, -6.3, 10.25), (2.6, -6.3, 9.5), (3.6, -6.3, 8.6), (4.6, -6.3, 7.15), (5.4, -6.3, 5.4), (6.0, -6.3, 3.4),
    (6.15, -6.3, 1.5), (6.2, -6.3, 0), (1.2, -8.0, 10.0), (2.2, -8.0, 9.35), (3.2, -8.0, 8.35), (4.2, -8.0, 6.9), (5.0, -8.0, 5.1), (5.55, -8.0, 3), (5.7, -8.0, 1),
    (5.6, -8.0, -0.5), (0.8, -9.3, 10.45), (1.6, -9.3, 9.9), (2.4, -9.3, 8.9), (3.3, -9.3, 7.5), (4.2, -9.3, 5.8), (4.9, -9.3, 4), (5.2, -9.3, 2), (1.0, -10.5, 9.6),
    (2.0, -10.5, 8.7), (3.0, -10.5, 7.0), (3.9, -10.5, 5.3), (4.6, -10.5, 3.4), (5.0, -10.5, 1.5), (1.0, -12, 9.0), (2, -12, 8.0), (3, -12, 6.3), (4.3, -12, 3.4),
    (7.1, -2, 0.5), (6.5, -4, -2), (5.2, -5, -4.2), (3, -5, -6.2), (0, -5, -6.9), (0, -3, -8.2), (5.6, -8, -2), (3, -8, -5.4), (0, -8, -6.0), (0, -12, -5.8),
    (4, -12, -4.5), (5, -12, -1)])


def cylinder(p):
    return np.arctan2(p[:, 0], p[:, 2]), np.hypot(p[:, 0], p[:, 2])


def measured(mri):
    """The radius of the MRI's skin on the grid, NaN where it isn't to be used: below, at the ears, on the nose."""
    angle = (np.arange(COLUMNS) / COLUMNS * 2 - 1) * np.pi
    y = LOW + STEP * np.arange(ROWS)
    radius = np.full((ROWS, COLUMNS), np.nan)
    r = np.arange(4, 13, 0.04)
    for row in np.flatnonzero(y > KNOWN):
        for column, a in enumerate(angle):
            side = abs(np.degrees(a))
            at_ear = 60 < side < 136 and y[row] < 3.6 or side > 40 and y[row] < 0.6
            at_nose = side < 14 and y[row] < 1.2
            if at_ear or at_nose:
                continue
            d = mri(np.stack([r * np.sin(a), np.full_like(r, y[row]), r * np.cos(a)], -1))
            inside = np.flatnonzero(d < 0)
            if len(inside):
                radius[row, column] = r[inside[-1]]
    return radius


def sheet(mri):
    """The radius on the grid: least bending through what is known."""
    known = measured(mri)
    number = np.arange(ROWS * COLUMNS).reshape(ROWS, COLUMNS)
    rows, columns, values, right = [], [], [], []
    count = 0

    def equations(index, weight, value):
        nonlocal count
        n = len(index)
        rows.append(np.repeat(np.arange(n) + count, index.shape[1]))
        columns.append(index.ravel())
        values.append(weight.ravel())
        right.append(value)
        count += n

    east, west = np.roll(number, -1, 1), np.roll(number, 1, 1)
    bend = np.stack([west.ravel(), number.ravel(), east.ravel()], -1)
    equations(bend, np.tile([1.0, -2, 1], (len(bend), 1)), np.zeros(len(bend)))
    bend = np.stack([number[:-2].ravel(), number[1:-1].ravel(), number[2:].ravel()], -1)
    equations(bend, np.tile([1.0, -2, 1], (len(bend), 1)), np.zeros(len(bend)))
    twist = np.stack([number[:-1].ravel(), east[:-1].ravel(), number[1:].ravel(), east[1:].ravel()], -1)
    equations(twist, np.tile([1.4, -1.4, -1.4, 1.4], (len(twist), 1)), np.zeros(len(twist)))
    there = np.isfinite(known)
    equations(number[there][:, None], np.full((there.sum(), 1), 3.0), 3 * known[there])
    points = np.concatenate([POINTS, POINTS * (-1, 1, 1)])
    angle, radius = cylinder(points)
    u, v = (angle / np.pi + 1) / 2 * COLUMNS, (points[:, 1] - LOW) / STEP
    i, j = np.floor(u).astype(int), np.floor(v).astype(int)
    s, t = u - i, v - j
    index = np.stack([number[j, i % COLUMNS], number[j, (i + 1) % COLUMNS], number[j + 1, i % COLUMNS], number[j + 1, (i + 1) % COLUMNS]], -1)
    weight = np.stack([(1 - s) * (1 - t), s * (1 - t), (1 - s) * t, s * t], -1)
    equations(index, 0.6 * weight, 0.6 * radius)
    a = sparse.csr_matrix((np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))), shape=(count, ROWS * COLUMNS))
    solution = linalg.spsolve((a.T @ a).tocsc(), a.T @ np.concatenate(right))
    return solution.reshape(ROWS, COLUMNS)


class Base:
    def __init__(self, mri):
        wide = np.pad(sheet(mri), ((0, 0), (4, 4)), mode="wrap")
        self.grid = ndimage.spline_filter(wide, 3)

    def __call__(self, p):
        """Distance to the sheet, made even by its slope."""
        angle, radius = cylinder(p)
        at = np.stack([(p[:, 1] - LOW) / STEP, (angle / np.pi + 1) / 2 * COLUMNS + 4])
        look = lambda dy, da: ndimage.map_coordinates(self.grid, at + np.array([[dy], [da]]), order=3, prefilter=False, mode="nearest")
        r = look(0, 0)
        up = (look(0.5, 0) - look(-0.5, 0)) / STEP
        around = (look(0, 0.5) - look(0, -0.5)) / (2 * np.pi / COLUMNS) / np.maximum(radius, 3)
        return ((radius - r) / np.sqrt(1 + up * up + around * around)).astype(np.float32)
