"""Denoises the indoor probe, makes the sky probe; both in cd/m2. Usage: finish_probe.py CHAPEL_DIRECTORY"""
import pathlib
import sys

import numpy as np

import imageio
import plan

WIDTH, HEIGHT = 256, 128
UNIT = 1000.0  # cd/m2 of one Cycles unit


def directions():
    """Direction of every texel: u = 0.5 + atan2(x, -z) / 2 pi, v = acos(y) / pi from the top row."""
    u = (np.arange(WIDTH) + .5) / WIDTH
    v = (np.arange(HEIGHT) + .5) / HEIGHT
    a, t = np.meshgrid((u - .5) * 2 * np.pi, v * np.pi)
    return np.stack([np.sin(t) * np.sin(a), np.cos(t), -np.sin(t) * np.cos(a)], -1)


def denoise(image):
    """Non-local means on log radiance: patches that look alike are averaged, patch edges stay."""
    log = np.log(image + 0.003)
    total, weight = np.zeros_like(image), np.zeros(image.shape[:2])
    noise = np.median(np.abs(log - np.roll(log, 1, 1)), axis=(0, 1)).mean() + 1e-3
    for dy in range(-4, 5):
        for dx in range(-4, 5):
            moved = np.roll(log, (dy, dx), (0, 1))
            d = ((log - moved) ** 2).mean(-1)
            patch = sum(np.roll(d, (py, px), (0, 1)) for py in (-1, 0, 1) for px in (-1, 0, 1)) / 9
            w = np.exp(-np.maximum(patch - 2 * noise ** 2, 0) / (1.2 * noise) ** 2)
            total += np.roll(image, (dy, dx), (0, 1)) * w[..., None]
            weight += w
    return total / weight[..., None]


def sky():
    """Clear sky after CIE type 12 with a sun-warm glow, a hazy horizon and sunlit grass below; the sun itself is the directional light."""
    d = directions()
    to_sun = -plan.sun_direction()
    gamma = np.arccos(np.clip(d @ to_sun, -1, 1))
    zenith = np.arccos(np.clip(d[..., 1], 0.02, 1))
    zs = np.arccos(to_sun[1])
    a, b, c, e, f = -1.0, -0.32, 10.0, -3.0, 0.45

    def lum(z, g):
        return (1 + a * np.exp(b / np.cos(z))) * (1 + c * (np.exp(e * g) - np.exp(e * np.pi / 2)) + f * np.cos(g) ** 2)

    relative = lum(zenith, gamma) / lum(0.0, zs)
    level = 2600.0 * np.minimum(relative, 9.0)
    haze = np.exp(-np.maximum(d[..., 1], 0) * 5.0)[..., None]
    glow = np.exp(-gamma * 2.2)[..., None]
    blue, white, warm = np.array([.55, .85, 1.75]), np.array([.95, 1.0, 1.08]), np.array([1.12, 1.0, .86])
    tint = (blue * (1 - haze) + white * haze) * (1 - .7 * glow) + warm * .7 * glow
    tint /= (tint @ [.2126, .7152, .0722])[..., None]
    horizontal = plan.SUN_LUX * to_sun[1] + 11000
    ground = np.array([.115, .135, .07]) * horizontal / np.pi
    return np.where(d[..., 1:2] > 0, level[..., None] * tint, ground)


def irradiance(image, normal):
    d = directions()
    solid = (np.pi / HEIGHT) * (2 * np.pi / WIDTH) * np.sin((np.arange(HEIGHT) + .5) / HEIGHT * np.pi)[:, None]
    y = image @ [.2126, .7152, .0722]
    return (y * np.maximum(d @ np.asarray(normal, float), 0) * solid).sum()


if __name__ == "__main__":
    folder = pathlib.Path(sys.argv[1])
    raw = folder / "probe_raw.exr"
    if raw.exists():
        nave = denoise(imageio.load(raw)[..., :3].astype(float)) * UNIT
        imageio.save(folder / "probe_nave.exr", nave)
        raw.unlink()
    imageio.save(folder / "probe_outside.exr", sky())
    for name in ("probe_nave.exr", "probe_outside.exr"):
        p = imageio.load(folder / name)[..., :3]
        print(name, "mean", p.mean((0, 1)).round(1), "lux on a floor", round(irradiance(p, [0, 1, 0])), "on a ceiling", round(irradiance(p, [0, -1, 0])))
