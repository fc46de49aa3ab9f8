"""Periodic noise and small filters on arrays that tile."""
import numpy as np


def spectral(shape, beta, seed, low=0.0, high=1e9, stretch=(1.0, 1.0)):
    """Gaussian noise of unit variance with power 1/f^beta between two frequencies in cycles per tile; periodic. `stretch` (rows, columns) > 1 lengthens features."""
    rng = np.random.default_rng(seed)
    fy = np.fft.fftfreq(shape[0], 1 / shape[0])[:, None] * stretch[0]
    fx = np.fft.rfftfreq(shape[1], 1 / shape[1])[None] * stretch[1]
    f = np.hypot(fx, fy)
    amplitude = np.where((f >= max(low, 0.5)) & (f <= high), np.maximum(f, 0.5) ** (-beta / 2), 0)
    spectrum = amplitude * np.exp(2j * np.pi * rng.random(amplitude.shape)) * np.sqrt(rng.exponential(1, amplitude.shape))
    a = np.fft.irfft2(spectrum, shape)
    return (a - a.mean()) / a.std()


def blur(a, sigma):
    """Periodic Gaussian blur, sigma in pixels (rows and columns)."""
    fy = np.fft.fftfreq(a.shape[0])[:, None]
    fx = np.fft.rfftfreq(a.shape[1])[None]
    return np.fft.irfft2(np.fft.rfft2(a) * np.exp(-2 * (np.pi * sigma) ** 2 * (fx ** 2 + fy ** 2)), a.shape)


def normal_map(height, metres_per_pixel):
    """Tangent-space normals (x right, y up in the image) of a height field in metres, encoded to 0..1."""
    sy, sx = metres_per_pixel if np.ndim(metres_per_pixel) else (metres_per_pixel,) * 2
    dx = (np.roll(height, -1, 1) - np.roll(height, 1, 1)) / (2 * sx)
    dy = (np.roll(height, 1, 0) - np.roll(height, -1, 0)) / (2 * sy)
    n = np.stack([-dx, -dy, np.ones_like(dx)], -1)
    n /= np.linalg.norm(n, axis=-1, keepdims=True)
    return n * 0.5 + 0.5


def smooth(lo, hi, x):
    t = np.clip((x - lo) / (hi - lo), 0, 1)
    return t * t * (3 - 2 * t)


def fill_gaps(image, covered):
    """Fills texels that are not covered from those around them (push-pull over a pyramid; sides are powers of two)."""
    levels = [(image * covered[..., None], covered.astype(float))]
    while min(levels[-1][1].shape) > 1:
        c, w = levels[-1]
        shape = (c.shape[0] // 2, 2, c.shape[1] // 2, 2)
        levels.append((c.reshape(*shape, 3).sum((1, 3)), w.reshape(shape).sum((1, 3))))
    c, w = levels[-1]
    fill = c / np.maximum(w, 1e-9)[..., None]
    for c, w in reversed(levels[:-1]):
        up = fill.repeat(2, 0).repeat(2, 1)
        fill = np.where(w[..., None] > 0, c / np.maximum(w, 1e-9)[..., None], up)
    return fill
