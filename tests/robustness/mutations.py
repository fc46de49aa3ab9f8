#!/usr/bin/env python3
"""Broken copies of real files through one `tyndall validate` and, for what only drawing reads, `tyndall capture`: messages, never a crash.

usage: mutations.py PROGRAM [SEED]
"""
import json
import random
import sys

from harness import ROOT, Tests

SCENES = ROOT / "assets" / "scenes"
WORDS = [b"null", b"-1", b"1e999", b"[]", b"{}", b'""', b"0", b"true", b'"\\ud800"', b"99999999999999999999", b",", b"\xff", b"\0"]


def mutated(content, dice):
    """One to four small wounds: bytes changed, cut, doubled, or a word that may not be there."""
    data = bytearray(content)
    for _ in range(dice.randint(1, 4)):
        at = dice.randrange(len(data))
        kind = dice.randrange(5)
        if kind == 0:
            data[at] = dice.randrange(256)
        elif kind == 1:
            del data[at : at + dice.randint(1, 40)]
        elif kind == 2:
            data[at:at] = data[at : at + dice.randint(1, 60)]
        elif kind == 3:
            data[at:at] = dice.choice(WORDS)
        else:
            del data[at:]
        if not data:
            data = bytearray(b" ")
    return bytes(data)


def ended_well(t, done, what):
    t.check(done is not None and done.returncode in (0, 1), f"{what}: {'did not end' if done is None else done.returncode}")
    if done is not None:
        t.check(not any(w in done.stderr for w in ("terminate called", "Assertion", "Sanitizer")), f"{what}: {done.stderr[-500:]}")


with Tests() as t:
    seed = int(sys.argv[2]) if len(sys.argv) > 2 else 1
    dice = random.Random(seed)
    scenes = [(SCENES / name).read_bytes() for name in ("still_life.json", "s1_fog_spot.json", "s4_hetero.json", "s3_sphere_potato_dielectric.json")]
    files = [t.file(f"scene{i}.json", mutated(scenes[i % len(scenes)], dice)) for i in range(200)]
    done = t.run("validate", *files)
    ended_well(t, done, f"200 scenes, seed {seed}")
    if done is not None:
        silent = [f.name for f in files if f.name not in done.stdout + done.stderr]
        t.check(not silent, f"nothing is said of {silent}, seed {seed}")

    # Many broken glTF files in one scene: each is refused, or drawn, by itself.
    sample = (SCENES / "sample.gltf").read_bytes()
    for name in ("tiles.png", "tilted_normal.png", "leaf.png"):
        t.file(f"textures/{name}", mutated((SCENES / "textures" / name).read_bytes(), dice))
    names = [t.file(f"sample{i}.gltf", mutated(sample, dice)).name for i in range(100)]
    scene = t.file("all.json", json.dumps({"tyndall": 1, "entities": [{"camera": {}}, *({"gltf": {"file": n}} for n in names)]}))
    ended_well(t, t.run("capture", scene, "--size", "32x18", "--out", t.folder / "out"), f"100 glTF files, seed {seed}")
