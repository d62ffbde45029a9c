#!/usr/bin/env python3
"""Writes the tables of some pages in docs/ from what the tests say that they show; --check only compares.

A test says so in a comment of its own, up to the end of the comment or to an empty line of it:

    // Compatibility, works: WHAT
    // Compatibility, differs: WHAT -> HOW, AND WHY
    // Compatibility, cannot: WHAT -> WHO SAYS SO (a code), AND WHAT CAN BE DONE
    // Guarantee, KIND: WHAT
"""
from __future__ import annotations

import argparse
import re
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
# Page -> its tables.
PAGES = {
    "docs/compatibility.md": ("works", "differs", "cannot"),
    "docs/guarantees.md": ("same bytes", "verified", "citable", "ci", "hostile input", "robust"),
}
# Its table is written by hand; the tests that it names must be there.
THREATS = "SECURITY.md"
# In C++ a "#" begins no comment but a directive, which has no space behind it.
COMMENT = re.compile(r"^\s*(?://\s?|#(?:\s|$))(.*)$")
CLAIM = re.compile(r"^(?:Compatibility|Guarantee), ([a-z ]+): (.*)$")
KINDS = [kind for kinds in PAGES.values() for kind in kinds]
# These speak of claims; and what a fuzzer made is not a test's word.
NO_CLAIMS = ("tests/tools/claims.py", "tests/unit/tools/claims_test.py")
MADE_INPUT = "tests/fuzz/corpus/"
# A comment that begins like a claim, in any form: it must be in a form that is read.
LIKE_CLAIM = re.compile(
    r"^\s*(?://+|#+|/?\*+|--|<!--|\"\"\")!?\s*(?:compatibility|guarantee|works|differs|cannot)\s*[,:]", re.I)
# Files in which claims are read; "" are those without an ending, as scripts of Python packages.
ENDINGS = (".ts", ".cpp", ".py", ".yaml", ".golden", ".txt", "")
# Kinds whose rows have two cells before the tests, and the heads of these.
TWO_CELLS = {"differs": "| what | how, and why |", "cannot": "| what | said by, and what can be done |"}
CODE = re.compile(r"\bR2W\d{4}\b")
# The suites of run_tests.py: a file is a test of a suite when it has one of these names below one of these folders.
SUITES = (
    ("tests/golden/", ".golden"), ("tests/e2e/", ".test.ts"), ("tests/unit/", ".test.ts"),
    ("tests/conformance/", ".test.ts"), ("tests/", "_test.py"), ("tests/", "_test.cpp"),
    ("tests/fuzz/", "run.py"), ("tests/figures/", "_checks.py"),
)

Rows = dict[str, list[str]]  # a row's text -> the files that show it


def claims_of(text: str) -> list[tuple[str, str]]:
    """Returns the kind and the text of each claim."""
    claims: list[tuple[str, str]] = []
    is_open = False
    for line in text.splitlines():
        comment = COMMENT.match(line)
        said = comment[1].strip() if comment else ""
        claim = CLAIM.match(said)
        if claim:
            claims.append((claim[1], claim[2]))
        elif is_open and said:
            claims[-1] = (claims[-1][0], f"{claims[-1][1]} {said}")
        is_open = bool(claim) or (is_open and bool(said))
    return claims


def unread_claims(name: str, text: str) -> list[str]:
    """Comments of a file that look like claims and are none."""
    is_read = Path(name).suffix in ENDINGS
    faults = []
    for number, line in enumerate(text.splitlines(), 1):
        if not LIKE_CLAIM.match(line):
            continue
        comment = COMMENT.match(line)
        claim = CLAIM.match(comment[1].strip()) if comment else None
        if not is_read or not claim or claim[1] not in KINDS:
            faults.append(f"{name}:{number}: `{line.strip()}` looks like a claim, and is none that is read")
    return faults


def all_claims() -> dict[str, Rows]:
    """Returns, for each kind, the rows in the order of the files."""
    command = ["git", "ls-files", "-co", "--exclude-standard", "tests"]
    names = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout.splitlines()
    rows: dict[str, Rows] = {kind: defaultdict(list) for kind in KINDS}
    faults: list[str] = []
    for name in sorted(names):
        if name in NO_CLAIMS or name.startswith(MADE_INPUT) or not (ROOT / name).is_file():
            continue
        text = (ROOT / name).read_text(encoding="utf-8", errors="replace")
        faults += unread_claims(name, text)
        if Path(name).suffix not in ENDINGS:
            continue
        for kind, claim in claims_of(text):
            if kind in rows:
                rows[kind][claim].append(name)
    if faults:
        raise SystemExit("\n".join(faults))
    return rows


def check_code(file: str, reason: str) -> None:
    """What cannot be had is said by a code, which has a page; where nothing can say so the row tells that."""
    codes = CODE.findall(reason)
    if not codes and not reason.startswith("no code:"):
        raise SystemExit(f"{file}: `{reason}` names no code that says so")
    for code in codes:
        if not (ROOT / "cli" / "explain" / f"{code}.md").is_file():
            raise SystemExit(f"{file}: there is no page for {code}")


