#!/usr/bin/env python3
"""Checks that no native code calls a function of std::filesystem in its throwing form.

Errors are values, and a removed folder, a missing right or a link circle is not a bug of the program. The form with a
`std::error_code` as its last argument reports them; `absolute_path`, `real_path` and others of bundler/io/files.hpp
give them as diagnostics.
"""
from __future__ import annotations

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = ("cli", "bundler", "workspace_schema")
NAMES = (
    "absolute", "canonical", "weakly_canonical", "relative", "proximate", "copy", "copy_file", "copy_symlink",
    "create_directory", "create_directories", "create_directory_symlink", "create_hard_link", "create_symlink",
    "current_path", "equivalent", "exists", "file_size", "hard_link_count", "is_block_file", "is_character_file",
    "is_directory", "is_empty", "is_fifo", "is_other", "is_regular_file", "is_socket", "is_symlink", "last_write_time",
    "permissions", "read_symlink", "remove", "remove_all", "rename", "resize_file", "space", "status", "symlink_status",
    "temp_directory_path", "directory_iterator", "recursive_directory_iterator",
)
CALL = re.compile(r"\b(?:fs|std::filesystem)::(" + "|".join(NAMES) + r")\b(?:\s+\w+)?\s*([({])")
# A file_status is looked at, not a file: these cannot fail.
OF_STATUS = re.compile(r"^\s*(?:\w*status\w*|(?:fs|std::filesystem)::(?:symlink_)?status\(.*\))\s*$", re.DOTALL)
# The variable that takes the error is named after what it is for.
TAKES_ERROR = re.compile(r",\s*\w*(?:error|ignored|none)\w*\s*$|^\s*(?:error|ignored)\s*$")
# Members of an entry, and steps of an iterator, throw likewise.
MEMBER = re.compile(r"(?:->|\.)(?:is_(?:directory|regular_file|symlink|other)|file_size|symlink_status|exists)\(\)")
LOOP = re.compile(r"for \([^;()]*:\s*(?:fs|std::filesystem)::(?:recursive_)?directory_iterator")


def arguments_from(text: str, begin: int) -> str:
    """What is between the bracket in front of `begin` and its partner."""
    depth, end = 1, begin
    while end < len(text) and depth:
        depth += (text[end] in "({") - (text[end] in ")}")
        end += 1
    return text[begin:end - 1]


def throwing_calls(text: str) -> list[tuple[int, str]]:
    """The line and the text of each call that throws."""
    found: list[tuple[int, str]] = []
    for call in CALL.finditer(text):
        arguments = arguments_from(text, call.end())
        end_of_walk = call[1].endswith("iterator") and not arguments.strip()
        looks_at_status = call[1].startswith(("is_", "exists")) and OF_STATUS.match(arguments)
        if not end_of_walk and not looks_at_status and not TAKES_ERROR.search(arguments):
            found.append((call.start(), call[0] + arguments))
    for pattern in (MEMBER, LOOP):
        found += [(match.start(), match[0]) for match in pattern.finditer(text)]
    return sorted((text.count("\n", 0, at) + 1, " ".join(said.split())) for at, said in found)


def main() -> int:
    faults = []
    for folder in FOLDERS:
        for path in sorted((ROOT / folder).rglob("*.?pp")):
            for line, call in throwing_calls(path.read_text(encoding="utf-8")):
                faults.append(f"{path.relative_to(ROOT)}:{line}: `{call[:60]}` throws; give it a std::error_code")
    print("\n".join(faults) or "no call throws")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
