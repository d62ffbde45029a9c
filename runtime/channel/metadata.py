"""What the channel says of a package: its conda record."""
from __future__ import annotations

import hashlib
from pathlib import Path
from typing import Any

from fingerprint import Compiler, tree_digest
from package_source import PackageSource

DISTRO = "jazzy"
ABI_PACKAGE = "emscripten-abi"
CLIENT_ABI_PACKAGE = "ros2wasm-abi"
COMPILED_SUFFIXES = (".a", ".wasm", ".o", ".so")


def conda_name(package: PackageSource) -> str:
    """Maps a ROS package name as the robostack channels do."""
    return package.conda_name or f"ros-{DISTRO}-{package.name.replace('_', '-')}"


def is_compiled(tree: Path) -> bool:
    """True when a tree has code for the site's processor, so that its compiler matters."""
    return any(path.suffix in COMPILED_SUFFIXES for path in tree.rglob("*"))


def record(package: PackageSource, packages: dict[str, PackageSource], tree: Path,
           compiler: Compiler) -> dict[str, Any]:
    """Returns the metadata of one package, as `ros2wasm channel add` takes it.

    The build string comes of the files: the same files have the same name, wherever they were made.
    """
    compiled = is_compiled(tree) and not package.any_compiler
    depends = [f"{conda_name(packages[need])} >={packages[need].version}" for need in package.use_needs]
    if compiled:
        depends.append(f"{ABI_PACKAGE} {compiler.version}.*")
    build = f"h{tree_digest(tree)[:8]}_0"
    return {
        "name": conda_name(package),
        "version": package.version,
        "build": f"{compiler.tag}_{build}" if compiled else build,
        "build_number": 0,
        "subdir": "emscripten-wasm32" if compiled else "noarch",
        "depends": sorted(depends),
        "license": package.license,
        "summary": package.description,
    }


def abi_record(compiler: Compiler) -> dict[str, Any]:
    """Returns the record of the empty package that stands for a compiler; its build string for what is in programs."""
    return {
        "name": ABI_PACKAGE,
        "version": compiler.version,
        "build": compiler.abi_build or "0",
        "build_number": 0,
        "subdir": "noarch",
        "depends": [],
        # The licenses of its system libraries, which compiled programs contain: musl, Emscripten's own, LLVM's.
        "license": "MIT AND (MIT OR NCSA) AND Apache-2.0 WITH LLVM-exception",
        "summary": "Marks packages that Emscripten of this version has compiled.",
    }


def client_abi_record(packages: dict[str, PackageSource]) -> dict[str, Any]:
    """Returns the record of the empty package that stands for the headers of the client libraries.

    What `ros2wasm channel build` compiles with these headers asks for exactly this build: with others, classes
    may have another layout.
    """
    headers = hashlib.sha256()
    for name, package in sorted(packages.items()):
        if package.folder.parent.name == "client":
            headers.update(f"{name}\0{tree_digest(package.folder / 'include')}\n".encode())
    return {
        "name": CLIENT_ABI_PACKAGE,
        "version": "1",
        "build": f"h{headers.hexdigest()[:12]}_0",
        "build_number": 0,
        "subdir": "noarch",
        "depends": [],
        "license": "Apache-2.0",
        "summary": "Marks packages that were compiled with these headers of the client libraries.",
    }
