"""The clustered column: a quatrefoil cluster on an octagonal plinth and moulded base, with a foliate capital and abacus."""
import numpy as np

import plan
from mesh import unit


def cluster_radius(th):
    """Polar outline of the shafts: four large, four slender, around a core."""
    r = np.full_like(th, 0.205)
    for k in range(4):
        r = np.maximum(r, _circle(th, k * np.pi / 2, 0.175, 0.105))
        r = np.maximum(r, _circle(th, np.pi / 4 + k * np.pi / 2, 0.205, 0.05))
    return r


def _circle(th, angle, distance, radius):
    c = np.cos(th - angle) * distance
    h = c * c - distance ** 2 + radius ** 2
    return np.where((h > 0) & (np.cos(th - angle) > 0), c + np.sqrt(np.maximum(h, 0)), 0)


def octagon_radius(th, apothem):
    return apothem / np.cos((th + np.pi / 8) % (np.pi / 4) - np.pi / 8)


def _rows():
    """(height, blend to octagon, offset, leaf) down the column's profile."""
    s = plan.SPRING
    rows = []
    for k, (y, o) in enumerate([(.46, .10), (.48, .118), (.51, .125), (.54, .118), (.56, .095), (.575, .06), (.6, .04), (.635, .035), (.66, .045),
                                (.67, .062), (.69, .068), (.71, .06), (.72, .03), (.735, .012), (.76, 0)]):
        rows.append((y, 0.25 * max(0, 1 - k / 9), o, 0))
    for y in (1.2, 2.0, 2.9):
        rows.append((y, 0, 0, 0))
    for y, o in ((3.06, 0), (3.075, .02), (3.1, .034), (3.13, .034), (3.155, .02), (3.17, 0)):
        rows.append((y, 0, o, 0))
    for y in (3.6, 4.4, 5.1):
        rows.append((y, 0, 0, 0))
    for y, o in ((5.33, 0), (5.345, .02), (5.365, .032), (5.39, .02), (5.405, .004)):
        rows.append((y, 0, o, 0))
    for k in range(9):
        t = k / 8
        rows.append((5.42 + t * .42, t * .6, .005 + .11 * t ** 1.7, np.sin(np.pi * min(t * 1.05, 1)) * (0.4 + 0.6 * t)))
    return rows


def column(mesh):
    """One column standing at the origin, its foot at y = 0."""
    around = 56
    th = np.linspace(0, 2 * np.pi, around + 1)
    base = cluster_radius(th)
    p, v = [], []
    for y, blend, offset, leaf in _rows():
        r = base * (1 - blend) + octagon_radius(th, 0.225) * blend + offset
        curl = np.maximum(np.cos(8 * th), 0) ** 0.6
        vein = 0.25 * np.cos(40 * th) * curl
        r = r + leaf * (0.055 * curl + 0.012 * vein)
        p.append(np.stack([r * np.cos(th), np.full_like(th, y), r * np.sin(th)], -1))
        v.append(y)
    p = np.array(p)
    uv = np.stack(np.broadcast_arrays(th[None] * 0.26, np.array(v)[:, None]), -1)
    mesh.grid(p, uv, away=[0, 3, 0])
    # Plinth and abacus: octagonal prisms with moulded edges.
    _octagons(mesh, [(-.3, .40), (.26, .40), (.285, .392), (.30, .375), (.31, .355), (.43, .35), (.448, .342), (.46, .30), (.462, .2)])
    _octagons(mesh, [(5.82, .26), (5.825, .35), (5.835, .362), (5.87, .365), (5.885, .372), (5.895, .40), (5.91, .413), (5.985, .415), (6.0, .40), (6.002, .05)])


def _octagons(mesh, profile):
    profile = np.array(profile)
    for k in range(8):
        a, b = (k - .5) * np.pi / 4, (k + .5) * np.pi / 4
        corner = 1 / np.cos(np.pi / 8)
        t = np.linspace(0, 1, 2)
        ring = np.stack([np.cos(a) * (1 - t) + np.cos(b) * t, 0 * t, np.sin(a) * (1 - t) + np.sin(b) * t], -1) * corner
        p = ring[None] * profile[:, :1][:, None] * [0, 0, 0] + ring[None] * profile[:, 1][:, None, None] + np.array([0, 1, 0]) * profile[:, 0][:, None, None]
        edge = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(profile, axis=0), axis=1))])
        uv = np.stack(np.broadcast_arrays(k * .31 + t[None] * .31, edge[:, None] - .3), -1)
        g = np.gradient(profile, axis=0)
        n2 = unit(np.stack([g[:, 0] * 1.0, -g[:, 1]], -1))  # (radial, vertical)
        mid = np.array([np.cos((a + b) / 2), 0, np.sin((a + b) / 2)])
        n = n2[:, :1] * mid + n2[:, 1:] * np.array([0, 1.0, 0])
        mesh.grid(p, uv, np.broadcast_to(n[:, None], p.shape))
