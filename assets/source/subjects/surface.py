"""A closed surface out of a signed distance: sampled on a grid, contoured by surface nets, so that it is manifold for sure, then drawn onto the true surface."""
import numpy as np

BLOCK = 8  # cells of the fine grid along a block's edge


def sampled(distance, low, high, cell):
    """Distances on a grid. Far from the surface only their sign is true; returns the grid and its origin."""
    low = np.asarray(low, float)
    blocks = np.ceil((np.asarray(high, float) - low) / (cell * BLOCK)).astype(int)
    wide = cell * BLOCK
    middle = low + (np.stack(np.meshgrid(*(np.arange(n) for n in blocks), indexing="ij"), -1).reshape(-1, 3) + 0.5) * wide
    coarse = in_batches(distance, middle)
    grid = np.repeat(np.repeat(np.repeat(coarse.reshape(blocks), BLOCK, 0), BLOCK, 1), BLOCK, 2)
    near = np.flatnonzero(np.abs(coarse) < 1.8 * wide)
    inner = np.stack(np.meshgrid(*[np.arange(BLOCK)] * 3, indexing="ij"), -1).reshape(-1, 3)
    index = np.stack(np.unravel_index(near, blocks), -1)[:, None] * BLOCK + inner
    index = index.reshape(-1, 3)
    grid[tuple(index.T)] = in_batches(distance, low + index * cell)
    for axis in range(3):  # nothing may touch the grid's edge
        for end in (0, -1):
            np.moveaxis(grid, axis, 0)[end] = np.maximum(np.moveaxis(grid, axis, 0)[end], cell)
    return grid, low


def in_batches(distance, points, size=400000):
    return np.concatenate([distance(points[i:i + size].astype(np.float32)) for i in range(0, len(points), size)]).astype(np.float32)


CORNERS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0), (0, 0, 1), (1, 0, 1), (0, 1, 1), (1, 1, 1)]


def _connected(mask):
    """Whether the corners of one kind hang together along edges of the cube."""
    corners = [i for i in range(8) if mask >> i & 1]
    if not corners:
        return True
    seen, todo = {corners[0]}, [corners[0]]
    while todo:
        i = todo.pop()
        for bit in (1, 2, 4):
            if i ^ bit in corners and i ^ bit not in seen:
                seen.add(i ^ bit)
                todo.append(i ^ bit)
    return len(seen) == len(corners)


SIMPLE = np.array([_connected(m) and _connected(~m & 255) for m in range(256)])


def cases(inside):
    n = np.array(inside.shape) - 1
    code = np.zeros(n, np.uint8)
    for bit, (i, j, k) in enumerate(CORNERS):
        code |= inside[i:i + n[0], j:j + n[1], k:k + n[2]].astype(np.uint8) << bit
    return code


def repaired(grid, cell):
    """Fills corners until every cell has one sheet of surface: only then are surface nets manifold."""
    for _ in range(200):
        bad = np.argwhere(~SIMPLE[cases(grid < 0)])
        if not len(bad):
            return grid
        corner = bad[:, None] + np.array(CORNERS)
        value = grid[tuple(np.moveaxis(corner, -1, 0))]
        least = np.where(value < 0, np.inf, value).argmin(1)
        grid[tuple(corner[np.arange(len(bad)), least].T)] = -0.02 * cell
    raise RuntimeError("the surface stays tangled")


