"""Packs the charts of all meshes into one light-map atlas (TEXCOORD_1)."""
import numpy as np

SIZE = 2048
PAD = 2.0  # texels around each chart


def pack(meshes, wants):
    """Gives every patch of the materials in `wants` its uv1 in [0,1]; returns texels per metre."""
    charts = {}
    for name, prims in meshes.items():
        for m in prims:
            for k, q in enumerate(m.patches):
                if m.material in wants:
                    charts.setdefault((name, q.get("group", (m.material, k))), []).append(q)
                else:
                    q["uv1"] = np.zeros((len(q["p"]), 2))
    boxes = []
    for group in charts.values():
        lo = np.min([q["chart"].min(0) for q in group], axis=0)
        hi = np.max([q["chart"].max(0) for q in group], axis=0)
        size = hi - lo
        boxes.append((group, lo, size, size[1] > size[0]))
    low, high = 2.0, 200.0
    for _ in range(24):
        middle = (low + high) / 2
        if _place(boxes, middle) is None:
            high = middle
        else:
            low = middle
    for (group, lo, size, turned), (x, y) in zip(boxes, _place(boxes, low)):
        for q in group:
            c = (q["chart"] - lo) * low
            if turned:
                c = c[:, ::-1]
            q["uv1"] = (c + [x + PAD, y + PAD]) / SIZE
    return low


def _place(boxes, scale):
    """Shelf packing, tallest first; None when it does not fit."""
    sizes = [np.sort(size * scale)[::-1] + 2 * PAD for _, _, size, _ in boxes]
    order = sorted(range(len(boxes)), key=lambda i: -sizes[i][1])
    at = [None] * len(boxes)
    x = y = shelf = 0.0
    for i in order:
        w, h = sizes[i]
        if w > SIZE:
            return None
        if x + w > SIZE:
            x, y, shelf = 0.0, y + shelf, 0.0
        shelf = max(shelf, h)
        if y + h > SIZE:
            return None
        at[i] = (x, y)
        x += w
    return at
