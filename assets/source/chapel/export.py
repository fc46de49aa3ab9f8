"""Writes chapel.glb. Usage: export.py OUTPUT_DIRECTORY"""
import pathlib
import sys

import build
import glb

if __name__ == "__main__":
    target = pathlib.Path(sys.argv[1]) / "chapel.glb"
    meshes, nodes = build.build()
    scale = glb.write(meshes, nodes, target)
    print(f"{target}: {target.stat().st_size / 1e6:.1f} MB, light map {scale:.1f} texels per metre")
