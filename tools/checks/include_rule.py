#!/usr/bin/env python3
"""Holds the include rule between floors (docs/architecture.md): a floor includes only from itself and the floors it stands on;
the engine names no module; modules include the engine and themselves, never one another."""
import pathlib
import re
import subprocess
import sys

STANDS_ON = {
    "core": [],
    "physics": [],
    "ecs": ["core"],
    "geometry": ["core"],
    "image": ["core"],
    "color": ["core", "image"],
    "platform": ["core"],
    "gpu": ["core"],
    "scene": ["core", "ecs", "geometry", "image", "color", "physics"],
    "render": ["core", "ecs", "geometry", "image", "color", "scene", "gpu", "physics"],
    "module": ["core", "ecs", "geometry", "image", "color", "scene", "gpu", "physics", "render"],
    "app": ["core", "physics", "ecs", "geometry", "image", "color", "platform", "gpu", "scene", "render", "module"],
}
INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.MULTILINE)


def files(*patterns):
    listed = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard", *patterns],
                            check=True, capture_output=True, text=True).stdout
    return [pathlib.Path(line) for line in listed.splitlines() if pathlib.Path(line).is_file()]


def problem(path, included):
    """What is wrong with `path` including `included`, or None."""
    top, room = path.parts[0], path.parts[1] if len(path.parts) > 2 else ""
    floor = included.split("/")[0]
    if top == "engine" and room in STANDS_ON:
        if floor in STANDS_ON and floor != room and floor not in STANDS_ON[room]:
            return f"floor '{room}' must not include from '{floor}' (it stands on: {', '.join(STANDS_ON[room]) or 'nothing'})"
        if floor in ("modules", "game", "tools"):
            return f"the engine never names '{floor}'"
    if top == "modules":
        if floor in ("modules", "game", "tools") or (floor not in STANDS_ON and "/" in included and not (path.parent / included).exists()
                                                     and not (pathlib.Path("modules") / room / included).exists()):
            return "a module includes the engine and itself only"
    return None


def main():
    bad = 0
    for path in files("engine/*.h", "engine/*.cpp", "engine/*.glsl", "modules/*.h", "modules/*.cpp"):
        text = path.read_text(errors="replace")
        for match in INCLUDE.finditer(text):
            what = problem(path, match.group(1))
            if what:
                line = text.count("\n", 0, match.start()) + 1
                print(f"{path}:{line}: \"{match.group(1)}\": {what}")
                bad += 1
    if bad:
        sys.exit(f"{bad} includes break the rule between floors")
    print("the include rule holds")


main()
