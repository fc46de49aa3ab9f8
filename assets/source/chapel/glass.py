"""Stained glass: the linear transmittance of each window design, with leads, bars, paint and weathering. Usage: glass.py OUTPUT_DIRECTORY"""
import pathlib
import sys

import numpy as np

import imageio
import plan
from build import glass_extent
from noise import blur, smooth, spectral

BLUE, COBALT, AZURE = (.030, .095, .52), (.05, .20, .70), (.16, .38, .72)
RUBY, ROSE, AMBER, GOLD = (.40, .014, .014), (.52, .13, .12), (.62, .24, .025), (.60, .39, .075)
GREEN, OLIVE, AQUA = (.03, .30, .09), (.20, .27, .045), (.13, .34, .31)
PURPLE, WHITE, PEARL = (.22, .035, .26), (.47, .48, .40), (.34, .39, .32)


class Cartoon:
    """A window being drawn: a colour and a piece number per texel; leads run where piece numbers change."""

    def __init__(self, window, width, height, seed):
        self.window, self.rng, self.seed = window, np.random.default_rng(seed), seed
        bottom, top = glass_extent(window)
        self.px = (2 * window.half / width, (top - bottom) / height)
        u = (np.arange(width) + .5) * self.px[0] - window.half
        v = top - (np.arange(height) + .5) * self.px[1]
        self.u, self.v = np.meshgrid(u, v)
        self.piece = np.zeros((height, width), np.int64)
        self.colour = np.zeros((height, width, 3))
        self.paint = np.zeros((height, width))
        self.layer = 0

    def fill(self, mask, number, colours):
        """Lays pieces: `number` tells them apart inside the mask, and picks among `colours`."""
        self.layer += 1
        number = np.broadcast_to(np.asarray(number, np.int64), self.piece.shape)
        colours = np.asarray(colours, float).reshape(-1, 3)
        self.piece[mask] = (number[mask] + 100000) * 1000 + self.layer
        self.colour[mask] = colours[number[mask] % len(colours)]

    def brush(self, mask, amount):
        """Dark vitreous paint on the glass."""
        self.paint = np.maximum(self.paint, mask * amount)

    def finish(self, lead=0.0085, bars=0.62):
        h, w = self.piece.shape
        ids, index = np.unique(self.piece, return_inverse=True)
        index = index.reshape(h, w)
        shade = np.exp(self.rng.normal(0, .20, len(ids)))[index]
        hue = self.rng.normal(0, .10, (len(ids), 3))[index]
        colour = self.colour * shade[..., None] * (1 + hue)
        p = self.piece
        edge = np.zeros((h, w))
        edge[:, :-1] += p[:, :-1] != p[:, 1:]
        edge[:-1] += p[:-1] != p[1:]
        edge = np.clip(edge, 0, 1)
        # Widen the one-texel edges to cames of `lead` metres, with anti-aliased rims.
        near = 1 - np.clip(_distance(edge > 0, self.px, lead * 1.6) / lead, 0, 1.6)
        came = smooth(.36, .62, near)
        bar = np.abs((self.v - self.window.sill + .3) % bars - bars / 2) < .011 if not self.window.round_window else np.zeros((h, w), bool)
        came = np.maximum(came, bar)
        aspect = self.px[0] / self.px[1]
        streak = spectral((h, w), 1.7, self.seed + 1, 3, w / 4, stretch=(aspect * 3, 1))
        cloud = spectral((h, w), 2.2, self.seed + 2, 1, 16, stretch=(aspect, 1))
        bubbles = smooth(2.6, 3.4, spectral((h, w), .7, self.seed + 3, w / 16, w / 5, stretch=(aspect, 1)))
        grime = blur(came, 5)
        colour *= np.exp(.10 * streak + .10 * cloud - .25 * bubbles - .75 * grime)[..., None]
        colour *= (1 - .82 * self.paint)[..., None]
        colour = np.clip(colour, .002, .92)
        return colour * (1 - came)[..., None] + .0004 * came[..., None]


