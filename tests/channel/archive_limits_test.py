"""How much an archive may unpack to is said by a flag or a variable, for every command that unpacks."""
from __future__ import annotations

from tests.network.channel_fixture import ChannelCase

WASM = b"\0asm\1\0\0\0"


class ArchiveLimits(ChannelCase):
    def setUp(self) -> None:
        super().setUp()
        self.archive = self.add_package("ros-jazzy-demo", {
            "share/demo/package.xml": b"<package/>", "lib/demo/talker.wasm": WASM, "share/demo/zeros": bytes(300_000)})
        self.write_index()
        (self.folder / "workspace.yaml").write_text(
            "schema: 1\nname: demo\nchannels: [./channel]\nlaunch:\n  - package: demo\n    executable: talker\n")

    def test_pack(self) -> None:
        text = self.fail_with("R2W0225", "pack", "--archive-limits", "size=100K")
        self.assertIn("more than 102400 bytes", text)
        self.assertFalse((self.folder / "site").exists())
        self.assertEqual(list((self.folder / "cache/ros2wasm/packages").glob("??/*")), [])
        self.fail_with("R2W0225", "pack", ROS2WASM_ARCHIVE_LIMITS="members=3")
        self.fail_with("R2W0225", "cache", "fetch", ROS2WASM_ARCHIVE_LIMITS="members=3")
        self.succeed("pack", "--archive-limits", "size=1M", ROS2WASM_ARCHIVE_LIMITS="members=3")

    def test_inspect(self) -> None:
        archive = str(self.archive)
        self.succeed("inspect", "archive", archive)
        self.fail_with("R2W0225", "inspect", "archive", archive, "--archive-limits", "size=100K")
        self.fail_with("R2W0225", "inspect", "archive", archive, ROS2WASM_ARCHIVE_LIMITS="members=3")
