"""Walls with their openings: inner faces, splayed reveals, mouldings, outer faces, roof. Closed, so that no light leaks."""
import numpy as np

import plan
from mesh import Mesh, rounded_rect, unit

SPLAY = 0.36      # how much an opening grows from the glass to the inner face
SILL_DROP = 0.55  # how far the sill slopes down towards the inside


def panel(mesh, frame, u0, u1, v0, v1, hole=None, grow=0.0, drop=0.0, w=0.0, out=None, uv_shift=0.0, floor=None):
    """A wall face in a frame's plane from (u0, v0) to (u1, v1), pierced by a window outline grown by `grow`."""
    out = -frame.w if out is None else out

    def patch(us, lows, highs, rows):
        t = np.linspace(0, 1, rows)
        v = lows[:, None] * (1 - t) + highs[:, None] * t
        uv = np.stack([np.broadcast_to(us[:, None], v.shape), v], -1)
        p = frame.at(uv, w)
        mesh.grid(p, uv + [uv_shift, 0], np.broadcast_to(unit(out), p.shape), out=out)

    if hole is None:
        patch(np.linspace(u0, u1, 3), np.full(3, v0), np.full(3, v1), 4)
        return
    half = hole.half + grow
    a = np.linspace(0, np.pi, 33)
    us = -half * np.cos(a)
    us[16] = 0
    low, high = hole.lower(us, grow, drop), hole.upper(us, grow)
    ends = [v0, low[0], high[0], v1]
    for ua, ub in ((u0, -half), (half, u1)):
        for lo, hi in zip(ends[:-1], ends[1:]):
            if hi - lo > 1e-6:
                patch(np.array([ua, ub]), np.full(2, lo), np.full(2, hi), 2)
    patch(us, high, np.full_like(us, v1), 3)
    if low.min() > v0 + 1e-6:
        patch(us, np.full_like(us, v0), low, 3)


def reveal(mesh, frame, window, w0, w1, grow0, grow1, drop0, drop1):
    """The splayed surfaces between two outlines at depths w0 and w1; they face the axis of the opening."""
    for a, b in zip(window.outline(grow0, drop0), window.outline(grow1, drop1)):
        t = np.linspace(0, 1, 4)[:, None, None]
        uv = a[None] * (1 - t) + b[None] * t
        p = frame.at(uv, np.broadcast_to(w0 + (w1 - w0) * t[..., 0], uv.shape[:2]))
        centre = frame.at(np.array([0, window.spring]), (w0 + w1) / 2)
        vertical = abs(a[0, 0] - a[-1, 0]) < 1e-6
        across = np.linspace(0, abs(w1 - w0) + 0.2, 4)[:, None]
        if vertical:  # courses stay level on the jambs
            tex = np.stack([np.broadcast_to(across, uv.shape[:2]), uv[..., 1]], -1)
        else:
            along = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(a, axis=0), axis=1))])
            tex = np.stack([np.broadcast_to(across, uv.shape[:2]), np.broadcast_to(along[None] + 0.13, uv.shape[:2])], -1)
        n = np.cross(np.gradient(p, axis=0), np.gradient(p, axis=1))
        n = unit(n)
        if ((centre - p) * n).sum() < 0:
            n = -n
        mesh.grid(p, tex, n)


def roll_moulding(mesh, frame, window, grow, w, radius, below=True, drop=0.0):
    """A round moulding along jambs and arch (and sill when `below`)."""
    pieces = window.outline(grow, drop, arc=18)
    if window.round_window:
        runs = [pieces[0]]
    else:
        runs = [np.vstack([pieces[1], pieces[2][1:]]), np.vstack([pieces[3][:-1], pieces[4]])]
        if below:
            runs.append(pieces[0])
    a = np.radians(np.linspace(0, 360, 13)[:-1])
    section = np.stack([np.cos(a), np.sin(a)], -1)
    for run in runs:
        t = np.gradient(run, axis=0)
        side = unit(np.stack([t[:, 1], -t[:, 0]], -1))
        x = side[:, :1] * frame.u + side[:, 1:] * frame.v
        mesh.sweep(section * radius, section, frame.at(run, w), x, np.broadcast_to(-frame.w, x.shape), closed=True, caps=True)


