"""Altar, cloths, candlesticks, chandeliers and the font."""
import numpy as np

import columns
import plan
import walls
from mesh import unit

ALTAR_Z, ALTAR_FLOOR = -8.3, plan.CHANCEL_FLOOR + 0.16
ALTAR_TOP = ALTAR_FLOOR + 0.98
STANDING_CANDLE = 1.334   # its foot over the altar's floor
FONT = np.array([-2.3, 0.0, 8.0])
WATER_LEVEL = 0.965
STATUE, STATUE_TURN = (-2.65, 1.0, -8.6), np.radians(43)  # its foot over the chancel's floor; it looks into the nave
BOWL, PILLAR = (0.60, ALTAR_TOP + 0.005, ALTAR_Z + 0.24), (0.80, ALTAR_TOP + 0.005, ALTAR_Z + 0.17)
CHANDELIERS = [(0, 4.1, 4.0), (0, 4.1, -4.0)]
FLAMES = {"altar": [], "chandelier": []}


def lathe(mesh, profile, centre=(0, 0, 0), around=24, uv_scale=1.0, sides=0):
    """Turns (radius, height) about the vertical through `centre`; `sides` = 8 makes it octagonal with flat faces."""
    profile = np.asarray(profile, float)
    th = np.linspace(0, 2 * np.pi, (around if not sides else sides * 4) + 1)
    shape = columns.octagon_radius(th, 1.0) if sides else np.ones_like(th)
    r = profile[:, :1] * shape
    p = np.stack([r * np.cos(th), np.broadcast_to(profile[:, 1:], r.shape), r * np.sin(th)], -1) + np.asarray(centre)
    g = np.gradient(profile, axis=0)
    n2 = unit(np.stack([g[:, 1], -g[:, 0]], -1))
    if sides:
        facet = (np.floor((th + np.pi / 8) / (np.pi / 4)) * np.pi / 4)
        radial = np.stack([np.cos(facet), 0 * th, np.sin(facet)], -1)
    else:
        radial = np.stack([np.cos(th), 0 * th, np.sin(th)], -1)
    n = n2[:, None, :1] * radial[None] + n2[:, None, 1:] * np.array([0, 1.0, 0])
    edge = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(profile, axis=0), axis=1))])
    uv = np.stack(np.broadcast_arrays(th[None] * max(profile[:, 0].max(), .02), edge[:, None]), -1) * uv_scale
    mesh.grid(p, uv, n)


def candle(wax, flame, foot, height, radius, rng, key):
    """A candle with a melted rim, its wick hidden in the flame's foot."""
    th = np.linspace(0, 2 * np.pi, 17)
    heights = np.array([0, height * .5, height - .012, height, height - .004, height - .010])
    radii = np.array([1, 1.0, 1.0, .9, .6, .05]) * radius
    p = []
    for k, (h, r) in enumerate(zip(heights, radii)):
        wave = rng.normal(0, .0015 if k in (2, 3) else 0, len(th))
        wave[-1] = wave[0]
        drip = 1 + (.06 * np.maximum(np.cos(3 * th + rng.uniform(0, 6)), 0) ** 6 if k in (1, 2) else 0)
        p.append(np.stack([r * drip * np.cos(th), h + wave, r * drip * np.sin(th)], -1))
    wax.grid(np.array(p) + foot, away=np.asarray(foot) + [0, height / 2, 0])
    burning(flame, np.asarray(foot) + [0, height - .006, 0], key)


def burning(flame, top, key):
    """A flame that stands at `top`."""
    t = np.linspace(0, 1, 10)
    r = .011 * np.sin(np.pi * t ** .62) ** .9 * (1 - .35 * t)
    r[0] = r[-1] = 0
    lathe(flame, np.stack([r, t * .062], -1), top, 12)
    FLAMES[key].append((top + [0, .03, 0]).tolist())


def candlestick(brass, foot, height):
    """A turned stick with a drip pan."""
    s = height
    profile = [(.085, 0), (.085, .012), (.07, .022), (.045, .035), (.03, .06), (.022, .075), (.034, .09), (.022, .105), (.013, .13),
               (.012, .3 * s), (.02, .42 * s), (.034, .47 * s), (.02, .52 * s), (.012, .62 * s), (.011, s - .09), (.018, s - .075),
               (.012, s - .06), (.03, s - .04), (.062, s - .024), (.066, s - .018), (.06, s - .016), (.02, s - .024), (.017, s - .02), (.017, s), (.012, s), (.0, s - .01)]
    lathe(brass, profile, foot, 24)


