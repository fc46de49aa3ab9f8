#!/usr/bin/env python3
"""tyndall measure on a tiny study: outputs, kept references, a damaged one, an interrupted run, wrong input. usage: measure_test.py PROGRAM"""
import json
import os
import pathlib
import signal
import subprocess
import sys
import xml.etree.ElementTree

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "robustness"))
from harness import ROOT, Tests  # noqa: E402

SCENE = ROOT / "assets" / "scenes" / "s1_fog_spot.json"
TRIANGLE = "v -1 0 0\nv 1 0 0\nv 0 {} 0\nf 1 2 3\n"


def study(**changes):
    """Fog on which three numbers of steps are held against a trace of 16 samples."""
    return {
        "tyndall_study": 1, "title": "A tiny study", "baseline": "none", "plots": ["relmse", "frame_relmse"], "bench": {"frames": 2, "warmup": 1},
        "scenes": [{"name": "fog & spot", "scene": str(SCENE), "size": [48, 27], "supersample": 2,
                    "subtract": ["/entities/Fog/medium/scattering_per_m=[0, 0, 0]", "/entities/Fog/medium/absorption_per_m=[0.11, 0.11, 0.11]"],
                    "reference": {"spp": 16, "min_order": 1, "max_order": 1, "surfaces": False}}],
        "techniques": [{"name": "march", "sweep": [{"set": "/render/participating_media/steps", "values": [1, 4, 16]}]},
                       {"name": "none", "set": ["/render/participating_media/enabled=false"]}],
        **changes}


def measure(t, content, *arguments):
    file = t.file("tiny.json", json.dumps(content))
    return t.run("measure", file, "--cache", t.folder / "cache", *arguments)


def films(t):
    return {file: file.stat().st_mtime_ns for file in (t.folder / "cache").glob("*.exr")}


def outputs(t):
    out = t.folder / "out"
    done = measure(t, study(), "--json", out / "numbers.json", "--markdown", out / "table.md", "--svg", out / "svg", "--report", out / "report", "--all-pictures")
    t.check(done and done.returncode == 0, f"a study ends with 0\n{done and done.stderr + done.stdout}")
    numbers = json.loads((out / "numbers.json").read_text())
    scene = numbers["scenes"][0]
    rows = {row["label"]: row for row in scene["rows"]}
    t.check(list(rows) == ["none", "march, steps 1", "march, steps 4", "march, steps 16"], f"rows {list(rows)}")
    errors = [rows[f"march, steps {n}"]["metrics"]["relmse"] for n in (1, 4, 16)]
    print("relMSE of 1, 4 and 16 steps:", *(f"{e:.3g}" for e in errors), f"floor {scene['noise_floor']:.3g}")
    t.check(errors[0] > errors[1] > errors[2] > 0 and errors[2] < 0.1, f"errors fall with the steps: {errors}")
    t.check(0.01 < scene["noise_floor"] < 0.03, f"noise floor {scene['noise_floor']}")
    t.check(abs(rows["march, steps 16"]["metrics"]["mean_ratio"] - 1) < 0.03, f"the same integral: {rows['march, steps 16']['metrics']['mean_ratio']}")
    t.check(all(row["ms"] > 0 and row["processor_ms"] > 0 and row["target_bytes"] > 0 for row in rows.values()), "times and memory")
    t.check(rows["none"]["ms_above"] is None and "relmse" not in rows["none"]["metrics"], "the baseline is timed alone")
    t.check(all("frame_relmse" in rows[label]["metrics"] for label in rows if label != "none"), "one frame's error")
    t.check({"GL renderer", "machine", "timing"} <= set(numbers["facts"]), f"facts {numbers['facts']}")
    t.check("march" in (out / "table.md").read_text() and "Pareto" in (out / "table.md").read_text(), "the table")
    plots = sorted(file.name for file in (out / "svg").iterdir())
    t.check(plots == ["fog---spot-frame_relmse.svg", "fog---spot-relmse.svg"], f"plots {plots}")
    for plot in plots:
        root = xml.etree.ElementTree.parse(out / "svg" / plot).getroot()
        t.check(root.tag.endswith("svg") and "fog & spot" in "".join(root.itertext()), f"{plot} is SVG")
    page = (out / "report" / "index.html").read_text()
    t.check("tp-front" in page and "fog & spot: march, steps 16" in page, "the report has the plot and the pictures")


