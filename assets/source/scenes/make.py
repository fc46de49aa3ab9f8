#!/usr/bin/env python3
"""Makes the small pictures, light probes, the glTF sample and the volumes of assets/scenes/. Needs nothing but Python; the results are committed.

usage: assets/source/scenes/make.py
"""
import base64
import json
import math
import pathlib
import struct
import zlib

OUT = pathlib.Path(__file__).resolve().parents[2] / "scenes"


def write_png(name, width, height, pixel):
    """8-bit PNG; pixel(x, y) gives 3 or 4 values 0..255, y from the top."""
    channels = len(pixel(0, 0))
    rows = b"".join(b"\0" + bytes(v for x in range(width) for v in pixel(x, y)) for y in range(height))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, {3: 2, 4: 6}[channels], 0, 0, 0)
    (OUT / "textures" / name).write_bytes(
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def write_hdr(name, width, height, radiance):
    """Radiance RGBE without run lengths; radiance(u, v) in 0..1 from the top left."""
    data = bytearray(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + f"-Y {height} +X {width}\n".encode())
    for y in range(height):
        for x in range(width):
            rgb = radiance((x + 0.5) / width, (y + 0.5) / height)
            mantissa, exponent = math.frexp(max(rgb))
            scale = mantissa * 256 / max(rgb)
            data += bytes([min(255, int(c * scale + 0.5)) for c in rgb] + [exponent + 128])
    (OUT / "textures" / name).write_bytes(bytes(data))


def noise(x, y):
    """A fixed hash in 0..1."""
    n = (x * 374761393 + y * 668265263) & 0xFFFFFFFF
    n = ((n ^ (n >> 13)) * 1274126177) & 0xFFFFFFFF
    return (n ^ (n >> 16)) / 0xFFFFFFFF


def tiles(x, y):
    """Four tiles of different colours with dark joints."""
    if x % 32 < 2 or y % 32 < 2:
        return 60, 56, 52
    base = [(200, 188, 166), (150, 84, 62), (96, 112, 92), (176, 158, 130)][(x // 32) + 2 * (y // 32)]
    shade = 0.92 + 0.08 * noise(x, y)
    return tuple(int(c * shade) for c in base)


def leaf(x, y):
    """A pointed leaf with a vein on nothing."""
    u, v = (x + 0.5) / 64 * 2 - 1, (y + 0.5) / 64
    half_width = 0.62 * math.sin(math.pi * v) ** 0.8
    inside = abs(u) < half_width
    vein = abs(u) < 0.04 or abs((abs(u) * 0.9 + v * 2) % 0.28 - 0.14) < 0.02
    return (118, 140, 62, 255 * inside) if vein else (62, 104, 38, 255 * inside)


def leaf_through(x, y):
    """What of light comes through that leaf: yellowish green; little through its veins. Alpha is the share that does."""
    vein = leaf(x, y)[:3] == (118, 140, 62)
    shade = 0.9 + 0.1 * noise(x, y)
    return (96, 110, 40, 110) if vein else (int(150 * shade), int(188 * shade), int(36 * shade), 215)


def window(x, y):
    """Panes of coloured glass between leads."""
    if x % 16 < 2 or y % 16 < 2 or x > 61 or y > 61:
        return 0, 0, 0
    return [(255, 210, 90), (70, 120, 255), (255, 70, 50), (90, 230, 120)][(x // 16 + 3 * (y // 16)) % 4]


def normal(nx, ny):
    nz = math.sqrt(max(0.0, 1 - nx * nx - ny * ny))
    return tuple(int((c * 0.5 + 0.5) * 255 + 0.5) for c in (nx, ny, nz))


def bumps_normal(x, y):
    """Round studs, four to the picture."""
    u, v = ((x + 0.5) / 32 % 1) * 2 - 1, 1 - ((y + 0.5) / 32 % 1) * 2
    return normal(u * 0.9, v * 0.9) if u * u + v * v < 0.6 else (128, 128, 255)


def tilted_normal(x, _):
    """Left half leans 30 degrees to +U, right half to the picture's top."""
    return normal(0.5, 0.0) if x < 8 else normal(0.0, 0.5)


def evening(u, v):
    """A clear evening: bright low in one direction, blue above, dim ground. cd/m2."""
    up = math.cos(math.pi * v)
    glow = max(0.0, math.cos(2 * math.pi * (u - 0.3))) ** 4 * math.exp(-((up - 0.15) / 0.25) ** 2)
    if up < 0:
        return 90 + 40 * up, 76 + 34 * up, 60 + 28 * up
    return 220 + 1800 * glow, 300 + 1100 * glow, 480 + 420 * glow


QUAD = {"position": [(-0.5, -0.5, 0), (0.5, -0.5, 0), (0.5, 0.5, 0), (-0.5, 0.5, 0)], "indices": [0, 1, 2, 0, 2, 3]}
QUAD_UV = [(0, 1), (1, 1), (1, 0), (0, 0)]
TRANSFORM = {"offset": [0.25, 0.4], "rotation": 0.5, "scale": [1.5, 0.75]}


def transformed(uv):
    """KHR_texture_transform: scale, then rotate, then offset."""
    u, v = uv[0] * TRANSFORM["scale"][0], uv[1] * TRANSFORM["scale"][1]
    c, s = math.cos(TRANSFORM["rotation"]), math.sin(TRANSFORM["rotation"])
    return u * c + v * s + TRANSFORM["offset"][0], -u * s + v * c + TRANSFORM["offset"][1]


class Gltf:
    """Collects a buffer and its accessors."""

    def __init__(self):
        self.data = bytearray()
        self.views, self.accessors = [], []

    def add(self, values, kind, component, code, bounds=False):
        flat = [c for v in values for c in (v if isinstance(v, tuple) else (v,))]
        raw = struct.pack(f"<{len(flat)}{code}", *flat)
        self.views.append({"buffer": 0, "byteOffset": len(self.data), "byteLength": len(raw)})
        self.data += raw + bytes(-len(raw) % 4)
        accessor = {"bufferView": len(self.views) - 1, "componentType": component, "count": len(values), "type": kind}
        if bounds:
            accessor["min"] = [min(v[i] for v in values) for i in range(3)]
            accessor["max"] = [max(v[i] for v in values) for i in range(3)]
        self.accessors.append(accessor)
        return len(self.accessors) - 1


def write_gltf():
    g = Gltf()
    position = g.add(QUAD["position"], "VEC3", 5126, "f", True)
    normals = g.add([(0, 0, 1)] * 4, "VEC3", 5126, "f")
    indices = g.add(QUAD["indices"], "SCALAR", 5123, "H")
    plain_uv = g.add(QUAD_UV, "VEC2", 5126, "f")
    baked_uv = g.add([transformed(uv) for uv in QUAD_UV], "VEC2", 5126, "f")
    names = ["Transformed", "Baked", "Leaning", "Leaf"]
    matte = {"KHR_materials_specular": {"specularFactor": 0}}

    def material(name, texture=None, **more):
        rough = {"metallicFactor": 0, "roughnessFactor": 1}
        if texture is not None:
            rough["baseColorTexture"] = texture
        return {"name": name, "pbrMetallicRoughness": rough, "extensions": matte, **more}

    gltf = {
        "asset": {"version": "2.0", "generator": "assets/source/scenes/make.py"},
        "extensionsUsed": ["KHR_texture_transform", "KHR_materials_specular"],
        "scene": 0,
        "scenes": [{"nodes": [0, 1, 2, 3]}],
        "nodes": [{"name": name, "mesh": i, "translation": [2 * i, 0, 0]} for i, name in enumerate(names)],
        "meshes": [{"name": name, "primitives": [{
            "attributes": {"POSITION": position, "NORMAL": normals, "TEXCOORD_0": baked_uv if name == "Baked" else plain_uv},
            "indices": indices, "material": i}]} for i, name in enumerate(names)],
        "materials": [
            material("Transformed", {"index": 0, "extensions": {"KHR_texture_transform": TRANSFORM}}),
            material("Baked", {"index": 0}),
            material("Leaning", normalTexture={"index": 1}),
            material("Leaf", {"index": 2}, alphaMode="MASK", alphaCutoff=0.5, doubleSided=True),
        ],
        "textures": [{"source": 0, "sampler": 0}, {"source": 1, "sampler": 1}, {"source": 2, "sampler": 0}],
        "samplers": [{"magFilter": 9729, "minFilter": 9987}, {"magFilter": 9728, "minFilter": 9728}],
        "images": [{"uri": "textures/tiles.png"}, {"uri": "textures/tilted_normal.png"}, {"uri": "textures/leaf.png"}],
        "accessors": g.accessors,
        "bufferViews": g.views,
        "buffers": [{"byteLength": len(g.data), "uri": "data:application/octet-stream;base64," + base64.b64encode(g.data).decode()}],
    }
    (OUT / "sample.gltf").write_text(json.dumps(gltf, indent=1) + "\n")


def lattice_noise(x, y, z):
    """Smooth noise in [0, 1] from hashed lattice values."""
    def corner(i, j, k):
        h = (i * 0x9E3779B1 ^ j * 0x85EBCA6B ^ k * 0xC2B2AE35) & 0xFFFFFFFF
        h = ((h ^ h >> 15) * 0x2C1B3C6D) & 0xFFFFFFFF
        h = ((h ^ h >> 12) * 0x297A2D39) & 0xFFFFFFFF
        return (h ^ h >> 15) / 0xFFFFFFFF

    i, j, k = math.floor(x), math.floor(y), math.floor(z)
    u, v, w = (t * t * (3 - 2 * t) for t in (x - i, y - j, z - k))
    return sum((u if a else 1 - u) * (v if b else 1 - v) * (w if c else 1 - w) * corner(i + a, j + b, k + c)
               for a in (0, 1) for b in (0, 1) for c in (0, 1))


def plume(x, y, z):
    """Smoke that rises from (0, 0, 0) to y = 1, swaying and widening: density in [0, 1]."""
    sway = 0.06 * math.sin(7 * y) * y, 0.05 * math.cos(6 * y + 1) * y
    width = 0.025 + 0.085 * y
    distance = math.hypot(x - sway[0], z - sway[1]) / width
    noise = sum(lattice_noise(*(9 * 2**o * t for t in (x, 0.7 * y, z))) / 2**o for o in range(4)) / 1.875
    core = math.exp(-distance * distance) * min(1, 12 * y) * min(1, 1.8 * (1 - y)) ** 2
    return min(1.0, max(0.0, 2.2 * core + 1.6 * (noise - 0.62) * min(1, 3 * core)))


def write_volume(name, about, size, value, width):
    """A raw volume of bytes and its description. value(x, y, z) in 0..1; y from 0 to 1, x and z within half a width of 0."""
    nx, ny, nz = size
    values = bytes(int(255 * value(((i + 0.5) / nx - 0.5) * width, (j + 0.5) / ny, ((k + 0.5) / nz - 0.5) * width) + 0.5)
                   for k in range(nz) for j in range(ny) for i in range(nx))
    (OUT / "volumes" / f"{name}.raw").write_bytes(values)
    description = {"about": about, "raw": f"{name}.raw", "type": "u8", "size": [nx, ny, nz], "voxel_m": [1 / ny] * 3}
    (OUT / "volumes" / f"{name}.json").write_text(json.dumps(description) + "\n")


def puff(x, y, z, age):
    """A ring of smoke that rises and widens as it ages from 0 to 1: density in [0, 1]."""
    ring, tube, height = 0.12 + 0.2 * age, 0.06 + 0.05 * age, 0.2 + 0.5 * age
    return (0.9 - 0.5 * age) * math.exp(-((math.hypot(x, z) - ring) ** 2 + (y - height) ** 2) / (tube * tube))


def flame(x, y, z):
    """A flame on y = 0, wide below and pointed above: how much soot there is, in [0, 1]."""
    lick = 0.05 * math.sin(9 * y + 1) * y, 0.05 * math.sin(8 * y + 4) * y
    width = 0.17 * (1 - y) ** 0.8 * min(1, 0.4 + 3 * y) + 0.01
    noise = sum(lattice_noise(*(7 * 2**o * t for t in (x, 0.5 * y, z))) / 2**o for o in range(3)) / 1.75
    distance = math.hypot(x - lick[0], z - lick[1]) / width
    return min(1.0, max(0.0, 1.3 * math.exp(-distance * distance) * (0.55 + 0.9 * noise) * min(1, 10 * y) - 0.12))


def flame_heat(x, y, z):
    """Its temperature: hottest where the soot is densest and low."""
    return min(1.0, (0.55 + 0.45 * flame(x, y, z)) * (1 - 0.35 * y))


def write_spray(name, count):
    """Drops of a jet that falls apart, as lines of x y z radius weight."""
    lines = ["# A jet of drops: x y z radius weight"]
    for i in range(count):
        t = i / count
        spread = 0.04 + 0.3 * t
        angle, away, size = 6.2832 * noise(i, 1), spread * math.sqrt(noise(i, 2)), noise(i, 3)
        place = away * math.cos(angle), 1.1 * t - 0.35 * t * t + 0.1 * (noise(i, 4) - 0.5) * t, away * math.sin(angle)
        lines.append(" ".join(f"{v:.4f}" for v in (*place, 0.03 + 0.05 * size * (0.5 + t), 1 - 0.7 * t)))
    (OUT / "volumes" / name).write_text("\n".join(lines) + "\n")


(OUT / "textures").mkdir(exist_ok=True)
(OUT / "volumes").mkdir(exist_ok=True)
write_png("tiles.png", 64, 64, tiles)
write_png("leaf.png", 64, 64, leaf)
write_png("leaf_through.png", 64, 64, leaf_through)
write_png("window.png", 64, 64, window)
write_png("bumps_normal.png", 64, 64, bumps_normal)
write_png("tilted_normal.png", 16, 16, tilted_normal)
write_hdr("uniform.hdr", 16, 8, lambda u, v: (1.0, 1.0, 1.0))
write_hdr("evening.hdr", 128, 64, evening)
write_gltf()
write_volume("plume", "A plume of smoke.", (48, 96, 48), plume, 0.5)
for age in range(4):
    write_volume(f"puff_{age + 1:02d}", "A ring of smoke that rises.", (24, 24, 24), lambda x, y, z: puff(x, y, z, age / 3), 1.0)
write_volume("flame", "Soot of a flame.", (24, 48, 24), flame, 0.5)
write_volume("flame_heat", "Temperature of a flame.", (24, 48, 24), flame_heat, 0.5)
write_spray("spray.txt", 400)
