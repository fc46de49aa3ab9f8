"""The maps of the skin: evaluated at places on the surface, so that no seam shows."""
import numpy as np
from scipy import ndimage

import colour
import relief
from features import mirrored
from noise import octaves
from regions import Regions
from shape import uneven
from texels import Chart, tangents


def gradient(shape, p, step=0.02):
    """Normals of the modelled surface."""
    corners = np.array([(1, -1, -1), (-1, -1, 1), (-1, 1, -1), (1, 1, 1)], np.float32)
    g = np.zeros_like(p, np.float32)
    for c in corners:
        for i in range(0, len(p), 300000):
            part = p[i:i + 300000].astype(np.float32)
            g[i:i + 300000] += c * shape(part + step * c)[:, None]
    return g / np.maximum(np.linalg.norm(g, axis=1, keepdims=True), 1e-9)


def openness(shape, p, n):
    """1 on open skin, less in folds: how far the surface stays away from points above it."""
    total = np.zeros(len(p), np.float32)
    for away in (0.12, 0.35, 0.9):
        for i in range(0, len(p), 300000):
            total[i:i + 300000] += (shape((p[i:i + 300000] + away * n[i:i + 300000]).astype(np.float32)) / away).clip(0, 1) / 3
    return total


def made(shape, points, normals, uv, faces, source, size=2048, log=print):
    """Pictures: colour (linear), roughness, specular, normal."""
    random = np.random.default_rng(7)
    p3, n3 = points[source], normals[source]
    chart = Chart(uv, faces, size)
    p, mesh_n = chart.field(p3), chart.field(n3)
    mesh_n /= np.linalg.norm(mesh_n, axis=1, keepdims=True)
    log(f"texels {len(p)}")
    near = p[:, 1] > -20
    n = mesh_n.astype(np.float32)
    n[near] = gradient(shape, p[near])
    agree = (n * mesh_n).sum(1) > 0.5      # not where the mesh is too coarse to say which side is meant
    n = np.where(agree[:, None], n, mesh_n).astype(np.float32)
    open_ = np.ones(len(p), np.float32)
    open_[near] = openness(shape, p[near], n[near])
    log("normals of the shape")
    q = uneven(p.astype(np.float32))
    to_ear = np.minimum(*shape.ear(mirrored(q)))
    r = Regions(q, n, octaves(q, 0.5, 3, 30), to_ear)
    corners = p3[faces]
    fq = uneven(corners.mean(1).astype(np.float32))
    faces_at = (corners, fq, n3[faces].mean(1), np.zeros(len(faces)))
    h, pore, line = relief.height(random, p, q, r, faces_at, Regions)
    log("relief")
    slope = chart.slopes(h, p3)
    fine = n - slope
    fine /= np.linalg.norm(fine, axis=1, keepdims=True)
    t = chart.field(tangents(p3, n3, uv, faces)[:, :])
    t -= mesh_n * (t * mesh_n).sum(1, keepdims=True)
    t /= np.maximum(np.linalg.norm(t, axis=1, keepdims=True), 1e-9)
    b = np.cross(mesh_n, t)
    normal = np.stack([(fine * t).sum(1), (fine * b).sum(1), np.maximum((fine * mesh_n).sum(1), 0.1)], -1)
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    albedo, cover = colour.reflectance(random, q, p, n, r, pore, line, open_, faces_at)
    log(f"colour: mean albedo {albedo.mean(0).round(3)}, relief {h.min() * 10:.2f} mm at most")
    rough = colour.roughness(q, r, pore, line, cover)
    gloss = colour.specular(q, r, pore, line, h, open_, cover)
    return {name: chart.picture(np.asarray(v, np.float32)) for name, v in dict(colour=albedo, roughness=rough, specular=gloss, normal=normal * 0.5 + 0.5).items()}
