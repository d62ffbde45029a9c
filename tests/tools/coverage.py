#!/usr/bin/env python3
"""Which lines the tests reach, by folder: `./dev coverage`.

The C++ of the command line is built once more with counters (build-coverage), and the native, golden and Python suites
run on it. The TypeScript of sites is counted by Node.js in its unit tests. What runs in browsers and as WebAssembly
only is not counted, so those folders are better tested than the table says. Prints a table and writes, below
build/coverage, summary.json, the report of each file (cpp.json, ts.lcov) and html/ to read beside the C++.
"""
from __future__ import annotations

import argparse
import json
import os
import re
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
NATIVE = ("bundler", "cli", "workspace_schema")


@dataclass
class Lines:
    reached: int = 0
    all: int = 0

    def percent(self) -> str:
        return f"{100 * self.reached / self.all:.1f}" if self.all else "-"


Table = dict[str, Lines]


def folder_of(path: str) -> str:
    """bundler/channel/x.cpp -> bundler/channel, cli/x.cpp -> cli, runtime/site/ui/model/x.ts -> runtime/site/ui."""
    return "/".join(path.split("/")[:-1][:3 if path.startswith("runtime/site/") else 2])


def count(table: Table, path: str, reached: int, total: int) -> None:
    lines = table.setdefault(folder_of(path), Lines())
    lines.reached += reached
    lines.all += total


def call(command: list[str], log: Path, environment: dict[str, str] | None = None) -> None:
    with log.open("w", encoding="utf-8") as out:
        code = subprocess.run(command, cwd=ROOT, env=environment, stdin=subprocess.DEVNULL, stdout=out,
                              stderr=subprocess.STDOUT, check=False).returncode
    if code != 0:
        sys.stderr.write(log.read_text(encoding="utf-8", errors="replace")[-4000:])
        sys.exit(f"coverage: {' '.join(command[:4])} ... failed; the whole log is {log}")


def native(build: Path, out: Path, table: Table) -> None:
    """Lines of C++ that the native, golden and Python suites reach."""
    counted = ROOT / "build-coverage"
    call(["cmake", "--preset", "coverage"], out / "configure.log")
    call(["ninja", "-C", str(counted)], out / "ninja.log")
    for name in ("runtime", "channel", "templates"):  # what the program finds beside itself
        link = counted / name
        if not link.exists():
            link.symlink_to(os.path.relpath(build / name, counted))
    for old in counted.rglob("*.gcda"):
        old.unlink()
    environment = dict(os.environ, ROS2WASM_BUILD=str(counted), ROS2WASM_CLI=str(counted / "ros2wasm"))
    call([sys.executable, "tests/tools/run_tests.py", "--build", str(counted), "native", "golden", "unit-python"],
         out / "tests.log", environment)
    (out / "html").mkdir(exist_ok=True)
    filters = [part for name in NATIVE for part in ("--filter", f"{name}/")]
    call(["gcovr", "--root", str(ROOT), "--object-directory", str(counted), *filters, "--json-summary",
          str(out / "cpp.json"), "--html-details", str(out / "html" / "index.html"), str(counted)], out / "gcovr.log")
    for file in json.loads((out / "cpp.json").read_text(encoding="utf-8"))["files"]:
        count(table, file["filename"], file["line_covered"], file["line_total"])


def scripts(out: Path, table: Table, tests: list[str]) -> None:
    """Lines of TypeScript that these tests reach."""
    report = out / "ts.lcov"
    call(["node", "--test", "--experimental-test-coverage", "--test-coverage-include=runtime/**/*.ts",
          "--test-reporter=lcov", f"--test-reporter-destination={report}", *tests], out / "ts.log")
    name, reached, total = "", 0, 0
    for line in report.read_text(encoding="utf-8").splitlines():
        if match := re.fullmatch(r"(SF|LH|LF):(.*)", line):
            kind, value = match.groups()
            name = value if kind == "SF" else name
            reached = int(value) if kind == "LH" else reached
            total = int(value) if kind == "LF" else total
        elif line == "end_of_record":
            count(table, os.path.relpath(ROOT / name, ROOT), reached, total)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=Path, required=True)
    build = parser.parse_args().build.resolve()
    out = build / "coverage"
    out.mkdir(parents=True, exist_ok=True)
    table: Table = {}
    native(build, out, table)
    scripts(out, table, sorted(str(path) for path in (ROOT / "tests" / "unit").rglob("*.test.ts")))
    rows = [*sorted(table.items())]
    for title, part in (("all C++", [lines for name, lines in rows if name.split("/")[0] in NATIVE]),
                        ("all TypeScript", [lines for name, lines in rows if name.startswith("runtime/")])):
        rows.append((title, Lines(sum(one.reached for one in part), sum(one.all for one in part))))
    width = max(len(name) for name, _ in rows)
    print(f"{'folder':{width}}   lines reached  percent")
    for name, lines in rows:
        print(f"{name:{width}}  {lines.all:6} {lines.reached:7}  {lines.percent():>7}")
    summary = {name: {"lines": lines.all, "reached": lines.reached} for name, lines in rows}
    (out / "summary.json").write_text(json.dumps(summary, indent=1) + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
