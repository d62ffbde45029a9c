#!/usr/bin/env python3
"""Writes the tables of codes from the pages in cli/explain/; --check only compares.

A source that names a code without a page does not compile: the C++ table and the TypeScript type are the codes that
have one. docs/error-codes.md says what each means and which files name it.
"""
from __future__ import annotations

import re
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGES = ROOT / "cli/explain"
NATIVE = ROOT / "workspace_schema/base/diagnostic_codes.hpp"
SITE = ROOT / "runtime/site/contract/diagnostic_codes.ts"
TABLE = ROOT / "docs/error-codes.md"
NOTE = "Made from cli/explain/ by tests/tools/codes.py; add a page there instead."
# A code in a comment does not count.
FOLDERS = ("cli/", "bundler/", "workspace_schema/", "runtime/site/", "runtime/launch_evaluator/",
           "runtime/packages/", "templates/")
SUFFIXES = (".cpp", ".hpp", ".ts", ".tsx", ".py", ".cmake", ".mjs", ".html", ".js")
LITERAL = re.compile(r"""(?:["'`>]|error\[)(R2W\d{4})\b""")


def titles() -> dict[str, str]:
    """By code: the first line of its page."""
    found = {}
    for page in sorted(PAGES.glob("R2W*.md")):
        first = page.read_text(encoding="utf-8").partition("\n")[0]
        found[page.stem] = first.removeprefix(f"# {page.stem}: ")
    return found


def reporters() -> dict[str, list[str]]:
    """By code: the files that have it as a literal, sorted."""
    names = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=ROOT, capture_output=True, text=True,
                           check=True).stdout.splitlines()
    found: dict[str, set[str]] = defaultdict(set)
    for name in names:
        if not name.startswith(FOLDERS) or not name.endswith(SUFFIXES) or ROOT / name in (NATIVE, SITE):
            continue
        path = ROOT / name
        if path.is_file():
            for code in LITERAL.findall(path.read_text(encoding="utf-8", errors="replace")):
                found[code].add(name)
    return {code: sorted(files) for code, files in found.items()}


def texts() -> dict[Path, str]:
    """What each table says, by its file."""
    pages, found = titles(), reporters()
    native = [f"// {NOTE}", "#pragma once", "", "#include <string_view>", "", "namespace ros2wasm {", "",
              "// clang-format off", "/// Sorted.", "inline constexpr std::string_view kDiagnosticCodes[] = {",
              *(f'    "{code}",' for code in pages), "};", "", "}  // namespace ros2wasm", ""]
    site = [f"// {NOTE}", "", "export type DiagnosticCode =", *(f"  | '{code}'" for code in pages)]
    site[-1] += ";"
    table = ["# Error codes", "", f"`ros2wasm explain CODE` prints the page of a code. {NOTE}", "",
             "| code | meaning | named in |", "| --- | --- | --- |"]
    for code, title in pages.items():
        files = ", ".join(found.get(code, ()))
        table.append(f"| [{code}](../cli/explain/{code}.md) | {title} | {files} |")
    return {NATIVE: "\n".join(native), SITE: "\n".join([*site, ""]), TABLE: "\n".join([*table, ""])}


def main() -> int:
    made = texts()
    old = [path for path, text in made.items() if not path.exists() or path.read_text(encoding="utf-8") != text]
    if "--check" in sys.argv[1:]:
        for path in old:
            print(f"{path.relative_to(ROOT)} is not current: run tests/tools/codes.py")
        return 1 if old else 0
    for path in old:
        path.write_text(made[path], encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
