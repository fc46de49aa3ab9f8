#!/usr/bin/env python3
"""tyndall trace and merge: wrong input, broken films, full disks, and being killed. usage: trace_input.py PROGRAM"""
import json
import os
import pathlib
import random
import resource
import signal
import subprocess
import sys
import time

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "report"))
from exr import rgb, write_exr  # noqa: E402
from harness import ROOT, Tests  # noqa: E402

SMALL = ("--size", "48x32", "--batch", "4")


def scene(*entities, **medium):
    camera = {"name": "Camera", "transform": {"translation": [0, 0, 4], "look_at": [0, 0, 0]}, "camera": {"exposure": 1}}
    lamp = {"name": "Lamp", "transform": {"translation": [1, 2, 1]}, "point_light": {"intensity_cd": 9}}
    fog = {"name": "Fog", "transform": {"scale": [4, 4, 4]}, "medium": {"bounds": {"box": {}}, "scattering_per_m": [0.2, 0.3, 0.4], **medium}}
    ball = {"name": "Ball", "mesh": {"primitive": "sphere", "tessellation": 32}, "material": {"base_colour": [0.7, 0.5, 0.3], "specular": 0}}
    return json.dumps({"tyndall": 1, "modules": ["participating_media"], "entities": [camera, lamp, fog, ball, *entities]}, indent=1)


def traced(t, file, out, *options):
    done = t.run("trace", file, *SMALL, "--out", out, *options)
    t.check(done and done.returncode == 0, f"trace {options}\n{done and done.stderr}")
    return out


def loads(t, film, what):
    """A film that merge reads is whole: it has a checksum."""
    done = t.run("merge", film, "--out", t.folder / "copy.exr")
    t.check(done and done.returncode == 0, f"{what}: the film is broken\n{done and done.stderr}")


def command_line(t, file):
    def wrong(name, options, *expected, code=1):
        out = t.folder / "never.exr"
        done = t.run("trace", file, "--out", out, *options)
        said = done.stderr if done else ""
        t.check(done and done.returncode == code if code else done and done.returncode > 0, f"{name}: {done and done.returncode}\n{said}")
        for words in expected:
            t.check(words in said, f"{name}: does not say '{words}'\n{said}")
        t.check(1 <= len(said.strip().splitlines()) <= 3, f"{name}: not one clear message\n{said}")
        t.check(not out.exists(), f"{name}: a film was begun")
        out.unlink(missing_ok=True)

    for shard in ("0/4", "5/4", "1/0", "x", "1/2/3", "2", "-1/2", "1.5/2", "99999999999999999999/2"):
        wrong(f"shard {shard}", [*SMALL, f"--shard={shard}"], f"'{shard}'", "I/N")
    for orders in ("3..1", "a", "1.2", "-1..2", "1..2..3", ".."):
        wrong(f"orders {orders}", [*SMALL, f"--orders={orders}"], f"'{orders}'", "A..B")
    wrong("orders of single scattering", [*SMALL, "--orders=0..1", "--single-scattering"], "--single-scattering")
    for size in ("64", "0x0", "x", "-3x4", "99999x1", "64x48x2"):
        wrong(f"size {size}", [f"--size={size}"], f"'{size}'", "WIDTHxHEIGHT")
    wrong("camera", [*SMALL, "--camera", "Camra"], "'Camra'", "did you mean 'Camera'")
    wrong("batch", ["--size", "48x32", "--batch", "3"], "3 samples", "power of two")
    for option in (("--spp", "0"), ("--spp", "-4"), ("--spp", "many"), ("--time", "-1"), ("--noise", "0"), ("--threads", "0"), ("--clamp", "-1"), ("--batch", "0"), ("--checkpoint", "-1"), ("--seed", "-1")):
        wrong(" ".join(option), ["--size", "48x32", "=".join(option)], option[0], code=None)
    wrong("change", [*SMALL, "--set", "/entities/Bal/material/roughness=1"], "Bal", "did you mean 'Ball'")


