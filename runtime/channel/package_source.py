"""Finds the ROS packages under runtime/packages/ and reads what the channel needs of their package.xml."""
from __future__ import annotations

import re
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
# The tags of dependencies that are needed to use a package, as opposed to building it.
USE_TAGS = ("depend", "exec_depend", "build_export_depend", "buildtool_export_depend")
BUILD_TAGS = ("depend", "build_depend", "buildtool_depend", "build_export_depend", "buildtool_export_depend")


@dataclass(frozen=True)
class PackageSource:
    """One folder with a package.xml. Dependencies name packages of ours only.

    A library that others made has in <export> its name in channels (<conda_name>), as it is not a ROS package,
    and what it is packed from: folders or files of this machine or below the repository (<host_folder>), or
    all of a Debian package (<host_package>), which dpkg has hashed, as thousands of headers would be slow to read.
    One that a machine updates has no version of ours: the first line of <version_file> says it.
    <any_compiler/> marks WebAssembly that does not care which Emscripten made the rest of a site.
    """

    name: str
    version: str
    description: str
    license: str
    folder: Path
    build_needs: tuple[str, ...]
    use_needs: tuple[str, ...]
    conda_name: str | None = None
    host_folders: tuple[str, ...] = ()
    host_packages: tuple[str, ...] = ()
    any_compiler: bool = False


def find_packages(packages: Path) -> dict[str, PackageSource]:
    """Returns all packages below `packages`, in folders of kinds, by name, each after those it needs."""
    manifests = sorted(packages.glob("*/*/package.xml"))
    roots = {path.parent: ElementTree.parse(path).getroot() for path in manifests}
    names = {_text(root, "name") for root in roots.values()}
    if len(names) != len(roots):
        raise ValueError("two packages under runtime/packages/ have the same name")
    found = [_read(folder, root, names) for folder, root in roots.items()]
    return _in_order({package.name: package for package in found})


def needed_by(workspace: Path, packages: dict[str, PackageSource]) -> dict[str, PackageSource]:
    """The packages that those below a folder name in package.xml, with all that these need, in the same order."""
    asked: set[str] = set()
    for path in sorted(workspace.rglob("package.xml")):
        root = ElementTree.parse(path).getroot()
        asked |= {(element.text or "").strip() for tag in {*BUILD_TAGS, *USE_TAGS} for element in root.findall(tag)}
    wanted = asked & set(packages)
    for name in reversed(packages):  # those that need it come before it
        if name in wanted:
            wanted |= set(packages[name].build_needs)
    return {name: package for name, package in packages.items() if name in wanted}


def longest_first(packages: dict[str, PackageSource]) -> list[str]:
    """The names by how much is to be compiled from each to the end of what waits for it, the most first."""
    lengths: dict[str, int] = {}
    for name in reversed(packages):  # those that need it come before it
        waiting = [lengths[user] for user in lengths if name in packages[user].build_needs]
        lengths[name] = _work(packages[name]) + max(waiting, default=0)
    return sorted(packages, key=lambda name: -lengths[name])


def _work(package: PackageSource) -> int:
    """How long a package takes, in bytes of C++: what it has, what is made of interfaces, and configuring."""
    work = 4000
    for folder in (package.folder, *map(Path, package.host_folders)):
        work += sum(file.stat().st_size for file in folder.rglob("*") if file.suffix in (".cpp", ".cxx", ".cc"))
        work += 400 * sum(1 for file in folder.rglob("*") if file.suffix in (".msg", ".srv", ".action"))
    return work


def _read(folder: Path, root: ElementTree.Element, names: set[str]) -> PackageSource:
    def needs(tags: tuple[str, ...]) -> tuple[str, ...]:
        asked = {(element.text or "").strip() for tag in tags for element in root.findall(tag)}
        return tuple(sorted((asked & names) - {_text(root, "name")}))

    return PackageSource(
        name=_text(root, "name"),
        version=_version(root),
        description=" ".join(_text(root, "description").split()),
        license=_text(root, "license"),
        folder=folder,
        build_needs=tuple(sorted({*needs(BUILD_TAGS), *needs(USE_TAGS)})),
        use_needs=needs(USE_TAGS),
        conda_name=root.findtext("export/conda_name"),
        host_folders=tuple(str(ROOT / (element.text or "")) for element in root.findall("export/host_folder")),
        host_packages=tuple(element.text or "" for element in root.findall("export/host_package")),
        any_compiler=root.find("export/any_compiler") is not None,
    )


def _version(root: ElementTree.Element) -> str:
    file = root.findtext("export/version_file")
    if file is None or not Path(file).exists():
        return _text(root, "version")
    with Path(file).open(encoding="utf-8") as lines:
        said = re.search(r"version (\w[\w.]*)", lines.readline())
    if said is None:
        raise ValueError(f"the first line of {file} says no version")
    return said[1]


def _text(root: ElementTree.Element, tag: str) -> str:
    text = root.findtext(tag)
    if text is None or not text.strip():
        raise ValueError(f"a package.xml has no <{tag}>")
    return text.strip()


def _in_order(packages: dict[str, PackageSource]) -> dict[str, PackageSource]:
    ordered: dict[str, PackageSource] = {}
    open_names: list[str] = []

    def place(name: str) -> None:
        if name in ordered:
            return
        if name in open_names:
            raise ValueError("packages need each other: " + " -> ".join([*open_names, name]))
        open_names.append(name)
        for need in packages[name].build_needs:
            place(need)
        open_names.pop()
        ordered[name] = packages[name]

    for name in sorted(packages):
        place(name)
    return ordered
