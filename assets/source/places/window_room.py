"""window_room.glb: a dark room with a window of six panes; drift.raw: smoke that hangs in sheets before it."""
import json

import numpy as np

from shapes import box, fractal, lathe, matte, merged, write_glb

# Metres. The window is in the wall at x = 2.5; the sun comes in from +X.
WALL, LOW, HIGH, NEAR, FAR = 2.5, 0.95, 2.55, 0.75, -0.75


def walls():
    thick = WALL + 0.32
    return merged([
        box((WALL, 0, -3.2), (thick, 3.2, FAR)), box((WALL, 0, NEAR), (thick, 3.2, 3.2)),          # beside the window
        box((WALL, 0, FAR), (thick, LOW, NEAR)), box((WALL, HIGH, FAR), (thick, 3.2, NEAR)),       # below and above it
        box((-3.2, 0, -3.5), (thick, 3.2, -3.2)), box((-3.2, 0, 3.2), (thick, 3.2, 3.5)), box((-3.5, 0, -3.5), (-3.2, 3.2, 3.5)),
        box((-3.5, 3.2, -3.5), (thick, 3.5, 3.5)),                                                 # the ceiling
        box((WALL - 0.02, 0, -3.2), (WALL, 0.14, 3.2)), box((-3.2, 0, -3.2), (WALL, 0.14, -3.18)),  # skirting
    ])


def boards():
    """The floor: boards with joints, each a little higher or lower than the next."""
    random = np.random.default_rng(3)
    parts = []
    for i, x in enumerate(np.arange(-3.5, 2.82, 0.16)):
        start = -3.5 + random.uniform(-1.2, 0)
        while start < 3.5:
            end = start + random.uniform(1.6, 2.6)
            parts.append(box((x + 0.002, -0.1, max(start, -3.5) + 0.002), (x + 0.158, random.uniform(-0.003, 0.0), min(end, 3.5))))
            start = end
    return merged(parts)


def frame():
    deep = (WALL + 0.1, WALL + 0.17)
    parts = [box((deep[0] - 0.01, LOW, z - h), (deep[1] + 0.01, HIGH, z + h)) for z, h in ((FAR, 0.05), (0, 0.03), (NEAR, 0.05))]
    parts += [box((deep[0], y - h, FAR), (deep[1], y + h, NEAR)) for y, h in ((LOW, 0.05), (LOW + 0.54, 0.022), (LOW + 1.07, 0.022), (HIGH, 0.05))]
    parts.append(box((WALL - 0.14, LOW - 0.045, FAR - 0.1), (WALL + 0.12, LOW, NEAR + 0.1)))  # the sill
    return merged(parts)


def table():
    top, x0, x1, z0, z1 = 0.76, 0.55, 1.45, -0.85, 0.55
    legs = [box((x, 0, z), (x + 0.06, top - 0.03, z + 0.06)) for x in (x0 + 0.03, x1 - 0.09) for z in (z0 + 0.03, z1 - 0.09)]
    rail = [box((x0 + 0.04, top - 0.12, z), (x1 - 0.04, top - 0.03, z + 0.025)) for z in (z0 + 0.05, z1 - 0.075)]
    books = [box((0.72, top, -0.62), (0.99, top + 0.05, -0.26)), box((0.74, top + 0.05, -0.60), (0.97, top + 0.085, -0.29))]
    return merged([box((x0, top - 0.035, z0), (x1, top, z1)), *legs, *rail, *books])


def chair():
    x, z = 0.05, -0.05
    legs = [box((a, 0, b), (a + 0.045, h, b + 0.045)) for a, b, h in
            ((x, z, 1.02), (x, z + 0.4, 1.02), (x + 0.4, z, 0.46), (x + 0.4, z + 0.4, 0.46))]
    slats = [box((x + 0.005, y, z), (x + 0.03, y + 0.07, z + 0.44)) for y in (0.62, 0.78, 0.94)]
    return merged([box((x - 0.01, 0.44, z - 0.01), (x + 0.46, 0.475, z + 0.455)), *legs, *slats])


def bowl():
    return merged([lathe(((0.0, 0.01), (0.05, 0.0), (0.055, 0.015), (0.1, 0.06), (0.108, 0.085), (0.1, 0.085), (0.06, 0.03), (0.0, 0.025)), 24, (1.1, 0.76, 0.2))])


SIZE, LOWEST, HIGHEST = (84, 58, 68), np.array([-1.7, 0.05, -1.6]), np.array([2.45, 2.93, 1.76])


def density():
    """Smoke that rises from the bowl, spreads under the warm air and folds: thin sheets where a warped field has its zeros."""
    axes = [l + (np.arange(n) + 0.5) / n * (h - l) for n, l, h in zip(SIZE, LOWEST, HIGHEST)]
    x, y, z = np.meshgrid(*axes, indexing="ij")
    p = np.stack([x, y, z], -1)
    warp = np.stack([fractal(p * [0.55, 0.8, 0.55] + 17 * i, 4, 31 * i) for i in range(3)], -1) - 0.5
    q = p + 1.5 * warp
    sheets = np.zeros(SIZE)
    for i, (scale, width, weight) in enumerate(((0.9, 0.055, 1.0), (1.5, 0.07, 0.6))):
        field = fractal(q * [scale, 1.6 * scale, scale] + 5 * i, 3, 100 + i) - 0.5
        sheets += weight * np.exp(-(field / width) ** 2)
    body = fractal(q * 0.8, 4, 77)
    height = np.clip((y - 0.5) / 0.7, 0, 1) * np.clip((2.9 - y) / 0.5, 0, 1)
    edge = np.ones(SIZE)
    for axis, coordinate in enumerate((x, y, z)):
        edge *= np.clip((coordinate - LOWEST[axis]) / 0.35, 0, 1) * np.clip((HIGHEST[axis] - coordinate) / 0.35, 0, 1)
    thread = np.hypot(x - 1.1 - 0.10 * np.sin(4 * y) * np.clip(y - 0.8, 0, 2), z - 0.2 - 0.12 * np.cos(3.3 * y) * np.clip(y - 0.8, 0, 2))
    width = 0.03 + 0.14 * np.clip(y - 0.8, 0, 3)
    rising = np.exp(-(thread / width) ** 2) * (y > 0.82) * np.clip((2.4 - y) / 1.0, 0, 1) * (0.03 / width) ** 0.7 * 1.4
    return np.clip(edge * (height * (0.10 * body + sheets * np.clip((body - 0.42) * 3.2, 0, 1)) + rising), 0, 1)


def make(folder):
    write_glb(folder / "window_room.glb", {
        "walls": (walls(), matte((0.30, 0.27, 0.22))),
        "boards": (boards(), matte((0.16, 0.095, 0.055))),
        "frame": (frame(), matte((0.34, 0.31, 0.27))),
        "table": (table(), matte((0.14, 0.075, 0.04))),
        "chair": (chair(), matte((0.11, 0.06, 0.035))),
        "bowl": (bowl(), matte((0.45, 0.24, 0.12), True)),
    })
    values = np.round(255 * density()).astype(np.uint8)
    (folder / "drift.raw").write_bytes(values.transpose(2, 1, 0).tobytes())
    about = dict(about="Smoke that drifts through a room.", raw="drift.raw", type="u8", size=list(SIZE), voxel_m=[0.0494, 0.0497, 0.0494])
    (folder / "drift.json").write_text(json.dumps(about) + "\n")