def altar(stone, dressed, linen, brocade, brass, wax, flame):
    rng = np.random.default_rng(2)
    z, y = ALTAR_Z, ALTAR_FLOOR
    walls.box(dressed, [-1.9, y - .2, z - .75], [1.9, y, z + 1.15], .012, axis=0)            # predella
    walls.box(dressed, [-1.05, y - .01, z - .38], [1.05, y + .82, z + .38], .01, axis=0)     # block
    walls.box(stone, [-1.25, y + .82, z - .5], [1.25, y + .98, z + .5], .025, axis=0)        # mensa
    for x in (-1.12, -.56, .56, 1.12):
        lathe(dressed, [(.085, 0), (.085, .05), (.075, .06), (.08, .08), (.062, .1), (.055, .13), (.055, .68), (.062, .69), (.055, .7), (.075, .78), (.09, .79), (.09, .82)],
              (x, y, z + .42), 20)
    top = y + .98
    _cloth(linen, 1.27, .53, top + .004, z, .42, .16, rng)
    # The frontal: a brocade panel hanging before the block.
    us, vs = np.linspace(-.5, .5, 41), np.linspace(0, 1, 9)
    fold = .012 * np.sin(us * 34)[:, None] * vs[None] ** .8 + .006 * np.sin(us * 71 + 1)[:, None] * vs[None]
    p = np.stack([np.broadcast_to(us[:, None], fold.shape), np.broadcast_to(top - .02 - vs[None] * .78, fold.shape), z + .516 + fold], -1)
    uv = np.stack([np.broadcast_to(us[:, None] + .5, fold.shape), np.broadcast_to(1 - vs[None] * .78, fold.shape)], -1)
    brocade.grid(p, uv, out=[0, 0, 1])
    p = np.array([[[x, top + .0065, z + d] for d in (-.3, .516)] + [[x, top - .02, z + .519]] for x in (-.5, .5)])
    brocade.grid(p, np.array([[[u, .42], [u, 1.0 - .015], [u, 1.0]] for u in (0, 1)]), np.broadcast_to([0, 1.0, 0], p.shape), out=[0, 1, .2])
    for x in (-.95, -.68, .68, .95):
        h = .52 if abs(x) > .8 else .42
        candlestick(brass, (x, top + .006, z - .22), h)
        candle(wax, flame, np.array([x, top + h, z - .22]), .30, .014, rng, "altar")
    for x in (-1.65, 1.65):
        foot = np.array([x, ALTAR_FLOOR, z + .75])
        candlestick(brass, foot, 1.35)
        burning(flame, foot + [0, STANDING_CANDLE + .482, 0], "altar")   # in the hollow of subjects/tall_candle.ply, which the scene puts here
    burning(flame, np.array(PILLAR) + [0, .099, 0], "altar")   # in that of subjects/candle.ply
    _cross(brass, top, z)


def _cross(brass, top, z):
    lathe(brass, [(.13, 0), (.13, .015), (.1, .03), (.06, .05), (.03, .09), (.04, .12), (.02, .15), (.012, .2)], (0, top + .007, z - .22), 24)
    walls.box(brass, [-.014, top + .19, z - .232], [.014, top + .82, z - .208], .006)
    walls.box(brass, [-.17, top + .6, z - .232], [.17, top + .628, z - .208], .006, axis=0)
    for x, y in ((-.17, .614), (.17, .614), (0, .82)):
        lathe(brass, [(0, -.026), (.02, -.02), (.027, 0), (.02, .02), (0, .026)], (x, top + y, z - .22), 14)


def _cloth(linen, half_x, half_z, top, z, drop_x, drop_z, rng):
    """Linen over the mensa: flat on top, hanging in soft folds at both ends and a short fall in front."""
    xs = np.concatenate([-half_x - np.linspace(drop_x, 0, 9)[:-1], np.linspace(-half_x, half_x, 15), half_x + np.linspace(0, drop_x, 9)[1:]])
    zs = np.concatenate([np.linspace(-half_z, half_z, 21), half_z + np.linspace(0, drop_z, 5)[1:]])
    fx = np.clip(np.abs(xs) - half_x, 0, None)
    fz = np.clip(zs - half_z, 0, None)
    x = np.sign(xs) * np.minimum(np.abs(xs), half_x)[...]
    p = np.zeros((len(xs), len(zs), 3))
    p[..., 0] = x[:, None] + np.sign(xs)[:, None] * (.014 * np.sin(zs * 21)[None] + .01) * (fx[:, None] / drop_x)
    p[..., 1] = top - np.maximum(fx[:, None], fz[None]) + np.where((fx[:, None] == 0) & (fz[None] == 0), rng.normal(0, .0008, p.shape[:2]), 0)
    p[..., 2] = z + np.minimum(zs, half_z)[None] + (.006 + .010 * np.sin(xs * 17)[:, None]) * (fz[None] / drop_z) * (fx[:, None] == 0)
    uv = np.stack(np.broadcast_arrays(xs[:, None], zs[None]), -1)
    linen.grid(p, uv, out=[0, 1, 0])


