#!/usr/bin/env python3
"""Checks that nothing points up: the layer rules of ARCHITECTURE.md, read off the includes and imports.

An import of a type counts like any other. No two files of the site import each other, however long the way round.
"""
from __future__ import annotations

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

NATIVE = ("workspace_schema", "bundler", "cli")
# The folders of the bundler, from the ground up. Files beside them put the steps together and may use all.
BUNDLER = ("io", "archive", "channel", "store", "resolve", "site", "workspace", "build", "languages", "launch",
           "render", "plan", "verify", "emit", "serve", "run")
# Folders within a folder, and the neighbours that each uses beside itself.
PARTS = {
    "workspace_schema": {"base": (), "conda": ("base",), "schema": ("base", "conda")},
    "bundler/launch": {"python": (), "xacro": ("", "python"), "": ("python", "xacro"), "host": ("", "python", "xacro")},
}
SITE = "runtime/site"
# The floors of the site, from the ground up: a file uses those of its own floor and of lower ones.
FLOORS = ("contract", "bus", "program", "python", "workers", "launch", "page", "checks", "session")
# Beside them: each sees the floors `contract` and what is named here, and nothing else of the site.
ROOMS: dict[str, set[str]] = {
    "decode": set(),
    "bag": {"decode"},
    "ros2cli": {"bag", "decode"},
    "ui": {"bag", "decode", "ros2cli"},
}
# Floors that look into messages; the others know only their bytes.
MESSAGE_READERS = ("page", "checks", "session")
# Rules of names are not messages.
NAMES = f"{SITE}/decode/ros_names.ts"
# Files above `contract` that a room may use, and why.
DOORS: dict[str, set[str]] = {
    # The page starts the session, and reads the files of a site that carries them in its page.
    "ui": {"session/launcher.ts", "program/carried_files.ts", "program/page_files.ts"},
    "ros2cli": set(),
    "bag": set(),
    "decode": set(),
}
# Programs for Node.js open the site themselves.
MAINS: dict[str, set[str]] = {
    "ros2cli/headless_main.ts": {"session/headless_session.ts", "session/site_session.ts", "session/coming_up.ts"},
    "ros2cli/headless_run_main.ts": {"session/headless_session.ts", "session/headless_run.ts"},
}
NATIVE_INCLUDE = re.compile(r'^\s*#\s*include\s*["<]([\w./-]+)[">]', re.MULTILINE)
SCRIPT_IMPORT = re.compile(r"""(?:from|import)\s*\(?\s*['"](\.{1,2}/[^'"]+)['"]""")


def imports_of(file: Path) -> list[str]:
    """The paths, from the root of the repository, of what a script imports."""
    found = []
    for target in SCRIPT_IMPORT.findall(file.read_text(encoding="utf-8")):
        resolved = (file.parent / target).resolve()
        if resolved.is_relative_to(ROOT):
            found.append(resolved.relative_to(ROOT).as_posix())
    return found


def place_in_site(path: str) -> tuple[str, str] | None:
    """(folder, rest) of a file of the site."""
    if not path.startswith(SITE + "/"):
        return None
    folder, _, rest = path.removeprefix(SITE + "/").partition("/")
    return folder, rest


def fault_of_import(name: str, used: str) -> str | None:
    """Why a file of the site may not import another file; None when it may."""
    here, there = place_in_site(name), place_in_site(used)
    if here is None:
        return None
    folder, rest = here
    if there is None:
        is_protocol = used.startswith("runtime/protocol/generated/")
        return None if is_protocol else "the site uses nothing of the repository but the constants of the protocol"
    other, other_rest = there
    if folder == other or used == NAMES:
        return None
    if folder in FLOORS:
        if other in FLOORS:
            return "it is on a higher floor" if FLOORS.index(other) > FLOORS.index(folder) else None
        if other != "decode":
            return "floors do not use what stands beside them"
        return None if folder in MESSAGE_READERS else "this floor knows no messages"
    if other in ROOMS[folder] or other == "contract":
        return None
    door = f"{other}/{other_rest}"
    if door in DOORS[folder] or door in MAINS.get(f"{folder}/{rest}", set()):
        return None
    return f"{folder} sees only {', '.join(['contract', *sorted(ROOMS[folder]), *sorted(DOORS[folder])])}"


