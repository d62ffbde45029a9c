#!/usr/bin/env python3
"""Checks that every file that a document names exists.

A path counts from the root of the repository when it begins with one of the top folders. Parts in capitals stand for a
name (cli/explain/CODE.md). In the tables of ARCHITECTURE.md a name without a folder must be that of some file.
"""
from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

TOPS = "cli|bundler|workspace_schema|runtime|templates|examples|tests|docs"
ENDINGS = "ts|tsx|cpp|hpp|py|mjs|cmake"
PATH = re.compile(rf"(?<![\w/.:-])((?:{TOPS})/[\w./-]*\w)")
BARE = re.compile(rf"(?<![\w/.*-])(\w+\.(?:{ENDINGS}))\b")
PLACEHOLDER = re.compile(r"(^|/)[A-Z]{2,}(?=[/.]|$)")


def faults(document: Path, names: set[str]) -> list[str]:
    """`names`: those of all files of the repository, without their folders."""
    errors = []
    for number, line in enumerate(document.read_text(encoding="utf-8").splitlines(), 1):
        where = f"{document.relative_to(ROOT)}:{number}"
        absent = [path for path in PATH.findall(line)
                  if "." in path.rpartition("/")[2] and not PLACEHOLDER.search(path) and not (ROOT / path).exists()]
        if document.name == "ARCHITECTURE.md" and line.startswith("|"):
            absent += [name for name in BARE.findall(line) if name not in names]
        errors += [f"{where}: there is no {path}" for path in absent]
    return errors


def tracked() -> list[Path]:
    out = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=ROOT, capture_output=True, text=True,
                         check=True)
    return [ROOT / name for name in out.stdout.splitlines() if (ROOT / name).is_file()]


def main() -> int:
    files = tracked()
    names = {file.name for file in files}
    problems = [fault for file in files if file.suffix == ".md" for fault in faults(file, names)]
    print("\n".join(problems) if problems else "documents: every file that is named exists")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
