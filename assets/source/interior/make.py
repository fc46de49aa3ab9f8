#!/usr/bin/env python3
"""Makes config/presets/interior/ from the materials in measured.json and estimated.json. Needs nothing but Python; the results are committed.

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


def write(row, doc, mean_cosine=0.0):
    coefficients = {"scattering": row["sigma_s_prime"], "absorption": row["sigma_a"], "reduced": True}
    fields = [f'"doc": {json.dumps(doc)}', f'"optics": {{ "coefficients_per_mm": {json.dumps(coefficients)} }}']
    if mean_cosine:
        fields.append(f'"phase": {{ "henyey_greenstein": {{ "g": {mean_cosine} }} }}')
    fields.append(f'"ior": {row["eta"]}')
    (OUT / file_name(row["name"])).write_text("{\n  " + ",\n  ".join(fields) + "\n}\n")


def mean_of(g):
    """One g for all channels, as a phase function has: the mean of those in which something scatters."""
    known = [c for c in g if c]
    return round(sum(known) / len(known), 3) if known else 0.0


OUT.mkdir(parents=True, exist_ok=True)
measured = json.loads((HERE / "measured.json").read_text())
for row in measured["materials"]:
    g = mean_of(row.get("g", []))
    about = f" Measured g {', '.join(map(str, row['g']))}; here the mean of those in which it scatters." if g else " g is unknown, so reduced and isotropic."
    write(row, f"{row['name']}, measured by {measured['sources'][row['source']]}.{about}", g)
for row in json.loads((HERE / "estimated.json").read_text())["materials"]:
    write(row, row["doc"])
