#!/usr/bin/env python3
"""Captures of one build are the same bytes over runs and thread counts. usage: identical.py PROGRAM"""
from harness import Tests

SCENES = ("assets/scenes/still_life.json", "assets/scenes/s1_fog_spot.json")

with Tests() as t:
    pictures = {}
    runs = [("again", {}), ("once more", {})] + [(f"LP_NUM_THREADS={n}", {"LP_NUM_THREADS": n}) for n in ("0", "1", "2", "4")]
    for number, (label, environment) in enumerate(runs):
        for scene in SCENES:
            out = t.folder / str(number)
            done = t.run("capture", scene, "--size", "160x90", "--frames", "3", "--out", out, **environment)
            if done is None or done.returncode != 0:
                t.check(False, f"{scene}, {label}: {done.stderr if done else 'did not end'}")
                continue
            for file in sorted(out.glob(scene.split("/")[-1].replace(".json", "") + ".*")):
                content = file.read_bytes()
                t.check(pictures.setdefault(file.name, content) == content, f"{file.name} differs, {label}")
    t.check(len(pictures) == 3 * len(SCENES), f"pictures: {sorted(pictures)}")
