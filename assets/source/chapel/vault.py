"""Rib vault: moulded ribs along pointed arcs, curved webs in courses between them, carved bosses."""
import numpy as np

import plan
from mesh import unit

RIB_PROFILE = np.array([(-.15, .02), (-.15, -.05), (-.137, -.065), (-.108, -.075), (-.11, -.115), (-.09, -.145), (-.064, -.165), (-.066, -.21), (-.045, -.25),
                        (0, -.272)])
RIB_PROFILE = np.vstack([RIB_PROFILE, RIB_PROFILE[-2::-1] * [-1, 1]])


def pointed(start, crown, n=17):
    """Arc from a springing point to a crown, circular in its vertical plane with its centre on the springing level."""
    start, crown = np.asarray(start, float), np.asarray(crown, float)
    flat = crown - start
    h = flat[1]
    flat = flat * [1, 0, 1]
    d = np.linalg.norm(flat)
    r = (d * d + h * h) / (2 * d)
    top = np.arcsin(min(h / r, 1.0)) if r >= d else np.pi - np.arcsin(h / r)
    a = np.linspace(0, top, n)
    s = r - r * np.cos(a)
    return start + (s / d)[:, None] * flat + np.stack([0 * a, r * np.sin(a), 0 * a], -1)


def rib(mesh, curve, scale=1.0, uv0=(0, 0), lift=0.0):
    """Sweeps the rib profile below a curve."""
    t = unit(np.gradient(curve, axis=0))
    flat = unit((curve[-1] - curve[0]) * [1, 0, 1])
    side = np.broadcast_to(unit(np.cross(flat, [0, 1, 0])), t.shape)
    up = unit(np.cross(side, t))
    s = RIB_PROFILE * scale
    # Fillets between the rolls stay readable with smooth normals because the profile is dense there.
    g = np.gradient(s, axis=0)
    n = unit(np.stack([g[:, 1], -g[:, 0]], -1))
    mid = len(n) // 2
    if n[mid, 1] > 0:
        n = -n
    mesh.sweep(s, n, curve + up * lift, side, up, uv0)


def bay_curves(sx, sz):
    """Curves of one quarter of a bay (centred on z = 0): diagonal, transverse half, wall-rib half."""
    b = plan.BAY / 2
    diagonal = pointed([sx * 3.53, plan.SPRING, sz * (b - .10)], [0, plan.BOSS, 0])
    transverse = pointed([sx * 3.52, plan.SPRING, sz * b], [0, plan.TRANSVERSE, sz * b])
    wall = pointed([sx * 3.98, plan.SPRING, sz * (b - .16)], [sx * 3.98, plan.WALL_RIB, 0])
    return diagonal, transverse, wall


def resample(curve, n):
    length = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(curve, axis=0), axis=1))])
    t = np.linspace(0, length[-1], n)
    return np.stack([np.interp(t, length, curve[:, k]) for k in range(3)], -1)


def web(mesh, a, b, outward_bulge, uv0):
    """A cell between two rib curves, slightly domed, its courses level from rib to rib."""
    n, m = 21, 9
    a, b = resample(a, n), resample(b, n)
    s = np.linspace(0, 1, m)
    p = a[:, None] * (1 - s[None, :, None]) + b[:, None] * s[None, :, None]
    width = np.linalg.norm(b - a, axis=1)
    t = unit(np.gradient((a + b) / 2, axis=0))
    normal = unit(np.cross(t, b - a + 1e-6))
    normal *= np.where(normal[:, 1:2] < 0, -1, 1)
    # Towards the crown the cell bulges straight up, so that it meets its mirror image without a gap.
    crown = np.linspace(0, 1, n)[:, None] ** 2
    normal = unit(normal * (1 - crown) + np.array([0, 1.0, 0]) * crown)
    bulge = np.sin(np.pi * s)[None, :, None] * (width * outward_bulge)[:, None, None]
    p = p + normal[:, None] * bulge
    rise = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff((a + b) / 2, axis=0), axis=1))])
    uv = np.stack([(s[None] - .5) * width[:, None] + uv0[0], np.broadcast_to(rise[:, None] + uv0[1], (n, m))], -1)
    mesh.grid(p, uv, out=[0, -1, 0])


def boss(mesh, centre, radius=0.34):
    """A carved keystone: a disc of eight leaves around a bud, hanging below the ribs."""
    rings, around = 12, 49
    rho = np.linspace(0, 1, rings)[:, None]
    th = np.linspace(0, 2 * np.pi, around)[None]
    leaf = 0.5 + 0.5 * np.cos(8 * th)
    r = radius * rho * (1 - 0.13 * (1 - leaf) * rho ** 2)
    bud = 0.09 * np.exp(-(rho / .28) ** 2)
    petals = 0.075 * np.exp(-((rho - .68) / .2) ** 2) * (0.35 + 0.65 * leaf) + 0.02 * np.cos(16 * th) * np.exp(-((rho - .5) / .15) ** 2)
    y = -0.30 - bud - petals + 0.24 * np.clip((rho - .86) / .14, 0, 1) ** 2
    p = np.stack([r * np.cos(th), np.broadcast_to(y, r.shape), r * np.sin(th)], -1) + np.asarray(centre)
    mesh.grid(p, uv=np.stack([p[..., 0], p[..., 2]], -1), out=[0, -1, 0])


def bay_ribs(mesh, first):
    """Ribs of a bay centred at z = 0: diagonals, wall ribs, and the transverse arch on its +Z side (both sides for the first bay)."""
    rng = np.random.default_rng(3)
    for sx in (-1, 1):
        for sz in (-1, 1):
            d, t, w = bay_curves(sx, sz)
            rib(mesh, d, 0.92, rng.uniform(0, 2, 2))
            rib(mesh, w, 0.9, rng.uniform(0, 2, 2))
            if sz > 0 or first:
                rib(mesh, t, 1.12, rng.uniform(0, 2, 2))
    boss(mesh, [0, plan.BOSS, 0])


def bay_webs(mesh, z, rng):
    for sx in (-1, 1):
        for sz in (-1, 1):
            d, t, w = (c + [0, 0, z] for c in bay_curves(sx, sz))
            web(mesh, d, t, 0.045, rng.uniform(0, 2.4, 2))
            web(mesh, d, w, 0.045, rng.uniform(0, 2.4, 2))
            # Behind the wall rib the web runs on into the wall.
            mesh.grid(np.stack([w - [0, 0.02, 0], w + [sx * 0.2, -0.02, 0]], 1), out=[0, -1, 0])
