#!/usr/bin/env python3
"""Makes a module with tools/new_module, builds, tests and captures it; then plays it with --watch in a virtual display, saves
its source, breaks it and repairs it, and looks at the pixels. Cleans up in any case.
usage: new_module_test.py BUILD_FOLDER"""
import os
import pathlib
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
NAME = "new_module_trial"
FOLDER = ROOT / "modules" / NAME
LIST = ROOT / "modules" / "CMakeLists.txt"
LIMIT_S = 60  # generous: the machine may be busy


class Screen:
    """Xvfb with its picture in a file."""

    def __init__(self, folder):
        read, write = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", "640x360x24", "-fbdir", folder],
            pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as pipe:
            self.display = ":" + pipe.readline().strip()
        self.file = pathlib.Path(folder) / "Xvfb_screen0"

    def brightness(self, x, y):
        """Sum of the channels of one pixel (X window dump, 32 bits a pixel)."""
        data = self.file.read_bytes()
        header = struct.unpack(">25I", data[:100])
        at = header[0] + header[19] * 12 + y * header[12] + x * 4
        return sum(data[at:at + 3])


def run(*command):
    print("+", *command, flush=True)
    subprocess.run(command, cwd=ROOT, check=True, timeout=300)


def wait_for(what, condition, player):
    start = time.monotonic()
    while not condition():
        if player.poll() is not None:
            sys.exit(f"the program ended while waiting for: {what}")
        if time.monotonic() - start > LIMIT_S:
            sys.exit(f"not within {LIMIT_S} s: {what}")
        time.sleep(0.01)
    print(f"{time.monotonic() - start:6.2f} s  {what}", flush=True)


def play(build, scratch):
    source = FOLDER / f"{NAME}.cpp"
    good = source.read_text()
    colour = "state->value.radiance_cd_m2"
    assert good.count(colour) == 1
    dark = good.replace(colour, "0.0f * " + colour)
    screen = Screen(scratch)
    log = pathlib.Path(scratch) / "log"
    with open(log, "w") as out:
        player = subprocess.Popen(
            [build / "bin" / "tyndall", "play", FOLDER / "captures" / f"{NAME}_scene.json", "--watch", "--no-vsync",
             "--size", "320x180"], cwd=ROOT, env={**os.environ, "DISPLAY": screen.display}, stdout=out, stderr=out)

    def shown():
        return screen.brightness(300, 20)  # far away there is nothing but the veil

    try:
        wait_for("the first picture", lambda: shown() > 100, player)
        first = shown()
        time.sleep(0.5)
        source.write_text(dark)
        wait_for("from saving a source to its picture", lambda: shown() < 30, player)
        source.write_text(dark.replace("install", "instal"))
        wait_for("from saving a broken source to its error", lambda: "does not build" in log.read_text(), player)
        time.sleep(0.5)
        assert shown() < 30, "the last good picture has not stayed"
        source.write_text(good)
        wait_for("from repairing it to its picture", lambda: shown() == first, player)
    except BaseException:
        print(log.read_text())
        raise
    finally:
        for process in (player, screen.server):
            process.terminate()
            process.wait()


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    modules = LIST.read_text()
    if FOLDER.exists() or NAME in modules:
        sys.exit(f"modules/{NAME} is in the way")
    signal.signal(signal.SIGTERM, lambda *_: sys.exit("terminated"))
    scratch = tempfile.mkdtemp(prefix="tyndall_new_module_")
    try:
        run("tools/new_module", NAME)
        run("cmake", "--build", build, "--target", f"module_{NAME}", f"module_{NAME}_test", "tyndall_program")
        run("ctest", "--test-dir", build, "-R", NAME, "--output-on-failure", "--no-tests=error")
        if shutil.which("Xvfb"):
            play(build, scratch)
        else:
            print("no Xvfb: --watch was not tried")
    finally:
        shutil.rmtree(FOLDER, ignore_errors=True)
        LIST.write_text(modules)
        for left in (build / "modules" / f"{NAME}.so", build / "bin" / f"module_{NAME}_test"):
            left.unlink(missing_ok=True)
        shutil.rmtree(build / "modules" / NAME, ignore_errors=True)
        shutil.rmtree(scratch, ignore_errors=True)
        subprocess.run(["cmake", "--log-level=WARNING", build], stdout=subprocess.DEVNULL)


main()
