"""forest.glb: trunks, ferns and crowns; the crowns are above the picture and break the sunlight into shafts."""
import numpy as np

from shapes import fractal, grid, matte, merged, tube, write_glb

TOP = 20.0  # metres


def ground_height(x, z):
    return 0.9 * (fractal(np.stack([x / 9, z / 9], -1), 3, 5) - 0.5) + 0.12 * (fractal(np.stack([x, z], -1), 2, 9) - 0.5)


def places(random):
    """Where trunks stand: none in the glade before the camera, and none closer than 1.7 m to another."""
    found = []
    while len(found) < 95:
        p = np.array([random.uniform(-24, 24), random.uniform(-44, 10)])
        glade = abs(p[0] - 0.05 * p[1]) < 1.5 + 0.035 * (12 - p[1]) and p[1] > -30
        if not glade and all(np.hypot(*(p - q)) > 1.7 for q in found):
            found.append(p)
    return found


def trunk(random, place, near):
    """A bent cone with roots and ridges of bark."""
    segments, rings = (13, 14) if near else (8, 8)
    radius, lean, phase = random.uniform(0.15, 0.34), random.normal(0, 0.018, 2), random.uniform(0, 6.28, 4)
    height = TOP * np.linspace(0, 1, rings) ** 1.7
    angle = -np.arange(segments) * 2 * np.pi / segments
    skin = []
    for h in height:
        r = radius * (1 - 0.042 * h) * (1 + 0.16 * (fractal(np.stack([np.cos(angle) * 2 + phase[2], np.full_like(angle, h * 0.45), np.sin(angle) * 2], -1), 2) - 0.5))
        r = r + radius * np.exp(-h / 0.28) * (0.45 + 0.3 * np.cos(5 * angle + phase[0]))
        bend = 0.12 * np.array([np.sin(0.35 * h + phase[1]), np.cos(0.3 * h + phase[3])]) * h / TOP * 2
        x, z = place[0] + lean[0] * h + bend[0], place[1] + lean[1] * h + bend[1]
        skin.append(np.stack([x + r * np.cos(angle), np.full(segments, h - 0.25) + ground_height(*place), z + r * np.sin(angle)], -1))
    return tube(skin), skin


def stub(random, ring):
    """A dead branch: a thin cone that starts inside the trunk."""
    start, turn = ring.mean(0), random.uniform(0, 6.28)
    along = np.array([np.cos(turn), random.uniform(-0.25, 0.45), np.sin(turn)])
    side = np.cross(along, [0, 1.0, 0])
    side, up = side / np.linalg.norm(side), np.cross(side, along) / np.linalg.norm(np.cross(side, along))
    length, thick = random.uniform(0.5, 1.6), random.uniform(0.018, 0.04)
    angle = np.arange(5) * 2 * np.pi / 5
    rings = [start + along * length * t + np.array([0, -0.12 * t * t, 0]) + thick * (1 - 0.85 * t) * (np.outer(np.cos(angle), side) + np.outer(np.sin(angle), up))
             for t in (0, 0.5, 1)]
    return tube(rings)


def fern(random, place):
    """Fronds that bow outward, each a strip that narrows."""
    points, faces = [], []
    size = random.uniform(0.35, 0.75)
    for turn in np.arange(9) * 2 * np.pi / 9 + random.uniform(0, 6.28):
        out, across = np.array([np.cos(turn), 0, np.sin(turn)]), np.array([-np.sin(turn), 0, np.cos(turn)])
        droop, base = random.uniform(0.5, 1.0), len(points)
        for t in (0.05, 0.4, 0.75, 1.0):
            middle = np.array([place[0], ground_height(*place) - 0.03, place[1]]) + size * (out * t + np.array([0, 1.5 * t - droop * 1.2 * t * t, 0]))
            half = size * 0.14 * (1.05 - t) ** 0.6
            points += [middle - across * half, middle + across * half]
        for i in (0, 2, 4):
            faces += [[base + i, base + i + 1, base + i + 3], [base + i, base + i + 3, base + i + 2]]
    return np.array(points), np.array(faces)


def crown(random, top):
    """Tufts of needles around a trunk's top: single triangles. Far crowns are in the picture and in the sun's way, near ones in neither."""
    count = 84 if top[2] < -12 else 12
    high = random.uniform(-0.40, 0.06, count) * TOP
    away = random.uniform(0.4, 2.6, count) * (0.5 - high / TOP)
    turn = random.uniform(0, 6.28, count)
    middle = top + np.stack([away * np.cos(turn) * 1.8, high, away * np.sin(turn) * 1.8], -1)
    points = middle[:, None] + random.normal(0, 0.36, (count, 3, 3)) * [1, 0.3, 1]
    return points.reshape(-1, 3), np.arange(3 * count).reshape(-1, 3)


def make(folder):
    random = np.random.default_rng(11)
    trunks, crowns, ferns = [], [], []
    for place in places(random):
        mesh, rings = trunk(random, place, place[1] > -14 and abs(place[0]) < 12)
        trunks.append(mesh)
        if place[1] > -24:
            trunks += [stub(random, rings[i]) for i in random.integers(len(rings) // 3, len(rings) - 2, 4)]
        crowns.append(crown(random, rings[-1].mean(0)))
    for _ in range(110):
        place = np.array([random.uniform(-11, 11), random.uniform(-20, 9.2)])
        if abs(place[0]) > 0.7 + 0.05 * (12 - place[1]):
            ferns.append(fern(random, place))
    write_glb(folder / "forest.glb", {
        "ground": (grid(100, 60, ground_height), matte((0.10, 0.085, 0.045))),
        "trunks": (merged(trunks), matte((0.115, 0.075, 0.05))),
        "ferns": (merged(ferns), matte((0.10, 0.15, 0.03), True)),
        "crowns": (merged(crowns), matte((0.05, 0.08, 0.025), True)),
    })
