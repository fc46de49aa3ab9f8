"""Where the surface is cut so that it can lie flat: down the back of the head, around the lower edge, and from the back into the grooves behind the ears."""
import numpy as np
from scipy import sparse
from scipy.sparse import csgraph


def edges_of(faces):
    """Edges [e, 2] with their two faces [e, 2]; -1 where there is none."""
    half = np.sort(np.stack([faces, np.roll(faces, -1, 1)], -1).reshape(-1, 2), 1)
    owner = np.repeat(np.arange(len(faces)), 3)
    edges, index, count = np.unique(half, axis=0, return_inverse=True, return_counts=True)
    order = np.argsort(index, kind="stable")
    first = np.concatenate([[0], np.cumsum(count)[:-1]])
    beside = np.full((len(edges), 2), -1)
    beside[:, 0] = owner[order[first]]
    two = count == 2
    beside[two, 1] = owner[order[first[two] + 1]]
    return edges, beside


class Paths:
    """Cheapest ways along edges; dear(p) is the price of a centimetre."""

    def __init__(self, points, faces):
        self.points, (self.edges, _) = points, edges_of(faces)

    def between(self, start, end, dear):
        a, b = self.edges.T
        middle = 0.5 * (self.points[a] + self.points[b])
        price = np.linalg.norm(self.points[a] - self.points[b], axis=1) * dear(middle) + 1e-6
        graph = sparse.coo_matrix((price, (a, b)), shape=(len(self.points),) * 2).tocsr()
        _, before = csgraph.dijkstra(graph, directed=False, indices=start, return_predecessors=True)
        path = [end]
        while path[-1] != start:
            path.append(before[path[-1]])
        return np.array(path[::-1])


def cut(faces, ways):
    """Faces with points of their own on each side of the ways; returns them and which old point each new one is."""
    size = faces.max() + 1
    key = lambda a, b: np.minimum(a, b).astype(np.int64) * size + np.maximum(a, b)
    cuts = np.unique(np.concatenate([key(w[:-1], w[1:]) for w in ways]))
    edges, beside = edges_of(faces)
    joined = (beside[:, 1] >= 0) & ~np.isin(key(*edges.T), cuts)
    links = []
    for end in (0, 1):
        point = edges[joined, end]
        corner = [3 * beside[joined, k] + (faces[beside[joined, k]] == point[:, None]).argmax(1) for k in (0, 1)]
        links.append(np.stack(corner, -1))
    links = np.concatenate(links)
    graph = sparse.coo_matrix((np.ones(len(links)), links.T), shape=(faces.size,) * 2)
    count, name = csgraph.connected_components(graph, directed=False)
    source = np.empty(count, int)
    source[name] = faces.ravel()
    return name.reshape(-1, 3), source


def border(faces):
    """The points around the edge of a disk, in order."""
    a, b = faces.ravel(), np.roll(faces, -1, 1).ravel()
    size = faces.max() + 1
    alone = ~np.isin(a.astype(np.int64) * size + b, b.astype(np.int64) * size + a)
    follows = dict(zip(a[alone].tolist(), b[alone].tolist()))
    ring = [next(iter(follows))]
    while follows[ring[-1]] != ring[0]:
        ring.append(follows[ring[-1]])
    if len(ring) != len(follows):
        raise RuntimeError(f"the surface has more than one edge: {len(ring)} of {len(follows)} points")
    return np.array(ring)
