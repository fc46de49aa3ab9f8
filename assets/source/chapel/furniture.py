"""Oak pews with shaped ends, and the west door. Planks are swept sections with worn, uneven edges; u follows the grain."""
import numpy as np

import plan
import walls
from mesh import Mesh, rounded_rect, unit

PEW_LENGTH = 2.35
PEW_ROWS = [5.3 - 0.98 * k for k in range(10)]
PEW_X = [-2.04, 2.04]


def plank(mesh, rng, a, b, w, h, up=(0, 1, 0), r=0.006, wear=0.0018, steps=5):
    """A board from a to b, w wide and h thick (h along `up`)."""
    a, b, up = np.asarray(a, float), np.asarray(b, float), unit(up)
    t = np.linspace(0, 1, steps)[:, None]
    d = unit(b - a)
    side = unit(np.cross(d, up))
    up = np.cross(side, d)
    path = a * (1 - t) + b * t + up * rng.normal(0, wear, (steps, 1)) + side * rng.normal(0, wear, (steps, 1))
    path[0], path[-1] = a, b
    s, n = rounded_rect(w, h, r, 3)
    mesh.sweep(s, n, path, np.broadcast_to(side, path.shape), np.broadcast_to(up, path.shape), rng.uniform(0, 2.4, 2), closed=True, caps=True)


def bench_end_outline(n=32):
    """Front and back edge of a bench end over its height, crowned by a rounded poppy head."""
    y = np.concatenate([np.linspace(0, .9, 14), .9 + .26 * (1 - np.cos(np.linspace(0.12, np.pi, n - 14))) / 2])
    front = np.interp(y, [0, .06, .07, .3, .42, .52, .62, .8, .9], [-.25, -.25, -.225, -.225, -.235, -.215, -.02, .13, .17])
    back = np.interp(y, [0, .06, .07, .45, .9], [.33, .33, .30, .30, .36])
    head = y > .9
    c, r = 1.02, .14
    bulge = np.sqrt(np.maximum(r ** 2 - (y - c) ** 2, 0)) * 0.85
    neck = np.maximum(.05, bulge) + 0.012 * np.cos((y - c) * 45) * (bulge > .05)
    front = np.where(head, .27 - neck, front)
    back = np.where(head, .27 + neck, back)
    front[-1] = back[-1] = .27
    return y, front, back


def bench_end(mesh, rng, x, thickness=0.065):
    y, front, back = bench_end_outline()
    shift = rng.uniform(0, 2, 2)
    for sx in (-1, 1):
        px = x + sx * thickness / 2
        inset = 0.008
        cols = np.stack([front + inset, (front + back) / 2, back - inset], -1)
        cols[-1] = .27
        p = np.stack([np.full_like(cols, px), np.broadcast_to(y[:, None], cols.shape), cols], -1)
        uv = np.stack([p[..., 1], p[..., 2]], -1) + shift
        mesh.grid(p, uv, np.broadcast_to([sx, 0, 0], p.shape), out=[sx, 0, 0])
    loop = np.concatenate([np.stack([front, y], -1), np.stack([back, y], -1)[::-1][1:]])
    t = unit(np.gradient(loop, axis=0))
    n = np.stack([-t[:, 1], t[:, 0]], -1)
    half = thickness / 2
    offsets = [(-half, .008, -1, 0), (-half, .008, -.9, .4), (-half + .008, 0, -.3, 1), (half - .008, 0, .3, 1), (half, .008, .9, .4), (half, .008, 1, 0)]
    p = np.stack([np.stack([np.full(len(loop), x + dx), loop[:, 1] - n[:, 1] * d, loop[:, 0] - n[:, 0] * d], -1) for dx, d, _, _ in offsets], 1)
    nn = np.stack([np.stack([np.full(len(loop), nx), n[:, 1] * k, n[:, 0] * k], -1) for _, _, nx, k in offsets], 1)
    mesh.grid(p, None, nn)
    # Blind lancets carved on both faces.
    for sx in (-1, 1):
        for cz in (-.11, .06):
            w = plan.Window(.07, .14, .36, .11)
            u = w.half * np.cos(np.linspace(0, np.pi / 2, 5))
            u[-1] = 0
            arch = np.stack([u, w.upper(u)], -1)
            run = np.vstack([[[.07, .14]], arch, (arch * [-1, 1])[::-1][1:], [[-.07, .14]], [[.07, .14]]])
            d = unit(np.gradient(run, axis=0))
            side = np.stack([0 * d[:, 0], -d[:, 0], d[:, 1]], -1)
            a = np.radians([0, 60, 120, 180])
            sec = np.stack([np.cos(a), np.sin(a)], -1)
            path = np.stack([np.full(len(run), x + sx * (half - .001)), run[:, 1], run[:, 0] + cz], -1)
            mesh.sweep(sec * .009, sec, path, side, np.broadcast_to([sx, 0.0, 0], side.shape))


