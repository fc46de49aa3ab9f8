"""Eyebrows, lashes and stubble: single hairs as strokes, drawn where the texels are."""
import numpy as np

import features
from common import curve


def strokes(place, lines, widths):
    """How much hair covers each place [n, 2]: lines [m, k, 2], widths at the root (they taper)."""
    cover = np.zeros(len(place), np.float32)
    order = np.argsort(place[:, 0])
    sorted_x = place[order, 0]
    for line, width in zip(lines, widths):
        reach = 3 * width
        low, high = line.min(0) - reach, line.max(0) + reach
        a, b = np.searchsorted(sorted_x, [low[0], high[0]])
        near = order[a:b]
        near = near[(place[near, 1] > low[1]) & (place[near, 1] < high[1])]
        if not len(near):
            continue
        p = place[near]
        best = np.zeros(len(near), np.float32)
        for i in range(len(line) - 1):
            edge = line[i + 1] - line[i]
            t = np.clip((p - line[i]) @ edge / max(edge @ edge, 1e-9), 0, 1)
            d = np.hypot(*(p - line[i] - t[:, None] * edge).T)
            along = (i + t) / (len(line) - 1)
            best = np.maximum(best, np.exp(-((d / (np.maximum(width * (1.05 - 0.7 * along), 0.0075))) ** 2)))
        cover[near] = 1 - (1 - cover[near]) * (1 - 0.75 * best)
    return cover


def brow_lines(random, count=520):
    """Hairs of the right brow: upwards near the nose, outwards beyond, a little down at the end."""
    x = 0.95 + 4.5 * random.beta(1.05, 1.05, count)
    middle = curve(x, [0.9, 1.6, 2.6, 3.8, 4.8, 5.6], [2.30, 2.48, 2.78, 3.02, 2.88, 2.45])
    half = curve(x, [0.8, 1.2, 2.0, 3.4, 4.6, 5.6], [0.16, 0.38, 0.44, 0.38, 0.27, 0.10])
    v = np.clip(random.normal(0, 0.5, count), -1.05, 1.05)
    y = middle + half * v
    lean = curve(x, [0.9, 1.5, 2.4, 3.6, 4.6, 5.6], [80, 62, 38, 14, -12, -32]) - 22 * v + random.normal(0, 9, count)
    size = 0.55 + 0.35 * random.random(count) - 0.2 * (x > 4.6)
    a = np.radians(lean)
    root = np.stack([x, y], -1)
    way = np.stack([np.cos(a), np.sin(a)], -1)
    bend = np.stack([np.cos(a - 0.5), np.sin(a - 0.5)], -1)
    return np.stack([root, root + 0.5 * size[:, None] * way, root + size[:, None] * (0.5 * way + 0.5 * bend)], 1)


def lash_lines(random, count=110):
    """Lashes of the shut right eye: from the lids' line downwards, fanning out."""
    x = np.sort(1.75 + 3.3 * random.random(count))
    y = features.lash_line(x) - 0.01
    fan = -90 + curve(x, [1.6, 3.2, 4.2, 5.2], [-22, 0, 26, 52]) + random.normal(0, 7, count)
    size = curve(x, [1.6, 2.4, 3.6, 4.6, 5.2], [0.22, 0.42, 0.52, 0.5, 0.3]) * random.uniform(0.7, 1.1, count)
    a = np.radians(fan)
    way = np.stack([np.cos(a), np.sin(a)], -1)
    curl = np.stack([np.cos(a) + 0.15 * (x > 3), np.sin(a) + 0.35], -1)
    root = np.stack([x, y], -1)
    return np.stack([root, root + 0.55 * size[:, None] * way, root + size[:, None] * (0.55 * way + 0.45 * curl)], 1)