def circles(graph: dict[str, list[str]]) -> list[list[str]]:
    """Groups of files that import each other, directly or not (Tarjan's algorithm, without recursion)."""
    number: dict[str, int] = {}
    low: dict[str, int] = {}
    stack: list[str] = []
    found: list[list[str]] = []
    for root in graph:
        if root in number:
            continue
        work = [(root, iter(graph[root]))]
        number[root] = low[root] = len(number)
        stack.append(root)
        while work:
            node, rest = work[-1]
            after = next((one for one in rest if one in graph), None)
            if after is not None:
                if after not in number:
                    number[after] = low[after] = len(number)
                    stack.append(after)
                    work.append((after, iter(graph[after])))
                elif after in stack:
                    low[node] = min(low[node], number[after])
                continue
            work.pop()
            if work:
                low[work[-1][0]] = min(low[work[-1][0]], low[node])
            if low[node] == number[node]:
                at = stack.index(node)
                if len(stack) - at > 1:
                    found.append(sorted(stack[at:]))
                del stack[at:]
    return found


def native_faults() -> list[str]:
    """Includes between the folders of the command line, and between it and what runs in a site."""
    errors = []
    for index, folder in enumerate(NATIVE):
        for file in sorted((ROOT / folder).rglob("*.?pp")):
            name = file.relative_to(ROOT).as_posix()
            for used in NATIVE_INCLUDE.findall(file.read_text(encoding="utf-8")):
                top = used.partition("/")[0]
                if top in NATIVE and NATIVE.index(top) > index:
                    errors.append(f"{name}: uses {used}; {folder} is below {top}")
                if top == "runtime":
                    errors.append(f"{name}: uses {used}; the command line includes nothing of the site")
    return errors


def bundler_faults() -> list[str]:
    """Includes between the folders of the bundler that point up."""
    errors = []
    for file in sorted((ROOT / "bundler").rglob("*.?pp")):
        name = file.relative_to(ROOT / "bundler").as_posix()
        folder, _, rest = name.partition("/")
        if not rest:
            continue
        if folder not in BUNDLER:
            errors.append(f"bundler/{name}: there is no such folder; {', '.join(BUNDLER)}")
            continue
        for used in NATIVE_INCLUDE.findall(file.read_text(encoding="utf-8")):
            other, _, there = used.removeprefix("bundler/").partition("/")
            if not used.startswith("bundler/") or (there and other not in BUNDLER):
                continue
            if not there or BUNDLER.index(other) > BUNDLER.index(folder):
                above = other if there else "what joins the steps"
                errors.append(f"bundler/{name}: uses {used}; {folder} is below {above}")
    return errors


def part_of(path: str, top: str) -> str:
    """The folder within `top` that a file is in; empty for `top` itself."""
    return path.removeprefix(top + "/").rpartition("/")[0]


def part_faults() -> list[str]:
    """Includes between the parts of a folder that it does not allow."""
    errors = []
    for top, parts in PARTS.items():
        for file in sorted((ROOT / top).rglob("*.?pp")):
            name = file.relative_to(ROOT).as_posix()
            part = part_of(name, top)
            if part not in parts:
                errors.append(f"{name}: there is no such part of {top}; {', '.join(filter(None, parts))}")
                continue
            for used in NATIVE_INCLUDE.findall(file.read_text(encoding="utf-8")):
                other = part_of(used, top)
                if used.startswith(top + "/") and other != part and other not in parts[part]:
                    errors.append(f"{name}: uses {used}; {part or top} does not know {other or top}")
    return errors


def package_faults() -> list[str]:
    """ROS packages of the channel include nothing of the command line or of the site."""
    errors = []
    for manifest in sorted((ROOT / "runtime" / "packages").glob("*/*/package.xml")):
        for file in sorted(manifest.parent.rglob("*.?pp")):
            name = file.relative_to(ROOT).as_posix()
            for used in NATIVE_INCLUDE.findall(file.read_text(encoding="utf-8")):
                if used.partition("/")[0] in (*NATIVE, "site", "runtime"):
                    errors.append(f"{name}: uses {used}; packages know the protocol and other packages only")
    return errors


def site_faults() -> list[str]:
    """Imports of the site that point up, and circles."""
    errors = []
    files = [file for file in sorted((ROOT / SITE).rglob("*")) if file.suffix in {".ts", ".tsx"}]
    graph: dict[str, list[str]] = {}
    for file in files:
        name = file.relative_to(ROOT).as_posix()
        folder = name.removeprefix(SITE + "/").partition("/")[0]
        if folder not in FLOORS and folder not in ROOMS:
            errors.append(f"{name}: there is no such floor; {', '.join((*FLOORS, *ROOMS))}")
            continue
        graph[name] = imports_of(file)
        for used in graph[name]:
            fault = fault_of_import(name, used)
            if fault is not None:
                errors.append(f"{name}: uses {used}; {fault}")
    errors += [f"these import each other: {', '.join(circle)}" for circle in circles(graph)]
    return errors


def violations() -> list[str]:
    return native_faults() + bundler_faults() + part_faults() + package_faults() + site_faults()


if __name__ == "__main__":
    problems = violations()
    print("\n".join(problems) if problems else "layers: nothing points up, and nothing goes round")
    sys.exit(1 if problems else 0)
