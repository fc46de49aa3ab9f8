"""Reading and writing images through OpenImageIO; arrays are [rows, columns, channels], row 0 at the top."""
import numpy as np
import OpenImageIO as oiio


def save(path, array, quality=88):
    """8-bit PNG or JPEG from values in 0..1 (already encoded), or a half-float EXR from linear values."""
    a = np.asarray(array)
    if a.ndim == 2:
        a = a[..., None]
    h, w, c = a.shape
    path = str(path)
    if path.endswith(".exr"):
        spec = oiio.ImageSpec(w, h, c, "half")
        spec.attribute("compression", "zip")
        data = np.ascontiguousarray(a, np.float32)
    else:
        spec = oiio.ImageSpec(w, h, c, "uint8")
        spec.attribute("CompressionQuality", quality)
        spec.attribute("Compression", f"jpeg:{quality}")
        spec.attribute("jpeg:subsampling", "4:2:0" if quality < 92 else "4:4:4")
        spec.attribute("png:compressionLevel", 9)
        data = np.ascontiguousarray(np.clip(a * 255 + 0.5, 0, 255).astype(np.uint8))
    out = oiio.ImageOutput.create(path)
    if not out or not out.open(path, spec) or not out.write_image(data) or not out.close():
        raise RuntimeError(f"{path}: cannot be written: {oiio.geterror()}")


def load(path):
    buf = oiio.ImageBuf(str(path))
    a = buf.get_pixels("float")
    if a is None or a.size == 0:
        raise RuntimeError(f"{path}: cannot be read: {buf.geterror()}")
    return a


def to_srgb(x):
    x = np.clip(x, 0, 1)
    return np.where(x <= 0.0031308, x * 12.92, 1.055 * np.power(x, 1 / 2.4) - 0.055)


def to_linear(x):
    return np.where(x <= 0.04045, x / 12.92, ((x + 0.055) / 1.055) ** 2.4)
