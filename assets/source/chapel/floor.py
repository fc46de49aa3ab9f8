"""Flagstones: each slab is its own bevelled, slightly tilted stone, worn down along the middle aisle."""
import numpy as np

import plan
from mesh import Mesh

BEVEL, JOINT = 0.014, 0.009


def slab(mesh, rng, x0, x1, z0, z1, level, group, wear=True):
    b = BEVEL * rng.uniform(.7, 1.3)
    xs = np.array([x0, x0 + b, x1 - b, x1])
    zs = np.array([z0, z0 + b, z1 - b, z1])
    x, z = np.meshgrid(xs, zs, indexing="ij")
    tilt = rng.normal(0, 0.0022, 2)
    y = level + rng.normal(0, 0.0018) + tilt[0] * (x - (x0 + x1) / 2) + tilt[1] * (z - (z0 + z1) / 2)
    if wear:
        y -= 0.010 * np.exp(-(x / .45) ** 2)
    edge = np.ones((4, 4), bool)
    edge[1:3, 1:3] = False
    y = np.where(edge, level - 0.014, y)
    n = np.zeros((4, 4, 3))
    n[..., 0] = np.array([-1, -tilt[0], -tilt[0], 1])[:, None] * np.where(edge, 1, 1)
    n[..., 2] = np.array([-1, -tilt[1], -tilt[1], 1])[None, :]
    n[..., 0] = np.where(np.abs(n[..., 0]) == 1, n[..., 0] * .8, n[..., 0])
    n[..., 2] = np.where(np.abs(n[..., 2]) == 1, n[..., 2] * .8, n[..., 2])
    n[..., 1] = 1
    turn = rng.integers(0, 4)
    uv = np.stack([x - x0, z - z0], -1)
    if turn & 1:
        uv = uv[..., ::-1]
    uv = uv * (1 if turn < 2 else -1) + rng.uniform(0, 3, 2)
    p = np.stack([x, y, z], -1)
    mesh.grid(p, uv, n, out=[0, 1, 0])
    mesh.patches[-1].update(group=group, chart=np.stack([x, z], -1).reshape(-1, 2))


def pave(mesh, rng, x0, x1, z0, z1, level, group, wear=True):
    """Lays slabs in courses across x."""
    z = z0
    while z < z1 - 1e-6:
        depth = min(rng.uniform(.5, .72), z1 - z)
        if z1 - z - depth < .3:
            depth = z1 - z
        x = x0
        while x < x1 - 1e-6:
            width = min(rng.uniform(.5, 1.05), x1 - x)
            if x1 - x - width < .35:
                width = x1 - x
            slab(mesh, rng, x + JOINT / 2, x + width - JOINT / 2, z + JOINT / 2, z + depth - JOINT / 2, level, group, wear)
            x += width
        z += depth
    p = np.array([[[x, level - .0125, z] for z in (z0, z1)] for x in (x0, x1)])
    mesh.grid(p, p[..., [0, 2]], out=[0, 1, 0], chart_scale=0.05)


STEPS = [(-5.5, 0.16), (-5.9, plan.CHANCEL_FLOOR)]


def floors():
    """One mesh per bay; the last holds the chancel with its steps."""
    rng = np.random.default_rng(11)
    found = []
    w = plan.HALF_WIDTH
    for i, z in enumerate(plan.BAY_CENTRES):
        m = Mesh("flagstone")
        z0, z1 = z - 2, z + 2
        if i == 3:
            z0 = -5.5
        if i < 4:
            pave(m, rng, -w, w, z0, z1, 0.0, f"floor{i}")
        if i == 0:  # the threshold under the door
            pave(m, rng, -1.15, 1.15, 10.0, 11.0, 0.0, "threshold", False)
        if i == 4:
            for (za, ya), zb in zip(STEPS, (STEPS[1][0], plan.EAST)):
                low = ya - .16
                pave(m, rng, -w, w, zb, za + .03, ya, f"chancel{ya}", False)
                riser = np.array([[[x, y, za + .012] for y in (low - .02, ya - .02)] for x in np.linspace(-w, w, 9)])
                m.grid(riser, riser[..., :2] + [rng.uniform(0, 2), 0], out=[0, 0, 1])
        found.append(m)
    return found
