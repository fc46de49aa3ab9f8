"""Smooths the baked occlusion a little and stores it in 8 bits. Usage: finish_ao.py CHAPEL_DIRECTORY"""
import pathlib
import sys

import numpy as np

import imageio
from noise import blur

folder = pathlib.Path(sys.argv[1])
raw = folder / "ambient_occlusion.npy"
ao = np.load(raw).astype(float)
ao = np.clip(ao, 0, 1)
# An edge-keeping average: the noise of the bake goes, contact shadows stay.
soft = blur(ao, 1.0)
ao = soft + (ao - soft) * np.clip(np.abs(ao - soft) / 0.12, 0, 1) ** 2
imageio.save(folder / "textures" / "ambient_occlusion.png", ao)
raw.unlink()
print("mean occlusion", ao.mean().round(3))
