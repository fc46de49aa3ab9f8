"""The skin's colour, gloss and cavities at texels."""
import numpy as np

import features
import hairs
from common import step
from noise import cells, octaves, scattered

# Reflectance without pigment, and what a unit of blood and of melanin absorbs (log), red, green, blue.
PALE = np.array([0.77, 0.61, 0.50], np.float32)
BLOOD = np.array([0.10, 0.62, 0.55], np.float32)
MELANIN = np.array([0.34, 0.62, 0.95], np.float32)
SHORN = np.array([0.098, 0.078, 0.067], np.float32)   # hair of a millimetre over the scalp
HAIR = np.array([0.042, 0.029, 0.021], np.float32)


def blood(q, r, n, lips):
    b = 0.34 + 0.09 * octaves(q, 5.0, 3, 80) * (1 - 0.5 * step(-12, -16, r.y)) + 0.05 * octaves(q, 0.7, 3, 83)
    b = b + 0.26 * r.cheeks() * (0.8 + 0.45 * octaves(q, 1.6, 3, 86)) + 0.24 * r.nose_tip() + 0.12 * r.nose() + 0.34 * r.ears()
    b = b + 0.10 * r.chin() + 0.07 * r.lids() + 0.12 * r.sockets()
    wing = np.exp(-(((r.x - 1.75) / 0.45) ** 2 + ((r.y + 3.7) / 0.6) ** 2)) * step(8.5, 9.5, r.z)
    vein = np.maximum(1 - np.abs(octaves(q, 0.5, 3, 89)) * 5, 0)
    b = b + 0.3 * wing + 0.14 * vein * (r.cheeks() + r.nose_tip() + 0.4 * r.ears()).clip(0, 1) * (octaves(q, 1.2, 2, 92) > 0.2)
    b = b - 0.08 * r.forehead() - 0.08 * r.beard() - 0.1 * step(-12, -17, r.y)
    return b.clip(0.08, 2) * (1 - lips) + lips * (1.02 + 0.12 * octaves(q, 0.5, 3, 93))


def melanin(random, q, r, corners, fq, p, lips):
    m = 0.20 + 0.05 * octaves(q, 6.0, 3, 100) + 0.035 * octaves(q, 0.5, 3, 103) + 0.06 * r.sockets() + 0.03 * r.forehead()
    sun = 90 * np.exp(-(((np.abs(fq[:, 0]) - 2.8) / 2.6) ** 2 + ((fq[:, 1] + 1.3) / 2.0) ** 2)) * (fq[:, 2] > 5)
    chance = 0.05 * sun + 0.25 * step(-30, -13, -np.abs(fq[:, 1] + 13) - 13) + 0.35
    freckles = scattered(random, corners, chance)
    size, depth = random.gamma(3.0, 0.022, len(freckles)) + 0.03, random.uniform(0.03, 0.30, len(freckles))
    d, index = cells(freckles, p, 1)
    spot = depth[index] * step(1.15, 0.55, d / size[index] + 0.18 * octaves(q, 0.12, 2, 106))
    moles = np.array([(2.9, -4.6, 9.3), (-4.9, -1.2, 7.9), (-2.3, -9.6, 8.9), (5.3, -12.5, 2.0), (-1.2, 5.6, 10.2)])
    radius = np.array([0.09, 0.13, 0.08, 0.15, 0.07])
    far, which = cells(moles, q, 1)
    near = cells(p[[np.linalg.norm(q - mole, axis=1).argmin() for mole in moles]], p, 1)
    mole = 0.75 * step(1.25, 0.8, near[0] / radius[near[1]] + 0.12 * octaves(q, 0.1, 1, 108))
    return (m + spot + mole).clip(0.05, 3) + 0.24 * lips


