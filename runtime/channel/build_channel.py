#!/usr/bin/env python3
"""Builds every ROS package under runtime/packages/ for the site and makes the embedded channel of them.

  build_channel.py --cli build/ros2wasm --out build/channel

A package is built when its sources, what it needs, the compiler or the tools have changed; a run with
nothing to do takes a fraction of a second. Packages that do not depend on each other build at once, those
first for which most of the rest waits, so that no core is idle at the end. With --for only the packages that the
workspace needs are built; the others stay as they are and follow with the next run without it.
"""
from __future__ import annotations

import argparse
import json
import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from pathlib import Path
from typing import Any

sys.dont_write_bytecode = True

from fingerprint import Compiler, find_compiler, linker_digest, package_keys, packer_digest, with_parts  # noqa: E402
from metadata import ABI_PACKAGE, CLIENT_ABI_PACKAGE, abi_record, client_abi_record, record  # noqa: E402
from package_source import PackageSource, find_packages, longest_first, needed_by  # noqa: E402
from stage import BuildFailure, Workshop, build_package  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
LOG_LINES_SHOWN = 40


def say(text: str) -> None:
    print(text, file=sys.stderr, flush=True)


def read_state(path: Path) -> dict[str, Any]:
    """Returns what the last run built: package -> its key and its record."""
    try:
        state = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return state if isinstance(state, dict) else {}


def write_state(path: Path, state: dict[str, Any]) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    beside = path.with_suffix(".new")
    beside.write_text(json.dumps(state, indent=1, sort_keys=True) + "\n", encoding="utf-8")
    beside.replace(path)


def all_metas(work: Path) -> list[dict[str, Any]]:
    """Returns the records of all packages that were built, with whichever compiler."""
    return [entry["meta"] for file in sorted(work.glob("*/state.json")) for entry in read_state(file).values()]


def archive_of(out: Path, meta: dict[str, Any]) -> Path:
    return out / str(meta["subdir"]) / f"{meta['name']}-{meta['version']}-{meta['build']}.conda"


