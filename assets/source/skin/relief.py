"""Pores, lines and wrinkles: heights of the skin in centimetres above the modelled surface."""
import numpy as np

import features
from common import curve, step
from noise import Noise, cells, octaves, scattered, thinned


def pores(random, corners, q, n, wobble, regions):
    """Scattered pores: their places, radii and depths (cm). q, n, wobble at the faces' centres."""
    r = regions(q, n, wobble, np.full(len(q), 9.0))
    lips, _ = r.lips()
    bare = (1 - lips) * (1 - 0.8 * r.lids()) * (1 - r.hair()) * step(-16, -11, q[:, 1])
    chance = (60 + 160 * r.nose() + 130 * r.cheeks() + 70 * r.chin() + 40 * r.forehead() * bare) * bare * step(1.0, 5.0, q[:, 2])
    points = scattered(random, corners, chance)
    return thinned(points, 0.035, random)


def network(random, corners, q):
    """Points whose cells are the fields between the skin's fine lines, 0.5 to 1 mm wide."""
    chance = 60 + 80 * step(-13, -10, q[:, 1]) + 240 * step(0.5, 5.0, q[:, 2]) * step(-13, -10, q[:, 1])
    return scattered(random, corners, chance)


def wrinkles(q, r, p):
    """Lines with a direction."""
    x, y, z = r.x, r.y, r.z
    h = np.zeros(len(q), np.float32)
    # forehead: five waving lines
    wave = y + 0.25 * octaves(q, 5.0, 2, 40) - 0.03 * x * x * 0.3
    strength = r.forehead() * (0.5 + 0.5 * octaves(q, 3.0, 2, 41)).clip(0, 1.2)
    h -= 0.009 * strength * np.exp(-((np.mod(wave, 0.95) - 0.47) / 0.07) ** 2)
    # fine ones across
    fine = octaves(q * np.array([0.25, 1.0, 0.25], np.float32), 0.14, 2, 42)
    h -= 0.0022 * r.forehead() * np.maximum(fine, 0)
    # crow's feet and the lids
    angle = np.arctan2(y - 0.5, x - 4.4)
    radius = np.hypot(y - 0.5, x - 4.4)
    feet = np.exp(-((radius - 1.4) / 0.6) ** 2) * step(1.15, 0.6, np.abs(angle)) * r.front.clip(0.3, 1)
    h -= 0.006 * feet * np.maximum(np.sin(angle * 11 + 0.6 * octaves(q, 1.0, 2, 43)), 0) ** 3
    lid = r.lids()
    across = octaves(np.stack([q[:, 0] * 0.3, q[:, 1] - features.lash_line(x), q[:, 2] * 0.3], -1), 0.09, 2, 44)
    h -= 0.0022 * lid * np.maximum(across, 0)
    under = np.exp(-((y - features.lash_line(x) + 0.55 + 0.1 * octaves(q, 1.5, 2, 45)) / 0.06) ** 2) * np.exp(-((x - 2.9) / 1.5) ** 4) * r.front
    h -= 0.008 * under
    # lips: lines from the mouth outwards
    lips, t = r.lips()
    spread = q[:, 0] * (1 + 0.12 * np.abs(t)) + 0.05 * octaves(q, 0.6, 2, 46)
    line = octaves(np.stack([spread, 0.12 * q[:, 1], 0.1 * q[:, 2]], -1), 0.16, 3, 47)
    h -= 0.005 * lips * np.maximum(line, -0.3) * step(1.0, 0.75, np.abs(t))
    # the throat
    neck = step(-11.5, -13, y) * step(-0.5, 2, z)
    ring = np.exp(-((np.mod(y + 0.06 * x * x * 0.4 + 0.2 * octaves(q, 4, 2, 48), 2.6) - 1.3) / 0.12) ** 2)
    h -= 0.006 * neck * ring * step(-17, -15, y)
    return h


def height(random, chart_points, q, r, faces_at, regions):
    """Heights at texels. faces_at: corners, q, normals, wobble of the mesh's faces."""
    corners, fq, fn, fw = faces_at
    lips, _ = r.lips()
    fine = cells(network(random, corners, fq), chart_points)[0]
    line = np.exp(-(((fine[:, 1] - fine[:, 0]) / 0.016) ** 2))
    strength = 0.0028 * (1 + 0.5 * octaves(q, 1.5, 2, 60)).clip(0.3, 2) * (1 - lips) * (1 - 0.5 * r.nose()) * (1 + 0.6 * r.lids()) * (1 - 0.7 * r.hair())
    h = -strength * line
    places = pores(random, corners, fq, fn, fw, regions)
    size, depth = random.uniform(0.010, 0.022, len(places)), random.uniform(0.25, 1.0, len(places)) ** 2
    d, index = cells(places, chart_points, 1)
    pore = depth[index] * np.exp(-((d / size[index]) ** 2))
    h = h - (0.004 + 0.004 * r.nose() + 0.002 * r.cheeks()) * pore
    h = h + 0.0035 * octaves(q, 0.35, 3, 61) * (1 - 0.6 * r.lids()) * (1 - lips) + 0.006 * octaves(q, 1.3, 2, 64) * step(-12, -10, r.y)
    # hair cut short: rough
    h = h + r.hair() * 0.0012 * octaves(q, 0.12, 2, 66)
    h = h + wrinkles(q, r, q)
    return h.astype(np.float32), pore.astype(np.float32), line.astype(np.float32)
