"""The embedded channel's recipe: which packages there are, what makes them build again, what is said
of them."""
from __future__ import annotations

import json
import subprocess
import tempfile
import unittest
from dataclasses import replace
from pathlib import Path

from . import ROOT
from fingerprint import Compiler, debian_digest, package_keys, packer_digest, tree_digest
from metadata import conda_name, record
from package_source import PackageSource, find_packages, longest_first, needed_by
from write_versions import page

COMPILER = Compiler(Path("/opt/em++"), "3.1.6", "0" * 64, "clang14.0.6_h0123456789ab_0")


def package_xml(name: str, *needs: str, tag: str = "depend") -> str:
    lines = "".join(f"<{tag}>{need}</{tag}>" for need in needs)
    return (f"<package format='3'><name>{name}</name><version>1.2.3</version><description>Two\n words</description>"
            f"<license>MIT</license>{lines}</package>")


class Scratch(unittest.TestCase):
    """A runtime folder to fill with packages."""

    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.root = Path(holder.name)

    def add(self, place: str, text: str) -> Path:
        """`place`: a kind and a name, or a name among the tools."""
        folder = self.root / "packages" / (place if "/" in place else f"tools/{place}")
        folder.mkdir(parents=True)
        (folder / "package.xml").write_text(text, encoding="utf-8")
        return folder

    def keys(self) -> dict[str, str]:
        for name in ("recipe", "toolchain"):
            (self.root / name).mkdir(exist_ok=True)
        (self.root / "recipe" / "stage.py").touch()
        packages = find_packages(self.root / "packages")
        return package_keys(packages, COMPILER, self.root / "recipe", self.root / "toolchain")


class FindPackages(Scratch):

    def test_needed_packages_come_first_and_others_are_ignored(self) -> None:
        self.add("a", package_xml("a", "b", "ament_cmake"))
        self.add("interfaces/b", package_xml("b", "c", tag="exec_depend"))
        self.add("interfaces/c", package_xml("c"))
        found = find_packages(self.root / "packages")
        self.assertEqual(list(found), ["c", "b", "a"])
        self.assertEqual(found["a"].use_needs, ("b",))
        self.assertEqual(found["b"].description, "Two words")

    def test_what_a_machine_updates_says_its_version_itself(self) -> None:
        said = self.root / "zones"
        text = package_xml("a").replace("</package>", f"<export><version_file>{said}</version_file></export></package>")
        self.add("a", text)
        self.assertEqual(find_packages(self.root / "packages")["a"].version, "1.2.3")
        said.write_text("# version 2026b\n# version 1\n", encoding="utf-8")
        self.assertEqual(find_packages(self.root / "packages")["a"].version, "2026b")
        said.write_text("# zones\n# version 1\n", encoding="utf-8")
        with self.assertRaisesRegex(ValueError, "says no version"):
            find_packages(self.root / "packages")

    def test_what_most_waits_for_is_built_first(self) -> None:
        self.add("a", package_xml("a"))
        self.add("z", package_xml("z"))
        (self.add("m", package_xml("m", "z")) / "large.cpp").write_text("//" * 5000)
        (self.add("n", package_xml("n")) / "middle.cpp").write_text("//" * 2000)
        self.assertEqual(longest_first(find_packages(self.root / "packages")), ["z", "m", "n", "a"])

    def test_a_workspace_needs_what_its_packages_name_and_what_these_need(self) -> None:
        for name, *needs in (("base",), ("client", "base"), ("tools", "client"), ("messages", "base"), ("other",)):
            self.add(name, package_xml(name, *needs))
        source = self.root / "workspace/src/mine"
        source.mkdir(parents=True)
        (source / "package.xml").write_text(package_xml("mine", "client", "not_ours"), encoding="utf-8")
        needed = needed_by(self.root / "workspace", find_packages(self.root / "packages"))
        self.assertEqual(list(needed), ["base", "client"])

    def test_a_circle_is_named(self) -> None:
        self.add("a", package_xml("a", "b"))
        self.add("b", package_xml("b", "a"))
        with self.assertRaisesRegex(ValueError, "a -> b -> a"):
            find_packages(self.root / "packages")

    def test_a_name_twice_is_refused(self) -> None:
        self.add("a", package_xml("same"))
        self.add("b", package_xml("same"))
        with self.assertRaisesRegex(ValueError, "same name"):
            find_packages(self.root / "packages")


