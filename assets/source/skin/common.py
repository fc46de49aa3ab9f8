"""Distances of simple shapes and contouring, shared with the subjects."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "subjects"))
from sdf import boxed, capsule, chain, curve, ellipsoid, length, smooth_max, smooth_min, step  # noqa: E402,F401
from surface import in_batches  # noqa: E402,F401