def reflectance(random, q, p, n, r, pore, line, open_, faces_at):
    """Diffuse albedo, linear; and how much hair covers the skin."""
    corners, fq = faces_at[0], faces_at[1]
    lips, t = r.lips()
    total = blood(q, r, n, lips) * (1 + 0.25 * (1 - open_) * r.front) + 0.25 * pore
    pigment = melanin(random, q, r, corners, fq, p, lips) + 0.10 * pore + 0.05 * line
    albedo = PALE * np.exp(-total[:, None] * BLOOD - pigment[:, None] * MELANIN)
    albedo *= np.array([1.0, 1.0 - 0.03, 1.0 - 0.05]) ** r.forehead()[:, None]
    # the shadow of a beard: hairs seen through the skin
    beard = r.beard() * (1 - lips)
    roots = scattered(random, corners, 190 * (fq[:, 2] > -1) * (fq[:, 1] < 0) * (fq[:, 1] > -14))
    d, index = cells(roots, p, 1)
    dot = random.uniform(0.2, 0.8, len(roots))[index] * np.exp(-((d / 0.014) ** 2))
    beard = beard * (0.13 + 0.04 * octaves(q, 0.4, 3, 110) + 0.5 * dot)
    albedo = albedo * (1 - beard[:, None] * np.array([0.72, 0.60, 0.46], np.float32))
    roots = scattered(random, corners, 130 * (fq[:, 1] > -7) * (fq[:, 1] > 5.0 - 1.2 * (5.5 - fq[:, 2])))
    d, index = cells(roots, p, 1)
    there = step(-0.12, 0.12, r.hair() - random.uniform(0, 1, len(roots))[index]) * random.uniform(0.4, 1, len(roots))[index]
    hair = r.hair() ** 1.5 * (0.40 + 0.04 * octaves(q, 2.0, 3, 114)) + 0.45 * there * np.exp(-((d / 0.026) ** 2))
    albedo = albedo + hair.clip(0, 0.9)[:, None] * (SHORN - albedo)
    # single hairs
    cover = np.zeros(len(q), np.float32)
    for side in (-1, 1):
        for make, width, low, high in ((hairs.brow_lines, 0.014, 1.4, 4.4), (hairs.lash_lines, 0.012, -1.0, 1.2)):
            near = np.flatnonzero((q[:, 0] * side > 0.3) & (r.x < 6.6) & (r.y > low) & (r.y < high) & (r.z > 4))
            lines = make(random)
            cover[near] = np.maximum(cover[near], hairs.strokes(np.stack([r.x[near], r.y[near]], -1), lines, random.uniform(0.7, 1.2, len(lines)) * width))
    above, half = r.brow()
    soft = 0.30 * np.exp(-((above / (half + 0.02)) ** 2)) * step(0.8, 1.5, r.x) * step(5.7, 4.8, r.x) * r.front.clip(0.2, 1) * (r.z > 4)
    root = 0.75 * np.exp(-(((r.y - features.lash_line(r.x)) / 0.045) ** 2)) * step(1.5, 1.9, r.x) * step(5.2, 4.9, r.x) * r.front
    cover = 1 - (1 - cover) * (1 - soft) * (1 - root)
    albedo = albedo * (1 + lips[:, None] * np.array([-0.13, -0.04, 0.13], np.float32))
    # wet red line where the lips meet, darker
    seam = lips * np.exp(-((t / 0.10) ** 2))
    albedo = albedo * (1 - 0.35 * seam[:, None])
    albedo = albedo + cover[:, None] * (HAIR - albedo)
    return albedo.clip(0.01, 0.9).astype(np.float32), np.maximum(cover, hair.clip(0, 1) * 0.6)


def roughness(q, r, pore, line, cover):
    lips, _ = r.lips()
    oily = np.maximum.reduce([r.nose(), 0.8 * r.forehead() * np.exp(-((r.x / 4) ** 2)), 0.6 * r.chin(), 0.5 * r.lids()])
    rough = 0.53 - 0.14 * oily + 0.03 * r.cheeks() - 0.03 * r.ears() + 0.035 * octaves(q, 1.2, 3, 120) + 0.03 * octaves(q, 0.12, 2, 124) + 0.05 * line + 0.06 * pore
    rough = rough + r.hair() * (0.64 - rough)
    rough = rough + lips * (0.35 - rough + 0.05 * octaves(q, 0.2, 2, 126))
    return (rough + cover * (0.5 - rough)).clip(0.28, 0.65)


def specular(q, r, pore, line, height_low, open_, cover):
    """How much the surface reflects, 1 where nothing hides it: pores, lines and folds are dark."""
    s = (1 - 0.55 * pore - 0.30 * line) * (0.35 + 0.65 * open_) * (0.92 + 0.05 * octaves(q, 0.8, 3, 130))
    return (s * (1 - 0.5 * cover) * (1 - 0.4 * r.hair())).clip(0, 1)