def cache(t):
    before = films(t)
    t.check(len(before) == 1, f"one film is kept: {before}")
    again = measure(t, study(), "--only", "march")
    t.check(again and again.returncode == 0 and films(t) == before, "a kept film is used as it is")
    more = study()
    more["scenes"][0]["reference"]["spp"] = 24
    done = measure(t, more)
    t.check(done and "traced with 24 samples" in done.stdout and films(t).keys() == before.keys() and films(t) != before, f"a film is gone on with\n{done and done.stdout}")
    film = next(iter(before))
    film.write_bytes(film.read_bytes()[:1000])
    done = measure(t, study())
    t.check(done and done.returncode == 0 and film.name in done.stderr and "made anew" in done.stderr, f"a damaged film is told and made anew\n{done and done.stderr}")
    done = measure(t, study())
    t.check(done and done.returncode == 0 and not done.stderr, f"and is whole then\n{done and done.stderr}")


def changed_asset(t):
    mesh = t.file("shape.obj", TRIANGLE.format(1))
    t.file("mesh.json", json.dumps({"tyndall": 1, "modules": [], "entities": [
        {"name": "Camera", "transform": {"translation": [0, 0.5, 3]}, "camera": {"exposure": 1}},
        {"name": "Lamp", "transform": {"translation": [0, 2, 3]}, "point_light": {"intensity_cd": 10}},
        {"name": "Shape", "mesh": {"file": "shape.obj"}, "material": {"roughness": 1}}]}))
    content = study(baseline="", techniques=[{"name": "plain"}])
    content["scenes"] = [{"name": "mesh", "scene": "mesh.json", "size": [16, 16], "reference": {"spp": 2, "max_order": 1}}]
    before = films(t)
    first = measure(t, content)
    t.check(first and first.returncode == 0 and len(films(t)) == len(before) + 1, f"a scene with a mesh\n{first and first.stderr + first.stdout}")
    mesh.write_text(TRIANGLE.format(2))
    second = measure(t, content)
    t.check(second and second.returncode == 0 and len(films(t)) == len(before) + 2, "a changed mesh makes another film")


def interrupted(t):
    content = study()
    content["techniques"][0]["sweep"][0]["values"] = list(range(1, 9))
    file = t.file("long.json", json.dumps(content))
    command = [t.program, "measure", file, "--cache", t.folder / "cache"]
    process = subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    for line in process.stdout:
        if line.startswith("[3/9]"):
            process.send_signal(signal.SIGINT)
            break
    said = process.communicate(timeout=60)[1]
    t.check(process.returncode == 130 and "interrupted" in said, f"an interrupted study ends with 130: {process.returncode} {said}")
    kept = t.folder / "cache" / "long.unfinished"
    t.check(len(list(kept.glob("*.json"))) >= 3, "finished rows are kept")
    broken = next(file for file in kept.glob("*.json") if json.loads(file.read_text())["label"] == "march, steps 1")
    broken.write_text("{")
    done = t.run(*command[1:])
    t.check(done and done.returncode == 0 and "cannot be read" in done.stderr, f"a damaged row is measured anew\n{done and done.stderr}")
    reused = done.stdout.count("before the interruption")
    t.check(reused >= 2 and "[9/9]" in done.stdout, f"the study is gone on with, {reused} rows were there\n{done.stdout}")
    t.check(not kept.exists(), "and nothing is left")


def refusal(t):
    spot_without = "/entities/Spot/spot_light/shadow={ \"enabled\": false }"
    content = study(techniques=[
        {"name": "closed form", "set": ["{fog}/solver=analytic"], "refused_if": ": ray_marched renders it instead",
         "points": [{"name": "shadows"}, {"name": "the same again"}, {"name": "none", "set": [spot_without]}]},
        {"name": "none", "set": ["/render/participating_media/enabled=false"]}])
    content["scenes"][0]["words"] = [{"name": "fog", "text": "/entities/Fog/medium"}]
    numbers = t.folder / "refusal.json"
    done = measure(t, content, "--json", numbers, "--markdown", "-")
    t.check(done and done.returncode == 0, f"what a technique cannot render is no failure\n{done and done.stdout + done.stderr}")
    rows = {row["label"]: row for row in json.loads(numbers.read_text())["scenes"][0]["rows"]}
    for label in ("closed form, shadows", "closed form, the same again"):
        t.check("casts shadows" in rows[label].get("cannot", "") and not rows[label]["metrics"], f"it is told and has no numbers: {rows[label]}")
    t.check("cannot: participating_media: analytic cannot render a light that casts shadows |" in done.stdout, f"in the table, too\n{done.stdout}")
    t.check(rows["closed form, none"]["metrics"]["relmse"] > 0 and "cannot" not in rows["closed form, none"], "without shadows it can")
    again = measure(t, content, "--json", t.folder / "again.json", "--errors", numbers)
    t.check(again and again.returncode == 0 and "reference" not in again.stdout, f"times alone\n{again and again.stdout + again.stderr}")
    later = json.loads((t.folder / "again.json").read_text())
    kept = {row["label"]: row for row in later["scenes"][0]["rows"]}["closed form, none"]
    t.check(kept["metrics"] == rows["closed form, none"]["metrics"] and kept["ms"] > 0 and "errors" in later["facts"], "with the errors of before")
    refused(t, "no such numbers", measure(t, content, "--errors", t.file("broken.json", "{}")), "broken.json", "--json")
    content["scenes"][0]["words"] = []
    refused(t, "unexplained word", measure(t, content), "/techniques/0", "{fog}/solver=analytic")


