"""Window tracery: chamfered stone bars along the arcs of each design, in the window's own plane (x right, y up, z to the inside)."""
import numpy as np

import plan
from mesh import unit

BAR = np.array([(-.055, -.06), (-.055, -.015), (-.03, .07), (-.012, .085), (.012, .085), (.03, .07), (.055, -.015), (.055, -.06)])


def bar(mesh, path, scale=1.0, closed=False):
    """Sweeps the bar section along a 2D path [k,2]."""
    path = np.asarray(path, float)
    t = np.gradient(path, axis=0)
    if closed:
        t[0] = t[-1] = path[1] - path[-2]
    t = unit(t)
    side = np.stack([t[:, 1], -t[:, 0], 0 * t[:, 0]], -1)
    s, n = _facets(BAR * scale)
    p3 = np.concatenate([path, np.zeros((len(path), 1))], 1)
    mesh.sweep(s, n, p3, side, np.broadcast_to([0, 0, 1.0], side.shape), (path[0, 0] * 3 + path[0, 1], 0))


def _facets(s):
    """Each facet keeps its own flat normal: points doubled."""
    pts, nrm = [], []
    loop = np.vstack([s, s[:1]])
    for a, b in zip(loop[:-1], loop[1:]):
        d = b - a
        n = np.array([-d[1], d[0]]) / np.linalg.norm(d)
        pts += [a, b]
        nrm += [n, n]
    return np.array(pts), np.array(nrm)


def arc(centre, radius, a0, a1, n=13):
    a = np.radians(np.linspace(a0, a1, n))
    return np.stack([centre[0] + radius * np.cos(a), centre[1] + radius * np.sin(a)], -1)


def lancet(cx, half, spring, rise, n=11):
    """Left and right halves of a pointed head."""
    w = plan.Window(half, 0, spring, rise)
    u = half * np.cos(np.linspace(0, np.pi / 2, n))
    u[-1] = 0
    right = np.stack([u + cx, w.upper(u)], -1)
    left = np.stack([cx - u, w.upper(u)], -1)
    return [right, left]


def trefoil_cusps(mesh, cx, half, spring, rise, scale):
    """Cusped inner arcs of a lancet head: three lobes."""
    r = half * 0.62
    bar(mesh, arc((cx - half + r, spring - .05), r, 180, 62, 7), scale)
    bar(mesh, arc((cx + half - r, spring - .05), r, 0, 118, 7), scale)
    bar(mesh, arc((cx, spring + rise * .52), half * .46, -28, 208, 11), scale)


def foils(mesh, centre, radius, count, scale, turn=0.0):
    """A circle with `count` cusped foils inside."""
    bar(mesh, arc(centre, radius, 0, 360, 33), 1.0, True)
    d = radius * (0.60 if count > 4 else 0.50)
    r = d * np.sin(np.pi / count) * 1.02
    for k in range(count):
        a = turn + k * 360 / count
        c = (centre[0] + d * np.cos(np.radians(a)), centre[1] + d * np.sin(np.radians(a)))
        bar(mesh, arc(c, r, a - 118, a + 118, 11), scale)


def frame_bars(mesh, window):
    if window.round_window:
        bar(mesh, arc((0, window.spring), window.half, 0, 360, 49), 1.25, True)
        return
    pieces = window.outline(0.0, 0.0, 16)
    bar(mesh, np.vstack([pieces[1][[0, -1]], pieces[2][1:]]), 1.25)
    bar(mesh, np.vstack([pieces[3][:-1], pieces[4][[0, -1]]]), 1.25)
    bar(mesh, pieces[0][[0, -1]], 1.25)


def side_window(mesh):
    """Two lancet lights under a quatrefoiled oculus."""
    w = plan.SIDE
    frame_bars(mesh, w)
    bar(mesh, [[0, w.sill], [0, 4.7], [0, w.spring + .02]])
    for cx in (-.5, .5):
        for half in lancet(cx, .5, w.spring - .25, .95):
            bar(mesh, half, .95)
        trefoil_cusps(mesh, cx, .47, w.spring - .25, .9, .55)
    foils(mesh, (0, 8.02), .40, 4, .6, 45)


def east_window(mesh):
    """Four lights in two pairs, each pair with a small oculus, and a great sixfoil in the head."""
    w = plan.EASTERN
    frame_bars(mesh, w)
    bar(mesh, [[0, w.sill], [0, 5], [0, w.spring + .1]], 1.15)
    for c in (-1.1, 1.1):
        bar(mesh, [[c, w.sill], [c, 5], [c, w.spring - .4]])
        for half in lancet(c, 1.1, w.spring - .2, 1.65, 15):
            bar(mesh, half, 1.15)
        for d in (-.55, .55):
            for half in lancet(c + d, .55, w.spring - .6, .95):
                bar(mesh, half, .9)
            trefoil_cusps(mesh, c + d, .51, w.spring - .6, .9, .55)
        foils(mesh, (c, 6.72), .36, 4, .55, 45)
    foils(mesh, (0, 8.12), .78, 6, .7, 30)


def rose_window(mesh):
    """Eight petals around an eye."""
    w = plan.ROSE
    c = (0, w.spring)
    frame_bars(mesh, w)
    bar(mesh, arc(c, .34, 0, 360, 33), 1.0, True)
    for k in range(8):
        a = np.radians(22.5 + 45 * k)
        d = np.array([np.cos(a), np.sin(a)])
        bar(mesh, [c + d * .34, c + d * .8, c + d * 1.25], .8)
        b = a + np.radians(22.5)
        e = np.array([np.cos(b), np.sin(b)])
        bar(mesh, arc(c + e * .88, .33, np.degrees(b) - 112, np.degrees(b) + 112, 11), .6)
    foils(mesh, c, .30, 4, .45, 0)