def string_course(mesh, frame, u0, u1, v, size=0.16):
    """A weathered horizontal moulding on a wall."""
    s = np.array([(0, .55), (.35, .35), (.62, .1), (.66, -.05), (.62, -.2), (.45, -.3), (.3, -.45), (.12, -.5), (0, -.5)]) * size
    n = plan.unit(np.stack([np.gradient(s[:, 1]) * -1, np.gradient(s[:, 0])], -1))
    path = frame.at(np.array([[u0, v], [(u0 + u1) / 2, v], [u1, v]]), 0.0)
    mesh.sweep(s, n, path, np.broadcast_to(-frame.w, path.shape), np.broadcast_to(frame.v, path.shape))


def wall_bay(ashlar, dressed, frame, window, shift, half=plan.BAY / 2, top=plan.WALL_TOP):
    """Inner face of one side bay with its window, mouldings and string course, and the outer face behind."""
    panel(ashlar, frame, -half, half, -0.4, top, window, SPLAY, SILL_DROP, 0.0, uv_shift=shift)
    reveal(ashlar, frame, window, 0.0, plan.GLASS_DEPTH + 0.02, SPLAY, 0.0, SILL_DROP, 0.0)
    reveal(ashlar, frame, window, plan.GLASS_DEPTH + 0.02, plan.WALL, 0.0, 0.16, 0.0, 0.2)
    panel(ashlar, frame, -half, half, -0.4, top, window, 0.16, 0.2, plan.WALL, out=frame.w, uv_shift=shift)
    roll_moulding(dressed, frame, window, SPLAY + 0.02, 0.015, 0.05, below=False, drop=SILL_DROP)
    string_course(dressed, frame, -half, half, 1.86)
    bench(dressed, frame, -half + 0.3, half - 0.3)


def bench(dressed, frame, u0, u1):
    """The stone bench along the foot of the wall."""
    s, n = rounded_rect(0.42, 0.12, 0.02, 3)
    path = frame.at(np.array([[u0, 0.42], [(u0 + u1) / 2, 0.425], [u1, 0.42]]), -0.2)
    dressed.sweep(s, n, path, np.broadcast_to(-frame.w, path.shape), np.broadcast_to(frame.v, path.shape), closed=True, caps=True)
    s, n = rounded_rect(0.34, 0.8, 0.01, 2)
    path = frame.at(np.array([[u0 + .04, -0.02], [u1 - .04, -0.02]]), -0.15)
    dressed.sweep(s, n, path, np.broadcast_to(-frame.w, path.shape), np.broadcast_to(frame.v, path.shape), closed=True, caps=True)


def box(mesh, lo, hi, radius=0.01, axis=1, uv0=(0, 0)):
    """A rounded box between two corners; u runs along `axis`."""
    lo, hi = np.asarray(lo, float), np.asarray(hi, float)
    c, size = (lo + hi) / 2, hi - lo
    x, y = [(1, 2), (2, 0), (0, 1)][axis]
    s, n = rounded_rect(size[x], size[y], min(radius, size[x] / 2.1, size[y] / 2.1), 3 if radius > 0.015 else 2)
    path = np.array([c, c, c])
    path[:, axis] = [lo[axis], c[axis], hi[axis]]
    eye = np.eye(3)
    mesh.sweep(s, n, path, np.broadcast_to(eye[x], (3, 3)), np.broadcast_to(eye[y], (3, 3)), uv0, closed=True, caps=True)


def pilaster(mesh, x_sign, z, half=0.27):
    x0, x1 = sorted((x_sign * 3.66, x_sign * 4.02))
    box(mesh, [x0, -0.3, z - half], [x1, plan.SPRING + 0.02, z + half], 0.03)
    x0, x1 = sorted((x_sign * 3.46, x_sign * 4.02))  # the springer, from which the ribs part
    box(mesh, [x0, plan.SPRING - 0.02, z - 0.15], [x1, plan.SPRING + 0.95, z + 0.15], 0.02)


