#!/usr/bin/env python3
"""Compiles the evaluation of launch files, which is the native half's own code, to launch_evaluator.wasm.

  build.py --out build/launch

A source is compiled when it, a header of it, the compiler or the flags have changed. The same sources give the same
bytes.
"""
from __future__ import annotations

import argparse
import hashlib
import json
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "runtime" / "channel"))

from fingerprint import find_compiler  # noqa: E402

# The folders of the native half that are pure, and two files of it.
LAUNCH = ("bundler/launch", "bundler/launch/python", "bundler/launch/xacro")
SCHEMA = ("workspace_schema/base",)
OTHER = ("bundler/render/launch_start.cpp", "bundler/render/site_node_json.cpp",
         "runtime/launch_evaluator/evaluator.cpp")
# Files of a folder are compiled several at a time, in so many groups: see compile_in_groups in CMakeLists.txt.
GROUPS = {"launch": 13, "workspace_schema": 4, "yaml-cpp": 2}
# As templates/toolchain/ compiles programs, for one thread.
FLAGS = ("-std=c++20", "-Oz", "-fwasm-exceptions", "-DNDEBUG")
LINK_FLAGS = ("-Oz", "-fwasm-exceptions", "-sSTANDALONE_WASM", "--no-entry", "-sALLOW_MEMORY_GROWTH",
              "-sMAXIMUM_MEMORY=1GB", "-sTOTAL_STACK=8MB",
              # Emscripten knows nothing of imports of other modules: those of evaluator.cpp.
              "-sERROR_ON_UNDEFINED_SYMBOLS=0", "-sWARN_ON_UNDEFINED_SYMBOLS=0")


class BuildFailure(Exception):
    """What the compiler said."""


def sources_of(folders: tuple[str, ...]) -> list[Path]:
    return [file for folder in folders for file in sorted((ROOT / folder).glob("*.cpp"))]


def units(debian: Path) -> dict[str, list[Path]]:
    """What is compiled at once, by name. A file's group comes of its name."""
    grouped = {
        "launch": sources_of(LAUNCH),
        "workspace_schema": sources_of(SCHEMA),
        "yaml-cpp": sorted((debian / "yaml-cpp/src").glob("*.cpp")),
    }
    alone = [*(ROOT / name for name in OTHER), debian / "tinyxml2/tinyxml2.cpp"]
    result = {file.stem: [file] for file in alone}
    for folder, files in grouped.items():
        for file in files:
            group = int(hashlib.md5(file.name.encode()).hexdigest()[:6], 16) % GROUPS[folder]
            result.setdefault(f"{folder}_{group}", []).append(file)
    return result


def digest(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def relative(path: Path) -> str:
    """To where the compiler runs, so that neither objects nor what is known of them depend on the place."""
    return os.path.relpath(path, ROOT)


def dependencies(rule: str) -> list[str]:
    """The files of a make rule, as -MMD writes it."""
    return sorted(set(rule.split(":", 1)[1].replace("\\\n", " ").split()))


class Builder:
    def __init__(self, compiler: Path, tag: str, debian: Path, out: Path) -> None:
        self._compiler, self._tag, self._debian, self._out = compiler, tag, debian, out
        self._objects = out / "objects"
        self._objects.mkdir(parents=True, exist_ok=True)
        version = (ROOT / "VERSION").read_text(encoding="utf-8").strip()
        includes = [ROOT / "runtime/launch_evaluator/include", ROOT, debian / "yaml-cpp/include", debian / "tinyxml2"]
        self._flags = [*FLAGS, f'-DROS2WASM_VERSION="{version}"', *(f"-I{relative(folder)}" for folder in includes),
                       # nlohmann/json.hpp, whose library has headers only
                       "-idirafter", "/usr/include"]

    def _run(self, *arguments: str) -> None:
        environment = {"NODE_PATH": "/usr/share/nodejs", **os.environ}
        # The user's, such as ccache, as CMake has it.
        if launcher := os.environ.get("CMAKE_CXX_COMPILER_LAUNCHER"):
            environment.setdefault("EM_COMPILER_WRAPPER", launcher)
        done = subprocess.run([str(self._compiler), *arguments], stdin=subprocess.DEVNULL, text=True, env=environment,
                              cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        if done.returncode != 0:
            raise BuildFailure(done.stdout)

    def _key(self) -> str:
        return hashlib.sha256("\0".join([self._tag, *self._flags]).encode()).hexdigest()

    def _is_current(self, state: Path, made: Path) -> bool:
        try:
            known: dict[str, Any] = json.loads(state.read_text(encoding="utf-8"))
            return bool(made.exists() and known["key"] == self._key()
                        and all(digest(ROOT / name) == hashed for name, hashed in known["files"].items()))
        except (OSError, ValueError, KeyError):
            return False

    def compile(self, name: str, sources: list[Path]) -> Path:
        unit, made, state, rule = (self._objects / f"{name}{ending}" for ending in (".cpp", ".o", ".json", ".d"))
        unit.write_text("".join(f'#include "{relative(source)}"\n' for source in sources), encoding="utf-8")
        if self._is_current(state, made):
            return made
        state.unlink(missing_ok=True)
        self._run(*self._flags, "-MMD", "-MF", str(rule), "-c", relative(unit), "-o", str(made))
        files = {file: digest(ROOT / file) for file in dependencies(rule.read_text(encoding="utf-8"))}
        state.write_text(json.dumps({"key": self._key(), "files": files}), encoding="utf-8")
        return made

    def link(self, objects: list[Path]) -> Path:
        made, state = self._out / "launch_evaluator.wasm", self._out / "launch_evaluator.link"
        key = hashlib.sha256("\0".join([*LINK_FLAGS, self._tag, *map(digest, objects)]).encode()).hexdigest()
        if made.exists() and state.exists() and state.read_text(encoding="utf-8") == key:
            return made
        self._run(*LINK_FLAGS, *map(str, objects), "-o", str(made))
        state.write_text(key, encoding="utf-8")
        return made


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--out", type=Path, required=True, help="folder of launch_evaluator.wasm")
    parser.add_argument("--sources", type=Path, default=ROOT / "build" / "sources", help="Debian's sources")
    parser.add_argument("--emscripten", type=Path, help="folder of em++ (default: EMSDK's, else on PATH)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    options = parser.parse_args()
    try:
        for name in ("tinyxml2", "yaml-cpp"):
            if not (options.sources / name).is_dir():
                raise FileNotFoundError(f"there is no {options.sources / name}: `./dev setup` fetches Debian's sources")
        compiler = find_compiler(options.emscripten)
        builder = Builder(compiler.cxx, compiler.digest, options.sources.resolve(), options.out.resolve())
        with ThreadPoolExecutor(max_workers=options.jobs) as pool:
            objects = list(pool.map(lambda unit: builder.compile(*unit), units(options.sources.resolve()).items()))
        builder.link(objects)
    except (OSError, BuildFailure) as error:
        print(f"launch_evaluator: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
