#!/usr/bin/env python3
"""Counts phrases that docs/STYLE.md replaces, in each file, and fails where a change adds one.

`--record` writes the counts of today. They only go down: a file with fewer than recorded is asked to be recorded, so
that what was removed cannot come back.
"""
from __future__ import annotations

import argparse
import json
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
RECORD = ROOT / "tests/tools/english.json"
SUFFIXES = (".cpp", ".hpp", ".h", ".ts", ".tsx", ".mjs", ".py", ".md")
# These quote what they replace, or belong to others' packages.
EXEMPT = ("docs/STYLE.md", "tests/tools/english.py", "tests/unit/tools/english_test.py", "tests/packages/")
PATTERNS = (
    # "there is no such file" is good English.
    ("is no ...", re.compile(r"(?<!there )(?<!There )\b[Ii]s no (?!longer\b|such\b|more\b|other\b)`?[A-Za-z]")),
    # A question has its mark in the same line.
    ("a comment that begins with What, Of, Who or Whose",
     re.compile(r"^\s*(?://+!?<?|#|\*|/\*\*)\s*(?:What|Of|Who|Whose|Whoever)\s(?![^\n]*\?)", re.MULTILINE)),
)


def phrases(text: str) -> list[tuple[int, str]]:
    """The line and the kind of each phrase."""
    return sorted((text.count("\n", 0, match.start()) + 1, kind)
                  for kind, pattern in PATTERNS for match in pattern.finditer(text))


def counted() -> dict[str, list[tuple[int, str]]]:
    """Of each file that has any."""
    names = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=ROOT, capture_output=True, text=True,
                           check=True).stdout.splitlines()
    found = {}
    for name in sorted(set(names)):
        path = ROOT / name
        if not name.endswith(SUFFIXES) or name.startswith(EXEMPT) or not path.is_file():
            continue
        rows = phrases(path.read_text(encoding="utf-8", errors="replace"))
        if rows:
            found[name] = rows
    return found


def faults(found: dict[str, list[tuple[int, str]]], recorded: dict[str, int]) -> list[str]:
    """What has become more, by file, and what has become less and is not recorded yet."""
    result = []
    for name, rows in found.items():
        most = recorded.get(name, 0)
        if len(rows) > most:
            result += [f"{name}:{line}: {kind} (docs/STYLE.md)" for line, kind in rows]
            result.append(f"{name}: {len(rows)} such phrases, at most {most} may stay")
    fewer = [name for name, most in recorded.items() if len(found.get(name, [])) < most]
    if fewer:
        result.append(f"fewer than recorded in {', '.join(fewer[:5])}: run tests/tools/english.py --record")
    return result


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--record", action="store_true")
    options = parser.parse_args()
    found = counted()
    if options.record:
        counts = {name: len(rows) for name, rows in found.items()}
        RECORD.write_text(json.dumps(counts, indent=1, sort_keys=True) + "\n", encoding="utf-8")
        print(f"{sum(counts.values())} phrases in {len(counts)} files")
        return 0
    recorded = json.loads(RECORD.read_text(encoding="utf-8"))
    problems = faults(found, recorded)
    print("\n".join(problems))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
