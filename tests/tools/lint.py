#!/usr/bin/env python3
"""Formatting, types and house rules. `lint.py` checks everything; `--fix format` rewrites the formatting."""
from __future__ import annotations

import argparse
import os
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LIMIT = 600  # lines of one source file
FUNCTION_LIMIT = 180  # lines of one function, with what is inside it
PYTHON = "/usr/bin/python3"  # Debian's: the one that its flake8 and mypy are installed for
REGISTRY_OR_MACHINE = re.compile(
    "://[^/ ]*(" + "|".join(("debian", "npmjs")) + r")\.|(^|[^A-Za-z0-9_.])/wor[k]/[A-Za-z.]"
)
LAUNCH_MODULES = "templates/python/launch_modules"
CODE = re.compile(r"R2W\d{4}")
# Included by projects that may not have called cmake_minimum_required() yet.
CMAKE_MODULE = re.compile(r"(templates/toolchain/modules|runtime/packages/\w+/\w+/cmake)/[^/]+\.cmake(\.in)?$")
CMAKE_CODE = re.compile(r"^\s*(function|macro|if)\(", re.MULTILINE)
NO_CODE = "R2W9999"  # stands for one that does not exist

# TypeScript has types in PascalCase; functions, variables and parameters in camelCase; constants of a module in
# camelCase or in CONSTANT_CASE. Components are functions that begin with a capital letter, in .tsx files.
TS_NAMES = (
    (re.compile(r"^\s*(?:export )?const (k[A-Z]\w*)"), "a constant has no prefix"),
    (re.compile(r"^(?:export )?(?:class|interface|type|enum) ([a-z_]\w*)"), "a type begins with a capital letter"),
    (re.compile(r"^\s*(?:export )?(?:async )?function (\w+_\w*)"), "a function is in camelCase"),
    (re.compile(r"^\s*(?:const|let) ([a-z]+_\w*)\s*[:=]"), "a variable is in camelCase"),
)
FUNCTION = re.compile(
    r"^(?P<indent>(?:  )?)(?:(?:export |default |async )*function\*? (?P<ts>\w+)"
    r"|(?:export )?const (?P<arrow>\w+) = [^;]*=> \{$"
    r"|(?!namespace|class|struct|enum|union|extern|if|for|while|switch|return|do|else|TEST)"
    r"[A-Za-z_\[].*\)(?:: [^;]+)? (?:const )?(?:noexcept )?\{$)"
)

WIRE_NUMBER = re.compile(r"\b(?:slot|other|from|to)\]? \+ [1-6]\]|\bload\(slot \+ [1-6]")


def tracked(*suffixes: str) -> list[str]:
    command = ["git", "ls-files", "-co", "--exclude-standard"]
    out = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    return [n for n in out.stdout.splitlines() if n.endswith(suffixes) and (ROOT / n).is_file()]


def native_files() -> list[str]:
    ours = ("cli/", "bundler/", "workspace_schema/", "tests/unit/", "runtime/")
    made = "/generated/"  # the generator's own text, which `constants` compares byte for byte
    return [n for n in tracked(".cpp", ".hpp", ".h") if n.startswith(ours) and made not in n]


def run(*command: str, environment: dict[str, str] | None = None) -> str | None:
    """Runs a checker; its output when it fails, None when it is content."""
    process = subprocess.run(command, cwd=ROOT, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                             env={**os.environ, **(environment or {})}, check=False)
    return None if process.returncode == 0 else process.stdout[-6000:]


def long_functions(name: str, lines: list[str]) -> list[str]:
    """Functions that are longer than FUNCTION_LIMIT. The formatters put the end of each below its beginning."""
    errors = []
    for number, line in enumerate(lines, 1):
        begun = FUNCTION.match(line)
        if begun is None:
            continue
        indent = begun["indent"]
        end = next((n for n, later in enumerate(lines[number:], number + 1)
                    if later.startswith(indent + "}") and not later.startswith(indent + "} from")
                    and not later.startswith((indent + "}):", indent + "}: "))), number)
        if end - number > FUNCTION_LIMIT:
            errors.append(f"{name}:{number}: a function of {end - number} lines ({FUNCTION_LIMIT} at most)")
    return errors


