#!/usr/bin/env python3
"""Checks that nothing points up: the layer rules of ARCHITECTURE.md, read off the includes and imports."""
from __future__ import annotations

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

# folder -> folders it may use besides itself. First matching folder (longest first) wins.
ALLOWED: dict[str, set[str]] = {
    "cli": {"bundler", "workspace_schema"},
    "bundler": {"workspace_schema"},
    "workspace_schema": set(),
    "runtime/ui": {"runtime/bag", "runtime/decode", "runtime/ros2cli", "runtime/wasm_js", "runtime/protocol"},
    "runtime/ros2cli": {"runtime/bag", "runtime/decode", "runtime/wasm_js"},
    "runtime/bag": {"runtime/decode", "runtime/wasm_js"},
    "runtime/decode": set(),
    "runtime/wasm_js": {"runtime/decode", "runtime/protocol"},
    "runtime/protocol": set(),
    "runtime/wasm_cpp": {"runtime/protocol"},
}
# The page sees the runtime through these files only.
UI_DOORS = {
    "session.ts", "launcher.ts", "carried_files.ts", "page_files.ts", "idle.ts", "qos_view.ts", "running_sha256.ts",
}
# Commands and bags know no more than panels do; the programs for Node.js open the site themselves.
COMMAND_DOORS = {"session.ts", "site_error.ts", "launch_arguments.ts", "qos_view.ts"}
HEADLESS_MAINS = {"runtime/ros2cli/headless_main.ts", "runtime/ros2cli/headless_run_main.ts"}
# The bus looks into no message: of the layer that does it uses the rules of names only.
DECODE_DOORS = {"ros_names.ts"}
# Except for what decides a site's checks and tasks, which is beside the bus and loaded for sites that have some.
MESSAGE_READERS = {"check_looks.ts", "check_run.ts", "task_run.ts"}
NATIVE_INCLUDE = re.compile(r'^\s*#\s*include\s*"((?:cli|bundler|workspace_schema)/[^"]+)"', re.MULTILINE)
SCRIPT_IMPORT = re.compile(r"""(?:from|import)\s*\(?\s*['"](\.{1,2}/[^'"]+)['"]""")


def layer_of(path: str) -> str | None:
    for folder in sorted(ALLOWED, key=len, reverse=True):
        if path == folder or path.startswith(folder + "/"):
            return folder
    return None


def used_paths(file: Path, text: str) -> list[str]:
    if file.suffix in {".cpp", ".hpp"}:
        return NATIVE_INCLUDE.findall(text)
    found = []
    for target in SCRIPT_IMPORT.findall(text):
        resolved = (file.parent / target).resolve()
        if resolved.is_relative_to(ROOT):
            found.append(resolved.relative_to(ROOT).as_posix())
    return found


def violations() -> list[str]:
    errors = []
    for folder, allowed in ALLOWED.items():
        for file in sorted((ROOT / folder).rglob("*")):
            if file.suffix not in {".cpp", ".hpp", ".ts", ".tsx"}:
                continue
            name = file.relative_to(ROOT).as_posix()
            if layer_of(name) != folder:
                continue
            for used in used_paths(file, file.read_text(encoding="utf-8")):
                layer = layer_of(used)
                if layer is not None and layer != folder and layer not in allowed:
                    errors.append(f"{name}: uses {used}, but {folder} may not use {layer}")
                reads_messages = layer == "runtime/decode" and Path(used).name not in DECODE_DOORS
                if folder == "runtime/wasm_js" and reads_messages and file.name not in MESSAGE_READERS:
                    errors.append(f"{name}: uses {used}; the bus knows no messages")
                is_command = folder in {"runtime/bag", "runtime/ros2cli"} and name not in HEADLESS_MAINS
                if is_command and layer == "runtime/wasm_js" and Path(used).name not in COMMAND_DOORS:
                    errors.append(f"{name}: uses {used}; commands see only {', '.join(sorted(COMMAND_DOORS))}")
                if folder == "runtime/ui" and layer == "runtime/wasm_js" and Path(used).name not in UI_DOORS:
                    errors.append(f"{name}: uses {used}; the page sees only {', '.join(sorted(UI_DOORS))}")
    return errors


if __name__ == "__main__":
    problems = violations()
    print("\n".join(problems) if problems else "layers: nothing points up")
    sys.exit(1 if problems else 0)