def scenes(t):
    def wrong(name, text, *expected):
        file = t.file(name.replace(" ", "_") + ".json", text)
        t.refused(name, ["trace", file, *SMALL, "--spp", "4", "--out", t.folder / "never.exr"], *expected)
        t.check(not (t.folder / "never.exr").exists(), f"{name}: a film was begun")

    t.refused("missing scene", ["trace", "no/such.json"], "no/such.json")
    wrong("no camera", '{ "tyndall": 1, "entities": [{ "name": "A" }] }', "camera", "no_camera.json")
    wrong("missing mesh", scene({"mesh": {"file": "no.obj"}}), "no.obj")
    wrong("missing texture", scene({"mesh": {"primitive": "box"}, "material": {"base_colour_texture": "no.png"}}), "no.png")
    wrong("missing probe", scene({"light_probe": {"file": "no.hdr"}}), "no.hdr")
    wrong("missing volume", scene(density={"volume": {"file": "no.vdb"}}), "no.vdb")
    wrong("unknown phase function", scene(phase={"henyey": {"g": 0.5}}), "henyey")
    for name, value in (("NaN", "NaN"), ("infinite", "1e999"), ("negative", "-1"), ("text", '"much"')):
        for where, text in (
            ("scattering", scene(absorption_per_m=[0.1, 0.1, 4321.5])),
            ("emission", scene({"mesh": {"primitive": "box"}, "material": {"emissive_cd_m2": [1, 1, 4321.5]}})),
            ("interior", scene({"mesh": {"primitive": "box"}, "interior": {"absorption_per_m": [1, 1, 4321.5]}})),
            ("lamp", scene({"point_light": {"intensity_cd": 4321.5}})),
        ):
            wrong(f"{name} {where}", text.replace("4321.5", value), f"{name}_{where}.json".replace(" ", "_"))


def not_finite(t):
    """Pictures may hold what is not a number: that is said, and left out; a film never holds any."""
    for value in ("nan", "inf"):
        image = write_exr(t.folder / f"{value}.exr", 8, 4, rgb(lambda x, y, c: float(value) if (x, y) == (5, 1) else 0.5))
        for name, entity in (
            ("emission", {"mesh": {"primitive": "box"}, "material": {"emissive_cd_m2": [1, 1, 1], "specular": 0, "emissive_texture": image.name}}),
            ("probe", {"light_probe": {"file": image.name}}),
        ):
            file = t.file(f"{value}_{name}.json", scene(entity))
            done = t.run("trace", file, *SMALL, "--spp", "8", "--out", t.folder / "finite.exr")
            said = done.stderr if done else "still running"
            t.check(done and done.returncode == 0 and f"{image.name}: 3 values are not finite" in said, f"{value} in {name}: {done and done.returncode}, {said}")
            done = t.run("compare", t.folder / "finite.exr", t.folder / "finite.exr")
            t.check(done and done.returncode == 0, f"{value} in {name}: the film is not finite\n{done and done.stderr}")


