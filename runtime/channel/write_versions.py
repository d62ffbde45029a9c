#!/usr/bin/env python3
"""Writes docs/upstream-versions.md from runtime/versions.json; --check only compares.

The table names, for every ROS package that one of ours stands for, the upstream release it follows.
"""
from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "upstream-versions.md"
TABLE = ROOT / "runtime" / "versions.json"


def read_of(entry: dict[str, str]) -> str:
    """Returns which release's interface ours has, where the newest one could not be read."""
    return f" (as read in {entry['read']})" if "read" in entry else ""


def page(table: dict[str, Any]) -> str:
    """Returns the Markdown text for a parsed versions.json."""
    rows = "".join(
        f"| {name} | {entry['version']}{read_of(entry)} | {entry['repository']} |\n"
        for name, entry in sorted(table["packages"].items())
    )
    return (
        "# Upstream versions\n\n"
        "<!-- Made from runtime/versions.json by runtime/channel/write_versions.py; do not edit. -->\n\n"
        f"A package of ours that stands for a ROS 2 {table['distro'].capitalize()} package has that "
        "package's name, version and public\ninterface. The versions are those released on "
        f"{table['as_of']} ({table['source']}).\nNewer upstream releases of the same distribution "
        "may exist. The table also names packages that are planned; build/channel has those that exist.\n\n"
        "| package | version | upstream repository |\n| --- | --- | --- |\n" + rows
    )


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--check", action="store_true", help="fail when the page is not current")
    options = parser.parse_args()
    text = page(json.loads(TABLE.read_text(encoding="utf-8")))
    if options.check:
        if PAGE.exists() and PAGE.read_text(encoding="utf-8") == text:
            return 0
        print(f"{PAGE.relative_to(ROOT)} is not current: run runtime/channel/write_versions.py", file=sys.stderr)
        return 1
    PAGE.parent.mkdir(exist_ok=True)
    PAGE.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
