#!/usr/bin/env python3
"""Builds the CDR conformance driver twice from the type support in a channel's workshop and of
edge_interfaces: as a wasm program, and natively with address and undefined behaviour checks (by clang,
which takes half of gcc's time for these).

  make_driver.py --work build/channel-work/em... --out build/conformance-cdr

Compiles only what has changed. Prints nothing when all goes well.
"""
from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

EDGE = "edge_interfaces"
HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
# rosidl gives it to a message without fields; it has no meaning and is always 0.
EMPTY_MEMBER = "structure_needs_at_least_one_member"
# The type support in question comes optimised from the channel (wasm), or is compiled here (native).
WASM_FLAGS = "-O0 -std=c++17 -fwasm-exceptions -w"
NATIVE_FLAGS = "-O0 -std=c++17 -w"
CHECKED = "-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer"


def build_edge_interfaces(work: Path, build: Path) -> subprocess.CompletedProcess[str]:
    """Builds the package of unusual types as a user's package is built."""
    configure = [
        "cmake", "-G", "Ninja", "-Wno-dev", "-S", str(HERE / EDGE), "-B", str(build),
        f"-DCMAKE_TOOLCHAIN_FILE={ROOT / 'templates/toolchain/ros2wasm-toolchain.cmake'}",
        f"-DCMAKE_PREFIX_PATH={work / 'prefix'}", "-DROS2WASM_CLI=not-needed",
    ]
    done = run(configure)
    return done if done.returncode != 0 else run(["ninja", "-C", str(build), "-j2"])


def run(command: list[str]) -> subprocess.CompletedProcess[str]:
    environment = dict(os.environ)
    environment.setdefault("NODE_PATH", "/usr/share/nodejs")
    return subprocess.run(command, env=environment, stdin=subprocess.DEVNULL, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)


def message_descriptions(folders: list[Path]) -> dict[str, dict[str, Any]]:
    """Returns the descriptions of all messages and message parts, by type name."""
    found: dict[str, dict[str, Any]] = {}
    for file in sorted(file for folder in folders for file in folder.glob("*/*.json")):
        if file.parent.name not in ("msg", "srv", "action"):
            continue
        full = json.loads(file.read_text(encoding="utf-8"))["type_description_msg"]
        for one in (full["type_description"], *full["referenced_type_descriptions"]):
            found[one["type_name"]] = one
    # Services and actions as such are not messages; events are made of parts that are here.
    parts = ("_Request", "_Response", "_Goal", "_Result", "_Feedback", "_FeedbackMessage")
    return {
        name: one for name, one in sorted(found.items())
        if "/msg/" in name or name.endswith(parts)
    }


def struct_header(type_name: str) -> str:
    """Returns the header that defines a message, without builders and traits."""
    package, folder, name = type_name.split("/")
    stem = name.split("_")[0] if folder != "msg" else name
    snake = ""
    for i, c in enumerate(stem):  # as rosidl does: before a capital that begins or ends a word
        if i and c.isupper() and (not stem[i - 1].isupper() or stem[i + 1:i + 2].islower()):
            snake += "_"
        snake += c.lower()
    return f"{package}/{folder}/detail/{snake}__struct.hpp"


def table_source(types: dict[str, dict[str, Any]]) -> str:
    lines = ['#include "driver.hpp"']
    lines += [f'#include "{path}"' for path in sorted({struct_header(name) for name in types})]
    lines += ["", "namespace driver {"]
    for name in types:
        lines += [f"template <> struct Members<::{name.replace('/', '::')}> {{",
                  "  static MemberRows rows();", "};"]
    for name, one in types.items():
        lines += [f"MemberRows Members<::{name.replace('/', '::')}>::rows() {{",
                  f"  using T = ::{name.replace('/', '::')};"]
        fields = [field for field in one["fields"] if field["name"] != EMPTY_MEMBER]
        if fields:
            lines.append("  static constexpr MemberRow rows[] = {")
            for field in fields:
                member, bound = field["name"], field["type"]["string_capacity"]
                operations = f"&kOperations<decltype(T::{member})>"
                lines.append(f'    {{"{member}", offsetof(T, {member}), {operations}, {bound}}},')
            lines += ["  };", "  return {rows, std::size(rows)};", "}"]
        else:
            lines += ["  return {nullptr, 0};", "}"]
    lines += ["std::vector<TypeRow> all_types() {", "  return {"]
    lines += [f'    row<::{name.replace("/", "::")}>(),' for name in types]
    lines += ["  };", "}", "}  // namespace driver", ""]
    return "\n".join(lines)


