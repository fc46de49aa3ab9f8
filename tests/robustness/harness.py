"""Runs the real program and judges how it ends. Used by the other scripts here; needs nothing but Python."""
import os
import pathlib
import resource
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
LIMIT_S = 20  # of the processors' time, so that a busy machine fails nothing
HANG_S = 120


def processor_s():
    """What all processes that have ended took."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


class Tests:
    """Counts what fails; `with Tests(...)` ends the process with 1 when something did. argv: the program."""

    def __init__(self):
        self.program = pathlib.Path(sys.argv[1]).resolve()
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="tyndall_robustness_"))
        self.checked = 0
        self.failures = []

    def __enter__(self):
        return self

    def __exit__(self, kind, *_):
        shutil.rmtree(self.folder, ignore_errors=True)
        if kind is not None:
            return
        for failure in self.failures:
            print("FAILED", failure)
        print(f"{self.checked} checks, {len(self.failures)} failed")
        sys.exit(1 if self.failures else 0)

    def check(self, holds, what):
        self.checked += 1
        if not holds:
            self.failures.append(what)

    def run(self, *arguments, limit_s=HANG_S, **environment):
        """The ended process, its output as text; None when it was still running after the limit."""
        command = [self.program, *map(str, arguments)]
        started = processor_s()
        try:
            done = subprocess.run(command, capture_output=True, timeout=limit_s, cwd=ROOT, env={**os.environ, **environment})
        except subprocess.TimeoutExpired:
            return None
        done.stdout, done.stderr = (text.decode(errors="replace") for text in (done.stdout, done.stderr))
        done.seconds = processor_s() - started
        return done

    def refused(self, name, arguments, *expected, **environment):
        """The program must end with 1 (not by a signal, not by a timeout), and say each of `expected` on stderr without shouting."""
        done = self.run(*arguments, **environment)
        if done is None:
            self.check(False, f"{name}: still running after {HANG_S} s")
            return
        said = done.stderr
        self.check(done.seconds < LIMIT_S, f"{name}: took {done.seconds:.0f} s")
        self.check(done.returncode == 1, f"{name}: ended with {done.returncode}, not 1\n{said}{done.stdout[-400:]}")
        for words in expected:
            self.check(words in said, f"{name}: does not say '{words}'\n{said}")
        lines = said.strip().splitlines()
        self.check(lines and (arguments[0] == "validate" or any(line.startswith("tyndall: ") for line in lines)), f"{name}: no line begins with the program's name\n{said}")
        self.check(len(lines) == len(set(lines)) and len(lines) <= 4, f"{name}: says too much\n{said}")
        noise = [w for w in ("terminate called", "Assertion", "Sanitizer", "stack trace", "std::") if w in said]
        self.check(not noise, f"{name}: {noise} in\n{said}")

    def file(self, name, content):
        """A file in the test's own folder."""
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path
