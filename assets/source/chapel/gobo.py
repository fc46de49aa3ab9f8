"""The sun's gobo: transmittance of every sun-facing window, projected along the sun onto the light's own XY plane.

Usage: gobo.py TEXTURE_DIRECTORY          makes sun_gobo.png and prints its size in metres
       gobo.py TEXTURE_DIRECTORY --check  compares it with the glass at random points of every window
"""
import pathlib
import sys

import numpy as np

import imageio
import plan
from build import glass_extent
from mesh import unit
from noise import fill_gaps

WIDTH, HEIGHT = 2048, 1024
PENUMBRA = 0.012                    # metres: the sun's disc (0.53 degrees) seen from a floor some 6 m away blurs by about this sigma
PANE = plan.GLASS_DEPTH + 0.015


def light_axes():
    """X (right), Y (up), Z of the light's frame; light travels along -Z."""
    d = plan.sun_direction()
    x = unit(np.cross(d, [0, 1.0, 0]))
    return x, np.cross(x, d), -d


def light_quaternion():
    """The light's rotation [x, y, z, w]."""
    m = np.stack(light_axes(), 1)
    w = np.sqrt(max(0, 1 + m[0, 0] + m[1, 1] + m[2, 2])) / 2
    return np.array([m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1], 4 * w * w]) / (4 * w)


def sunny_windows():
    return [w for w in plan.windows() if w[2].w @ plan.sun_direction() < -0.05]


def sunny_corners():
    found = []
    for _, window, frame, _ in sunny_windows():
        bottom, top = glass_extent(window)
        found.append(frame.at(np.array([[u, v] for u in (-window.half, window.half) for v in (bottom, top)]), PANE))
    return np.concatenate(found)


def origin():
    """The light's place: where the rectangle around all sunny windows has its centre. It only anchors the gobo."""
    x, y, _ = light_axes()
    middle = np.array([0.0, 5.5, 0.0])
    q = np.stack([(sunny_corners() - middle) @ x, (sunny_corners() - middle) @ y], -1)
    centre = (q.min(0) + q.max(0)) / 2
    return np.round(middle + centre[0] * x + centre[1] * y, 5)


def to_light(p):
    x, y, _ = light_axes()
    return np.stack([(p - origin()) @ x, (p - origin()) @ y], -1)


def extent():
    """Width and height in metres of the centred rectangle that holds every sunny window, rounded up."""
    return np.ceil(np.abs(to_light(sunny_corners())).max(0) * 20 + 2) / 10


def soften(glass, window):
    bottom, top = glass_extent(window)
    h, w = glass.shape[:2]
    for axis, px in ((0, (top - bottom) / h), (1, 2 * window.half / w)):
        s = PENUMBRA / px
        k = np.exp(-0.5 * (np.arange(-int(3 * s), int(3 * s) + 1) / s) ** 2)
        pad = [(0, 0)] * 3
        pad[axis] = (len(k) // 2,) * 2
        padded = np.pad(glass, pad, mode="edge")
        glass = np.apply_along_axis(lambda a: np.convolve(a, k / k.sum(), "valid"), axis, padded)
    return glass


def sample(glass, u, v):
    """Nearest texel of a glass image at normalised window coordinates (v upwards)."""
    h, w = glass.shape[:2]
    return glass[np.clip(((1 - v) * h).astype(int), 0, h - 1), np.clip((u * w).astype(int), 0, w - 1)]


def load_glass(folder):
    return {d: imageio.to_linear(imageio.load(folder / f"glass_{d}.jpg")[..., :3]) for d in {w[3] for w in sunny_windows()}}


def project(folder):
    x, y, z = light_axes()
    size = extent()
    glass = load_glass(folder)
    soft = {}
    px = (np.arange(WIDTH) + .5) / WIDTH * size[0] - size[0] / 2
    py = size[1] / 2 - (np.arange(HEIGHT) + .5) / HEIGHT * size[1]
    a, b = np.meshgrid(px, py)
    start = origin() + a[..., None] * x + b[..., None] * y
    image = np.zeros((HEIGHT, WIDTH, 3))
    covered = np.zeros((HEIGHT, WIDTH), bool)
    for _, window, frame, design in sunny_windows():
        if design not in soft:
            soft[design] = soften(glass[design], window)
        t = ((frame.o - start) @ frame.w + PANE) / (-z @ frame.w)
        q = start - t[..., None] * z - frame.o
        u, v = q @ frame.u, q @ frame.v
        bottom, top = glass_extent(window)
        inside = (np.abs(u) < window.half) & (v > bottom) & (v < window.upper(np.clip(u, -window.half, window.half)))
        image[inside] = sample(soft[design], u[inside] / (2 * window.half) + .5, (v[inside] - bottom) / (top - bottom))
        covered |= inside
    return fill_gaps(image, covered), size


def check(folder):
    """The gobo under a point of the glass must show the glass around that point."""
    gobo = imageio.to_linear(imageio.load(folder / "sun_gobo.png")[..., :3])
    size = extent()
    rng = np.random.default_rng(4)
    glass = load_glass(folder)
    worst = 0.0
    for name, window, frame, design in sunny_windows():
        soft = soften(glass[design], window)
        bottom, top = glass_extent(window)
        u = rng.uniform(-.9, .9, 400) * window.half
        v = bottom + .1 + rng.random(400) * (window.upper(u) - bottom - .2)
        p = to_light(frame.at(np.stack([u, v], -1), PANE))
        col = ((p[:, 0] / size[0] + .5) * WIDTH).astype(int)
        row = ((.5 - p[:, 1] / size[1]) * HEIGHT).astype(int)
        error = np.abs(gobo[row, col] - sample(soft, u / (2 * window.half) + .5, (v - bottom) / (top - bottom)))
        worst = max(worst, error.mean())
        print(f"{name:10} mean error {error.mean():.4f}, largest {error.max():.3f}")
    # Texels are 1 x 1.5 cm and neighbouring pieces differ by 0.5: 0.03 is half a texel; a misplaced gobo has 0.15 and more.
    assert worst < 0.03, "the gobo does not lie on the glass"


if __name__ == "__main__":
    target = pathlib.Path(sys.argv[1])
    if "--check" in sys.argv:
        check(target)
    else:
        picture, metres = project(target)
        imageio.save(target / "sun_gobo.png", imageio.to_srgb(picture))
        print("sun_gobo.png covers", metres.tolist(), "m")
