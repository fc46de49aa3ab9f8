"""Writes plain OpenEXR files, so that tests know every number in them: 32-bit floats, uncompressed, one part."""
import struct


def attribute(name, kind, value):
    return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(value)) + value


def write_exr(path, width, height, channels):
    """`channels`: name -> function of (x, y) that gives a number."""
    names = sorted(channels)
    listed = b"".join(name.encode() + b"\0" + struct.pack("<iB3xii", 2, 0, 1, 1) for name in names) + b"\0"
    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    header = struct.pack("<ii", 20000630, 2)
    header += attribute("channels", "chlist", listed) + attribute("compression", "compression", b"\0")
    header += attribute("dataWindow", "box2i", window) + attribute("displayWindow", "box2i", window)
    header += attribute("lineOrder", "lineOrder", b"\0") + attribute("pixelAspectRatio", "float", struct.pack("<f", 1))
    header += attribute("screenWindowCenter", "v2f", struct.pack("<2f", 0, 0)) + attribute("screenWindowWidth", "float", struct.pack("<f", 1))
    header += b"\0"
    size = 4 * width * len(names)
    first = len(header) + 8 * height
    lines = b"".join(struct.pack("<ii", y, size) + b"".join(struct.pack(f"<{width}f", *(channels[name](x, y) for x in range(width))) for name in names)
                     for y in range(height))
    path.write_bytes(header + b"".join(struct.pack("<Q", first + y * (size + 8)) for y in range(height)) + lines)
    return path


def rgb(function):
    """Three channels of a function of (x, y, channel)."""
    return {name: (lambda x, y, c=c: function(x, y, c)) for c, name in enumerate("RGB")}
