"""A torus, a wax candle and a jade bowl: closed surfaces over two parameters, in metres, y = 0 at the foot."""
import numpy as np

from sdf import curve, step


def skin(places):
    """Triangles over places [k, n, 3], closed around; the first and the last ring are points. Outward where rings run clockwise seen from the last."""
    k, n, _ = places.shape
    points = np.concatenate([places[:1, 0], places[1:-1].reshape(-1, 3), places[-1:, 0]])
    index = np.arange(1, 1 + (k - 2) * n).reshape(k - 2, n)
    a, b, c, d = index[:-1], np.roll(index[:-1], -1, 1), np.roll(index[1:], -1, 1), index[1:]
    across = np.linalg.norm(points[a] - points[c], axis=-1) <= np.linalg.norm(points[b] - points[d], axis=-1)
    first = np.where(across[..., None], np.stack([a, c, b], -1), np.stack([a, d, b], -1)).reshape(-1, 3)
    second = np.where(across[..., None], np.stack([a, d, c], -1), np.stack([b, d, c], -1)).reshape(-1, 3)
    ring, last = index[0], index[-1]
    low = np.stack([np.zeros_like(ring), ring, np.roll(ring, -1)], -1)
    high = np.stack([np.full_like(last, len(points) - 1), np.roll(last, -1), last], -1)
    return points, np.concatenate([low, first, second, high])


