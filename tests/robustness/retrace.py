#!/usr/bin/env python3
"""tyndall capture --retrace, and captures whose references are not what they should be. usage: retrace.py PROGRAM"""
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "report"))
from exr import rgb, write_exr  # noqa: E402
from harness import ROOT, Tests  # noqa: E402

CAPTURE = {
    "tyndall_capture": 1, "scene": "shadows.json", "size": [32, 16],
    "variants": [{"name": "spot", "set": ["/entities/Spot/spot_light/intensity_cd=1000"]}],
    "references": [{"name": "floor", "samples": 16, "orders": [1, 1]}],
    "expect": [{"of": "spot", "traced": "floor", "region": [0, 0, 0.3, 1], "max_relmse": 0.001},
               {"of": "spot", "equals": "spot", "max_difference": 0}, {"of": "spot", "mean_between": [0.1, 100]}],
}


def write(t, **changes):
    return t.file("capture.json", json.dumps({**CAPTURE, **changes}))


def judged(t, file, code, *words):
    done = t.run("capture", file, "--exr", "--out", t.folder / "out", "--report", t.folder / "report")
    t.check(done is not None and done.returncode == code, f"capture ended with {done and done.returncode}, not {code}\n{done and done.stderr + done.stdout}")
    for word in words:
        t.check(word in done.stdout, f"does not say '{word}'\n{done.stdout}")


def retraced(t, file, *words, how="--retrace"):
    done = t.run("capture", how, file)
    t.check(done is not None and done.returncode == 0, f"{how} ended with {done and done.returncode}\n{done and done.stderr}")
    for word in words:
        t.check(word in done.stdout, f"{how} does not say '{word}'\n{done.stdout}")


def life(t):
    """Missing, made, as it should be, changed, made again."""
    file, stored = write(t), t.folder / "floor.exr"
    judged(t, file, 1, "the reference 'floor' is not there", f"run tyndall capture --retrace {file}")
    retraced(t, file, "tracing floor", "wrote")
    first = stored.read_bytes()
    judged(t, file, 0, "relMSE", "3 expectations held", "report: ")
    page = (t.folder / "report" / "index.html").read_text()
    for words in ('"kind":"reference"', '"kind":"variant"', "capture: spot = floor", "Judged without a second picture"):
        t.check(words in page, f"the report does not hold {words}")
    retraced(t, file, "as it should be")
    t.check(stored.read_bytes() == first, "what is right is not traced")
    retraced(t, file, "asked for", how="--retrace=all")
    t.check(stored.read_bytes() == first, "the same recipe gives the same bytes")
    retraced(t, file, "asked for", how="--retrace=floor")
    brighter = {**CAPTURE["variants"][0], "set": ["/entities/Spot/spot_light/intensity_cd=1100"]}
    judged(t, write(t, variants=[brighter]), 1, "scene changed", "--retrace")
    retraced(t, file, "scene changed")
    judged(t, file, 0)
    t.check(stored.read_bytes() != first, "a changed scene has another reference")


def broken(t):
    file, stored = write(t), t.folder / "floor.exr"
    retraced(t, file)
    whole = stored.read_bytes()
    stored.write_bytes(whole[: len(whole) // 2])
    judged(t, file, 1, "floor.exr", "FAILED")
    stored.write_bytes(b"")
    judged(t, file, 1, "floor.exr")
    retraced(t, file, "wrote")
    t.check(stored.read_bytes() == whole, "a broken reference is made again")
    write_exr(stored, 32, 16, rgb(lambda x, y, c: 1.0))
    judged(t, file, 1, "no recipe", "--retrace")
    stored.write_bytes(whole)
    write_exr(t.folder / "old.exr", 32, 16, rgb(lambda x, y, c: 3.0))
    judged(t, write(t, expect=[{"of": "spot", "reference": "old.exr", "baseline": True, "max_relmse": 100}]), 0, "a baseline, no truth backs it")
    t.check('"kind":"baseline"' in (t.folder / "report" / "index.html").read_text(), "the report marks baselines")


def wrong_use(t):
    file = write(t)
    t.refused("unknown reference", ["capture", "--retrace=flor", file], "flor", "did you mean 'floor'")
    t.refused("a scene", ["capture", "--retrace", t.folder / "shadows.json"], "shadows.json", "no capture file")
    t.refused("no such scene", ["capture", "--retrace=all", write(t, scene="no.json")], "no.json")
    t.refused("no such camera", ["capture", "--retrace=all", write(t, references=[{"name": "floor", "camera": "Camra"}])], "tracing floor", "Camra", "did you mean 'Camera'")
    done = t.run("capture", "--retrace", file, "--size", "10x10")
    t.check(done is not None and done.returncode != 0, "--retrace traces what the file says, and nothing else")


def interrupted(t):
    """A killed or failed run leaves the old file whole, and nothing beside it."""
    stored = t.folder / "floor.exr"
    retraced(t, write(t))
    old = stored.read_bytes()
    file = write(t, references=[{"name": "floor", "samples": 1 << 20, "orders": [1, 1]}])
    for how in (signal.SIGKILL, signal.SIGINT):
        process = subprocess.Popen([t.program, "capture", "--retrace", file], cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        process.stdout.readline()  # "tracing floor"
        time.sleep(0.5)
        t.check(process.poll() is None, "still tracing")
        process.send_signal(how)
        process.communicate()
        t.check(process.returncode != 0 and stored.read_bytes() == old, f"{how.name}: the old reference stays")
    full = ["bash", "-c", 'trap "" XFSZ; ulimit -f 1; exec "$@"', "bash", t.program, "capture", "--retrace=all", write(t)]
    done = subprocess.run(full, capture_output=True, text=True, cwd=ROOT)
    t.check(done.returncode == 1 and "floor.exr" in done.stderr and "cannot write" in done.stderr, f"a full disk is told: {done.returncode}\n{done.stderr}")
    t.check(stored.read_bytes() == old, "a full disk: the old reference stays")
    t.check(not [name for name in os.listdir(t.folder) if name.startswith("floor.exr.")], "nothing half-written is left")


with Tests() as t:
    shutil.copy(ROOT / "assets" / "scenes" / "shadows.json", t.folder)
    life(t)
    broken(t)
    wrong_use(t)
    interrupted(t)