class Keys(Scratch):

    def test_a_change_reaches_what_needs_it_and_nothing_else(self) -> None:
        base = self.add("base", package_xml("base"))
        self.add("user", package_xml("user", "base"))
        self.add("other", package_xml("other"))
        before = self.keys()
        self.assertEqual(self.keys(), before)
        (base / "new.cpp").write_text("int x;", encoding="utf-8")
        after = self.keys()
        self.assertEqual({name for name in before if before[name] != after[name]}, {"base", "user"})

    def test_how_trees_are_built_counts_and_how_they_are_described_does_not(self) -> None:
        self.add("base", package_xml("base"))
        before = self.keys()
        (self.root / "recipe" / "metadata.py").write_text("more = 1", encoding="utf-8")
        self.assertEqual(self.keys(), before)
        seen = {before["base"]}
        for number, file in enumerate(("recipe/stage.py", "toolchain/toolchain.cmake"), start=2):
            (self.root / file).write_text("more = 1", encoding="utf-8")
            seen.add(self.keys()["base"])
            self.assertEqual(len(seen), number, file)

    def test_how_packages_are_described_counts_for_archives(self) -> None:
        recipe = self.root / "runtime" / "channel"
        recipe.mkdir(parents=True)
        (self.root / "bundler" / "archive").mkdir(parents=True)
        digests = [packer_digest(self.root)]
        for file in ("metadata.py", "package_source.py", "build_channel.py"):
            (recipe / file).write_text(file, encoding="utf-8")
            digests.append(packer_digest(self.root))
        self.assertEqual(len(set(digests)), 4)
        for file in ("stage.py", "write_versions.py"):
            (recipe / file).write_text(file, encoding="utf-8")
            self.assertEqual(packer_digest(self.root), digests[-1])

    def test_names_count_as_much_as_contents(self) -> None:
        one, two = self.root / "one", self.root / "two"
        for folder, name in ((one, "a"), (two, "b")):
            folder.mkdir()
            (folder / name).write_text("same", encoding="utf-8")
        self.assertNotEqual(tree_digest(one), tree_digest(two))

    def test_a_single_file_counts_by_its_content(self) -> None:
        header = self.root / "one.hpp"
        header.write_text("int x;", encoding="utf-8")
        before = tree_digest(header)
        header.write_text("int y;", encoding="utf-8")
        self.assertNotEqual(tree_digest(header), before)

    def test_a_debian_package_counts_by_what_dpkg_says_of_its_files(self) -> None:
        (self.root / "libone-dev-doc.md5sums").write_text("0  usr/share/doc/libone", encoding="utf-8")
        with self.assertRaisesRegex(FileNotFoundError, "apt-get install libone-dev"):
            debian_digest("libone-dev", self.root)
        for name in ("libone-dev.md5sums", "libone-dev:amd64.md5sums"):
            file = self.root / name
            file.write_text("1  usr/include/one.hpp", encoding="utf-8")
            before = debian_digest("libone-dev", self.root)
            file.write_text("2  usr/include/one.hpp", encoding="utf-8")
            self.assertNotEqual(debian_digest("libone-dev", self.root), before)