def evenly(profile, count, rounding=0.0, weight=None):
    """Places along a polyline whose corners are rounded: [count, 2], as dense as `weight` of a place says, else evenly by length."""
    profile = np.asarray(profile, float)
    length = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(profile, axis=0), axis=1))])
    fine = np.linspace(0, length[-1], 4000)
    course = np.stack([np.interp(fine, length, profile[:, i]) for i in (0, 1)], -1)
    wide = int(4000 * rounding / length[-1]) | 1
    if wide > 1:  # corners become round
        ends = course[:1], course[-1:]
        padded = np.concatenate([2 * ends[0] - course[wide // 2:0:-1], course, 2 * ends[1] - course[-2:-wide // 2 - 1:-1]])
        window = np.hanning(wide + 2)[1:-1]
        course = np.stack([np.convolve(padded[:, i], window / window.sum(), "valid") for i in (0, 1)], -1)
    course[[0, -1]] = profile[[0, -1]]
    pieces = np.linalg.norm(np.diff(course, axis=0), axis=1)
    length = np.concatenate([[0], np.cumsum(pieces if weight is None else pieces * weight(course[1:]))])
    at = np.linspace(0, length[-1], count)
    return np.stack([np.interp(at, length, course[:, i]) for i in (0, 1)], -1)


def torus(major=0.030, minor=0.006, around=200, tube=50):
    """Lies in the plane y = 0; its normals are exact."""
    u, v = np.meshgrid(np.arange(around) * 2 * np.pi / around, np.arange(tube) * 2 * np.pi / tube, indexing="ij")
    normal = np.stack([np.cos(v) * np.cos(u), np.sin(v), np.cos(v) * np.sin(u)], -1)
    points = minor * normal + major * np.stack([np.cos(u), 0 * u, np.sin(u)], -1)
    i, j = np.meshgrid(np.arange(around), np.arange(tube), indexing="ij")
    a, b = i * tube + j, i * tube + (j + 1) % tube
    c, d = (i + 1) % around * tube + (j + 1) % tube, (i + 1) % around * tube + j
    return points.reshape(-1, 3), np.concatenate([np.stack([a, b, c], -1).reshape(-1, 3), np.stack([a, c, d], -1).reshape(-1, 3)]), normal.reshape(-1, 3)


RUNS = ((2.2, 93, 2.6), (2.5, 54, 1.9), (1.93, 37, 1.7), (4.9, 27, 1.5), (0.4, 45, 1.8))  # of wax: where around, how far down, how thick in mm


def candle(tall=115.0, half=30.0, runs=RUNS, around=128, along=84):
    """A candle of wax, in mm. The flame has melted a hollow 24 mm deep; its rim is thin and uneven, and wax has run down outside."""
    profile = evenly([(0, 0), (half - 1.5, 0), (half, 1.5), (half, tall - 1.5), (half - 1.4, tall + 0.4), (half - 3.4, tall - 0.6), (half - 4.8, tall - 9),
                      (half - 6.4, tall - 16), (half - 10, tall - 21.6), (half - 18, tall - 23.8), (0, tall - 24)], along, 5.0,
                     lambda place: 1 + tall / 60 * np.exp(-((place[:, 1] - tall + 10) / 25) ** 2))
    theta = np.arange(around) * 2 * np.pi / around
    r, y = profile[:, :1], profile[:, 1:]
    along_rim = np.exp(-((y - tall - 1) / 16) ** 2) * step(8, 24, r)
    sag = 3.2 * np.sin(theta + 0.7) + 1.9 * np.sin(2 * theta + 2.0) + 0.9 * np.sin(5 * theta) + 0.5 * np.sin(9 * theta + 1)
    sag = sag - 7.5 * np.exp(-(np.angle(np.exp(1j * (theta - 2.2))) / 0.28) ** 2)        # where it overflowed
    height = y + along_rim * sag
    outside = (np.arange(along)[:, None] < np.argmax(profile[:, 1])) & (r > half - 10)
    bulge = 0.35 * np.sin(3 * theta + 0.05 * y) * step(0, 20, y)
    for place, down, thick in runs:
        low = tall - down
        away = np.angle(np.exp(1j * (theta - place - 0.02 * np.sin(0.11 * y))))
        drop = np.exp(-((y - low - 3) / 4.0) ** 2)
        width = 0.042 * thick * 30 / half * (1 + 0.5 * drop)
        bulge = bulge + thick * (1 + 0.6 * drop) * np.exp(-(away / width) ** 2) * step(low - 6, low + 4, y) * step(tall + 1, tall - 15, y)
    radius = r + np.where(outside, bulge, 0)
    radius = radius + along_rim * 0.5 * np.sin(4 * theta + 1.5)
    places = np.stack([radius * np.cos(theta), height, radius * np.sin(theta)], -1) * 1e-3
    places[0], places[-1] = places[0].mean(0), places[-1].mean(0)
    return skin(places)


def tall_candle():
    """For a candlestick: 50 mm wide and half a metre tall."""
    return candle(498.0, 25.0, ((2.2, 170, 2.4), (2.55, 90, 1.8), (1.85, 60, 1.7), (4.9, 120, 1.6), (0.4, 45, 1.8), (3.7, 240, 1.9)), along=110)


def bowl(around=480, along=190):
    """A bowl of 132 mm, 3 mm thin, on a foot; two rows of lotus petals are carved into its outside, and they end in the rim's lobes."""
    outer = [(0, 2.4), (24, 2.4), (25.5, 0), (29, 0), (30, 1.2), (29, 6), (30.5, 8.2), (40, 12), (51, 21), (59, 34), (63.6, 48), (66, 61)]
    inner = [(64.6, 62.6), (63.0, 61), (60.6, 48.5), (56, 35.2), (48.2, 23.2), (37.5, 14.6), (24, 10.2), (10, 9.2), (0, 9.1)]
    profile = evenly(outer + inner, along, 4.0)
    theta = np.arange(around) * 2 * np.pi / around
    r, y = profile[:, :1], profile[:, 1:]
    outside = (np.arange(along)[:, None] <= np.argmax(profile[:, 1])).astype(float)
    up = np.clip((y - 8.5) / 53, 0, 1)
    relief = np.maximum(petals(theta, up, 12, 0.0, -0.05, 1.06), 0.8 * petals(theta, up, 12, 0.5, -0.05, 0.62))
    rim = step(0.80, 1.0, up) * (r > 50)
    lobe = np.abs(np.cos(6 * theta)) - 0.6
    height = y + rim * 2.2 * lobe
    radius = r + outside * step(8, 12, y) * (1.5 * relief - 0.5) + rim * 0.9 * lobe
    radius = np.where(r < 1e-9, 0, radius)
    return skin(np.stack([radius * np.cos(theta), height, radius * np.sin(theta)], -1) * 1e-3)


def petals(theta, up, count, shift, low, high):
    """Height in [0, 1] of a row of pointed petals: swollen, with a rib and a raised edge."""
    across = ((theta * count / (2 * np.pi) + shift) % 1 - 0.5) * 2
    t = np.clip((up - low) / (high - low), 0, 1)
    shape = [0, 0.25, 0.55, 0.82, 1.0], [0.68, 0.93, 0.98, 0.62, 0.0]
    half = curve(t, *shape)
    slope = (curve(t + 0.01, *shape) - curve(t - 0.01, *shape)) / 0.02
    within = (half - np.abs(across)) / np.sqrt(1 + (0.35 * slope / (high - low)) ** 2)
    inside, edge = step(0.0, 0.13, within), step(0.30, 0.12, within)
    return inside * (0.55 + 0.45 * edge + 0.25 * np.exp(-(across / 0.07) ** 2) * (1 - t)) * (up > low) * (t < 1)


def pedestal():
    """Octagonal, one metre tall, with flat sides of their own normals and UVs in metres: points, faces, normals, UVs."""
    profile = np.array([(0.17, 0), (0.17, 0.07), (0.163, 0.08), (0.145, 0.085), (0.14, 0.10), (0.12, 0.125), (0.112, 0.15), (0.106, 0.80), (0.112, 0.82), (0.118, 0.822),
                        (0.118, 0.84), (0.128, 0.865), (0.148, 0.885), (0.152, 0.89), (0.152, 0.975), (0.145, 0.985), (0.14, 1.0), (0.0, 1.0)])
    course = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(profile, axis=0), axis=1))])
    points, uvs = [], []
    for side in range(8):
        corners = [np.stack([r / np.cos(np.pi / 8) * np.sin(a), h, r / np.cos(np.pi / 8) * np.cos(a)], -1)
                   for a in ((side - 0.5) * np.pi / 4, (side + 0.5) * np.pi / 4) for r, h in (profile.T,)]
        half = profile[:, 0] * np.tan(np.pi / 8)
        for i in range(len(profile) - 1):
            points += [corners[0][i], corners[1][i], corners[1][i + 1], corners[0][i + 1]]
            uvs += [(0.1 + 0.3 * side + x * half[j], course[j]) for x, j in ((-1, i), (1, i), (1, i + 1), (-1, i + 1))]
    quads = np.arange(len(points)).reshape(-1, 4)
    faces = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    points, uvs = np.array(points), np.array(uvs)
    area = np.linalg.norm(np.cross(points[faces[:, 1]] - points[faces[:, 0]], points[faces[:, 2]] - points[faces[:, 0]]), axis=1)
    faces = faces[area > 1e-12]
    low, high = points[quads[:, 1]] - points[quads[:, 0]], points[quads[:, 3]] - points[quads[:, 0]]
    normals = np.cross(low, high)
    return points, faces, np.repeat(normals / np.linalg.norm(normals, axis=1, keepdims=True), 4, 0), uvs
