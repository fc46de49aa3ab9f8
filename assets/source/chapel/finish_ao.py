"""Smooths the baked occlusion a little and stores it in 8 bits. Usage: finish_ao.py CHAPEL_DIRECTORY"""
import pathlib
import sys

import numpy as np

import imageio
from noise import blur, fill_gaps

folder = pathlib.Path(sys.argv[1])
raw = folder / "ambient_occlusion.npy"
ao = np.load(raw).astype(float)
ao = np.clip(ao, 0, 1)
# An edge-keeping average: the noise of the bake goes, contact shadows stay.
soft = blur(ao, 1.0)
ao = soft + (ao - soft) * np.clip(np.abs(ao - soft) / 0.12, 0, 1) ** 2
# Texels without a surface, or inside another stone, take their neighbours' value: no dark seams under filtering.
ao = fill_gaps(np.repeat(ao[..., None], 3, -1), ao > 0.004)[..., 0]
# Light that bounces between pale stones fills hollows (Jimenez et al. 2016, for an albedo of 0.45).
a, b, c = (k0 * 0.45 + k1 for k0, k1 in ((2.0404, -0.3324), (-4.7951, 0.6417), (2.7552, 0.6903)))
ao = np.clip(np.maximum(ao, ((ao * a + b) * ao + c) * ao), 0, 1)
imageio.save(folder / "textures" / "ambient_occlusion.png", ao)
raw.unlink()
print("mean occlusion", ao.mean().round(3))