def house_rules(names: list[str] | None = None) -> str | None:
    """Of these files, or of all."""
    errors = []
    for name in tracked("") if names is None else names:
        path = ROOT / name
        try:
            text = path.read_text(encoding="utf-8")
        except UnicodeDecodeError:
            continue
        lines = text.count("\n")
        if path.suffix in {".cpp", ".hpp", ".ts", ".tsx", ".py"} and lines > LIMIT:
            errors.append(f"{name}: {lines} lines; a file has one subject ({LIMIT} at most)")
        upstreams = "/include/" in name  # public headers stand at the paths that user code includes
        if not upstreams and path.stem in {"util", "utils", "helper", "helpers", "common", "misc"}:
            errors.append(f"{name}: a name that says nothing")
        if CMAKE_MODULE.match(name) and CMAKE_CODE.search(text) and "cmake_policy(VERSION" not in text:
            errors.append(f"{name}: a module sets its policies itself: cmake_policy(VERSION ...)")
        if path.suffix in {".cpp", ".ts", ".tsx"}:
            errors += long_functions(name, text.splitlines())
        for number, line in enumerate(text.splitlines(), 1):
            if path.suffix in {".ts", ".tsx"}:
                errors += [f"{name}:{number}: {found[1]}: {rule}" for pattern, rule in TS_NAMES
                           if (found := pattern.match(line))]
            for code in CODE.findall(line):
                if code != NO_CODE and not (ROOT / "cli/explain" / f"{code}.md").is_file():
                    errors.append(f"{name}:{number}: there is no code {code}")
            if REGISTRY_OR_MACHINE.search(line):
                errors.append(f"{name}:{number}: names a package registry's host or a path of a machine")
            if name.startswith("runtime/site/bus/") and WIRE_NUMBER.search(line):
                errors.append(f"{name}:{number}: a word of a slot has a name in BusSlot, which is generated")
            if path.suffix == ".ts" and "waitForFunction(async" in line:
                errors.append(f"{name}:{number}: a promise counts as true here; use tests/support/eventually.ts")
    return "\n".join(errors) or None


def checks() -> dict[str, object]:
    python = tracked(".py")
    # Users' packages need no hints, nor do programs that are written as users write them. Launch files find modules
    # whose names others have too.
    unhinted = ("tests/packages/", "examples/", "templates/workspaces/", "runtime/packages/interfaces/",
                "runtime/packages/tools/demo_nodes_", "runtime/packages/tools/joy/",
                "runtime/packages/tools/teleop_twist_joy/",
                "runtime/packages/tools/twist_mux/", "runtime/packages/tools/urdf_launch/", LAUNCH_MODULES,
                # cv2 makes its functions from tables when it is imported, as OpenCV's own does; neither has hints.
                "runtime/packages/vendor/py_opencv/", "tests/support/opencv/")
    hinted = [n for n in python if not n.startswith(unhinted) and not n.endswith("launch.py")]
    shell = ["dev", ".ci/run", *tracked(".sh")]
    return {
        "format": lambda: run("clang-format", "--dry-run", "--Werror", *native_files()),
        "typescript": lambda: run("node", "tests/tools/format.ts", "check"),
        "layers": lambda: run(sys.executable, "tests/tools/layers.py"),
        "files": lambda: run(sys.executable, "tests/tools/file_calls.py"),
        "house": house_rules,
        "documents": lambda: run(sys.executable, "tests/tools/documents.py"),
        "types": lambda: run("node_modules/.bin/tsc", "--noEmit", "--incremental",
                             "--tsBuildInfoFile", "build/.tsbuildinfo", "-p", "tsconfig.json"),
        "english": lambda: run(sys.executable, "tests/tools/english.py"),
        "words": lambda: run("node", "tests/tools/page_texts.ts"),
        "constants": lambda: run("node", "runtime/protocol/generate.mjs", "--check"),
        "codes": lambda: run(sys.executable, "tests/tools/codes.py", "--check"),
        "tables": lambda: run(sys.executable, "tests/tools/claims.py", "--check"),
        "python": lambda: run(PYTHON, "-m", "flake8", "--max-line-length=120", *python),
        "hints": lambda: run(PYTHON, "-m", "mypy", "--cache-dir=build/.mypy_cache", *hinted),
        "launch": lambda: run(PYTHON, "-m", "mypy", "--cache-dir=build/.mypy_launch", LAUNCH_MODULES,
                              environment={"MYPYPATH": LAUNCH_MODULES}),
        "shell": lambda: run("shellcheck", *shell),
    }


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=Path, required=True)
    parser.add_argument("--fix", action="store_true")
    parser.add_argument("names", nargs="*")
    options = parser.parse_args()
    if options.fix:
        commands = (["clang-format", "-i", *native_files()], ["node", "tests/tools/format.ts", "fix"])
        return max(subprocess.run(command, cwd=ROOT, check=False).returncode for command in commands)
    failed = 0
    rows = {name: check for name, check in checks().items() if not options.names or name in options.names}
    for name, check in rows.items():
        problem = check()  # type: ignore[operator]
        print(f"{name:10} {'ok' if problem is None else 'FAILED'}")
        if problem is not None:
            failed += 1
            print(problem)
    print(f"{len(rows) - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
