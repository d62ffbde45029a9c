"""Packages from before info/paths.json: their files are listed in info/files and have no hashes of their own."""
from __future__ import annotations

import bz2
import json
import tarfile
from pathlib import Path

from tests.channel.tar_forms_test import FILES, LONG, PLACEHOLDER, Member, member, tarred
from tests.network.channel_fixture import ChannelCase

OLD_PLACEHOLDER = "/opt/anaconda1anaconda2anaconda3"
SCRIPT = f"#!{OLD_PLACEHOLDER}/bin/python\n".encode()
HAS_PREFIX = f"{PLACEHOLDER} text lib/demo.cmake\n{PLACEHOLDER} binary \"lib/demo.bin\"\nbin/tool\n"


class OldPackages(ChannelCase):
    def setUp(self) -> None:
        super().setUp()
        (self.folder / "workspace.yaml").write_text(
            "schema: 1\nname: demo\nchannels: [./channel]\nlaunch:\n  - package: demo\n    executable: talker\n")

    def add(self, files: str | None = None, has_prefix: str | None = HAS_PREFIX) -> Path:
        """A package with these lists; `files` None: of all that is in it."""
        payload = FILES | {"bin/tool": SCRIPT}
        index = {"name": "ros-jazzy-demo", "version": "1.0", "build": "h_0", "build_number": 0, "subdir": "noarch",
                 "depends": []}
        listed = "".join(f"{path}\n" for path in [*payload, "share/link"]) if files is None else files
        info: list[Member] = [member("info/index.json", json.dumps(index).encode()),
                              member("info/files", listed.encode()), member("info/no_link", b"bin/tool\n")]
        if has_prefix is not None:
            info.append(member("info/has_prefix", has_prefix.encode()))
        archive = self.folder / "ros-jazzy-demo-1.0-h_0.tar.bz2"
        archive.write_bytes(bz2.compress(tarred(
            [*info, *(member(path, data) for path, data in payload.items()),
             member("share/link", kind=tarfile.SYMTYPE, target="demo/package.xml")])))
        self.succeed("channel", "add", str(self.channel), str(archive))
        self.write_index()
        (self.folder / "ros2wasm.lock").unlink(missing_ok=True)
        return archive

    def environment_prefix(self) -> Path:
        prefix, = (p for p in (self.folder / "cache/ros2wasm/environments").iterdir()
                   if p.is_dir() and p.name != "unfinished")
        return prefix

    def test_is_installed_and_said_to_be_old(self) -> None:
        archive = self.add()
        done = self.run_cli("pack")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("only the archive of ros-jazzy-demo-1.0-h_0 could be checked", done.stderr)
        prefix = self.environment_prefix()
        self.assertEqual((prefix / "lib/demo.cmake").read_text(), f"set(P {prefix}/lib;{prefix})\n")
        binary = (prefix / "lib/demo.bin").read_bytes()
        self.assertEqual(binary[2:].split(b"\0")[0], f"{prefix}/lib:{prefix}/bin".encode())
        self.assertEqual(len(binary), len(FILES["lib/demo.bin"]))
        self.assertEqual((prefix / "bin/tool").read_text(), f"#!{prefix}/bin/python\n")
        self.assertEqual((prefix / "share/link").readlink(), Path("demo/package.xml"))
        self.assertEqual((prefix / LONG).read_bytes(), b"long\n")
        said = json.loads(self.succeed("inspect", "archive", str(archive)))
        self.assertEqual((said["faults"], said["has_file_hashes"]), ([], False))

    # Guarantee, hostile input: a file of the cache that was changed is found by `cache verify`, in packages
    # without hashes of their files too
    def test_what_changes_in_the_cache_is_noticed_all_the_same(self) -> None:
        self.add()
        self.succeed("pack")
        self.assertIn(" 0 damaged", self.succeed("cache", "verify"))
        package, = (self.folder / "cache/ros2wasm/packages").glob("??/*[0-9a-f]")
        (package / LONG).chmod(0o644)
        (package / LONG).write_bytes(b"gone\n")
        self.fail_with("R2W0239", "cache", "verify")
        self.succeed("pack")
        self.assertEqual((package / LONG).read_bytes(), b"long\n")
        self.assertIn(" 0 damaged", self.succeed("cache", "verify"))

    def test_without_prefixes(self) -> None:
        self.add(has_prefix=None)
        self.succeed("pack")
        self.assertEqual((self.environment_prefix() / "bin/tool").read_bytes(), SCRIPT)

    def test_lists_that_do_not_fit_are_refused(self) -> None:
        for code, why, files, has_prefix in (
            ("R2W0226", "its info/files lists", "lib/demo.bin\n", ""),
            ("R2W0226", "`lib/more` is missing", None, ""),
            ("R2W0221", "info/files names the path `../x`", "../x\n", ""),
            ("R2W0221", "info/has_prefix has the line `/p wrong bin/tool`", None, "/p wrong bin/tool\n"),
            ("R2W0221", "info/has_prefix has the line `not/there`", None, "not/there\n"),
        ):
            with self.subTest(why):
                if "missing" in why:
                    files = "".join(f"{path}\n" for path in [*FILES, "bin/tool", "share/link", "lib/more"])
                archive = self.add(files, has_prefix)
                self.assertIn(why, self.fail_with(code, "pack"))
                self.assertEqual(self.run_cli("inspect", "archive", str(archive)).returncode, 1)
                self.assertIn("0 checked", self.succeed("cache", "verify"))
