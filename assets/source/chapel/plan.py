"""The chapel's measures, in metres: +Y up, altar towards -Z (east), sun side +X (south). Everything else follows from these."""
import numpy as np

from mesh import unit

HALF_WIDTH = 4.0          # inner face of the side walls
WALL = 1.0                # wall thickness
BAY = 4.0                 # length of one bay along Z
BAY_CENTRES = [8.0, 4.0, 0.0, -4.0, -8.0]
BAY_LINES = [10.0, 6.0, 2.0, -2.0, -6.0, -10.0]
EAST, WEST = -10.0, 10.0
COLUMN_X = 3.6
SPRING = 6.0              # where the ribs leave the capitals
BOSS = 10.8               # crown of the diagonal ribs
TRANSVERSE = 10.45        # crown of the transverse ribs
WALL_RIB = 10.05          # crown of the wall ribs
WALL_TOP = 11.6
GLASS_DEPTH = 0.70        # from the inner wall face to the glass
CHANCEL_FLOOR = 0.32

SUN_ELEVATION, SUN_AZIMUTH = 41.0, 27.0
SUN_LUX = 60000.0
SUN_COLOUR = (1.0, 0.95, 0.88)


def sun_direction():
    """Unit vector along which sunlight travels: down, towards the north wall and towards the door."""
    e, a = np.radians(SUN_ELEVATION), np.radians(SUN_AZIMUTH)
    return np.array([-np.cos(e) * np.cos(a), -np.sin(e), np.cos(e) * np.sin(a)])


class Window:
    """An opening: pointed (or round) outline in wall coordinates u (to the right seen from inside) and v (height)."""

    def __init__(self, half, sill, spring, rise, round_window=False):
        self.half, self.sill, self.spring, self.rise, self.round_window = half, sill, spring, rise, round_window

    def upper(self, u, grow=0.0, grow_rise=None):
        half = self.half + grow
        if self.round_window:
            return self.spring + np.sqrt(np.maximum(half ** 2 - np.asarray(u) ** 2, 0))
        rise = self.rise + (grow * 1.3 if grow_rise is None else grow_rise)
        r = (half ** 2 + rise ** 2) / (2 * half)
        return self.spring + np.sqrt(np.maximum(r ** 2 - (np.abs(u) + r - half) ** 2, 0))

    def lower(self, u, grow=0.0, drop=0.0):
        if self.round_window:
            return self.spring - np.sqrt(np.maximum((self.half + grow) ** 2 - np.asarray(u) ** 2, 0))
        return np.full_like(np.asarray(u, float), self.sill - drop)

    def outline(self, grow=0.0, drop=0.0, arc=14):
        """Closed boundary pieces, counter-clockwise seen from inside: list of [k,2] polylines (sill, jamb, arch, arch, jamb)."""
        half = self.half + grow
        if self.round_window:
            a = np.linspace(-np.pi / 2, 1.5 * np.pi, arc * 4 + 1)
            return [np.stack([half * np.cos(a), self.spring + half * np.sin(a)], -1)]
        u = half * np.cos(np.linspace(0, np.pi / 2, arc + 1))
        u[-1] = 0
        right = np.stack([u, self.upper(u, grow)], -1)
        left = right[::-1] * [-1, 1]
        low = self.sill - drop
        jamb = np.linspace(low, self.spring, 5)
        return [np.array([[-half, low], [0, low], [half, low]]), np.stack([np.full(5, half), jamb], -1), right, left,
                np.stack([np.full(5, -half), jamb[::-1]], -1)]


SIDE = Window(1.0, 2.45, 6.95, 1.95)
EASTERN = Window(2.2, 3.2, 6.3, 3.0)
ROSE = Window(1.25, 0, 7.4, 0, round_window=True)
DOOR = Window(0.85, 0.0, 2.0, 1.05)


class Frame:
    """A wall's own coordinates: u to the right and v up as seen from inside, w into the wall."""

    def __init__(self, origin, w):
        self.o, self.w = np.asarray(origin, float), unit(w)
        self.u = np.cross(self.w, [0, 1.0, 0])
        self.v = np.array([0, 1.0, 0])

    def at(self, uv, w=0.0):
        uv = np.asarray(uv, float)
        w = np.broadcast_to(np.asarray(w, float), uv.shape[:-1])
        return self.o + uv[..., :1] * self.u + uv[..., 1:2] * self.v + w[..., None] * self.w

    def matrix(self):
        """Local X = u, Y = v, Z = -w."""
        m = np.eye(4)
        m[:3, 0], m[:3, 1], m[:3, 2], m[:3, 3] = self.u, self.v, -self.w, self.o
        return m


def south(z):
    return Frame([HALF_WIDTH, 0, z], [1, 0, 0])


def north(z):
    return Frame([-HALF_WIDTH, 0, z], [-1, 0, 0])


def east():
    return Frame([0, 0, EAST], [0, 0, -1])


def west():
    return Frame([0, 0, WEST], [0, 0, 1])


def windows():
    """Every glazed opening: (name, window, frame, design)."""
    found = []
    for i, z in enumerate(BAY_CENTRES):
        found.append((f"south_{i + 1}", SIDE, south(z), "abcab"[i]))
        found.append((f"north_{i + 1}", SIDE, north(z), "bcabc"[i]))
    found.append(("east", EASTERN, east(), "east"))
    found.append(("west", ROSE, west(), "rose"))
    return found
