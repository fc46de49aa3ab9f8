#!/usr/bin/env python3
"""Makes config/presets/interior/ from the measured materials in measured.json. Needs nothing but Python; the results are committed.

usage: assets/source/interior/make.py
"""
import json
import pathlib
import re

HERE = pathlib.Path(__file__).resolve().parent
OUT = HERE.parents[2] / "config" / "presets" / "interior"


def file_name(material):
    """"Lowfat Milk" -> lowfat_milk, "Chicken1" -> chicken_1."""
    words = re.sub(r"(?<=[a-z])(?=[0-9])", "_", material.lower())
    return re.sub(r"[^a-z0-9]+", "_", words).strip("_") + ".json"


OUT.mkdir(parents=True, exist_ok=True)
for row in json.loads((HERE / "measured.json").read_text())["materials"]:
    coefficients = {"scattering": row["sigma_s_prime"], "absorption": row["sigma_a"], "reduced": True}
    text = f'{{\n  "optics": {{ "coefficients_per_mm": {json.dumps(coefficients)} }},\n  "ior": {row["eta"]}\n}}\n'
    (OUT / file_name(row["name"])).write_text(text)