class Channel:
    """The channel folder, written through the command line of ros2wasm."""

    def __init__(self, cli: Path, out: Path) -> None:
        self._cli, self._out = cli, out

    def add(self, meta: dict[str, Any], tree: Path, scratch: Path) -> None:
        """Packs a tree."""
        scratch.parent.mkdir(parents=True, exist_ok=True)
        scratch.write_text(json.dumps(meta, indent=1, sort_keys=True), encoding="utf-8")
        self._run("channel", "add", str(self._out), "--prefix", str(tree), "--metadata", str(scratch))

    def keep_only(self, metas: list[dict[str, Any]]) -> None:
        """Removes archives of earlier builds."""
        kept = {archive_of(self._out, meta) for meta in metas}
        for archive in self._out.glob("*/*.conda"):
            if archive not in kept:
                archive.unlink()

    def index(self) -> None:
        self._run("channel", "index", str(self._out))

    def _run(self, *arguments: str) -> None:
        done = subprocess.run([str(self._cli), *arguments], stdin=subprocess.DEVNULL, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        if done.returncode != 0:
            raise RuntimeError(f"ros2wasm {' '.join(arguments[:2])} failed:\n{done.stdout}")


def build_changed(workshop: Workshop, packages: dict[str, PackageSource], changed: list[str], jobs: int,
                  done: Callable[[str, Path], None]) -> None:
    """Builds the changed packages, each after those it needs; calls `done(name, tree)` for each."""
    waiting = list(changed)
    running: dict[Future[Path], str] = {}
    with ThreadPoolExecutor(max_workers=jobs) as pool:
        while waiting or running:
            unfinished = {*waiting, *running.values()}
            for name in [n for n in waiting if not unfinished.intersection(packages[n].build_needs)]:
                if len(running) >= jobs:
                    break
                waiting.remove(name)
                running[pool.submit(build_package, workshop, packages[name])] = name
            finished, _ = wait(running, return_when=FIRST_COMPLETED)
            for future in finished:
                name = running.pop(future)
                done(name, future.result())


def run(options: argparse.Namespace) -> int:
    compiler: Compiler = with_parts(find_compiler(options.emscripten), options.cli)
    every = find_packages(ROOT / "runtime" / "packages")
    packages = every if options.workspace is None else needed_by(options.workspace, every)
    toolchain = ROOT / "templates" / "toolchain"
    keys = package_keys(every, compiler, Path(__file__).parent, toolchain)
    work: Path = options.work or options.out.parent / "channel-work"
    workshop = Workshop(work / f"{compiler.tag}-{compiler.digest[:8]}", compiler, toolchain, options.cli, options.jobs)
    # Built by the same version with other parts: a site with packages of both would not link.
    outdated = [one for one in work.glob(f"{compiler.tag}-*") if one != workshop.folder]
    for one in outdated:
        shutil.rmtree(one)
    state_file = workshop.folder / "state.json"
    state = read_state(state_file)
    channel = Channel(options.cli, options.out)

    packer, linker = packer_digest(ROOT), linker_digest(ROOT)

    def is_built(name: str) -> bool:
        tree = workshop.tree(name)
        return (name in state and state[name]["key"] == keys[name] and tree.is_dir()
                and (state[name]["linker"] == linker or not any(tree.glob("lib/*/*.wasm"))))

    def is_packed(name: str) -> bool:
        return state[name]["packer"] == packer and archive_of(options.out, state[name]["meta"]).exists()

    changed = [name for name in longest_first(packages) if not is_built(name)]
    unpacked = [name for name in packages if name not in changed and not is_packed(name)]
    gone = [name for name in state if name not in every and name not in (ABI_PACKAGE, CLIENT_ABI_PACKAGE)]
    abi = abi_record(compiler)
    musl = compiler.cxx.resolve().parent / "system" / "lib" / "libc" / "musl" / "COPYRIGHT"
    abi["license_files"] = [str(musl)] if musl.exists() else []
    markers = [abi, client_abi_record(every)]
    index_there = (options.out / "noarch" / "repodata.json").exists()
    is_current = index_there and all(archive_of(options.out, marker).exists() for marker in markers)
    if is_current and not (changed or unpacked or gone or outdated):
        return 0

    count = 0

    def packed(name: str, tree: Path) -> None:
        nonlocal count
        count += 1
        meta = record(packages[name], every, tree, compiler)
        meta["license_files"] = [str(path) for path in (ROOT / "LICENSE", tree / "share" / name / "copyright")
                                 if path.exists()]
        channel.add(meta, tree, workshop.folder / "meta" / f"{name}.json")
        state[name] = {"key": keys[name], "packer": packer, "linker": linker, "meta": meta}
        write_state(state_file, state)
        say(f"[{count}/{len(changed) + len(unpacked)}] {name} {meta['version']}")

    for name in gone:
        del state[name]
    empty = workshop.folder / "trees" / "empty"
    empty.mkdir(parents=True, exist_ok=True)
    for marker in markers:
        name = str(marker["name"])
        channel.add(marker, empty, workshop.folder / "meta" / f"{name}.json")
        state[name] = {"key": compiler.version, "packer": packer, "linker": linker, "meta": marker}
    for name in unpacked:
        packed(name, workshop.tree(name))
    try:
        build_changed(workshop, packages, changed, options.jobs, packed)
    except BuildFailure as failure:
        lines = failure.log.read_text(encoding="utf-8", errors="replace").splitlines()
        say("\n".join(lines[-LOG_LINES_SHOWN:]))
        say(str(failure))
        return 1
    write_state(state_file, state)
    channel.keep_only(all_metas(work))
    channel.index()
    return 0


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--cli", type=Path, required=True, help="the ros2wasm binary")
    parser.add_argument("--out", type=Path, required=True, help="the channel's folder")
    parser.add_argument("--work", type=Path, help="folder for builds (default: channel-work beside --out)")
    parser.add_argument("--emscripten", type=Path, help="folder of em++ (default: EMSDK's, else on PATH)")
    parser.add_argument("--for", dest="workspace", type=Path, metavar="FOLDER",
                        help="builds only what the packages below this folder need")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    options = parser.parse_args()
    options.cli, options.out = options.cli.resolve(), options.out.resolve()
    if shutil.which("cmake") is None or shutil.which("ninja") is None:
        say("cmake and ninja are needed: `sudo apt-get install cmake ninja-build`")
        return 1
    try:
        return run(options)
    except (OSError, ValueError, RuntimeError) as error:
        say(f"build_channel: {error}")
        return 1


if __name__ == "__main__":
    sys.exit(main())
