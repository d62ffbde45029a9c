"""Builds one package with the site's toolchain and installs it twice: into a tree of its own, to be
packed, and into the common prefix, where the packages that need it find it."""
from __future__ import annotations

import os
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

from fingerprint import Compiler
from package_source import PackageSource

# Baked into CMake files as the place of installation. Nothing is ever there: it keeps paths of the
# build machine out of the packages.
NEUTRAL_PREFIX = "/opt/ros2wasm"
# Set-up scripts for shells have no use in a site's environment and name the build machine's paths.
LEFT_OUT_FILES = ("local_setup.*", "package.dsv", "package.ps1", "package.bash", "package.sh", "package.zsh")


class BuildFailure(Exception):
    """A package did not build; `log` has the whole output."""

    def __init__(self, package: str, log: Path) -> None:
        super().__init__(f"package {package} failed to build; the whole log is {log}")
        self.log = log


@dataclass(frozen=True)
class Workshop:
    """Folders and tools of one channel build with one compiler."""

    folder: Path
    compiler: Compiler
    toolchain: Path  # the folder
    cli: Path
    jobs: int  # processes that this machine runs well at a time

    @property
    def prefix(self) -> Path:
        return self.folder / "prefix"

    def tree(self, package: str) -> Path:
        return self.folder / "trees" / package


def build_package(workshop: Workshop, package: PackageSource) -> Path:
    """Configures, builds and installs; returns the package's own tree. Raises BuildFailure."""
    build = workshop.folder / "build" / package.name
    tree = workshop.tree(package.name)
    log = workshop.folder / "logs" / f"{package.name}.log"
    log.parent.mkdir(parents=True, exist_ok=True)
    environment = dict(os.environ)
    environment.setdefault("NODE_PATH", "/usr/share/nodejs")
    for name in ("AMENT_PREFIX_PATH", "CMAKE_PREFIX_PATH", "COLCON_PREFIX_PATH", "PYTHONPATH"):
        environment.pop(name, None)
    # Caches the answers of the compiler's driver, so that it is not started for each source and program.
    # How programs that load plugins are linked, so that they can be linked again with a workspace's plugins.
    kits = workshop.folder / "link-kits" / package.name
    environment["ROS2WASM_LINK_KITS"] = str(kits)
    environment["ROS2WASM_TOOL_CALLS"] = str(workshop.folder / "tool-calls")
    steps = [
        ["cmake", "-G", "Ninja", "-Wno-dev", "-S", str(package.folder), "-B", str(build),
         f"-DCMAKE_TOOLCHAIN_FILE={workshop.toolchain / 'ros2wasm-toolchain.cmake'}",
         f"-DROS2WASM_CLI={workshop.cli}",
         f"-DROS2WASM_EMCXX={workshop.compiler.cxx}",
         f"-DCMAKE_CXX_COMPILER_LAUNCHER={workshop.cli};compile-source;--",
         f"-DCMAKE_PREFIX_PATH={workshop.prefix}",
         f"-DCMAKE_INSTALL_PREFIX={NEUTRAL_PREFIX}"],
        # More than one process only while other packages leave cores idle.
        ["cmake", "--build", str(build), "--", f"-j{workshop.jobs}", f"-l{workshop.jobs}"],
        ["cmake", "--install", str(build), "--prefix", str(tree)],
        [str(workshop.cli), "install-kits", "--package", package.name, "--kits", str(kits), "--tree", str(tree),
         "--environment", str(workshop.prefix)],
    ]
    shutil.rmtree(tree, ignore_errors=True)
    # Only into an empty cache CMake reads the flags of the toolchain file, which may have changed.
    (build / "CMakeCache.txt").unlink(missing_ok=True)
    with log.open("w", encoding="utf-8") as stream:
        for step in steps:
            done = subprocess.run(step, env=environment, stdin=subprocess.DEVNULL, stdout=stream,
                                  stderr=subprocess.STDOUT, check=False)
            if done.returncode != 0:
                raise BuildFailure(package.name, log)
    _clean(tree)
    _merge(tree, workshop.prefix)
    return tree


def _clean(tree: Path) -> None:
    """Removes what has no use in a site's environment."""
    for share in tree.glob("share/*"):
        shutil.rmtree(share / "environment", ignore_errors=True)
        for pattern in LEFT_OUT_FILES:
            for file in share.glob(pattern):
                file.unlink()
    shutil.rmtree(tree / "share/ament_index/resource_index/parent_prefix_path", ignore_errors=True)


def _merge(tree: Path, prefix: Path) -> None:
    """Copies a tree into the common prefix; files of an older build with other names stay there."""
    shutil.copytree(tree, prefix, dirs_exist_ok=True)
