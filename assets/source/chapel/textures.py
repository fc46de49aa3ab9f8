"""Stone, wood, metal and cloth, synthesised as tiling maps. Usage: textures.py OUTPUT_DIRECTORY [NAME...]"""
import pathlib
import sys

import numpy as np

import imageio
from noise import blur, normal_map, smooth, spectral


def shrunk(image, factor):
    """The mean of blocks of factor x factor texels: memory goes where eyes look."""
    h, w = image.shape[:2]
    return image.reshape(h // factor, factor, w // factor, factor, -1).mean((1, 3))


def write(folder, name, colour, rough, height, tile, occlusion=None, metal=None, quality=86):
    """Albedo is linear here; the colour map is stored sRGB-encoded, the ORM and normal maps are data."""
    h, w = rough.shape
    occlusion = np.ones_like(rough) if occlusion is None else occlusion
    metal = np.zeros_like(rough) if metal is None else metal
    # What a texture takes of memory goes where eyes look: walls first, then colours, then normals, then the rest.
    colour, normals = imageio.to_srgb(colour), normal_map(height, (tile[1] / h, tile[0] / w))
    packed = np.stack([occlusion, rough, metal], -1)
    imageio.save(folder / f"{name}_color.jpg", shrunk(colour, 2) if name in ("oak", "flagstone", "linen", "brocade") else colour, quality)
    imageio.save(folder / f"{name}_normal.jpg", shrunk(normals, 2) if w > 512 else normals, quality + 1)
    imageio.save(folder / f"{name}_orm.jpg", shrunk(packed, 4 if w > 1024 else 2), quality - 4)


def mix(a, b, t):
    return np.asarray(a) * (1 - t[..., None]) + np.asarray(b) * t[..., None]


def masonry(size, tile, courses, lengths, joint, seed, perpends=True):
    """Blocks in level courses. Returns, per pixel: distance to the nearest joint centre line (m), block number, position in block (-1..1, two axes)."""
    rng = np.random.default_rng(seed)
    px = tile / size
    heights = rng.uniform(*courses, 100)
    count = max(1, int(round(tile / heights.mean())))
    heights = heights[:count] / heights[:count].sum() * tile
    # Hand-cut edges wander by a few millimetres.
    wy = spectral((size, size), 2.2, seed + 1, 2, 60) * joint * 0.28
    wx = spectral((size, size), 2.2, seed + 2, 2, 60) * joint * 0.28
    yy, xx = np.meshgrid((np.arange(size) + .5) * px, (np.arange(size) + .5) * px, indexing="ij")
    yy, xx = (yy + wy) % tile, (xx + wx) % tile
    edges = np.concatenate([[0], np.cumsum(heights)])
    row = np.clip(np.searchsorted(edges, yy, side="right") - 1, 0, count - 1)
    dist = np.minimum(yy - edges[row], edges[row + 1] - yy)
    ly = 2 * (yy - edges[row]) / heights[row] - 1
    block = np.zeros((size, size), int)
    lx = np.zeros((size, size))
    serial = 0
    for r in range(count):
        inside = row == r
        n = max(2, int(round(tile / rng.uniform(*lengths))))
        widths = rng.uniform(.7, 1.3, n)
        cuts = np.concatenate([[0], np.cumsum(widths / widths.sum() * tile)])
        x = (xx[inside] + rng.uniform(0, tile)) % tile
        k = np.clip(np.searchsorted(cuts, x, side="right") - 1, 0, n - 1)
        if perpends:
            dist[inside] = np.minimum(dist[inside], np.minimum(x - cuts[k], cuts[k + 1] - x))
        lx[inside] = 2 * (x - cuts[k]) / (cuts[k + 1] - cuts[k]) - 1
        block[inside] = serial + k
        serial += n
    return dist, block, lx, ly, serial


def stone(folder, name, size, tile, courses, lengths, joint, seed, warm, contrast, perpends=True, rough_base=.78, depth=.006, quality=86):
    """Limestone masonry: pale blocks of slightly different beds, tooled faces, recessed lime joints, stains."""
    rng = np.random.default_rng(seed + 100)
    shape = (size, size)
    dist, block, lx, ly, count = masonry(size, tile, courses, lengths, joint, seed, perpends)
    grain = spectral(shape, 0.7, seed + 3, size / 40, size / 2.5)
    mottle = spectral(shape, 1.8, seed + 4, 3, size / 6)
    cloud = spectral(shape, 2.4, seed + 5, 1, 14)
    bed = spectral(shape, 1.8, seed + 6, 2, size / 6, stretch=(1, 7))
    chips = spectral(shape, 1.6, seed + 7, 8, size / 6)

    tone = 1 + np.clip(rng.normal(0, .115 * contrast, count), -.26, .2)[block]
    hue = rng.normal(0, 1, count)[block] * contrast
    dark = (rng.random(count) < .10)[block]
    palette = np.array(warm)
    colour = palette * tone[..., None] * (1 + .05 * mottle + .05 * cloud + .035 * bed + .03 * grain)[..., None]
    colour = colour * (1 + hue[..., None] * np.array([.020, .0, -.055]))
    colour = colour * (1 - .10 * contrast * dark[..., None])
    # Iron stains and grime that run over several blocks.
    rust = smooth(1.1, 2.4, cloud + .45 * mottle)
    colour = mix(colour, colour * [1.0, .86, .68], .45 * rust)
    grime = smooth(.9, 2.2, -cloud + .4 * chips)
    colour = mix(colour, colour * [.62, .60, .57], .5 * grime)
    pores = smooth(1.7, 2.6, spectral(shape, .8, seed + 8, size / 24, size / 4))
    colour *= (1 - .22 * pores)[..., None]

    arris = joint * (1.0 + .55 * np.clip(chips, -1, 2.2))
    in_joint = 1 - smooth(arris * .42, arris * .72, dist)
    mortar = np.array([.50, .465, .40]) * (1 + .08 * grain + .10 * cloud)[..., None]
    colour = mix(colour, mortar * .86, in_joint * .85)
    colour *= (1 - .16 * np.exp(-dist / (joint * 1.1)) * (1 - in_joint))[..., None]

    tilt = rng.normal(0, .0007, (count, 3))
    face = tilt[block, 0] + tilt[block, 1] * lx + tilt[block, 2] * ly
    round_edge = smooth(0, joint * 2.2, dist)
    tooled = spectral(shape, .6, seed + 9, size / 50, size / 8, stretch=(3.5, 1)) * .00022
    height = face + depth * round_edge * (1 - .6 * in_joint) - depth * .5 * in_joint
    height += .00075 * blur(mottle, 1.5) + .00013 * grain + tooled - .0012 * pores - .0012 * smooth(.8, 2, chips) * np.exp(-dist / (joint * 2.5))
    rough = rough_base + .05 * mottle * .6 + .08 * in_joint + .07 * pores - .05 * rust + .02 * grain
    occlusion = 1 - .45 * in_joint - .2 * pores
    write(folder, name, np.clip(colour, .01, .9), np.clip(rough, .3, .98), height, (tile, tile), occlusion, quality=quality)


def flagstone(folder):
    """Worn paving: denser grey-buff stone without joints (the slabs are geometry), polished where people walk."""
    size, tile, seed = 1536, 3.0, 500
    shape = (size, size)
    grain = spectral(shape, .5, seed, 60, 600)
    mottle = spectral(shape, 1.9, seed + 1, 2, 200)
    cloud = spectral(shape, 2.2, seed + 2, 1, 10)
    veins = np.exp(-(spectral(shape, 2.4, seed + 3, 1, 60) / .035) ** 2)
    scuff = spectral(shape, 1.2, seed + 4, 10, 300, stretch=(1, 4))
    blotch = spectral(shape, 1.5, seed + 8, 6, 90)
    tone = 1 + .075 * mottle + .11 * cloud + .07 * blotch + .045 * grain
    colour = np.array([.285, .252, .205]) * tone[..., None]
    colour = mix(colour, np.array([.40, .335, .25]), .38 * smooth(-.2, 1.6, spectral(shape, 2.0, seed + 5, 1, 8)))
    colour = mix(colour, colour * .66, .28 * smooth(.7, 2.0, -.6 * cloud + .6 * blotch + .3 * mottle))
    colour *= (1 - .20 * veins)[..., None]
    pits = smooth(1.9, 2.8, spectral(shape, .9, seed + 6, 60, 380))
    colour *= (1 - .3 * pits)[..., None]
    height = .0016 * spectral(shape, 2.4, seed + 7, 2, 30) + .0004 * blur(mottle, 2) + .00007 * grain - .0014 * pits - .0005 * veins + .00009 * scuff
    rough = .44 + .05 * mottle + .035 * scuff + .22 * pits + .10 * smooth(0, 2, -cloud) - .05 * smooth(0, 2, cloud)
    write(folder, "flagstone", np.clip(colour, .02, .8), np.clip(rough, .24, .95), height, (tile, tile), 1 - .3 * pits)


def oak(folder):
    """Old oak: u along the grain. Growth rings cut by the plane, rays, pores, dark wax in the hollows."""
    w, h, seed = 2048, 1024, 700
    shape = (h, w)
    tile = (2.4, .8)
    bend = spectral(shape, 2.6, seed, 1, 10, stretch=(1, 5))
    fine = spectral(shape, 2.0, seed + 1, 1, 40, stretch=(1, 9))
    v = np.arange(h)[:, None] / h
    rings = 14 * v + .55 * bend + .12 * fine
    saw = rings % 1.0
    early = np.exp(-saw * 3.2) + .4 * np.exp(-(1 - saw) * 14)
    fibre = spectral(shape, .6, seed + 2, 30, 500, stretch=(1, 26))
    pores = smooth(1.3, 2.3, spectral(shape, .5, seed + 3, 60, 500, stretch=(1, 18)) + .9 * (early - .45))
    flecks = smooth(1.6, 2.4, spectral(shape, .8, seed + 4, 10, 140, stretch=(2.4, 1)))
    cloud = spectral(shape, 2.2, seed + 5, 1, 12, stretch=(1, 3))
    tone = 1 - .26 * early + .07 * fibre + .12 * cloud
    colour = np.array([.195, .102, .048]) * tone[..., None]
    colour = mix(colour, np.array([.27, .160, .085]), .28 * flecks)
    colour = mix(colour, np.array([.055, .028, .014]), .75 * pores)
    worn = smooth(.4, 2.0, spectral(shape, 2.0, seed + 6, 1, 9))
    colour = mix(colour, colour * [1.28, 1.24, 1.18], .55 * worn)
    scratches = smooth(2.3, 3.0, spectral(shape, .7, seed + 7, 15, 300, stretch=(1.2, 14)))
    colour *= (1 + .25 * scratches)[..., None]
    height = -.00035 * pores - .00010 * early + .00006 * fibre + .0006 * spectral(shape, 2.4, seed + 8, 1, 8, stretch=(1, 2)) - .0002 * scratches
    rough = .46 + .20 * pores + .05 * fibre * .5 + .06 * cloud - .10 * worn + .1 * scratches
    write(folder, "oak", np.clip(colour, .008, .7), np.clip(rough, .22, .95), height, tile, 1 - .35 * pores)


def iron(folder):
    """Forged iron, blackened, with rust in the hammer marks."""
    size, seed = 512, 900
    shape = (size, size)
    dents = spectral(shape, 2.0, seed, 4, 60)
    rust = smooth(.5, 1.9, spectral(shape, 1.7, seed + 1, 3, 200))
    grain = spectral(shape, .6, seed + 2, 30, 200)
    colour = mix(np.array([.075, .072, .07]) * (1 + .12 * grain)[..., None], np.array([.135, .06, .028]), .8 * rust)
    height = .0006 * dents + .00008 * grain + .00015 * rust
    write(folder, "iron", np.clip(colour, .01, .6), np.clip(.50 + .28 * rust + .05 * grain, .2, .95), height, (.5, .5), metal=np.clip(.92 - .85 * rust, 0, 1))


def weave(size, threads, seed):
    """Plain weave: height 0..1 of crossing threads, and which thread is on top."""
    y, x = np.meshgrid(np.arange(size) / size, np.arange(size) / size, indexing="ij")
    x = x + .0016 * spectral((size, size), 2, seed, 1, 30)
    y = y + .0016 * spectral((size, size), 2, seed + 1, 1, 30)
    a, b = x * threads, y * threads
    over = ((np.floor(a) + np.floor(b)) % 2) == 0
    bump_a, bump_b = np.abs(np.sin(np.pi * a)), np.abs(np.sin(np.pi * b))
    return np.where(over, bump_a * (.6 + .4 * bump_b), bump_b * (.6 + .4 * bump_a)), over


def linen(folder):
    size = 1024
    height, _ = weave(size, 160, 1000)
    slub = spectral((size, size), 1.4, 1003, 4, 200, stretch=(1, 12)) + spectral((size, size), 1.4, 1004, 4, 200, stretch=(12, 1))
    cloud = spectral((size, size), 2.2, 1005, 1, 8)
    colour = np.array([.84, .82, .76]) * (.9 + .1 * height + .025 * slub + .02 * cloud)[..., None]
    write(folder, "linen", np.clip(colour, 0, .9), np.clip(.86 + .04 * slub, .5, 1), .00035 * height + .00012 * slub, (.5, .5), .7 + .3 * height, quality=80)


def brocade(folder):
    """Crimson silk with gold thread: an ogival lattice with a quatrefoil in every cell, and a gold hem."""
    size = 1024
    y, x = np.meshgrid((np.arange(size) + .5) / size, (np.arange(size) + .5) / size, indexing="ij")
    u, v = x * 5, y * 4
    swing = .25 + .25 * np.cos(2 * np.pi * v)  # ogees that touch every half turn
    line = np.minimum(np.abs((u + swing) % 1 - .5), np.abs((u - swing) % 1 - .5))
    shift = np.where((v % 1 > .25) & (v % 1 < .75), .5, .0)
    cu, cv = ((u + shift) % 1) - .5, ((v + .25) % .5) - .25
    r, th = np.hypot(cu, cv * 1.25), np.arctan2(cv * 1.25, cu)
    flower = r < .135 * (.72 + .28 * np.cos(4 * th))
    flower |= (r > .16) & (r < .178)
    gold = (line < .03) | flower
    edge = np.minimum(np.minimum(x, 1 - x), 1 - y)
    hem = (edge < .035) & (edge > .004)
    gold = np.where(edge < .045, hem & ((np.floor(edge / .035 * 5) % 2 == 0) | (np.sin((x + y) * 220) > 0)), gold)
    height, _ = weave(size, 220, 1100)
    g = blur(gold.astype(float), 1.0)
    silk = np.array([.235, .012, .018]) * (.75 + .35 * height + .05 * spectral((size, size), 1.6, 1103, 4, 300, stretch=(12, 1)))[..., None]
    thread = np.array([.78, .53, .20]) * (.7 + .3 * height)[..., None]
    colour = mix(silk, thread, g)
    write(folder, "brocade", np.clip(colour, 0, .95), np.clip(.58 - .16 * g, .2, 1), .0006 * g + .00022 * height, (1, 1), .75 + .25 * height, metal=.9 * g, quality=82)


def water(folder):
    """Faint ripples."""
    size = 256
    height = .00035 * spectral((size, size), 2.8, 1200, 2, 20)
    imageio.save(folder / "water_normal.png", normal_map(height, .6 / size))


MAKERS = {
    "ashlar": lambda f: stone(f, "ashlar", 2048, 4.0, (.27, .40), (.45, .85), .010, 100, (.525, .472, .385), 1.0, quality=84),
    "dressed": lambda f: stone(f, "dressed", 1024, 2.0, (.42, .58), (2.0, 2.0), .006, 200, (.56, .51, .425), .6, perpends=False, depth=.003),
    "web": lambda f: stone(f, "web", 1024, 2.4, (.16, .22), (.28, .5), .010, 300, (.60, .555, .475), .9, depth=.005),
    "flagstone": flagstone, "oak": oak, "iron": iron, "linen": linen, "brocade": brocade, "water": water,
}

if __name__ == "__main__":
    target = pathlib.Path(sys.argv[1])
    target.mkdir(parents=True, exist_ok=True)
    for wanted in sys.argv[2:] or MAKERS:
        MAKERS[wanted](target)
        print(wanted, flush=True)
