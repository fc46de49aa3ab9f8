"""Flattens a disk with as little stretch as can be, and no triangle turned over: Tutte's map onto a circle, then scalable locally injective maps (Rabinovich et al.,
ACM TOG 36(2), 2017) of the symmetric Dirichlet energy."""
import numpy as np
from scipy import sparse
from scipy.sparse import linalg

import seams


def onto_circle(points, faces):
    ring = seams.border(faces)
    step = np.linalg.norm(points[ring] - points[np.roll(ring, -1)], axis=1)
    angle = 2 * np.pi * np.cumsum(step) / step.sum()
    edges, _ = seams.edges_of(faces)
    weight = 1 / np.maximum(np.linalg.norm(points[edges[:, 0]] - points[edges[:, 1]], axis=1), 1e-3)
    n = len(points)
    w = sparse.coo_matrix((np.r_[weight, weight], (np.r_[edges[:, 0], edges[:, 1]], np.r_[edges[:, 1], edges[:, 0]])), shape=(n, n)).tocsr()
    laplace = sparse.diags(np.asarray(w.sum(1)).ravel()) - w
    flat = np.zeros((n, 2))
    flat[ring] = np.stack([np.cos(angle), np.sin(angle)], -1)
    inner = np.setdiff1d(np.arange(n), ring)
    flat[inner] = linalg.spsolve(laplace[inner][:, inner].tocsc(), -laplace[inner][:, ring] @ flat[ring])
    return flat


class Map:
    """The gradients of functions on the triangles, each laid flat and scaled."""

    def __init__(self, points, faces, scale):
        p = points[faces] * scale[:, None, None]
        e1, e2 = p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]
        x1 = np.linalg.norm(e1, axis=1)
        x2 = (e1 * e2).sum(1) / x1
        y2 = np.sqrt(np.maximum((e2 * e2).sum(1) - x2 * x2, 1e-12))
        self.area, self.faces = 0.5 * x1 * y2, faces
        dx = np.stack([-1 / x1, 1 / x1, 0 * x1], -1)
        dy = np.stack([(x2 - x1) / (x1 * y2), -x2 / (x1 * y2), 1 / y2], -1)
        row = np.repeat(np.arange(len(faces)), 3)
        shape = (len(faces), len(points))
        self.dx, self.dy = (sparse.csr_matrix((d.ravel(), (row, faces.ravel())), shape=shape) for d in (dx, dy))

    def jacobian(self, flat):
        return np.stack([self.dx @ flat, self.dy @ flat], -1)  # [face, u or v, x or y]

    def energy(self, j):
        det = j[:, 0, 0] * j[:, 1, 1] - j[:, 0, 1] * j[:, 1, 0]
        if (det <= 0).any():
            return np.inf
        return (self.area * (j * j).sum((1, 2)) * (1 + 1 / det ** 2)).sum() / self.area.sum()


def longest(flat, move, faces):
    """The longest step that turns no triangle over."""
    p, d = flat[faces], move[faces]
    e1, e2, f1, f2 = p[:, 1] - p[:, 0], p[:, 2] - p[:, 0], d[:, 1] - d[:, 0], d[:, 2] - d[:, 0]
    cross = lambda a, b: a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    a, b, c = cross(f1, f2), cross(e1, f2) + cross(f1, e2), cross(e1, e2)
    inner = b * b - 4 * a * c
    q = -0.5 * (b + np.where(b < 0, -1, 1) * np.sqrt(np.maximum(inner, 0)))
    with np.errstate(divide="ignore", invalid="ignore"):
        t = np.stack([q / a, c / q])
    return np.where(np.isfinite(t) & (t > 0) & (inner > 0), t, np.inf).min()


def flattened(points, faces, scale, rounds=60, log=print):
    """UVs [n, 2]; scale says for each face how large it shall be."""
    flat, m = onto_circle(points, faces), Map(points, faces, scale)
    flat *= np.sqrt(m.area.sum() / np.pi)
    count = len(points)
    root = np.sqrt(m.area)
    before = m.energy(m.jacobian(flat))
    for turn in range(rounds):
        j = m.jacobian(flat)
        u, s, vt = np.linalg.svd(j)
        rotation = u @ vt
        with np.errstate(divide="ignore", invalid="ignore"):
            strong = np.sqrt(np.where(np.abs(s - 1) < 1e-4, 4.0, (s - s ** -3) / (s - 1)))
        w = np.einsum("fij,fj,fkj->fik", u, np.minimum(strong, 1e8), u)
        target = w @ rotation
        rows, right = [], []
        for i in range(2):
            for d, k in ((m.dx, 0), (m.dy, 1)):
                rows.append(sparse.hstack([sparse.diags(root * w[:, i, 0]) @ d, sparse.diags(root * w[:, i, 1]) @ d]))
                right.append(root * target[:, i, k])
        a, b = sparse.vstack(rows).tocsr(), np.concatenate(right)
        near = 1e-6 * m.area.sum() / count
        system = (a.T @ a + near * sparse.identity(2 * count)).tocsc()
        wanted = linalg.splu(system, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options=dict(SymmetricMode=True)).solve(a.T @ b + near * flat.T.ravel()).reshape(2, -1).T
        move = wanted - flat
        step = min(1.0, 0.8 * longest(flat, move, faces))
        while (now := m.energy(m.jacobian(flat + step * move))) > before and step > 1e-9:
            step *= 0.6
        if step <= 1e-9:
            break
        flat = flat + step * move
        if log:
            log(f"flatten {turn}: energy {now:.4f} step {step:.3g}")
        if before - now < 1e-4 * now:
            break
        before = now
    return flat