def times(t):
    content = study(compare=False, against=["steps", "pixels"], baseline="", techniques=[
        {"name": "march", "sweep": [{"set": "/render/participating_media/steps", "values": [1, 8]}]},
        {"name": "pictures", "points_are": "pixels", "points": [{"name": str(w * w), "size": [w, w]} for w in (16, 64, 256)]}])
    before = films(t)
    done = measure(t, content, "--svg", t.folder / "times", "--json", t.folder / "times.json", "--markdown", "-")
    t.check(done and done.returncode == 0 and films(t) == before, f"times without references\n{done and done.stdout + done.stderr}")
    plots = sorted(file.name for file in (t.folder / "times").iterdir())
    t.check(plots == ["fog---spot-pixels.svg", "fog---spot-steps.svg"], f"a plot for each parameter: {plots}")
    drawn = "".join(xml.etree.ElementTree.parse(t.folder / "times" / "fog---spot-pixels.svg").getroot().itertext())
    t.check("pictures, pixels 65536: " in drawn and "march" not in drawn, f"time over pixels: {drawn}")
    rows = {row["label"]: row["ms"] for row in json.loads((t.folder / "times.json").read_text())["scenes"][0]["rows"]}
    t.check(rows["pictures, pixels 65536"] > 2 * rows["pictures, pixels 256"], f"each at its own size: {rows}")
    refused(t, "unknown parameter", measure(t, {**content, "against": ["step"]}), "/against/0", "did you mean 'steps'")
    refused(t, "another size", measure(t, {**content, "compare": True}), "/techniques/1/points/0/size", "cannot be compared")


def wrong_input(t):
    failing = study()
    failing["techniques"].insert(0, {"name": "wrong", "set": ["/render/participating_media/stepz=4"]})
    done = measure(t, failing)
    t.check(done and done.returncode == 1 and "'stepz'" in done.stdout and "march, steps 16: " in done.stdout, f"a failing technique is one row's trouble\n{done and done.stdout}")
    unreachable = t.file("cache_is_a_file", "")
    done = t.run("measure", t.file("tiny.json", json.dumps(study())), "--cache", unreachable)
    t.check(done and done.returncode == 1 and "cache_is_a_file" in done.stdout, f"a cache that cannot be written\n{done and done.stdout + done.stderr}")
    lost = study()
    lost["scenes"][0]["scene"] = "nowhere.json"
    refused(t, "missing scene", measure(t, lost), "/scenes/0/scene", "nowhere.json")
    refused(t, "unknown field", measure(t, study(titel="x")), "tiny.json", "did you mean 'title'")
    refused(t, "unknown name", measure(t, study(), "--only", "marsh"), "did you mean 'march'")
    refused(t, "missing study", t.run("measure", t.folder / "nothing.json"), "nothing.json")
    file = study()
    file["scenes"][0]["reference"] = {"file": "truth.exr"}
    done = measure(t, file)
    t.check(done and done.returncode == 1 and "truth.exr" in done.stdout, f"a missing reference\n{done and done.stdout}")


def refused(t, name, done, *expected):
    t.check(done and done.returncode == 2 and all(words in done.stderr for words in expected), f"{name}: {done and done.stderr}")


def main():
    with Tests() as t:
        os.environ["TYNDALL_LOG"] = "warning"
        outputs(t)
        cache(t)
        changed_asset(t)
        interrupted(t)
        refusal(t)
        times(t)
        wrong_input(t)


main()
