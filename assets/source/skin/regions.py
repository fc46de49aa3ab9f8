"""Which part of the skin a point is, as weights from 0 to 1, in the frame of the head."""
import numpy as np

import features
from common import curve, step


def bump(v, centre, size):
    return np.exp(-(((v - centre) / size) ** 2))


class Regions:
    """At points q (those of shape.uneven) with the outward normals n; wobble is noise that frays the borders, to_ear the distance to the ears."""

    def __init__(self, q, n, wobble, to_ear):
        self.x, self.y, self.z = np.abs(q[:, 0]), q[:, 1], q[:, 2]
        self.side, self.n, self.wobble, self.to_ear = q[:, 0], n, wobble, to_ear
        self.front = step(6.0, 8.0, self.z)

    def lips(self):
        """The red of the lips, and where between line and border."""
        y = self.y + 0.025 * self.wobble
        above, below, middle = features.border_above(self.x), features.border_below(self.x), features.line_between(self.x)
        inner = np.minimum(above - y, y - below)
        return step(-0.10, 0.12, inner) * step(2.75, 2.55, self.x) * self.front, (y - middle) / np.maximum(np.where(y > middle, above - middle, middle - below), 0.05)

    def nose(self):
        return np.exp(-((self.x / 1.7) ** 4)) * step(-4.7, -4.0, self.y) * step(0.8, -1.2, self.y) * step(9.3, 10.2, self.z)

    def nose_tip(self):
        return np.exp(-((self.x / 1.5) ** 2 + ((self.y + 3.3) / 0.9) ** 2)) * step(9.8, 11, self.z)

    def cheeks(self):
        return np.exp(-(((self.x - 4.6) / 2.0) ** 2 + ((self.y + 2.6) / 1.7) ** 2)) * step(3.5, 6, self.z)

    def chin(self):
        return np.exp(-((self.x / 1.9) ** 2 + ((self.y + 9.2) / 1.1) ** 2)) * self.front

    def forehead(self):
        return step(2.8, 4.2, self.y) * step(9.5, 8.0, self.y) * step(5.0, 7.5, self.z)

    def lids(self):
        return np.exp(-((((self.x - 3.2) / 2.1) ** 2) ** 2 + ((self.y - 0.55) / 0.75) ** 4)) * self.front

    def sockets(self):
        return np.exp(-(((self.x - 3.0) / 2.3) ** 2 + ((self.y + 0.1) / 1.2) ** 2)) * self.front

    def ears(self):
        return step(0.35, 0.05, self.to_ear)

    def beard(self):
        """Where a beard would grow."""
        top = curve(self.x, [0, 2.2, 2.9, 3.8, 5.2, 6.5, 8.0], [-4.5, -4.6, -5.6, -5.9, -4.4, -2.2, -1.0])
        low = curve(self.z, [0, 2, 5, 8, 9.5], [-9.5, -10.5, -12.5, -13, -13])
        return step(-0.5, 0.7, top - self.y + 0.35 * self.wobble) * step(-0.8, 0.8, self.y - low + 0.4 * self.wobble) * step(-0.3, 1.2, self.z)

    def hair(self):
        """Where the hair of the head is cut short."""
        hairline = curve(self.y, [-3, -1.5, 0.5, 2.5, 4.5, 6.0, 7.2, 8.3], [-1.6, -0.6, 0.2, 2.2, 4.0, 4.4, 5.6, 9.4])
        temple = 0.9 * np.exp(-(((self.x - 4.0) / 1.5) ** 2)) * step(6.0, 7.5, self.y)
        ahead = hairline - temple - self.z
        nape = self.y - curve(-self.z, [-2, 1.5, 4.5, 6.0, 9.0], [-1.8, -1.8, -4.6, -6.2, -6.6])
        return step(-0.8, 1.6, np.minimum(ahead / (1 + 1.8 * step(5.5, 7.0, self.y)), nape) + 0.10 * self.wobble) * (1 - self.ears())

    def brow(self):
        """Distance above the eyebrow's middle line, and its half width there."""
        middle = curve(self.x, [0.9, 1.6, 2.6, 3.8, 4.8, 5.6], [2.30, 2.48, 2.78, 3.02, 2.88, 2.45])
        half = curve(self.x, [0.8, 1.2, 2.0, 3.4, 4.6, 5.6], [0.16, 0.38, 0.44, 0.38, 0.27, 0.10])
        return self.y - middle, half