def _distance(mask, px, reach):
    """Distance in metres to the nearest set texel, exact up to `reach`."""
    d = np.where(mask, 0.0, 1e3)
    best = d.copy()
    ry, rx = int(reach / px[1]) + 1, int(reach / px[0]) + 1
    for dy in range(-ry, ry + 1):
        for dx in range(-rx, rx + 1):
            step = np.hypot(dx * px[0], dy * px[1])
            if 0 < step <= reach:
                best = np.minimum(best, np.roll(d, (dy, dx), (0, 1)) + step)
    return best


def lancet_depth(c, cx, half, spring, rise, sill):
    """How far inside a lancet light each texel is (negative outside)."""
    r = (half ** 2 + rise ** 2) / (2 * half)
    x = np.abs(c.u - cx)
    d = np.where(c.v <= spring, half - x, r - np.hypot(x + r - half, c.v - spring))
    return np.minimum(d, c.v - sill)


def border(c, d, light, pitch, colours, beads):
    """A white fillet, coloured blocks parted by beads, and an inner fillet."""
    along = np.floor(c.v / pitch).astype(int)
    c.fill(light & (d < .125), 0, [WHITE])
    c.fill(light & (d < .112), along, colours)
    bead = np.hypot(d - .065, ((c.v / pitch) % 1) * pitch) < .026
    bead |= np.hypot(d - .065, (1 - (c.v / pitch) % 1) * pitch) < .026
    c.fill(light & bead & (d < .112), along * 2 + (((c.v / pitch) % 1) > .5), [beads])
    c.fill(light & (d < .020), along, [WHITE])


def lozenges(c, light, cx, pitch, aspect, colours, flower):
    """A quarry field; each quarry carries a painted four-petalled flower."""
    x, y = (c.u - cx) / pitch, c.v / (pitch * aspect)
    a, b = np.floor(x + y).astype(int), np.floor(x - y).astype(int)
    c.fill(light, (a * 7 + b * 13) % 997 + a * 1000 + b * 1000000, [colours[0]])
    k = len(colours)
    index = (a + 2 * b) % k
    for i in range(1, k):
        m = light & (index == i)
        c.colour[m] = colours[i]
    fx, fy = (x + y) % 1 - .5, (x - y) % 1 - .5
    r, th = np.hypot(fx, fy), np.arctan2(fy, fx)
    petal = np.abs(r - .23 * np.abs(np.cos(2 * th)) - .03) < .018
    if flower:
        c.brush(light & (petal | (r < .035)), .8)


def ring_of(c, mask_radius, cx, cy, count, turn=0.0):
    r, th = np.hypot(c.u - cx, c.v - cy), np.arctan2(c.v - cy, c.u - cx) + np.radians(turn)
    return r / mask_radius, th, np.floor((th / (2 * np.pi) * count) % count).astype(int)


