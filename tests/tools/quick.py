#!/usr/bin/env python3
"""Checks what has changed, without a browser and without Emscripten: formatting, house rules, types and unit tests.

  quick.py --build build [PATH...]

Without a path, the files that differ from the last commit. A unit test runs when it, or a file that it imports,
has changed; a native test when a file of its folder has, and only where the native build exists.
"""
from __future__ import annotations

import argparse
import os
import re
import subprocess
import sys
import time
from collections.abc import Callable, Iterable
from functools import partial
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from tests.tools import lint  # noqa: E402

ROOT = lint.ROOT
IMPORT = re.compile(r"(?:from|import) '(\.[^']+)'")
# The folder of native sources -> the targets of its tests.
NATIVE_TESTS = {
    "workspace_schema": ["workspace_schema_test"],
    "bundler": ["bundler_build_test", "bundler_channel_test", "bundler_serve_test"],
    "cli": ["cli_test"],
    "runtime": ["runtime_cpp_test"],
}


def changed_files(paths: list[Path]) -> list[str]:
    """Names below the repository's root: of the given files and folders, or of what git sees as changed."""
    if paths:
        found = [file for path in paths for file in ([path] if path.is_file() else path.rglob("*"))]
        return sorted(str(file.resolve().relative_to(ROOT)) for file in found if file.is_file())
    listed = subprocess.run(["git", "status", "--porcelain", "-uall", "-z"], cwd=ROOT, capture_output=True, text=True,
                            check=True).stdout.split("\0")
    return sorted(line[3:] for line in listed if line[3:] and (ROOT / line[3:]).is_file())


def imports_of(file: Path) -> set[Path]:
    return {(file.parent / name).resolve() for name in IMPORT.findall(file.read_text(encoding="utf-8"))}


def script_tests(changed: Iterable[str]) -> list[str]:
    """The unit tests in TypeScript that reach one of these files by their imports."""
    wanted = {ROOT / name for name in changed}
    known: dict[Path, set[Path]] = {}

    def reaches(file: Path) -> bool:
        waiting, seen = [file], {file}
        while waiting:
            one = waiting.pop()
            if one in wanted:
                return True
            if one not in known:
                known[one] = imports_of(one) if one.is_file() and one.suffix in (".ts", ".tsx", ".mjs") else set()
            fresh = known[one] - seen
            seen |= fresh
            waiting += fresh
        return False

    return [str(test) for test in sorted((ROOT / "tests/unit").rglob("*.test.ts")) if reaches(test)]


def native_targets(changed: Iterable[str]) -> list[str]:
    """Targets whose tests look at the folders of these files."""
    folders = {name.removeprefix("tests/unit/").split("/")[0] for name in changed
               if name.endswith((".cpp", ".hpp", ".h")) and not name.startswith("tests/fuzz/")}
    below = {"runtime_cpp": "runtime"}
    return sorted({target for folder in folders for target in NATIVE_TESTS.get(below.get(folder, folder), [])})


def python_tests(changed: Iterable[str]) -> list[str]:
    """The modules of unit tests that have changed themselves, or whose neighbour in the same tool has."""
    names = {name for name in changed if name.endswith(".py")}
    tests = {name for name in names if name.endswith("_test.py")}
    for name in names - tests:
        beside = sorted(ROOT.glob(f"tests/unit/**/{Path(name).stem}_test.py"))
        tests |= {str(file.relative_to(ROOT)) for file in beside}
    return sorted(test.removesuffix(".py").replace("/", ".") for test in tests)


def steps(build: Path, changed: list[str]) -> list[tuple[str, Callable[[], str | None]]]:
    """What is run for these files: a name, and what returns the output when it fails."""
    every: dict[str, Callable[[], str | None]] = lint.checks()  # type: ignore[assignment]
    native = [name for name in lint.native_files() if name in set(changed)]
    python = [name for name in changed if name.endswith(".py")]
    rows: list[tuple[str, Callable[[], str | None]]] = [(name, every[name]) for name in ("layers", "files")]
    rows.append(("house", lambda: lint.house_rules(changed)))
    if native:
        rows.append(("format", lambda: lint.run("clang-format", "--dry-run", "--Werror", *native)))
    scripted = [name for name in changed if name.endswith((".ts", ".tsx", ".mjs"))]
    if scripted:
        rows.append(("typescript", lambda: lint.run("node", "tests/tools/format.ts", "check", *scripted)))
        rows.append(("types", every["types"]))
    if any(name.startswith("runtime/protocol/") for name in changed):
        rows.append(("constants", every["constants"]))
    if python:
        rows.append(("python", lambda: lint.run(lint.PYTHON, "-m", "flake8", "--max-line-length=120", *python)))
    if any(name in ("dev", ".ci/run") or name.endswith(".sh") for name in changed):
        rows.append(("shell", every["shell"]))
    scripts, modules, targets = script_tests(changed), python_tests(changed), native_targets(changed)
    if scripts:
        rows.append((f"unit-js ({len(scripts)} files)", lambda: lint.run("node", "--test", *scripts)))
    if modules:
        rows.append((f"unit-python ({len(modules)} files)",
                     lambda: lint.run(sys.executable, "-m", "unittest", *modules)))
    if targets and (build / "build.ninja").exists():
        rows.append((f"build {' '.join(targets)}", lambda: lint.run("ninja", "-C", str(build), *targets)))
        rows += [(target, partial(run_program, build, target)) for target in targets]
    elif targets:
        print(f"skipped: {', '.join(targets)}: there is no native build yet (./dev build)")
    return rows


def run_program(build: Path, target: str) -> str | None:
    """Runs a program of native tests, which is known by its name."""
    found = next(file for file in (build / "tests/unit").rglob(target) if os.access(file, os.X_OK))
    return lint.run(str(found), "--gtest_brief=1")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--build", type=Path, required=True)
    parser.add_argument("path", nargs="*", type=Path)
    options = parser.parse_args()
    began = time.monotonic()
    changed = changed_files(options.path)
    if not changed:
        print("nothing has changed since the last commit")
        return 0
    rows = steps(options.build.resolve(), changed)
    failed = 0
    for name, check in rows:
        at = time.monotonic()
        problem = check()
        print(f"{time.monotonic() - at:6.1f} s  {name:24} {'ok' if problem is None else 'FAILED'}", flush=True)
        if problem is not None:
            failed += 1
            print(problem, flush=True)
    print(f"{len(rows) - failed} passed, {failed} failed ({time.monotonic() - began:.0f} s, {len(changed)} files)")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
