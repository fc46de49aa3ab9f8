"""The upper half of the head: the skin of an MRI head (`ch2.nii.gz` of Debian's `mricron-data`), as a signed distance in centimetres."""
import gzip
import struct

import numpy as np
from scipy import ndimage

from common import step

SCALE = np.array([0.087, 0.082, 0.092])  # cm to a voxel of 1 mm: the template stands in a space that is larger than life
ORIGIN = np.array([90.0, 24.0, 98.0])    # the voxel at the head's origin: between the ear canals
AIR = 30                                 # gray between air and skin


def volume(path):
    """Gray values [x, y up, z to the face]."""
    data = gzip.open(path).read()
    nx, ny, nz = struct.unpack("<8h", data[40:56])[1:4]
    offset = int(struct.unpack("<f", data[108:112])[0])
    voxels = np.frombuffer(data[offset:], np.uint8).reshape(nz, ny, nx)
    return voxels.transpose(2, 0, 1)[::-1].astype(np.float32)


def filled(gray):
    """Gray values of a body without hollows: only what can be reached from outside is air."""
    air = gray < AIR
    shut = ndimage.binary_opening(air, iterations=2)
    label, _ = ndimage.label(shut)
    outside = label == label[5, -5, 5]
    near = ndimage.binary_dilation(outside, iterations=4)
    return np.where(near, gray, 120)


class Head:
    def __init__(self, path):
        gray = np.pad(volume(path), 8, mode="edge")
        gray = ndimage.gaussian_filter(filled(gray), 0.8)
        fine = ndimage.zoom(gray, 2, order=1, grid_mode=True, mode="nearest")
        inside = fine > AIR
        distance = ndimage.distance_transform_edt(~inside) - ndimage.distance_transform_edt(inside)
        distance = distance.astype(np.float32) * 0.5 * 0.089
        self.fine, self.smooth = (ndimage.spline_filter(ndimage.gaussian_filter(distance, width), 2, output=np.float32) for width in (2.0, 9.0))

    def __call__(self, p):
        voxel = p / SCALE + ORIGIN + 8
        at = (voxel + 0.5) * 2 - 0.5
        fine, smooth = (ndimage.map_coordinates(grid, at.T, order=2, prefilter=False, mode="nearest") for grid in (self.fine, self.smooth))
        x, y = np.abs(p[:, 0]), p[:, 1]
        face = step(5.0, 8.0, p[:, 2]) * step(4.2, 2.8, y) * (1 - step(1.6, 2.4, y) * step(1.6, 0.9, x))   # the scan is noisy elsewhere
        return (smooth + face * (fine - smooth)).astype(np.float32)