def rosette(c, inside, cx, cy, radius, ground, petals, eye, count=8, frame=GOLD, turn=0.0):
    """A medallion: a pearled frame, a ground, two rings of petals and an eye."""
    r, th, sector = ring_of(c, radius, cx, cy, count * 2, turn)
    c.fill(inside & (r < 1), sector, [frame])
    c.fill(inside & (r < .91), sector // 2, ground)
    long = np.abs(((th * count / (2 * np.pi)) % 1) - .5) * 2
    c.fill(inside & (r < .80 - .34 * long ** 1.6) & (r > .24), sector // 2, petals)
    c.fill(inside & (r < .40 - .13 * (1 - long)), sector // 2, [ground[-1]])
    c.fill(inside & (r < .24), 0, [eye])
    c.brush(inside & (np.abs(r - .955) < .018) & (np.sin(th * 48) > -.3), .75)
    c.brush(inside & (np.abs(long - .0) < .05) & (r > .42) & (r < .76), .6)
    c.brush(inside & (np.abs(r - .12) < .025), .7)


def quatrefoil(c, inside, cx, cy, radius, ground, inner, petals, eye, frame=GOLD):
    """A four-lobed medallion around a rosette."""
    dx, dy = np.abs(c.u - cx), np.abs(c.v - cy)
    lobe = radius * .56
    d = np.minimum(np.hypot(dx - radius * .48, dy), np.hypot(dx, dy - radius * .48)) / lobe
    q = (np.floor(np.arctan2(c.v - cy, c.u - cx) / (np.pi / 2) + .5) % 4).astype(int)
    c.fill(inside & (d < 1), q, [frame])
    c.fill(inside & (d < .86), q, ground)
    trefoil = (np.hypot(dx - radius * .70, dy) < lobe * .30) | (np.hypot(dx, dy - radius * .70) < lobe * .30)
    c.fill(inside & trefoil, q, [petals[0]])
    c.brush(inside & (d < .86) & (d > .78), .7)
    rosette(c, inside, cx, cy, radius * .58, inner, petals, eye, 8, frame)


def vesica(c, inside, cx, cy, radius, ground, petals, eye, frame=WHITE):
    """An almond of scales with a small rosette."""
    dx, dy = np.abs(c.u - cx), np.abs(c.v - cy)
    d = np.hypot(dx + radius * .62, dy) / (radius * 1.32)
    c.fill(inside & (d < 1), (c.v > cy).astype(int), [frame])
    row = np.floor(c.v / .075).astype(int)
    col = np.floor((c.u - cx) / .09 + .5 * (row % 2)).astype(int)
    c.fill(inside & (d < .90), row * 50 + col + 5000, ground)
    rosette(c, inside, cx, cy, radius * .56, [ground[0], ground[1]], petals, eye, 6, frame)


STYLES = {
    "a": dict(field=[BLUE, COBALT, BLUE], flower=False, border=[RUBY, GREEN], beads=GOLD, spandrel=[BLUE, RUBY],
              medal=lambda c, m, x, y, k: quatrefoil(c, m, x, y, .335, [RUBY, RUBY], [COBALT, BLUE], [GOLD, WHITE], AMBER)),
    "b": dict(field=[PEARL, GOLD, PEARL, AQUA], flower=True, border=[COBALT, RUBY], beads=WHITE, spandrel=[RUBY, AMBER],
              medal=lambda c, m, x, y, k: rosette(c, m, x, y, .335, [COBALT, BLUE], [[RUBY, AMBER], [AMBER, RUBY]][k % 2], GOLD, 8, WHITE)),
    "c": dict(field=[GREEN, AQUA, GREEN], flower=False, border=[COBALT, RUBY], beads=GOLD, spandrel=[BLUE, GREEN],
              medal=lambda c, m, x, y, k: vesica(c, m, x, y, .36, [[AZURE, COBALT, BLUE], [RUBY, PURPLE, RUBY]][k % 2], [GOLD, AMBER], WHITE, GOLD)),
    "d": dict(field=[RUBY, PURPLE, RUBY], flower=False, border=[COBALT, AQUA], beads=GOLD, spandrel=[GREEN, BLUE],
              medal=lambda c, m, x, y, k: vesica(c, m, x, y, .36, [[AZURE, COBALT, BLUE], [GREEN, OLIVE, AQUA]][k % 2], [GOLD, AMBER], WHITE, GOLD)),
}


def light(c, style, cx, half, spring, rise, sill, step=1.02, first=.62):
    """One lancet light in a style: field, border and a ladder of medallions."""
    s = STYLES[style]
    d = lancet_depth(c, cx, half, spring, rise, sill)
    inside = d > 0
    pitch = .17 if not s["flower"] else .155
    lozenges(c, inside, cx, pitch, 1.45, s["field"], s["flower"])
    if not s["flower"]:  # small jewels where the quarries cross
        x, y = (c.u - cx) / pitch, c.v / (pitch * 1.45)
        a, b = (x + y + .5) % 1 - .5, (x - y + .5) % 1 - .5
        cell = np.floor(x + y + .5).astype(int) * 401 + np.floor(x - y + .5).astype(int)
        c.fill(inside & (np.hypot(a, b) < .2), cell + 50000, [s["beads"]])
    border(c, d, inside, .26, s["border"], s["beads"])
    field = inside & (d > .05)
    y, k = sill + first, 0
    while y < spring + rise * .45:
        s["medal"](c, field, cx, y, k)
        y, k = y + step, k + 1


def spandrels(c, colours):
    """Everything outside the lights: a fan of bent pieces."""
    r = np.hypot(c.u, c.v - c.window.spring)
    ring = np.floor(r / .22).astype(int)
    th = np.floor(np.arctan2(c.v - c.window.spring, c.u) / (2 * np.pi) * (8 + 4 * ring)).astype(int)
    c.fill(np.ones_like(r, bool), ring * 100 + th + 3000, colours)


def roundel(c, cx, cy, radius, ground, petals, eye, count, turn=0.0, frame=GOLD):
    inside = np.hypot(c.u - cx, c.v - cy) < radius
    rosette(c, inside, cx, cy, radius, ground, petals, eye, count, frame, turn)


def side(style, seed):
    w = plan.SIDE
    c = Cartoon(w, 1024, 2048, seed)
    spandrels(c, STYLES[style]["spandrel"])
    for cx in (-.5, .5):
        light(c, style, cx, .5, w.spring - .25, .95, w.sill)
    roundel(c, 0, 8.02, .42, [COBALT, BLUE] if style != "b" else [RUBY, PURPLE], [GOLD, WHITE], RUBY if style != "b" else AZURE, 8, 22.5)
    return c.finish()


def eastern(seed):
    w = plan.EASTERN
    c = Cartoon(w, 1536, 2048, seed)
    spandrels(c, [BLUE, COBALT, RUBY, BLUE])
    for k, cx in enumerate((-1.65, -.55, .55, 1.65)):
        light(c, "adda"[k], cx, .55, w.spring - .6, .95, w.sill, 1.06, .56)
    for cx in (-1.1, 1.1):
        roundel(c, cx, 6.72, .37, [RUBY, PURPLE], [GOLD, WHITE], COBALT, 8, 22.5)
    roundel(c, 0, 8.12, .80, [COBALT, BLUE], [RUBY, AMBER], GOLD, 12)
    for k in range(6):
        a = np.radians(30 + 60 * k)
        roundel(c, .49 * np.cos(a), 8.12 + .49 * np.sin(a), .20, [RUBY, ROSE], [GOLD, WHITE], COBALT, 6)
    roundel(c, 0, 8.12, .22, [COBALT, GREEN], [GOLD, WHITE], RUBY, 8)
    return c.finish()


def rose(seed):
    w = plan.ROSE
    c = Cartoon(w, 1024, 1024, seed)
    r, th, sector = ring_of(c, w.half, 0, w.spring, 16)
    ring = np.floor(r * 9).astype(int)
    c.fill(r < 2, ring * 16 + sector, [BLUE, COBALT, RUBY])
    for k in range(8):
        a = np.radians(45 * k + 45)
        roundel(c, .88 * np.cos(a), w.spring + .88 * np.sin(a), .32, [[RUBY, PURPLE], [GREEN, COBALT]][k % 2], [GOLD, WHITE], AMBER, 8)
    roundel(c, 0, w.spring, .34, [RUBY, ROSE], [GOLD, WHITE], COBALT, 8)
    return c.finish()


def designs():
    """Name -> function that draws its linear transmittance."""
    return {"a": lambda: side("a", 31), "b": lambda: side("b", 32), "c": lambda: side("c", 33), "east": lambda: eastern(34), "rose": lambda: rose(35)}


if __name__ == "__main__":
    target = pathlib.Path(sys.argv[1])
    for name, draw in designs().items():
        t = draw()
        imageio.save(target / f"glass_{name}.jpg", imageio.to_srgb(t), 92)
        print(name, "mean transmittance", t.reshape(-1, 3).mean(0).round(3), flush=True)