class Record(Scratch):

    def package(self, name: str, *needs: str) -> PackageSource:
        return PackageSource(name, "1.2.3", "Text", "MIT", self.root, needs, needs)

    def test_a_library_names_its_compiler(self) -> None:
        packages = {"a": self.package("a", "b_c"), "b_c": self.package("b_c")}
        (self.root / "tree" / "lib").mkdir(parents=True)
        (self.root / "tree" / "lib" / "liba.a").write_bytes(b"!<arch>")
        meta = record(packages["a"], packages, self.root / "tree", COMPILER)
        self.assertEqual(meta["subdir"], "emscripten-wasm32")
        self.assertEqual(meta["depends"], ["emscripten-abi 3.1.6.*", "ros-jazzy-b-c >=1.2.3"])
        self.assertRegex(meta["build"], r"^em316_h[0-9a-f]{8}_0$")

    def test_headers_are_for_all(self) -> None:
        (self.root / "tree").mkdir()
        meta = record(self.package("a"), {}, self.root / "tree", COMPILER)
        self.assertEqual((meta["subdir"], meta["depends"]), ("noarch", []))

    def test_names_are_those_of_robostack(self) -> None:
        package = self.package("rosidl_typesupport_wasm_cpp")
        self.assertEqual(conda_name(package), "ros-jazzy-rosidl-typesupport-wasm-cpp")

    def test_a_library_has_the_name_that_its_manifest_tells(self) -> None:
        library = replace(self.package("yaml-cpp-dev"), conda_name="yaml-cpp")
        (self.root / "tree").mkdir()
        meta = record(self.package("a", "yaml-cpp-dev"), {"yaml-cpp-dev": library}, self.root / "tree", COMPILER)
        self.assertEqual(meta["depends"], [f"yaml-cpp >={library.version}"])
        self.assertEqual(record(library, {}, self.root / "tree", COMPILER)["name"], "yaml-cpp")


def debian_version(package: str) -> str:
    return subprocess.check_output(["dpkg-query", "-W", "-f=${Version}", package], text=True)


def version_of(folder: Path) -> str:
    """The version of the npm or Debian package that a folder is from, of the latter installed or its source."""
    if "node_modules" in folder.parts:
        version = str(json.loads((folder / "package.json").read_text(encoding="utf-8"))["version"])
        lock = folder / "pyodide-lock.json"
        if lock.exists():  # it has a Python of its own
            version += f" (Python {json.loads(lock.read_text(encoding='utf-8'))['info']['python']})"
        return version
    # A part of a source package lies below it.
    changelog = next((one for top in (folder.parent, folder) if (one := top / "debian" / "changelog").exists()), None)
    if changelog is not None:
        return changelog.read_text(encoding="utf-8").partition("(")[2].partition(")")[0]
    if folder.parent.name == "sources":  # without Debian's part, as ./dev fetches some
        return (folder / "CMakeLists.txt").read_text(encoding="utf-8").partition("VERSION")[2]
    owner = subprocess.check_output(["dpkg-query", "-S", str(folder)], text=True).split(":")[0]
    return debian_version(owner)


class Repository(unittest.TestCase):
    """The packages of this repository."""

    def test_versions_are_those_of_the_table(self) -> None:
        table = json.loads((ROOT / "runtime" / "versions.json").read_text(encoding="utf-8"))["packages"]
        own = (ROOT / "VERSION").read_text(encoding="utf-8").split()[0]
        for name, package in find_packages(ROOT / "runtime" / "packages").items():
            with self.subTest(name):
                # A package of ROS has the version of ROS, whosever files are in it.
                if name in table or not (package.host_folders or package.host_packages):
                    self.assertEqual(package.version, table[name]["version"] if name in table else own)
                    continue
                # Libraries that are built into the first one have versions of their own.
                folders = package.host_folders[:1] if name == "mujoco" else package.host_folders
                said = [*(version_of(Path(folder)) for folder in folders), *map(debian_version, package.host_packages)]
                for version in said:
                    self.assertIn(package.version, version)

    def test_the_page_of_versions_is_current(self) -> None:
        table = json.loads((ROOT / "runtime" / "versions.json").read_text(encoding="utf-8"))
        self.assertEqual((ROOT / "docs" / "upstream-versions.md").read_text(encoding="utf-8"), page(table))


if __name__ == "__main__":
    unittest.main()
