"""`channel::name` with a channel that is not listed: it comes behind the others, as in conda."""
from __future__ import annotations

import json

from tests.network.channel_fixture import ChannelCase
from tests.network.fault_server import FaultServer

WASM = b"\0asm\1\0\0\0"


class NamedChannel(ChannelCase):
    def setUp(self) -> None:
        super().setUp()
        self.add_package("lib", {"share/lib": b"first"})
        self.add_package("ros-jazzy-demo", {"share/demo/package.xml": b"<package/>",
                                            "lib/demo/talker.wasm": WASM})
        self.write_index()
        self.other = self.folder / "host/other"
        self.add_package("lib", {"share/lib": b"second"}, version="2.0", channel=self.other)
        self.add_package("more", {"share/more": b"m"}, ["lib"], channel=self.other)
        self.write_index(self.other)

    def write_manifest(self, dependency: str, more: str = "") -> None:
        (self.folder / "ros2wasm.lock").unlink(missing_ok=True)
        (self.folder / "workspace.yaml").write_text(
            f"schema: 1\nname: demo\nchannels: [./channel]\n{more}dependencies: ['{dependency}']\n"
            "launch:\n  - package: demo\n    executable: talker\n")

    def test_a_folder(self) -> None:
        self.write_manifest("./host/other::more")
        self.succeed("pack")
        self.assertIn("channel: ./host/other\n", self.locked("more"))
        self.assertIn("channel: ./channel\n", self.locked("lib"))  # the listed one comes first
        self.succeed("lock", "--check")
        self.succeed("pack", "--locked")
        self.succeed("pack", "--frozen")

    def test_the_named_channel_wins_for_that_package(self) -> None:
        self.write_manifest("./host/other::lib")
        self.succeed("lock")
        self.assertIn("version: 2.0\n", self.locked("lib"))
        self.write_manifest("lib[channel=./host/other]")
        self.succeed("lock")
        self.assertIn("version: 2.0\n", self.locked("lib"))

    def test_a_name_below_the_alias(self) -> None:
        with FaultServer(self.folder) as server:
            self.write_manifest("other::more", f"channel_alias: {server.url}/host\n")
            self.succeed("lock")
            self.assertIn(f"channel: {server.url}/host/other\n", self.locked("more"))

    def test_a_name_of_nothing(self) -> None:
        self.write_manifest("other::more")
        text = self.fail_with("R2W0240", "lock")
        self.assertIn("workspace.yaml:4:", text)
        self.write_manifest("./nowhere::more")
        self.assertIn("workspace.yaml:4:", self.fail_with("R2W0201", "lock"))

    def test_credentials_stay_out_of_lock_and_messages(self) -> None:
        (self.folder / "t/hush").mkdir(parents=True)
        (self.folder / "t/hush/host").symlink_to(self.folder / "host")
        with FaultServer(self.folder) as server:
            address = server.url + "/host/other"
            secret = address.replace("http://", "http://user:hush@")
            token = address.replace("/host", "/t/${WORD}/host")
            for spec in (f"{secret}::more", f"more[channel={secret}]", f"{token}::more"):
                with self.subTest(spec=spec):
                    self.write_manifest(spec)
                    said = self.run_cli("lock", WORD="hush")
                    self.assertNotIn("hush", said.stdout + said.stderr)
                    self.assertEqual(said.returncode, 0, said.stderr)
                    self.assertIn(f"channel: {address}\n", self.locked("more"))
                    self.assertNotIn("hush", (self.folder / "ros2wasm.lock").read_text())
                    self.succeed("lock", "--check", WORD="hush")
                    self.assertNotIn("hush", self.succeed("check", "--json", WORD="hush"))
            self.assertTrue(server.seen("/t/hush/host/other/noarch/more-1.0-h_0.conda") or server.seen(
                "/t/hush/host/other/noarch/repodata_shards.msgpack.zst"))

    def test_a_variable(self) -> None:
        with FaultServer(self.folder) as server:
            self.write_manifest("${PRIVATE}::more")
            self.succeed("lock", PRIVATE=server.url + "/host/other")
            self.assertIn(f"channel: {server.url}/host/other\n", self.locked("more"))

    def test_another_spelling_of_a_listed_folder(self) -> None:
        for spelling in ("./host/../channel", self.channel.as_uri(), str(self.channel)):
            with self.subTest(spelling=spelling):
                self.write_manifest(spelling + "::lib")
                self.succeed("lock")
                self.assertIn("channel: ./channel\n", self.locked("lib"))
                self.assertNotIn(spelling, (self.folder / "ros2wasm.lock").read_text())

    def test_what_cannot_be_told_from_the_text(self) -> None:
        for spec in ("https://user:hush@ho(x)st/chan::foo", "https://user:hush@host/ch[license=x]an::foo"):
            with self.subTest(spec=spec):
                self.assertNotIn("hush", self.fail_with("R2W0303", "solve", "-c", "./channel", spec))

    def test_solve_and_search(self) -> None:
        self.assertEqual([line.split(" ")[1] for line in self.solution("./channel", "./host/other::more")],
                         ["./channel/noarch/lib-1.0-h_0.conda", "./host/other/noarch/more-1.0-h_0.conda"])
        found = json.loads(self.succeed("search", "--json", "-c", "./channel", "./host/other::lib"))
        self.assertEqual([one["version"] for one in found["packages"]], ["2.0"])
