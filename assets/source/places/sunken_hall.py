"""sunken_hall.glb: a vaulted hall under water with a grating in its roof; caustics.png: sunlight that waves have gathered."""
import struct
import zlib

import numpy as np

from shapes import box, fractal, grid, lathe, matte, merged, tube, write_glb

# Metres: x across, -z away from the camera. The grating is above the far half.
HALF, HEIGHT, FAR, NEAR = 3.2, 4.2, -7.5, 3.5
OPEN_X, OPEN_NEAR, OPEN_FAR = 1.15, -2.2, -5.4


def shell():
    t = 0.4
    return merged([
        box((-HALF - t, -0.4, FAR), (-HALF, HEIGHT, NEAR)), box((HALF, -0.4, FAR), (HALF + t, HEIGHT, NEAR)),
        box((-HALF - t, -0.4, FAR - t), (HALF + t, HEIGHT, FAR)), box((-HALF - t, -0.4, NEAR), (HALF + t, HEIGHT, NEAR + t)),
        box((-HALF - t, HEIGHT, FAR - t), (-OPEN_X, HEIGHT + t, NEAR + t)), box((OPEN_X, HEIGHT, FAR - t), (HALF + t, HEIGHT + t, NEAR + t)),
        box((-OPEN_X, HEIGHT, OPEN_NEAR), (OPEN_X, HEIGHT + t, NEAR + t)), box((-OPEN_X, HEIGHT, FAR - t), (OPEN_X, HEIGHT + t, OPEN_FAR)),
    ])


def grating():
    bars = [box((x - 0.035, HEIGHT + 0.1, OPEN_FAR), (x + 0.035, HEIGHT + 0.2, OPEN_NEAR)) for x in (-0.58, 0, 0.58)]
    return merged(bars + [box((-OPEN_X, HEIGHT + 0.12, z - 0.05), (OPEN_X, HEIGHT + 0.22, z + 0.05)) for z in (-3.0, -3.8, -4.6)])


def silt(x, z):
    return 0.16 * (fractal(np.stack([x / 1.6, z / 1.6], -1), 4, 2) - 0.5) + 0.10 * np.clip(np.abs(x) / HALF, 0, 1) ** 2 + 0.02 * np.sin(9 * x + 2 * z)


def column(place, height=HEIGHT):
    profile = [(0.42, -0.2), (0.42, 0.18), (0.36, 0.22), (0.38, 0.30), (0.30, 0.36), (0.27, 0.45)]
    profile += [(0.27 - 0.02 * t, 0.45 + t * (height - 0.95)) for t in (0.35, 0.7, 1.0)]
    return lathe(profile + [(0.30, height - 0.45), (0.27, height - 0.40), (0.40, height - 0.15), (0.44, height - 0.1), (0.44, height)], 20, (place[0], 0, place[1]))


def arch(z, low=3.0):
    """A wall across the hall with a round opening, as an arcade's rib."""
    turn = np.linspace(0, np.pi, 17)
    across, high = (HALF - 0.55) * np.cos(turn), low + (HEIGHT - low - 0.12) * np.sin(turn)
    rings = [np.array([[x, y, z - 0.22], [x, y, z + 0.22], [x * 1.14, HEIGHT + 0.05, z + 0.22], [x * 1.14, HEIGHT + 0.05, z - 0.22]]) for x, y in zip(across, high)]
    return tube(rings)


def urn(place, size, tilt):
    profile = [(0.0, 0.0), (0.10, 0.0), (0.13, 0.04), (0.27, 0.30), (0.29, 0.44), (0.22, 0.60), (0.10, 0.70), (0.09, 0.78), (0.14, 0.84), (0.12, 0.84), (0.07, 0.76), (0.08, 0.69)]
    points, faces = lathe([(r * size, h * size) for r, h in profile], 22)
    c, s = np.cos(tilt), np.sin(tilt)
    points = points @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]) + [place[0], place[1], place[2]]
    return points, faces


