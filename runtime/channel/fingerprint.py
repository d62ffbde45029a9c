"""Hashes of everything that a built package depends on, so that nothing is built twice.

A key is the same on every machine that has the same sources and tools: contents count, times do not.
"""
from __future__ import annotations

import hashlib
import os
import shutil
import subprocess
from dataclasses import dataclass, replace
from pathlib import Path

from package_source import PackageSource

# Debian's generators, which write the C++ headers of messages.
HOST_GENERATORS = (
    "/usr/share/rosidl_cmake", "/usr/share/rosidl_adapter", "/usr/share/rosidl_generator_cpp",
    "/usr/lib/python3/dist-packages/rosidl_adapter", "/usr/lib/python3/dist-packages/rosidl_parser",
    "/usr/lib/python3/dist-packages/rosidl_pycommon",
    "/usr/lib/python3/dist-packages/rosidl_generator_cpp",
    "/usr/include/rosidl_runtime_c", "/usr/include/rosidl_runtime_cpp",
    "/usr/include/rosidl_typesupport_interface",
)
SOURCE_SUFFIXES_LEFT_OUT = (".pyc",)
# The part of the recipe that makes a package's tree: the commands, their environment, and which files stay.
TREE_RECIPE = "stage.py"
# Has no part in any package.
PAGE_RECIPE = "write_versions.py"


@dataclass(frozen=True)
class Compiler:
    """Emscripten: the C++ driver, its version, a hash of all that matters of it, and what of it is in programs."""

    cxx: Path
    version: str
    digest: str
    abi_build: str = ""  # clang and the system libraries; empty when they are not known

    @property
    def tag(self) -> str:
        return "em" + "".join(c for c in self.version if c.isdigit())


def with_parts(compiler: Compiler, cli: Path) -> Compiler:
    """The compiler with its clang and libraries, as ros2wasm finds them where the channel is used."""
    environment = {**os.environ, "PATH": f"{compiler.cxx.parent}{os.pathsep}{os.environ['PATH']}"}
    environment.pop("EMSDK", None)
    said = subprocess.run([cli, "describe-compiler"], env=environment, capture_output=True, text=True, check=True)
    build = said.stdout.strip()
    return replace(compiler, digest=hashlib.sha256((compiler.digest + build).encode()).hexdigest(), abi_build=build)


def find_compiler(emscripten: Path | None) -> Compiler:
    """Takes `emscripten` (the folder of em++), else EMSDK's, else the one on PATH."""
    sdk = os.environ.get("EMSDK")
    folders = [emscripten] if emscripten else [Path(sdk, "upstream", "emscripten")] if sdk else []
    places = [str(folder / "em++") for folder in folders if folder] + ([] if emscripten else ["em++"])
    for place in places:
        found = shutil.which(place)
        if found:
            break
    else:
        raise FileNotFoundError("Emscripten is not installed: `sudo apt-get install emscripten`")
    real = Path(found).resolve().parent
    version = (real / "emscripten-version.txt").read_text(encoding="utf-8").strip().strip('"')
    digest = hashlib.sha256(version.encode() + (real / "emcc.py").read_bytes()).hexdigest()
    return Compiler(Path(found), version, digest)


def tree_digest(folder: Path) -> str:
    """Hashes names and contents of all files below a folder; of a file its content."""
    if folder.is_file():
        return hashlib.sha256(folder.read_bytes()).hexdigest()
    result = hashlib.sha256()
    for parent, folders, files in os.walk(folder):
        folders[:] = sorted(name for name in folders if name != "__pycache__")
        for name in sorted(files):
            if name.endswith(SOURCE_SUFFIXES_LEFT_OUT):
                continue
            path = os.path.join(parent, name)
            with open(path, "rb") as stream:
                content = hashlib.sha256(stream.read()).hexdigest()
            result.update(f"{os.path.relpath(path, folder)}\0{content}\n".encode())
    return result.hexdigest()


def debian_digest(package: str, info: Path = Path("/var/lib/dpkg/info")) -> str:
    """Hashes the hashes that dpkg has of all files of an installed package."""
    lists = [*info.glob(f"{package}.md5sums"), *info.glob(f"{package}:*.md5sums")]
    if not lists:
        raise FileNotFoundError(f"Debian's package {package} is not installed: `sudo apt-get install {package}`")
    return hashlib.sha256(b"\0".join(file.read_bytes() for file in sorted(lists))).hexdigest()


def packer_digest(repository: Path) -> str:
    """Hashes the code that makes archives of trees: when it changes, packages are packed again, not built."""
    writers = sorted((repository / "bundler" / "archive").glob("conda_writer*"))
    recipe = sorted(file for file in (repository / "runtime" / "channel").glob("*.py")
                    if file.name not in (TREE_RECIPE, PAGE_RECIPE))
    return hashlib.sha256(b"\0".join(file.read_bytes() for file in (*writers, *recipe))).hexdigest()


def linker_digest(repository: Path) -> str:
    """Hashes the code that links programs: when it changes, packages with programs are built again."""
    folder = repository / "bundler" / "build"
    patterns = ("link_*", "direct_link*", "single_link_object*", "wasm_module*")
    files = sorted(file for pattern in patterns for file in folder.glob(pattern))
    return hashlib.sha256(b"\0".join(file.read_bytes() for file in files)).hexdigest()


def package_keys(packages: dict[str, PackageSource], compiler: Compiler, recipe: Path,
                 toolchain: Path) -> dict[str, str]:
    """Returns a key for each package: its sources, the keys of its needs, tools, and how `recipe` builds a tree."""
    base = hashlib.sha256()
    base.update(compiler.digest.encode())
    base.update((recipe / TREE_RECIPE).read_bytes())
    for folder in (toolchain, *map(Path, HOST_GENERATORS)):
        base.update(tree_digest(folder).encode())
    keys: dict[str, str] = {}
    for name, package in packages.items():
        text = "\n".join([
            base.hexdigest(), name, tree_digest(package.folder),
            *(tree_digest(Path(folder)) for folder in package.host_folders),
            *(debian_digest(one) for one in package.host_packages),
            *(keys[need] for need in package.build_needs),
        ])
        keys[name] = hashlib.sha256(text.encode()).hexdigest()
    return keys
