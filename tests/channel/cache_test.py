"""`cache info|verify|prune` and the kept indexes in <cache>/index."""
from __future__ import annotations

import hashlib
import json
import os
import tarfile
from collections.abc import Mapping
from pathlib import Path

from tests.network.channel_fixture import ChannelCase
from tests.network.fault_server import FaultServer


class KeptIndexes(ChannelCase):
    def setUp(self) -> None:
        super().setUp()
        # An index is kept when it is large enough to be worth it.
        records = {f"p{i}-1.0-0.conda": {"name": f"p{i}", "version": "1.0", "build": "0", "build_number": 0,
                                         "depends": [], "sha256": f"{i:064x}", "size": 1} for i in range(400)}
        self.write_repodata(records)

    def write_repodata(self, records: Mapping[str, object]) -> None:
        (self.channel / "noarch").mkdir(parents=True, exist_ok=True)
        (self.channel / "noarch/repodata.json").write_text(json.dumps(
            {"info": {"subdir": "noarch"}, "packages": {}, "packages.conda": records}))

    def kept(self) -> list[Path]:
        return sorted((self.folder / "cache/ros2wasm/index").glob("*.index"))

    def test_info_counts_them(self) -> None:
        self.solution("./channel", "p1")
        kept, = self.kept()
        areas = {area["name"]: area for area in json.loads(self.succeed("cache", "info", "--json"))["areas"]}
        self.assertEqual(areas["index"]["files"], 1)
        self.assertEqual(areas["index"]["bytes"], kept.stat().st_size)

    def test_verify_and_prune_find_damaged_ones(self) -> None:
        self.solution("./channel", "p1")
        kept, = self.kept()
        whole = kept.read_bytes()
        self.assertIn("1 checked, 0 damaged", self.succeed("cache", "verify"))
        for at in (0, 20, 40, len(whole) // 2, len(whole) - 1):
            with self.subTest(at=at):
                kept.write_bytes(whole[:at] + bytes([whole[at] ^ 1]) + whole[at + 1:])
                self.assertIn(f"index/{kept.name}: it is damaged", self.fail_with("R2W0239", "cache", "verify"))
        kept.write_bytes(whole[:100])
        self.fail_with("R2W0239", "cache", "verify")
        self.succeed("cache", "prune")
        self.assertEqual(self.kept(), [])
        self.assertIn(" 0 damaged", self.succeed("cache", "verify"))

    def test_prune_leaves_those_of_copies_in_use(self) -> None:
        self.solution("./channel", "p1")
        with FaultServer(self.folder) as server:
            self.solution(server.url + "/channel", "p1")
            self.assertEqual(len(self.kept()), 2)
            self.succeed("cache", "prune")
            in_use, = self.kept()
            self.write_repodata({"q-1.0-0.conda": {"name": "q", "version": "1.0", "build": "0", "build_number": 0,
                                                   "depends": [], "sha256": "0" * 64, "size": 1}})
            self.solution(server.url + "/channel", "q")
            self.succeed("cache", "prune")
            self.assertEqual(self.kept(), [])


class Packages(ChannelCase):
    def test_a_package_may_have_a_file_called_as_a_seal(self) -> None:
        """What is unpacked holds what the archive does and nothing else."""
        stage = self.folder / "stage"
        (stage / "info").mkdir(parents=True)
        index = {"name": "sealed", "version": "1.0", "build": "h_0", "build_number": 0, "depends": [],
                 "subdir": "noarch", "noarch": "generic"}
        (stage / "info/index.json").write_text(json.dumps(index))
        (stage / "info/.sha256sums").write_text("of somebody else")
        (stage / "share").mkdir()
        (stage / "share/a").write_text("1")
        paths = {"paths_version": 1, "paths": [{"_path": "share/a", "path_type": "hardlink", "size_in_bytes": 1,
                                                "sha256": hashlib.sha256(b"1").hexdigest()}]}
        (stage / "info/paths.json").write_text(json.dumps(paths))
        noarch = self.channel / "noarch"
        noarch.mkdir(parents=True)
        with tarfile.open(noarch / "sealed-1.0-h_0.tar.bz2", "w:bz2") as archive:
            for part in ("info", "share"):
                archive.add(stage / part, arcname=part)
        self.write_index()
        (self.folder / "workspace.yaml").write_text(
            "schema: 1\nname: demo\nchannels: [./channel]\ndependencies: [sealed]\n"
            "launch:\n  - package: demo\n    executable: talker\n")
        self.succeed("lock")
        self.succeed("cache", "fetch")
        self.assertIn("1 checked, 0 damaged", self.succeed("cache", "verify"))
        mine, = (self.folder / "cache/ros2wasm/packages").rglob(".sha256sums")
        self.assertEqual(mine.read_text(), "of somebody else")
        mine.chmod(0o644)
        mine.write_text("and changed")
        self.fail_with("R2W0239", "cache", "verify")

    def test_what_is_left_of_writing_a_seal_is_no_package(self) -> None:
        self.add_package("p", {"share/p/a": b"a"})
        self.write_index()
        (self.folder / "workspace.yaml").write_text(
            "schema: 1\nname: demo\nchannels: [./channel]\ndependencies: [p]\n"
            "launch:\n  - package: demo\n    executable: talker\n")
        self.succeed("lock")
        self.succeed("cache", "fetch")
        seal, = (self.folder / "cache/ros2wasm/packages").glob("??/*.seal")
        left = seal.with_name(seal.name + ".a1b2c3")
        left.write_bytes(b"")
        self.assertIn(" 0 damaged", self.succeed("cache", "verify"))
        self.succeed("cache", "prune")
        self.assertTrue(left.exists())  # somebody may be at it
        os.utime(left, (0, 0))
        os.utime(seal, (0, 0))
        self.succeed("cache", "prune")
        self.assertFalse(left.exists())
        self.assertTrue(seal.exists())

    def test_prune_removes_builds_of_other_versions(self) -> None:
        builds = self.folder / "cache/ros2wasm/build"
        for other in ("work/demo-1", "built/demo-1", "0.0.1-1/built/demo-1"):
            (builds / other).mkdir(parents=True)
        self.succeed("cache", "prune")
        self.assertEqual(list(builds.iterdir()), [])