def ring(mesh, centre, radius, thick, tall, around=48):
    """A flat iron hoop."""
    a = np.linspace(0, 2 * np.pi, around + 1)
    radial = np.stack([np.cos(a), 0 * a, np.sin(a)], -1)
    h, w = tall / 2, thick / 2
    pts = np.array([(w, -h), (w, h), (w, h), (-w, h), (-w, h), (-w, -h), (-w, -h), (w, -h)])
    nrm = np.array([(1, 0), (1, 0), (0, 1), (0, 1), (-1, 0), (-1, 0), (0, -1), (0, -1)], float)
    mesh.sweep(pts, nrm, np.asarray(centre) + radial * radius, radial, np.broadcast_to([0, 1.0, 0], radial.shape))


def rod(mesh, a, b, radius, sides=8):
    a, b = np.asarray(a, float), np.asarray(b, float)
    d = unit(b - a)
    x = unit(np.cross(d, [.3, .1, .9]))
    th = np.radians(np.linspace(0, 360, sides + 1)[:-1])
    s = np.stack([np.cos(th), np.sin(th)], -1)
    mesh.sweep(s * radius, s, np.array([a, b]), np.broadcast_to(x, (2, 3)), np.broadcast_to(np.cross(d, x), (2, 3)), closed=True)


def chain(mesh, top, bottom, pitch=0.075):
    """Oval links, each turned a quarter against the last."""
    top, bottom = np.asarray(top, float), np.asarray(bottom, float)
    count = max(int(np.linalg.norm(bottom - top) / pitch), 2)
    d = (bottom - top) / count
    axis = unit(d)
    x = unit(np.cross(axis, [.2, .1, 1]))
    y = np.cross(axis, x)
    a = np.linspace(0, 2 * np.pi, 9)
    th = np.radians([0, 120, 240])
    s = np.stack([np.cos(th), np.sin(th)], -1)
    for k in range(count):
        side = x if k % 2 else y
        other = y if k % 2 else x
        c = top + d * (k + .5)
        radial = np.cos(a)[:, None] * axis * 1.0 + np.sin(a)[:, None] * side * .55
        n = unit(np.cos(a)[:, None] * axis * .6 + np.sin(a)[:, None] * side)
        mesh.sweep(s * .0055, s, c + radial * pitch * .58, n, np.broadcast_to(other, n.shape), closed=True)


def chandelier(iron, wax, flame):
    """A crown of twelve candles about the origin, hung on three rods and a chain to the keystone."""
    rng = np.random.default_rng(8)
    ring(iron, (0, 0, 0), .72, .008, .075)
    ring(iron, (0, .03, 0), .724, .014, .012)
    ring(iron, (0, -.03, 0), .724, .014, .012)
    for k in range(12):
        a = k * np.pi / 6
        c = np.array([np.cos(a) * .72, .04, np.sin(a) * .72])
        lathe(iron, [(0, 0), (.012, .0), (.018, .02), (.045, .032), (.05, .042), (.042, .04), (.016, .036), (.016, .06), (.012, .062)], c, 12)
        candle(wax, flame, c + [0, .05, 0], rng.uniform(.13, .2), .0125, rng, "chandelier")
        tip = c + [0, .0, 0]
        lathe(iron, [(0, -.02), (.008, -.012), (.0, .0)], tip * [1.012, 0, 1.012] + [0, -.045, 0], 8)
    for k in range(3):
        a = k * 2 * np.pi / 3 + .26
        rod(iron, [np.cos(a) * .72, .03, np.sin(a) * .72], [0, 1.05, 0], .007)
    lathe(iron, [(0, 0), (.02, .01), (.035, .04), (.02, .08), (0, .1)], (0, 1.02, 0), 12)
    chain(iron, (0, plan.BOSS - .38 - CHANDELIERS[0][1], 0), (0, 1.1, 0))


def font(dressed):
    """An octagonal stone basin on a stem and steps; the bowl is round inside."""
    c = FONT
    lathe(dressed, [(.78, -.05), (.78, .13), (.765, .145), (.56, .147)], c, sides=8)
    lathe(dressed, [(.57, .14), (.57, .27), (.555, .285), (.40, .288), (.395, .33), (.37, .35), (.34, .36), (.30, .40), (.265, .43), (.25, .47),
                    (.25, .62), (.275, .64), (.27, .67), (.33, .70), (.43, .76), (.485, .80), (.50, .82), (.50, .985), (.515, 1.0), (.515, 1.03), (.50, 1.045), (.40, 1.047)], c, sides=8)
    bowl = np.array([(.43, 1.0465), (.415, 1.045), (.40, 1.03), (.385, .98), (.34, .86), (.25, .79), (.12, .765), (0, .76)])
    lathe(dressed, bowl, c, 40)


def water(mesh):
    """The water's surface, a disc a little below the rim."""
    rho, th = np.linspace(0, .383, 6)[:, None], np.linspace(0, 2 * np.pi, 41)[None]
    p = np.stack(np.broadcast_arrays(rho * np.cos(th), WATER_LEVEL + 0 * rho * th, rho * np.sin(th)), -1) + FONT
    mesh.grid(p, p[..., [0, 2]], np.broadcast_to([0, 1.0, 0], p.shape), out=[0, 1, 0])
