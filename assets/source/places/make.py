#!/usr/bin/env python3
"""Makes the meshes, the volume and the picture of the places in assets/scenes/. Needs Debian's python3-numpy; the results are committed.

usage: assets/source/places/make.py [NAME...]
"""
import importlib
import pathlib
import sys

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "scenes" / "places"
FOLDER.mkdir(exist_ok=True)
for name in sys.argv[1:] or ["forest", "window_room", "sunken_hall"]:
    importlib.import_module(name).make(FOLDER)