def write_if_changed(path: Path, text: str) -> None:
    if not path.exists() or path.read_text(encoding="utf-8") != text:
        path.write_text(text, encoding="utf-8")


def ninja_file(work: Path, edge: Path, packages: list[str]) -> str:
    prefix = work / "prefix"
    # Not what stands before the compiler's own library: messages need none of it.
    folders = sorted({*os.listdir(prefix / "include")} - {"ros2wasm_std"})
    includes = [HERE, edge / "rosidl_generator_cpp", edge / "rosidl_typesupport_wasm_cpp",
                *(prefix / "include" / name for name in folders)]
    flags = " ".join(f"-I{path}" for path in includes)
    lines = [
        f"wasm_flags = {WASM_FLAGS} {flags}",
        f"native_flags = {NATIVE_FLAGS} {flags}",
        "rule emxx", "  command = em++ $wasm_flags -MD -MF $out.d -c $in -o $out",
        "  deps = gcc", "  depfile = $out.d",
        "rule emlink",
        "  command = em++ -O1 -fwasm-exceptions -sSTANDALONE_WASM -sALLOW_MEMORY_GROWTH=1 $in -o $out",
        "rule cxx", "  command = clang++-14 $native_flags $checks -MD -MF $out.d -c $in -o $out",
        "  deps = gcc", "  depfile = $out.d",
        "rule link", "  command = clang++-14 -fsanitize=address,undefined $in -o $out",
    ]
    archives, objects, own = [], [], {"driver": HERE / "driver.cpp", "values": HERE / "driver_values.cpp",
                                      "types": Path("types.cpp")}
    for name, source in own.items():
        lines += [f"build wasm/{name}.o: emxx {source}", f"build native/{name}.o: cxx {source}"]
    for name in [EDGE, *packages]:
        build = edge if name == EDGE else work / "build" / name
        source = build / "rosidl_typesupport_wasm_cpp" / name / f"{name}__rosidl_typesupport_wasm_cpp.cpp"
        lines += [f"build native/{name}.o: cxx {source}", f"  checks = {CHECKED}"]
        objects.append(f"native/{name}.o")
        folder = edge if name == EDGE else prefix / "lib"
        archives.append(str(folder / f"lib{name}__rosidl_typesupport_cpp.a"))
    wasm = " ".join(f"wasm/{name}.o" for name in own)
    native = " ".join(f"native/{name}.o" for name in own)
    lines.append(f"build driver.wasm: emlink {wasm} {' '.join(archives)}")
    lines.append(f"build driver: link {native} {' '.join(objects)}")
    return "\n".join(lines) + "\n"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--work", type=Path, required=True, help="folder of one compiler in channel-work")
    parser.add_argument("--out", type=Path, required=True)
    options = parser.parse_args()
    work, out = options.work.resolve(), options.out.resolve()
    out.mkdir(parents=True, exist_ok=True)
    interfaces = sorted(path.name for path in (ROOT / "runtime" / "packages" / "interfaces").iterdir() if path.is_dir())
    edge = out / EDGE
    done = build_edge_interfaces(work, edge)
    if done.returncode == 0:
        share = work / "prefix" / "share"
        types = message_descriptions(
            [*(share / name for name in interfaces), edge / "rosidl_typesupport_wasm_cpp" / EDGE])
        write_if_changed(out / "types.cpp", table_source(types))
        write_if_changed(out / "build.ninja", ninja_file(work, edge, interfaces))
        done = run(["ninja", "-C", str(out), "-j2"])
    if done.returncode != 0:
        print(done.stdout[-8000:], file=sys.stderr)
    return done.returncode


if __name__ == "__main__":
    sys.exit(main())