def end_walls(ashlar_e, ashlar_w, dressed):
    e, w = plan.east(), plan.west()
    reach = plan.HALF_WIDTH + 0.0
    gable = 11.0 + 0.0
    panel(ashlar_e, e, -reach, reach, -0.4, plan.WALL_TOP, plan.EASTERN, SPLAY, 0.5, 0.0, uv_shift=0.7)
    reveal(ashlar_e, e, plan.EASTERN, 0.0, plan.GLASS_DEPTH + 0.02, SPLAY, 0.0, 0.5, 0.0)
    reveal(ashlar_e, e, plan.EASTERN, plan.GLASS_DEPTH + 0.02, plan.WALL, 0.0, 0.16, 0.0, 0.2)
    panel(ashlar_e, e, -reach - 1, reach + 1, -0.4, plan.WALL_TOP, plan.EASTERN, 0.16, 0.2, plan.WALL, out=e.w, uv_shift=0.7)
    roll_moulding(dressed, e, plan.EASTERN, SPLAY + 0.02, 0.015, 0.06, below=False, drop=0.5)
    string_course(dressed, e, -reach, reach, 2.5)
    # West: door below, rose above.
    panel(ashlar_w, w, -reach, reach, -0.4, 4.6, plan.DOOR, 0.3, 0.0, 0.0, uv_shift=0.2)
    panel(ashlar_w, w, -reach, reach, 4.6, plan.WALL_TOP, plan.ROSE, SPLAY, 0.0, 0.0, uv_shift=0.2)
    reveal(ashlar_w, w, plan.ROSE, 0.0, plan.GLASS_DEPTH + 0.02, SPLAY, 0.0, 0, 0)
    reveal(ashlar_w, w, plan.ROSE, plan.GLASS_DEPTH + 0.02, plan.WALL, 0.0, 0.16, 0, 0)
    reveal(ashlar_w, w, plan.DOOR, 0.0, 0.55, 0.3, 0.0, 0, 0)
    reveal(ashlar_w, w, plan.DOOR, 0.55, plan.WALL, 0.0, 0.12, 0, 0)
    panel(ashlar_w, w, -reach - 1, reach + 1, -0.4, 4.6, plan.DOOR, 0.12, 0.0, plan.WALL, out=w.w)
    panel(ashlar_w, w, -reach - 1, reach + 1, 4.6, plan.WALL_TOP, plan.ROSE, 0.16, 0.0, plan.WALL, out=w.w)
    roll_moulding(dressed, w, plan.ROSE, SPLAY + 0.02, 0.015, 0.06)
    roll_moulding(dressed, w, plan.DOOR, 0.31, 0.0, 0.06, below=False)
    string_course(dressed, w, -reach, reach, 4.6)
    return gable


def outside(ashlar, roof):
    """Returns of the side walls, buttresses and a closed roof with gables."""
    t, x1, z1 = plan.WALL_TOP, plan.HALF_WIDTH + plan.WALL, plan.WEST + plan.WALL
    for sx in (-1, 1):
        for sz in (-1, 1):  # the corners that the bays do not reach
            zs = sorted((sz * plan.WEST, sz * z1))
            f = plan.Frame([sx * x1, 0, 0], [sx, 0, 0])
            u = sorted(np.dot([0, 0, z], f.u) for z in zs)
            panel(ashlar, f, u[0], u[1], -0.4, t, out=f.w)
        for z in plan.BAY_LINES:
            xs = sorted((sx * (x1 - 0.05), sx * (x1 + 0.7)))
            box(ashlar, [xs[0], -0.4, z - 0.35], [xs[1], 8.6, z + 0.35], 0.02)
    eave, ridge = x1 + 0.35, 15.2
    z = np.array([-z1 - 0.3, z1 + 0.3])
    for sx in (-1, 1):
        p = np.array([[[sx * eave, t - 0.25, k], [0, ridge, k]] for k in z])
        roof.grid(p, out=[sx, 1, 0])
        roof.grid(p - [0, 0.25, 0], out=[-sx, -1, 0])
        roof.grid(np.array([[[sx * eave, t - 0.5, k], [sx * eave, t - 0.25, k]] for k in z]), out=[sx, 0, 0])
    for sz in (-1, 1):
        k = sz * z1
        p = np.array([[[-eave, t - 0.3, k], [-eave, t - 0.29, k]], [[0, t - 0.3, k], [0, ridge - 0.05, k]], [[eave, t - 0.3, k], [eave, t - 0.29, k]]])
        ashlar.grid(p, uv=p[..., :2], out=[0, 0, sz])
        ashlar.grid(p - [0, 0, sz * 0.6], uv=p[..., :2], out=[0, 0, -sz])
    # Ceiling boards over the vault: a second skin between vault and roof.
    p = np.array([[[x, t - 0.02, k] for x in (-x1, 0, x1)] for k in (-z1, 0, z1)])
    roof.grid(p, out=[0, -1, 0])
    roof.grid(p + [0, 0.1, 0], out=[0, 1, 0])