def rubble():
    random, parts = np.random.default_rng(8), []
    for _ in range(26):
        size = random.uniform(0.06, 0.28, 3)
        points, faces = box(-size / 2, size / 2)
        points = points * random.uniform(0.75, 1.2, points.shape)  # corners of faces part a little: broken stone
        turn, nod = random.uniform(0, 6.28), random.uniform(-0.5, 0.5)
        c, s, cn, sn = np.cos(turn), np.sin(turn), np.cos(nod), np.sin(nod)
        points = points @ np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]) @ np.array([[1, 0, 0], [0, cn, sn], [0, -sn, cn]])
        x, z = random.uniform(-2.4, 2.4), random.uniform(-6.8, 0.6)
        parts.append((points + [x, float(silt(np.array(x), np.array(z))) + 0.02, z], faces))
    return merged(parts)


def steps():
    return merged([box((-1.7, -0.2, FAR), (1.7, 0.22 * (4 - i), FAR + 0.4 * (i + 1))) for i in range(4)])


def caustics(cells=384):
    """Light behind waves: rays of an even beam, bent by the slopes of a periodic surface, counted where they land."""
    random, per_cell = np.random.default_rng(21), 10
    line = (np.arange(cells * per_cell) + 0.5) / (cells * per_cell)
    u, v = np.meshgrid(line, line)
    move = [np.zeros_like(u), np.zeros_like(v)]
    for _ in range(26):
        k = np.round(random.normal(0, 8.0, 2))
        length = np.hypot(*k)
        if length < 4:
            continue
        wave = 0.05 / length ** 1.15 * np.cos(2 * np.pi * (k[0] * u + k[1] * v) + random.uniform(0, 6.28))
        move = [m + wave * c for m, c in zip(move, k / length * 1.0)]
    x, y = ((u + move[0]) % 1 * cells).astype(int), ((v + move[1]) % 1 * cells).astype(int)
    count = np.bincount((y % cells * cells + x % cells).ravel(), minlength=cells * cells).reshape(cells, cells) / per_cell ** 2
    kernel = np.array([1, 4, 6, 4, 1]) / 16
    for axis in (0, 1):
        count = sum(w * np.roll(count, i - 2, axis) for i, w in enumerate(kernel))
    return np.clip(count / 3.6, 0, 1)  # the mean light is 1/3.6


def write_grey(path, values):
    """8-bit PNG, sRGB-encoded."""
    encoded = np.where(values <= 0.0031308, 12.92 * values, 1.055 * np.maximum(values, 1e-9) ** (1 / 2.4) - 0.055)
    rows = np.round(255 * encoded).astype(np.uint8)
    raw = b"".join(b"\0" + row.tobytes() for row in rows)

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", rows.shape[1], rows.shape[0], 8, 0, 0, 0, 0)) + chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b""))


def make(folder):
    ground, faces = grid(7.4, 56, silt)
    floor = (ground * [1, 1, 1.55] + [0, 0, -2.0], faces)
    columns = [column((side * 2.25, z)) for side in (-1, 1) for z in (0.4, -2.6, -5.6)]
    write_glb(folder / "sunken_hall.glb", {
        "shell": (shell(), matte((0.46, 0.43, 0.37))),
        "arches": (merged([arch(z) for z in (0.4, -2.6, -5.6)]), matte((0.52, 0.49, 0.42), True)),
        "columns": (merged(columns), matte((0.56, 0.53, 0.46))),
        "steps": (steps(), matte((0.50, 0.47, 0.41))),
        "silt": (floor, matte((0.50, 0.44, 0.33))),
        "rubble": (rubble(), matte((0.46, 0.42, 0.35))),
        "grating": (grating(), matte((0.10, 0.08, 0.07))),
        "urns": (merged([urn((-0.95, 0.05, -1.5), 0.85, 0.16), urn((0.75, 0.24, -2.4), 0.75, -1.25), urn((-1.15, 0.02, -3.9), 0.95, 0)]), matte((0.62, 0.26, 0.13), True)),
    })
    write_grey(folder / "caustics.png", caustics())
