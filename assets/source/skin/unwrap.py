"""UVs of the bust: one chart whose seam runs down the back of the head and behind the ears, and a small one for the cut below."""
import numpy as np
from scipy import sparse
from scipy.sparse import csgraph

import seams
from common import length, step
from flatten import flattened

MARGIN = 0.006


def cap_of(points, faces, bottom):
    """Faces of the flat cut, in one piece."""
    p = points[faces]
    n = np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])
    cap = (n[:, 1] < -0.8 * length(n)) & (p[:, :, 1].mean(1) < bottom + 0.6)
    _, beside = seams.edges_of(faces)
    for _ in range(10):  # a border without notches
        votes = np.bincount(beside[:, 0], cap[beside[:, 1]], len(faces)) + np.bincount(beside[:, 1], cap[beside[:, 0]], len(faces))
        cap = np.where(votes >= 2, True, np.where(votes <= 1, False, cap))
    cap = largest_piece(cap, beside)
    return ~largest_piece(~cap, beside)


def largest_piece(kept, beside):
    both = kept[beside[:, 0]] & kept[beside[:, 1]]
    graph = sparse.coo_matrix((np.ones(both.sum()), beside[both].T), shape=(len(kept),) * 2)
    _, name = csgraph.connected_components(graph, directed=False)
    return kept & (name == np.bincount(name[kept]).argmax())


def nearest(points, place, allowed):
    d = length(points - np.asarray(place))
    return int(np.where(allowed, d, np.inf).argmin())


def ways(points, faces, bottom, groove):
    """The paths of the seam. groove(p) is small in the folds behind the ears."""
    here = np.zeros(len(points), bool)
    here[faces] = True
    paths = seams.Paths(points, faces)
    ring = border_points(faces)
    low = np.zeros(len(points), bool)
    low[ring] = True
    top = nearest(points, (0, 9.5, -6.2), here)
    end = nearest(points, (0, bottom, -11), low)
    back = paths.between(top, end, lambda p: 1 + 30 * np.abs(p[:, 0]) + 100 * (p[:, 2] > 0))
    result = [back]
    on_back = np.zeros(len(points), bool)
    on_back[back] = True
    for side in (-1, 1):
        start = nearest(points, (0, -3.5, -8), on_back)
        inner = here & (points[:, 0] * side > 5.5)
        lower = nearest(points, (side * 6.6, -3.1, -2.4), inner)
        upper = nearest(points, (side * 7.2, 2.2, -2.3), inner)
        dear = lambda p: 1 + 60 * np.clip(groove(p), 0, 1)
        result.append(paths.between(start, lower, lambda p: 1 + 50 * (p[:, 2] > -1.8)))
        result.append(paths.between(lower, upper, dear))
    return result


def border_points(faces):
    edges, beside = seams.edges_of(faces)
    return np.unique(edges[beside[:, 1] < 0])


def share(p):
    """How large each part is drawn."""
    q = np.abs(p[:, 0])
    face = step(0.5, 5.5, p[:, 2]) * step(-14, -10.5, p[:, 1]) * step(9.5, 4.5, p[:, 1])
    ear = step(6.0, 7.0, q) * step(-5.5, -3.5, p[:, 1]) * step(5, 2.8, p[:, 1]) * step(-7, -4.5, p[:, 2])
    body = 0.34 - 0.14 * step(-12, -19, p[:, 1])
    return np.maximum.reduce([body, face, 0.75 * ear])


def unwrapped(points, faces, bottom, groove, log=print):
    """UVs in [0, 1], v upwards; faces with points of their own along the seam; which point each was."""
    cap = cap_of(points, faces, bottom)
    body = faces[~cap]
    used, index = np.unique(body, return_inverse=True)
    body = index.reshape(-1, 3)
    split, source = seams.cut(body, ways(points[used], body, bottom, groove))
    p = points[used][source]
    flat = flattened(p, split, share(p[split].mean(1)), log=log)
    # upright: the brow above the chin
    low, high = (flat[nearest(p, place, np.ones(len(p), bool))] for place in ((0, -9.5, 10.5), (0, 6, 10.5)))
    up = (high - low) / np.linalg.norm(high - low)
    flat = flat @ np.array([[up[1], up[0]], [-up[0], up[1]]])
    flat -= flat.min(0)
    size = flat.max(0)
    # the cut below, small, in the freest corner
    base_used, base_index = np.unique(faces[cap], return_inverse=True)
    base = points[base_used][:, [0, 2]] * (1, 1)
    base = (base - base.min(0)) / np.ptp(base, 0).max()
    log(f"chart {size}, {len(split)} + {cap.sum()} faces")
    extent = size.max()
    uv = MARGIN + (1 - 2 * MARGIN) * (flat + (extent - size) / 2 * (1, 1)) / extent
    base = corner(uv, split, base * 0.05)
    all_faces = np.concatenate([split, base_index.reshape(-1, 3) + len(source)])
    return np.concatenate([uv, base]), all_faces, np.concatenate([used[source], base_used])


def corner(uv, faces, base):
    """The small chart moved to where nothing else lies."""
    taken = np.zeros((128, 128), bool)
    for t in np.linspace(0, 1, 5):
        for s in np.linspace(0, 1 - t, 5):
            q = uv[faces] .transpose(1, 0, 2)
            at = np.clip(((q[0] * (1 - s - t) + q[1] * s + q[2] * t) * 128).astype(int), 0, 127)
            taken[at[:, 0], at[:, 1]] = True
    need = int(np.ceil(0.05 * 128)) + 4
    for j in range(128 - need):
        for i in range(128 - need):
            if not taken[i:i + need, j:j + need].any():
                return base + np.array([i + 2, j + 2]) / 128
    raise RuntimeError("no room for the lower cut's chart")