def is_test(name: str) -> bool:
    """Is it run by a suite itself?"""
    return any(name.startswith(folder) and name.endswith(ending) for folder, ending in SUITES)


def unused_files(rows: dict[str, Rows]) -> list[str]:
    """Files that claim something and that no suite runs: they are no test, and none names them or their package."""
    claiming = {file for of_kind in rows.values() for files in of_kind.values() for file in files}
    command = ["git", "ls-files", "-co", "--exclude-standard", "tests"]
    names = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout.splitlines()
    sources = [name for name in names if name.endswith(".ts") and (ROOT / name).is_file()]
    texts = {name: (ROOT / name).read_text(encoding="utf-8", errors="replace") for name in sources}
    cmake = "".join(path.read_text(encoding="utf-8") for path in (ROOT / "tests").rglob("*.cmake"))
    cmake += "".join(path.read_text(encoding="utf-8") for path in (ROOT / "tests").rglob("CMakeLists.txt"))
    unused = []
    for file in sorted(claiming):
        path = Path(file)
        if file.endswith("_test.cpp"):
            is_run = path.name in cmake
        elif is_test(file):
            is_run = True
        elif path.parts[1] == "scoreboard":  # which reads its whole folder
            is_run = path.parent.name == "expectations"
        else:  # a package by its folder, else what another file of the tests imports
            word = path.parts[2] if path.parts[1] == "packages" else path.name
            is_run = any(word in text for name, text in texts.items() if name != file)
        if not is_run:
            unused.append(file)
    return unused


def table(kind: str, rows: Rows) -> str:
    """Returns the Markdown table of a kind."""
    head = "| what | shown by |\n| --- | --- |\n"
    if kind in TWO_CELLS:
        head = f"{TWO_CELLS[kind]} shown by |\n| --- | --- | --- |\n"
    lines = []
    for text, files in rows.items():
        cells = text.split(" -> ", 1) if kind in TWO_CELLS else [text]
        if len(cells) != (2 if kind in TWO_CELLS else 1):
            raise SystemExit(f"{files[0]}: `{text}` does not say how or why, behind ` -> `")
        if kind == "cannot":
            check_code(files[0], cells[1])
        lines.append(f"| {' | '.join([*cells, ', '.join(files)])} |\n")
    return head + "".join(lines)


def page(name: str, old: str, rows: dict[str, Rows]) -> str:
    """Returns the page with its tables as the tests say."""
    for kind in PAGES[name]:
        begin, end = f"<!-- made from the tests: {kind} -->\n", "<!-- end -->\n"
        before, found, rest = old.partition(begin)
        _, ended, after = rest.partition(end)
        if not found or not ended:
            raise SystemExit(f"{name} has no place for the table `{kind}`")
        old = before + begin + table(kind, rows[kind]) + end + after
    return old


def threat_faults(text: str, rows: dict[str, Rows]) -> list[str]:
    """What is wrong with the table of threats: each row must name tests, and each must show a guarantee of safety."""
    kinds = ("hostile input", "verified", "robust")
    showing = {file for kind in kinds for files in rows[kind].values() for file in files}
    lines = [line.strip().strip("|").split(" | ") for line in text.splitlines() if line.startswith("| ")]
    threats = [[cell.strip() for cell in cells] for cells in lines[1:] if not cells[0].strip().startswith("---")]
    faults = []
    for cells in threats:
        tests = cells[3].split(", ") if len(cells) == 4 else []
        if not tests or "" in tests:
            faults.append(f"`{cells[0]}` names no test")
        faults += [f"`{cells[0]}`: {name} shows no guarantee" for name in tests if name and name not in showing]
    # Nobody of these may be forgotten.
    everybody = (
        "channel", "mirror", "package", "workspace", "lab's author", "visitor's link", "page that shows a site")
    for who in everybody:
        if not any(who in cells[0] for cells in threats):
            faults.append(f"there is no row for a {who}")
    return faults


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--check", action="store_true", help="fail when a page is not current")
    options = parser.parse_args()
    rows = all_claims()
    stale = False
    for name in PAGES:
        old = (ROOT / name).read_text(encoding="utf-8")
        new = page(name, old, rows)
        if new == old:
            continue
        stale = True
        if options.check:
            print(f"{name} is not current: run tests/tools/claims.py", file=sys.stderr)
        else:
            (ROOT / name).write_text(new, encoding="utf-8")
    for file in unused_files(rows):
        print(f"{file} claims something, and no suite runs it", file=sys.stderr)
        stale = True
    faults = threat_faults((ROOT / THREATS).read_text(encoding="utf-8"), rows)
    for fault in faults:
        print(f"{THREATS}: {fault}", file=sys.stderr)
    return 1 if faults or (stale and options.check) else 0


if __name__ == "__main__":
    sys.exit(main())