def pew(mesh):
    """A pew centred on x = 0 whose sitters look towards -Z; seat at 0.45 m."""
    rng = np.random.default_rng(5)
    h = PEW_LENGTH / 2
    for sx in (-1, 1):
        bench_end(mesh, rng, sx * h)
    e = h - .03
    plank(mesh, rng, [-e, .432, -.03], [e, .432, -.03], .42, .036, r=.012, steps=7)
    plank(mesh, rng, [-e, .34, -.19], [e, .34, -.19], .14, .025, up=(0, 0, -1), r=.005)
    recline = unit([0, .97, .13])
    face = unit([0, .13, -.97])
    for k in range(3):
        c = np.array([0, .50, .20]) + recline * (k * .138)
        plank(mesh, rng, c - [e, 0, 0], c + [e, 0, 0], .134, .024, up=face, r=.005)
    c = np.array([0, .915, .258])
    plank(mesh, rng, c - [e, 0, 0], c + [e, 0, 0], .075, .05, up=(0, 1, 0), r=.02, steps=7)
    plank(mesh, rng, [-e, .74, .33], [e, .74, .33], .17, .022, up=unit([0, 1, .12]), r=.005)
    plank(mesh, rng, [-e, .765, .408], [e, .765, .408], .016, .05, up=(0, 1, 0), r=.005)
    plank(mesh, rng, [-e + .05, .16, .55], [e - .05, .16, .55], .18, .03, up=unit([0, 1, .2]), r=.01)
    for x in (-e + .25, 0, e - .25):
        walls.box(mesh, [x - .03, 0, .5], [x + .03, .15, .6], .006, uv0=rng.uniform(0, 2, 2))
    walls.box(mesh, [-.03, 0, -.15], [.03, .42, .2], .006, uv0=rng.uniform(0, 2, 2))


def door(wood, iron):
    """Two leaves of vertical boards with strap hinges, set in the west doorway."""
    rng = np.random.default_rng(9)
    f, w, depth = plan.west(), plan.DOOR, 0.56
    edges = np.linspace(-w.half - .02, w.half + .02, 13)
    for a, b in zip(edges[:-1], edges[1:]):
        us = np.array([a, a + .006, (a + b) / 2, b - .006, b])
        ds = np.array([.014, 0, 0, 0, .014]) + depth + rng.normal(0, .0015)
        top = w.upper(np.clip(us, -w.half, w.half)) + .03
        t = np.linspace(0, 1, 5)
        v = -.02 + (top[:, None] + .02) * t
        uv = np.stack([np.broadcast_to(us[:, None], v.shape), v], -1)
        p = f.at(uv, np.broadcast_to(ds[:, None], v.shape))
        tex = np.stack([v, np.broadcast_to((us - a)[:, None], v.shape)], -1) + rng.uniform(0, 2, 2)
        wood.grid(p, tex, out=-f.w)
        wood.grid(p + f.w * .07, tex, out=f.w)
    for v in (.45, 1.75):
        for s in (-1, 1):
            length = w.half - .06
            u = np.linspace(.03, length, 9)
            width = np.interp(u, [.03, .1, length], [.012, .035, .045]) + .012 * np.cos(u * 25) * (u < .25)
            top, low = np.stack([s * (w.half - u), v + width], -1), np.stack([s * (w.half - u), v - width], -1)
            rows = [f.at(low, depth - .001), f.at(low, depth - .012), f.at(top, depth - .012), f.at(top, depth - .001)]
            for r0, r1, out in ((0, 1, [0, -1, 0]), (1, 2, -f.w), (2, 3, [0, 1, 0])):
                iron.grid(np.stack([rows[r0], rows[r1]], 1), out=out)
    a = np.linspace(0, 2 * np.pi, 25)
    ring = f.at(np.stack([.16 + .075 * np.sin(a), 1.02 + .075 * np.cos(a)], -1), depth - .025)
    sec = np.radians(np.linspace(0, 360, 9)[:-1])
    s = np.stack([np.cos(sec), np.sin(sec)], -1)
    x = np.sin(a)[:, None] * f.u + np.cos(a)[:, None] * f.v
    iron.sweep(s * .009, s, ring, x, np.broadcast_to(f.w, x.shape), closed=True)
