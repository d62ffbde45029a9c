#!/usr/bin/env python3
"""Runs the golden tests: one *.golden file each, holding the input and what the program must answer.

A case is a head and sections. The head has `what:` (one line on what it shows) and `run:` (the command). Sections
begin with a line of their own:

    --- file NAME          a file in the folder where the command runs, as it stands
    --- bytes NAME         the same with \\xNN, \\t, \\r, \\n and \\\\ for what cannot stand in a text; lines are joined
    --- copy FOLDER        what a folder of the repository has, without locks and sites
    --- exit N             from here on is the answer, which --bless writes anew: the exit code,
    --- stdout             what was printed (sections that would be empty are left out)
    --- stderr
    --- file-after NAME    a file that the command must have written; name it once by hand, --bless fills it

In answers, DIR stands for the folder and VERSION for the program's version.
"""
from __future__ import annotations

import argparse
import difflib
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
HEADER = re.compile(r"^--- (file|bytes|copy|exit|stdout|stderr|file-after)(?: (.+))?$")
ESCAPE = re.compile(r"\\(x[0-9a-fA-F]{2}|[trn\\])")
WATCHDOG_SECONDS = 300


@dataclass
class Case:
    path: Path
    head: list[str] = field(default_factory=list)
    inputs: list[tuple[str, str, str]] = field(default_factory=list)  # kind, name, text
    answer: str = ""
    wanted_files: list[str] = field(default_factory=list)

    def command(self) -> list[str]:
        for line in self.head:
            if line.startswith("run: "):
                return shlex.split(line[5:])
        raise ValueError(f"{self.path}: no `run:` line")


def parse(path: Path) -> Case:
    case = Case(path)
    lines = path.read_text(encoding="utf-8").split("\n")
    kind, name = "", ""
    body: list[str] = []
    answer_from = len(lines)

    def close() -> None:
        if kind in ("file", "bytes", "copy"):
            case.inputs.append((kind, name, "\n".join(body)))

    for number, line in enumerate(lines):
        header = HEADER.match(line)
        if header is None:
            (body if kind else case.head).append(line)
            continue
        close()
        kind, name, body = header[1], header[2] or "", []
        if kind == "exit" and answer_from == len(lines):
            answer_from = number
        if kind == "file-after":
            case.wanted_files.append(name)
    if answer_from == len(lines):  # a new case: the newline that ends the file is not a line of its input
        if body and body[-1] == "":
            body.pop()
        close()
    case.answer = "\n".join(lines[answer_from:])
    if not any(line.startswith("what: ") for line in case.head):
        raise ValueError(f"{path}: no `what:` line")
    return case


def unescaped(text: str) -> bytes:
    plain = {"t": b"\t", "r": b"\r", "n": b"\n", "\\": b"\\"}
    out, end = b"", 0
    joined = text.replace("\n", "")
    for match in ESCAPE.finditer(joined):
        out += joined[end:match.start()].encode()
        out += plain[match[1]] if match[1] in plain else bytes([int(match[1][1:], 16)])
        end = match.end()
    return out + joined[end:].encode()


def answer_of(case: Case, cli: Path, version: str) -> str:
    # Always there: CMake wraps its messages by the length of their paths.
    with tempfile.TemporaryDirectory(prefix="golden-", dir="/tmp") as folder:
        for kind, name, text in case.inputs:
            if kind == "copy":
                made = shutil.ignore_patterns("ros2wasm.lock", "site")
                shutil.copytree(ROOT / name, folder, dirs_exist_ok=True, ignore=made)
                continue
            target = Path(folder, name)
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(unescaped(text) if kind == "bytes" else (text + "\n").encode())
        command = case.command()
        if command[0] == "ros2wasm":
            command[0] = str(cli)
        environment = {"PATH": os.environ.get("PATH", ""), "HOME": folder, "LC_ALL": "C.UTF-8", "TERM": "dumb",
                       "ROS2WASM": str(cli)}
        process = subprocess.run(
            command, cwd=folder, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
            stderr=subprocess.PIPE, timeout=WATCHDOG_SECONDS, check=False,
        )
        parts = [f"--- exit {process.returncode}"]
        for name, output in (("stdout", process.stdout), ("stderr", process.stderr)):
            if output:
                parts += [f"--- {name}", output.decode("utf-8", "backslashreplace").rstrip("\n")]
        for name in case.wanted_files:
            path = Path(folder, name)
            written = path.read_text(encoding="utf-8") if path.exists() else "(was not written)"
            parts += [f"--- file-after {name}", written.rstrip("\n")]
        text = "\n".join(parts) + "\n"
        return text.replace(folder, "DIR").replace(version, "VERSION")


def run(case: Case, cli: Path, version: str, bless: bool) -> str | None:
    """What differs, or None when the case is good (or was blessed)."""
    try:
        answer = answer_of(case, cli, version)
    except subprocess.TimeoutExpired:
        return f"no answer within {WATCHDOG_SECONDS} s"
    if answer == case.answer:
        return None
    if bless:
        inputs = "".join(
            f"--- {kind} {name}\n" + ("" if kind == "copy" else f"{text}\n") for kind, name, text in case.inputs
        )
        head = "\n".join(case.head).rstrip("\n") + "\n"
        case.path.write_text(head + inputs + answer, encoding="utf-8")
        print(f"blessed {case.path.relative_to(ROOT)}")
        return None
    return "\n".join(difflib.unified_diff(
        case.answer.splitlines(), answer.splitlines(), "expected", "printed", lineterm="", n=4))


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cli", type=Path, required=True, help="the program under test")
    parser.add_argument("--bless", action="store_true", help="write what is printed now into the files")
    parser.add_argument("names", nargs="*", help="parts of paths; all cases when none is given")
    options = parser.parse_args()
    folder = Path(__file__).parent
    paths = sorted(folder.rglob("*.golden"))
    if options.names:
        paths = [p for p in paths if any(n in p.relative_to(folder).as_posix() for n in options.names)]
    version = (ROOT / "VERSION").read_text(encoding="utf-8").strip()
    cases = [parse(path) for path in paths]
    with ThreadPoolExecutor(2) as pool:
        results = list(pool.map(lambda case: run(case, options.cli.resolve(), version, options.bless), cases))
    failed = 0
    for case, difference in zip(cases, results):
        if difference is not None:
            failed += 1
            print(f"FAILED {case.path.relative_to(ROOT)}\n{difference}\n")
    print(f"{len(cases) - failed} passed, {failed} failed")
    return 1 if failed or not cases else 0


if __name__ == "__main__":
    sys.exit(main())
