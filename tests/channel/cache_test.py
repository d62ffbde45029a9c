"""`cache info|verify|prune` and the kept indexes in <cache>/index."""
from __future__ import annotations

import json
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
