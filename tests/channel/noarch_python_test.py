"""`noarch: python` packages are installed for the Python of the lock, as conda does."""
from __future__ import annotations

import hashlib
import io
import json
import tarfile
from pathlib import Path

from tests.network.channel_fixture import ChannelCase

WASM = b"\0asm\1\0\0\0"


def paths_entry(path: str, data: bytes, **more: str) -> dict[str, object]:
    return {"_path": path, "path_type": "hardlink", "sha256": hashlib.sha256(data).hexdigest(),
            "size_in_bytes": len(data)} | more


class NoarchPython(ChannelCase):
    def setUp(self) -> None:
        super().setUp()
        self.add_package("ros-jazzy-demo", {"share/demo/package.xml": b"<package/>",
                                            "lib/demo/talker.wasm": WASM})

    def add_tar(self, index: dict[str, object], files: dict[str, bytes], link: dict[str, object] | None = None,
                placeholder: str = "") -> Path:
        """A .tar.bz2 as conda-build makes it: info/ and files in one tarball."""
        index = {"version": "1.0", "build": "h_0", "build_number": 0, "subdir": "noarch", "depends": []} | index
        file = self.folder / f"{index['name']}-{index['version']}-{index['build']}.tar.bz2"
        paths = [paths_entry(path, data, **({"prefix_placeholder": placeholder, "file_mode": "text"}
                                            if placeholder and placeholder.encode() in data else {}))
                 for path, data in files.items()]
        members = {"info/index.json": json.dumps(index).encode(),
                   "info/paths.json": json.dumps({"paths": paths, "paths_version": 1}).encode()}
        if link is not None:
            members["info/link.json"] = json.dumps(link).encode()
        with tarfile.open(file, "w:bz2") as tar:
            for name, data in (files | members).items():
                member = tarfile.TarInfo(name)
                member.size = len(data)
                tar.addfile(member, io.BytesIO(data))
        self.succeed("channel", "add", str(self.channel), str(file))
        return file

    def add_module(self, entry_points: list[str]) -> Path:
        return self.add_tar(
            {"name": "greet", "noarch": "python", "depends": ["python >=3.8"]},
            {"site-packages/greet/__init__.py": b"def main(): print('hi')\n",
             "site-packages/greet-1.0.dist-info/RECORD": b"greet/__init__.py,,\n",
             "python-scripts/greet-old": b"#!/old/place/bin/python\nimport greet\n", "share/doc/greet": b"text\n"},
            {"noarch": {"type": "python", "entry_points": entry_points}, "package_metadata_version": 1},
            placeholder="/old/place")

    def pack(self, *dependencies: str) -> None:
        self.write_index()
        (self.folder / "workspace.yaml").write_text(
            f"schema: 1\nname: demo\nchannels: [./channel]\ndependencies: {json.dumps(dependencies)}\n"
            "launch:\n  - package: demo\n    executable: talker\n")
        self.succeed("pack")

    def environment_files(self) -> tuple[Path, list[str]]:
        prefix, = (p for p in (self.folder / "cache/ros2wasm/environments").iterdir()
                   if p.is_dir() and p.name != "unfinished")
        return prefix, sorted(str(f.relative_to(prefix)) for f in prefix.rglob("*") if f.is_file())

    def test_files_go_to_the_python_of_the_lock(self) -> None:
        archive = self.add_module(["greet = greet:main", "greet2=greet.cli:App.run"])
        self.add_package("python", {"bin/python3.wasm": WASM}, version="3.13.1")
        self.pack("greet")
        prefix, files = self.environment_files()
        for wanted in ("lib/python3.13/site-packages/greet/__init__.py",
                       "lib/python3.13/site-packages/greet-1.0.dist-info/RECORD", "bin/greet-old", "share/doc/greet"):
            self.assertIn(wanted, files)
        self.assertFalse([f for f in files if f.startswith(("site-packages/", "python-scripts/"))])
        self.assertFalse([f for f in files if f.endswith(".pyc")])
        self.assertNotIn("bin/greet", files)  # listed, not written
        self.assertIn(f"#!{prefix}/bin/python", (prefix / "bin/greet-old").read_text())
        said = json.loads(self.succeed("inspect", "archive", str(archive)))
        self.assertEqual(said["faults"], [])
        self.assertEqual(said["entry_points"], [
            {"command": "greet", "module": "greet", "function": "main"},
            {"command": "greet2", "module": "greet.cli", "function": "App.run"}])
        self.assertIn(" 0 damaged", self.succeed("cache", "verify"))

    def test_a_python_says_where_its_modules_are(self) -> None:
        self.add_module([])
        own = "lib/python3.14t/site-packages"
        self.add_tar({"name": "python", "version": "3.14.0", "python_site_packages_path": own},
                     {"bin/python3.wasm": WASM})
        self.pack("greet")
        self.assertIn(f"{own}/greet/__init__.py", self.environment_files()[1])

    def test_a_python_whose_modules_are_elsewhere_is_refused(self) -> None:
        self.add_module([])
        self.add_tar({"name": "python", "version": "3.14.0", "python_site_packages_path": "../up"},
                     {"bin/python3.wasm": WASM})
        with self.assertRaisesRegex(AssertionError, "R2W0242"):
            self.pack("greet")

    def test_no_python(self) -> None:
        self.add_tar({"name": "greet", "noarch": "python"}, {"site-packages/greet.py": b""})
        with self.assertRaisesRegex(AssertionError, "R2W0242"):
            self.pack("greet")
        self.assertFalse((self.folder / "site").exists())

    # Guarantee, hostile input: entry points of a package that lead out of its folder are refused
    def test_hostile_entry_points(self) -> None:
        archive = self.add_module(["../../evil = greet:main"])
        said = self.run_cli("inspect", "archive", str(archive))
        self.assertEqual(said.returncode, 1)
        self.assertEqual([fault["path"] for fault in json.loads(said.stdout)["faults"]], ["info/link.json"])