def films(t, file):
    shards = [traced(t, file, t.folder / f"shard{i}.exr", "--spp", "24", "--shard", f"{i}/3") for i in (1, 2, 3)]
    whole = traced(t, file, t.folder / "whole.exr", "--spp", "24")
    sum_ = t.folder / "sum.exr"
    done = t.run("merge", *shards, "--out", sum_)
    t.check(done and done.returncode == 0 and sum_.read_bytes() == whole.read_bytes(), f"three shards are the whole, bit for bit\n{done and done.stderr}")

    def left_out(name, film, *expected):
        """merge names what it cannot add, adds the rest, and ends with 1."""
        sum_.unlink(missing_ok=True)
        done = t.run("merge", shards[0], film, shards[1], "--out", sum_)
        said = done.stderr if done else "still running"
        t.check(done and done.returncode == 1, f"{name}: ended with {done and done.returncode}\n{said}")
        for words in (pathlib.Path(film).name, *expected):
            t.check(words in said, f"{name}: does not say '{words}'\n{said}")
        t.check(done and "1 of 3 films were left out" in done.stdout and sum_.exists(), f"{name}: the others are added\n{done and done.stdout}")
        t.check(len(said.strip().splitlines()) <= 4, f"{name}: not one clear message\n{said}")

    bytes_ = shards[2].read_bytes()
    dice = random.Random(3)
    for i in range(12):  # anywhere: header, offsets, compressed sums and pictures
        at = len(bytes_) * i // 12 + dice.randrange(max(1, len(bytes_) // 12))
        broken = t.file(f"flipped{i}.exr", bytes_[:at] + bytes([bytes_[at] ^ (1 << dice.randrange(8))]) + bytes_[at + 1 :])
        done = t.run("merge", shards[0], broken, "--out", sum_)
        said = done.stderr if done else "still running"
        fine = done and (done.returncode == 0 or (done.returncode == 1 and broken.name in said and len(said.strip().splitlines()) <= 4))
        t.check(fine, f"a bit flipped at {at}: {done and done.returncode}\n{said}")
        if done and done.returncode == 0:  # then it was in what is not summed
            t.run("merge", shards[0], shards[2], "--out", t.folder / "right.exr")
            t.check(sum_.read_bytes() == (t.folder / "right.exr").read_bytes(), f"a bit flipped at {at} went into the sum")
    for share in (0.02, 0.5, 0.99):
        left_out(f"cut at {share}", t.file("cut.exr", bytes_[: int(len(bytes_) * share)]))
    left_out("empty", t.file("empty.exr", b""))
    left_out("text", t.file("text.exr", "hello"))
    left_out("foreign", write_exr(t.folder / "foreign.exr", 48, 32, rgb(lambda x, y, c: 1.0)), "not a traced film")
    left_out("missing", "no.exr", "no such file")
    left_out("a folder", t.folder)
    left_out("twice", shards[0], "in both films")
    other = t.folder / "other.exr"
    done = t.run("trace", file, "--size", "32x32", "--batch", "4", "--spp", "4", "--out", other)
    left_out("another size", other, "48x32 and 32x32")
    left_out("another seed", traced(t, file, other, "--spp", "4", "--seed", "5"), "different scenes or settings")
    left_out("another range of orders", traced(t, file, other, "--spp", "4", "--single-scattering"), "different scenes or settings")

    nothing = t.folder / "nothing.exr"
    done = t.run("merge", "no.exr", t.folder / "text.exr", "--out", nothing)
    t.check(done and done.returncode == 1 and "nothing was written" in done.stderr and not nothing.exists(), f"no film at all\n{done and done.stderr}")
    t.refused("merge to nowhere", ["merge", shards[0], "--out", t.folder / "no" / "sum.exr"], "sum.exr", "cannot write")
    t.refused("merge to a folder", ["merge", shards[0], "--out", t.folder], "cannot write")

    def not_resumed(name, content, *expected, options=(), size="48x32"):
        film = t.file("resumed.exr", content)
        t.refused(f"resume {name}", ["trace", file, "--size", size, "--batch", "4", "--spp", "24", "--resume", "--out", film, *options], *expected)
        t.check(film.read_bytes() == (content if isinstance(content, bytes) else content.encode()), f"resume {name}: the film was touched")

    not_resumed("a text", "hello", "resumed.exr")
    not_resumed("a cut film", bytes_[: len(bytes_) // 2], "resumed.exr")
    not_resumed("a foreign picture", (t.folder / "foreign.exr").read_bytes(), "resumed.exr", "not a traced film")
    not_resumed("with another size", bytes_, "48x32", "64x32", size="64x32")
    not_resumed("with another seed", bytes_, "different scenes or settings", options=("--seed", "9"))
    not_resumed("with other changes", bytes_, "different scenes or settings", options=("--set", "/entities/Ball/material/roughness=0.5"))
    resumed = t.file("resumed.exr", shards[0].read_bytes())
    traced(t, file, resumed, "--spp", "24", "--resume")
    t.check(resumed.read_bytes() == whole.read_bytes(), "a shard that is resumed without --shard is the whole")


def disks(t):
    # no module: it would be copied before it is loaded, and is larger than what is allowed here
    whole_scene = json.loads(scene())
    file = t.file("plain.json", json.dumps({"tyndall": 1, "entities": [e for e in whole_scene["entities"] if "medium" not in e]}))
    whole = traced(t, file, t.folder / "plain.exr", "--spp", "24")
    if os.geteuid() != 0:
        locked = t.folder / "locked"
        locked.mkdir(mode=0o555)
        t.refused("a folder that may not be written", ["trace", file, *SMALL, "--spp", "4", "--out", locked / "film.exr"], "film.exr", "cannot write")
    pipe = t.folder / "pipe"
    os.mkfifo(pipe)
    t.refused("a pipe", ["trace", file, *SMALL, "--spp", "4", "--out", pipe], "pipe", "cannot write")
    t.check(pipe.is_fifo(), "what is no file is not replaced by one")
    t.refused("a file as a folder", ["trace", file, *SMALL, "--spp", "4", "--out", t.file("taken", "") / "film.exr"], "taken")

    def limited(name, most, out, *options):
        limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))  # noqa: E731
        done = subprocess.run([t.program, "trace", file, *SMALL, "--out", out, *options], capture_output=True, text=True, timeout=120, cwd=ROOT, preexec_fn=limit)
        t.check(done.returncode == 1, f"{name}: ended with {done.returncode}\n{done.stderr}")
        t.check("cannot write" in done.stderr and out.name in done.stderr, f"{name}: does not say what it cannot write\n{done.stderr}")
        t.check(not list(t.folder.glob("*.part")), f"{name}: leaves {list(t.folder.glob('*.part'))}")
        return done

    full = t.folder / "full.exr"
    limited("no room at all", 1000, full, "--spp", "4")
    t.check(not full.exists(), "no room at all: no film")
    size = len(whole.read_bytes())
    limited("full at the end", size // 2, full, "--spp", "24")
    loads(t, full, "full at the end")  # as it was begun
    for less in (1, 300, 4000):  # what the last bytes need
        kept = t.file("kept.exr", whole.read_bytes())
        limited(f"{less} bytes too few", size - less, kept, "--spp", "24", "--resume")
        t.check(kept.read_bytes() == whole.read_bytes(), f"{less} bytes too few: the film that was there stays")
    full.unlink()
    done = limited("full all the while", size // 2, full, "--spp", "24", "--checkpoint", "0")
    t.check("tracing goes on" in done.stderr, f"full all the while: tracing goes on\n{done.stderr}")


def killed(t, file):
    """Kills at random moments; the film that is left loads, and what goes on from it has the bits of a run left alone."""
    whole = traced(t, file, t.folder / "alone.exr", "--spp", "160")
    film = t.folder / "killed.exr"
    dice = random.Random(11)
    killed, interrupted = 0, 0
    for i in range(12):
        command = [t.program, "trace", file, *SMALL, "--spp", "160", "--checkpoint", "0", "--resume", "--out", film]
        before = film.stat().st_mtime_ns if film.exists() else 0
        process = subprocess.Popen([str(c) for c in command], cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        started = time.monotonic()
        while process.poll() is None and time.monotonic() - started < 60 and (not film.exists() or film.stat().st_mtime_ns == before):
            time.sleep(0.002)
        time.sleep(dice.random() * 0.1)
        process.send_signal(signal.SIGINT if i % 4 == 3 else signal.SIGKILL)
        process.wait(60)
        killed += process.returncode == -signal.SIGKILL
        interrupted += process.returncode == 130
        t.check(process.returncode in (0, 130, -signal.SIGKILL), f"killed: ended with {process.returncode}\n{process.stderr.read()}")
        process.stderr.close()
        loads(t, film, f"killed {i}")
        if process.returncode == 0:
            break
    t.check(killed >= 3, f"only {killed} runs were killed before they ended")
    traced(t, file, film, "--spp", "160", "--resume")
    t.check(film.read_bytes() == whole.read_bytes(), f"killed {killed} times, interrupted {interrupted} times: the same bits")
    print(f"killed {killed} times, interrupted {interrupted} times")


with Tests() as t:
    good = t.file("good.json", scene())
    command_line(t, good)
    scenes(t)
    not_finite(t)
    films(t, good)
    disks(t)
    killed(t, good)
