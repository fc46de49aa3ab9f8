"""Puts the chapel together: meshes (name -> primitives) and nodes (name, mesh, matrix)."""
import numpy as np

import columns
import floor
import furniture
import plan
import things
import tracery
import vault
import walls
from mesh import Mesh, rotation_y, translation


def glass_pane(window, design):
    """The pane behind the tracery, in the window's local frame; u and v of its texture run over the window's bounding box."""
    m = Mesh(design)
    grow = 0.02
    half = window.half + grow
    us = -half * np.cos(np.linspace(0, np.pi, 33))
    us[16] = 0
    low, high = window.lower(us, grow, grow), window.upper(us, grow)
    t = np.linspace(0, 1, 6)
    v = low[:, None] * (1 - t) + high[:, None] * t
    p = np.stack([np.broadcast_to(us[:, None], v.shape), v, np.full(v.shape, -0.015)], -1)
    bottom, top = glass_extent(window)
    uv = np.stack([p[..., 0] / (2 * window.half) + .5, (v - bottom) / (top - bottom)], -1)
    m.grid(p, uv, np.broadcast_to([0, 0, 1.0], p.shape), out=[0, 0, 1])
    return m


def glass_extent(window):
    """Bottom and top of a window's texture, metres above the floor."""
    if window.round_window:
        return window.spring - window.half, window.spring + window.half
    return window.sill, window.spring + window.rise


def build():
    rng = np.random.default_rng(1)
    meshes, nodes = {}, []

    def put(name, primitives, matrix=None, mesh=None):
        if primitives is not None:
            meshes[mesh or name] = [p for p in primitives if p.patches]
        nodes.append((name, mesh or name, np.eye(4) if matrix is None else matrix))

    for i, z in enumerate(plan.BAY_CENTRES):
        for side, frame in (("south", plan.south(z)), ("north", plan.north(z))):
            ashlar, dressed = Mesh("ashlar"), Mesh("dressed")
            walls.wall_bay(ashlar, dressed, frame, plan.SIDE, rng.uniform(0, 4))
            put(f"wall_{side}_{i + 1}", [ashlar, dressed])
        webs = Mesh("web")
        vault.bay_webs(webs, z, rng)
        put(f"vault_{i + 1}", [webs])

    ribs = Mesh("dressed")
    vault.bay_ribs(ribs, False)
    for i, z in enumerate(plan.BAY_CENTRES):
        put(f"ribs_{i + 1}", [ribs] if i == 0 else None, translation(0, 0, z), "ribs")
    # The transverse arch against the east wall.
    arch = Mesh("dressed")
    for sx in (-1, 1):
        vault.rib(arch, vault.bay_curves(sx, -1)[1] + [0, 0, plan.BAY_CENTRES[-1]], 1.12)
    ashlar_e, ashlar_w = Mesh("ashlar"), Mesh("ashlar")
    walls.end_walls(ashlar_e, ashlar_w, arch)
    put("wall_east", [ashlar_e, arch])
    put("wall_west", [ashlar_w])

    piers, shell, roof = Mesh("dressed"), Mesh("outside"), Mesh("roof")
    for z in plan.BAY_LINES:
        for sx in (-1, 1):
            walls.pilaster(piers, sx, z)
    put("pilasters", [piers])
    walls.outside(shell, roof)
    put("outside", [shell, roof])

    column = Mesh("dressed")
    columns.column(column)
    for k, z in enumerate(plan.BAY_LINES):
        for sx, side in ((1, "south"), (-1, "north")):
            y = plan.CHANCEL_FLOOR if z < -9 else 0.0
            put(f"column_{side}_{k + 1}", [column] if not nodes_named(nodes, "column") else None, rotation_y(0 if sx > 0 else 180, sx * plan.COLUMN_X, 0, z), "column")  # its back, in the wall, is dark in the light map

    made = {}
    for name, window, frame, design in plan.windows():
        kind = {"east": "tracery_east", "rose": "tracery_rose"}.get(design, "tracery_side")
        matrix = frame.matrix()
        matrix[:3, 3] += frame.w * plan.GLASS_DEPTH
        if kind not in made:
            made[kind] = Mesh("dressed")
            {"tracery_side": tracery.side_window, "tracery_east": tracery.east_window, "tracery_rose": tracery.rose_window}[kind](made[kind])
            put(f"tracery_{name}", [made[kind]], matrix, kind)
        else:
            put(f"tracery_{name}", None, matrix, kind)
        lit = "sun" if name.startswith(("south", "east")) else "sky"
        key = f"glass_{design}_{lit}"
        pane = [glass_pane(window, key)] if key not in meshes else None
        put(f"glass_{name}", pane, matrix, key)

    for i, m in enumerate(floor.floors()):
        put(f"floor_{i + 1}", [m])

    pew = Mesh("oak")
    furniture.pew(pew)
    for k, z in enumerate(furniture.PEW_ROWS):
        for x in furniture.PEW_X:
            jitter = rotation_y(rng.normal(0, .35), x + rng.normal(0, .008), 0.003, z + rng.normal(0, .01))
            put(f"pew_{k + 1}_{'south' if x > 0 else 'north'}", [pew] if not nodes_named(nodes, "pew") else None, jitter, "pew")
    door_wood, iron = Mesh("oak"), Mesh("iron")
    furniture.door(door_wood, iron)
    put("door", [door_wood, iron])

    stone, dressed, linen, brocade, brass, wax, flame = (Mesh(m) for m in ("flagstone", "dressed", "linen", "brocade", "brass", "wax", "flame"))
    things.altar(stone, dressed, linen, brocade, brass, wax, flame)
    put("altar", [stone, dressed, linen, brocade])
    put("candlesticks", [brass, wax])
    put("flame_altar", [flame])
    iron, wax, flame = Mesh("iron"), Mesh("wax"), Mesh("flame")
    things.chandelier(iron, wax, flame)
    for k, p in enumerate(things.CHANDELIERS):
        put(f"chandelier_{k + 1}", [iron, wax] if k == 0 else None, translation(*p), "chandelier")
        put(f"flame_chandelier_{k + 1}", [flame] if k == 0 else None, translation(*p), "chandelier_flames")
    basin, surface = Mesh("dressed"), Mesh("water")
    things.font(basin)
    things.water(surface)
    put("font", [basin])
    put("water", [surface])
    return meshes, nodes


def nodes_named(nodes, prefix):
    return any(n[0].startswith(prefix) for n in nodes)


if __name__ == "__main__":
    meshes, nodes = build()
    count = {name: sum(p.triangles() for p in prims) for name, prims in meshes.items()}
    drawn = sum(count[mesh] for _, mesh, _ in nodes)
    print("triangles drawn", drawn, "stored", sum(count.values()), "primitives", sum(len(meshes[m]) for _, m, _ in nodes))
    for name in sorted(count, key=count.get, reverse=True)[:16]:
        print(f"  {name:24} {count[name]}")
