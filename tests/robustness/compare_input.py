#!/usr/bin/env python3
"""tyndall compare: verdicts, exit codes, its JSON, and wrong input. usage: compare_input.py PROGRAM"""
import json
import math
import pathlib
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "report"))
from exr import rgb, write_exr  # noqa: E402
from harness import Tests  # noqa: E402

WIDTH, HEIGHT = 40, 24


def scene(x, y, c):
    return 0.5 + 0.3 * math.sin(0.2 * x * (c + 1) + 0.1 * y)


def layered(name, function):
    return {f"{name}.{channel}": value for channel, value in rgb(function).items()}


def exit_codes(t, truth, off):
    same = t.run("compare", truth, truth, "--metric", "relmse=0", "--metric", "ssim=0.999")
    t.check(same and same.returncode == 0, f"a picture is itself\n{same and same.stderr}")
    failed = t.run("compare", truth, off, "--metric", "mean_error=0.005")
    t.check(failed and failed.returncode == 1 and "FAILED  mean_error" in failed.stdout, "a limit that does not hold ends with 1")
    unjudged = t.run("compare", truth, off)
    t.check(unjudged and unjudged.returncode == 0, "without limits nothing fails")
    broken = write_exr(t.folder / "nan.exr", WIDTH, HEIGHT, rgb(lambda x, y, c: math.nan if (x, y) == (7, 5) else scene(x, y, c)))
    nan = t.run("compare", truth, broken)
    t.check(nan and nan.returncode == 1 and "x 7, y 5" in nan.stdout, f"NaN fails and says where\n{nan and nan.stdout}")


def numbers(t, truth, off):
    file = t.folder / "numbers.json"
    done = t.run("compare", truth, off, truth, "--metric", "mean_error=0.02", "--crop", "8,0,16,16", "--json", file)
    t.check(done and done.returncode == 0, f"numbers\n{done and done.stderr}")
    all_ = json.loads(file.read_text())
    t.check(all_["tyndall_compare"] == 1 and all_["held"] is True and len(all_["tests"]) == 2, "the JSON's head")
    first = all_["tests"][0]
    t.check(abs(first["metrics"]["mean_ratio"] - 1.01) < 1e-5, f"mean ratio {first['metrics']['mean_ratio']}")
    t.check(first["limits"] == [{"metric": "mean_error", "limit": 0.02, "at_least": False, "held": True}], "limits")
    t.check(all(8 <= block["x"] < 24 for block in first["worst_blocks"]), "blocks are told in the whole picture's pixels")
    t.check(all_["settings"]["crop"] == [8, 0, 16, 16], "settings")


def layers(t):
    noise = layered("variance", lambda x, y, c: 1e-4)
    truth = write_exr(t.folder / "traced.exr", WIDTH, HEIGHT, {**rgb(scene), **noise, "samples": lambda x, y: 16, **layered("albedo", scene)})
    off = write_exr(t.folder / "biased.exr", WIDTH, HEIGHT, {**rgb(lambda x, y, c: scene(x, y, c) * 1.05), **noise})
    done = t.run("compare", truth, truth, "--significance", "0.01")
    t.check(done and done.returncode == 0 and "z_p" in done.stdout, f"the variance is found\n{done and done.stdout}")
    done = t.run("compare", truth, off, "--significance", "0.01")
    t.check(done and done.returncode == 1 and "FAILED  z_p" in done.stdout, "a bias beyond the noise fails")
    done = t.run("compare", truth, truth, "--layer", "albedo")
    t.check(done and done.returncode == 0, "a layer by name")
    refused(t, "unknown layer", [truth, truth, "--layer", "albdo"], "traced.exr", "'albdo'", "did you mean 'albedo'")
    return truth


def refused(t, name, arguments, *expected):
    done = t.run("compare", *arguments)
    t.check(done is not None and done.returncode == 2, f"{name}: ended with {done and done.returncode}, not 2\n{done and done.stderr}")
    for words in expected:
        t.check(words in done.stderr, f"{name}: does not say '{words}'\n{done.stderr}")
    t.check(len(done.stderr.strip().splitlines()) <= 3 and done.stderr.startswith("tyndall: "), f"{name}: not one clear message\n{done.stderr}")


def wrong_input(t, truth):
    write = lambda name, w, h: write_exr(t.folder / name, w, h, rgb(scene))  # noqa: E731
    refused(t, "missing reference", ["no.exr", truth], "no.exr", "no such file")
    refused(t, "missing test", [truth, "no.exr"], "no.exr", "no such file")
    refused(t, "a folder", [truth, t.folder], "not a file")
    refused(t, "sizes", [truth, write("odd.exr", WIDTH + 1, HEIGHT)], "odd.exr", f"{WIDTH + 1}x{HEIGHT}", f"{WIDTH}x{HEIGHT}", "whole multiple")
    refused(t, "smaller test", [truth, write("small.exr", WIDTH // 2, HEIGHT // 2)], "small.exr")
    double = t.run("compare", truth, write("double.exr", 2 * WIDTH, 2 * HEIGHT))
    t.check(double and double.returncode == 0, "twice the size is filtered")
    nan = write_exr(t.folder / "nan.exr", WIDTH, HEIGHT, rgb(lambda x, y, c: math.inf if (x, y) == (3, 2) else 1.0))
    refused(t, "NaN in the reference", [nan, truth], "nan.exr", "NaN or Inf", "x 3, y 2")
    refused(t, "cut short", [truth, t.file("cut.exr", truth.read_bytes()[:2000])], "cut.exr", "truncated")
    refused(t, "no picture", [truth, t.file("text.exr", "hello")], "text.exr", "not a picture")
    refused(t, "unknown metric", [truth, truth, "--metric", "relmsee=1"], "'relmsee'", "did you mean 'relmse'")
    refused(t, "metric without limit", [truth, truth, "--metric", "relmse"], "relmse", "NAME=LIMIT")
    refused(t, "limit that is no number", [truth, truth, "--metric", "relmse=small"], "'small'")
    refused(t, "crop", [truth, truth, "--crop", "0,0,10"], "X,Y,WIDTH,HEIGHT")
    refused(t, "crop outside", [truth, truth, "--crop", "30,0,20,8"], "does not lie in the picture")
    refused(t, "mask of another size", [truth, truth, "--mask", t.folder / "small.exr"], "small.exr", "mask")
    black = write_exr(t.folder / "black.exr", WIDTH, HEIGHT, rgb(lambda x, y, c: 0.0))
    refused(t, "empty mask", [truth, truth, "--mask", black], "no pixel")
    refused(t, "no variance", [black, truth, "--significance", "0.01"], "black.exr", "variance", "--reference-noise")
    refused(t, "report where a file is", [truth, truth, "--report", t.file("taken", "")], "taken")
    refused(t, "JSON nowhere", [truth, truth, "--json", t.folder / "no" / "numbers.json"], "numbers.json")


with Tests() as t:
    plain = write_exr(t.folder / "truth.exr", WIDTH, HEIGHT, rgb(scene))
    brighter = write_exr(t.folder / "brighter.exr", WIDTH, HEIGHT, rgb(lambda x, y, c: scene(x, y, c) * 1.01))
    exit_codes(t, plain, brighter)
    numbers(t, plain, brighter)
    wrong_input(t, layers(t))
