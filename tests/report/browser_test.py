#!/usr/bin/env python3
"""Opens a report in headless Chromium, drags its wipe, reads a pixel, moves the exposure. usage: browser_test.py PROGRAM FOLDER-FOR-SCREENSHOTS"""
import json
import pathlib
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path += [str(ROOT / "tests" / "robustness"), str(HERE)]
from exr import rgb, write_exr  # noqa: E402
from harness import Tests  # noqa: E402

DRIVER = ROOT / "build" / "browser_driver" / "node_modules"
WIDTH, HEIGHT = 96, 54


def skip_without(found, what):
    if not found:
        print(f"SKIPPED: {what}")
        sys.exit(77)


def reference(x, y, c):
    """Reddish, with a bright lamp."""
    lamp = 6.0 if (x - 70) ** 2 + (y - 14) ** 2 < 25 else 0.0
    return (0.42, 0.11, 0.05)[c] * (0.5 + x / WIDTH) + lamp


def changed(x, y, c):
    """Greenish where the reference is reddish."""
    return reference(x, y, 1 - c if c < 2 else 2) * 1.1


skip_without(shutil.which("chromium"), "no chromium (Debian package chromium)")
skip_without(shutil.which("node"), "no node (Debian package nodejs)")
skip_without((DRIVER / "playwright-core").is_dir(), f"no {DRIVER.relative_to(ROOT)}/playwright-core (tools/setup installs it with npm)")

with Tests() as t:
    screenshots = pathlib.Path(sys.argv[2])
    screenshots.mkdir(parents=True, exist_ok=True)
    truth = write_exr(t.folder / "truth.exr", WIDTH, HEIGHT, rgb(reference))
    far = write_exr(t.folder / "far.exr", WIDTH, HEIGHT, rgb(changed))
    near = write_exr(t.folder / "near.exr", WIDTH, HEIGHT, rgb(lambda x, y, c: reference(x, y, c) * 1.001))
    for _ in range(2):  # two runs make a sparkline
        done = t.run("compare", truth, near, far, "--metric", "relmse=0.01", "--report", t.folder / "report")
        t.check(done and done.returncode == 1, f"one of two comparisons fails\n{done and done.stderr}")
    # Beyond 2^18 pixels the page gets 16-bit numbers; held against an earlier picture, it says so.
    wide, high = 560, 480
    old = write_exr(t.folder / "old.exr", wide, high, rgb(lambda x, y, c: 20000.0 + 7 * x + 11 * y + c))
    new = write_exr(t.folder / "new.exr", wide, high, rgb(lambda x, y, c: 3e-3 * (1 + x)))
    done = t.run("compare", old, new, "--fast", "--kind", "baseline", "--report", t.folder / "large")
    t.check(done and done.returncode == 0, f"nothing is judged\n{done and done.stderr}")
    x, y = 30, 20
    facts = {"page": (t.folder / "report" / "index.html").as_uri(), "screenshots": str(screenshots.resolve()), "width": WIDTH, "height": HEIGHT, "x": x, "y": y,
             "large": (t.folder / "large" / "index.html").as_uri(), "old": [20000 + 7 * x + 11 * y + c for c in range(3)], "new": 3e-3 * (1 + x),
             "reference": [reference(x, y, c) for c in range(3)], "test": [changed(x, y, c) for c in range(3)]}
    done = subprocess.run(["node", HERE / "browser_test.js", json.dumps(facts)], capture_output=True, text=True, timeout=560,
                          env={"PATH": "/usr/bin:/bin", "NODE_PATH": str(DRIVER), "HOME": str(t.folder)})
    print(done.stdout, done.stderr)
    t.check(done.returncode == 0, "the browser's checks hold")