def nets(grid, low, cell):
    """Points and quads: a point in each cell that the surface passes, a quad for each edge that it cuts."""
    inside = grid < 0
    code = cases(inside)
    cells = np.argwhere((code != 0) & (code != 255))
    number = np.full(code.shape, -1, np.int64)
    number[tuple(cells.T)] = np.arange(len(cells))
    total, count = np.zeros((len(cells), 3)), np.zeros(len(cells))
    for a in range(8):
        for bit in (0, 1, 2):
            b = a | 1 << bit
            if a == b:
                continue
            va, vb = (grid[tuple((cells + CORNERS[c]).T)] for c in (a, b))
            cut = (va < 0) != (vb < 0)
            t = np.where(cut, va / np.where(cut, va - vb, 1), 0)
            place = np.asarray(CORNERS[a]) + t[:, None] * (np.asarray(CORNERS[b]) - CORNERS[a])
            total += np.where(cut[:, None], place, 0)
            count += cut
    points = low + (cells + total / count[:, None]) * cell
    quads = []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        first, second = (np.take(inside, np.arange(s, inside.shape[axis] - 1 + s), axis) for s in (0, 1))
        for here, turn in ((first & ~second, 1), (~first & second, -1)):
            edge = np.argwhere(here)
            ring = [number[tuple((edge - np.eye(3, dtype=int)[u] * i - np.eye(3, dtype=int)[v] * j).T)] for i, j in ((1, 1), (0, 1), (0, 0), (1, 0))[::turn]]
            quads.append(np.stack(ring, -1))
    return points, np.concatenate(quads)


def between(grid, places):
    """The grid's values at places in cells, linear between."""
    places = np.clip(places, 0, np.array(grid.shape) - 1.001)
    base = places.astype(int)
    t = places - base
    total = 0.0
    for i, j, k in CORNERS:
        weight = np.where(i, t[:, 0], 1 - t[:, 0]) * np.where(j, t[:, 1], 1 - t[:, 1]) * np.where(k, t[:, 2], 1 - t[:, 2])
        total = total + weight * grid[base[:, 0] + i, base[:, 1] + j, base[:, 2] + k]
    return total


def drawn(points, quads, grid, low, cell, rounds):
    """Evens the net out and draws it onto the surface, by steps too small to fold it."""
    for _ in range(rounds):
        total, count = np.zeros_like(points), np.zeros(len(points))
        for a in range(4):
            for b in ((a + 1) % 4, (a - 1) % 4):
                for axis in range(3):
                    total[:, axis] += np.bincount(quads[:, a], points[quads[:, b], axis], len(points))
                count += np.bincount(quads[:, a], minlength=len(points))
        points = points + 0.5 * (total / count[:, None] - points)
        at = (points - low) / cell
        d = between(grid, at)
        slope = np.stack([between(grid, at + 0.5 * e) - between(grid, at - 0.5 * e) for e in np.eye(3)], -1) / cell
        points = points - np.clip(d / np.maximum((slope ** 2).sum(-1), 0.25), -0.3 * cell, 0.3 * cell)[:, None] * slope
    return points


def contoured(distance, low, high, cell, rounds=3):
    """Points [n, 3] and triangles [m, 3], seen from outside counter-clockwise."""
    grid, low = sampled(distance, low, high, cell)
    grid = repaired(grid, cell)
    points, quads = nets(grid, low, cell)
    points = drawn(points, quads, grid, low, cell, rounds)
    diagonal = [np.linalg.norm(points[quads[:, i]] - points[quads[:, i + 2]], axis=1) for i in (0, 1)]
    short = (diagonal[0] <= diagonal[1])[:, None]
    return points, np.concatenate([np.where(short, quads[:, [0, 1, 2]], quads[:, [0, 1, 3]]), np.where(short, quads[:, [0, 2, 3]], quads[:, [1, 2, 3]])])


def largest(points, faces):
    """The piece with the most points: crumbs that float and hollows inside are left out."""
    a, b = faces.reshape(-1), faces[:, [1, 2, 0]].reshape(-1)
    b = b[np.argsort(a, kind="stable")]
    degree = np.bincount(a, minlength=len(points))
    start = np.concatenate([[0], np.cumsum(degree)])
    piece = np.full(len(points), -1)
    for name in range(len(points)):
        rest = np.flatnonzero(piece < 0)
        if len(rest) == 0:
            break
        edge = rest[:1]
        while len(edge):
            piece[edge] = name
            many = degree[edge]
            slot = np.arange(many.sum()) - np.repeat(np.cumsum(many) - many, many) + np.repeat(start[edge], many)
            edge = np.unique(b[slot])
            edge = edge[piece[edge] < 0]
    keep = piece[faces[:, 0]] == np.bincount(piece).argmax()
    used, index = np.unique(faces[keep], return_inverse=True)
    return points[used], index.reshape(-1, 3)
