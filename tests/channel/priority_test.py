"""`channel_priority` of the manifest: the order of channels counts as conda has it."""
from __future__ import annotations

from tests.network.channel_fixture import ChannelCase

WASM = b"\0asm\1\0\0\0"


class Priority(ChannelCase):
    def setUp(self) -> None:
        super().setUp()
        second = self.folder / "second"
        self.add_package("lib", {"share/lib": b"old"})
        self.add_package("ros-jazzy-demo", {"share/demo/package.xml": b"<package/>",
                                            "lib/demo/talker.wasm": WASM})
        self.add_package("lib", {"share/lib": b"new"}, version="2.0", channel=second)
        self.write_index()
        self.write_index(second)

    def write_manifest(self, dependency: str, priority: str) -> None:
        (self.folder / "ros2wasm.lock").unlink(missing_ok=True)
        line = f"channel_priority: {priority}\n" if priority else ""
        (self.folder / "workspace.yaml").write_text(
            f"schema: 1\nname: demo\nchannels: [./channel, ./second]\n{line}dependencies: ['{dependency}']\n"
            "launch:\n  - package: demo\n    executable: talker\n")

    def test_which_channel_a_package_comes_from(self) -> None:
        for dependency, priority, version in (
            ("lib", "", "1.0"), ("lib", "strict", "1.0"), ("lib", "flexible", "1.0"), ("lib", "disabled", "2.0"),
            ("lib >=2", "flexible", "2.0"), ("lib >=2", "disabled", "2.0"),
        ):
            with self.subTest(dependency=dependency, priority=priority):
                self.write_manifest(dependency, priority)
                self.succeed("pack")
                self.assertIn(f"\n    version: {version}\n", self.locked("lib"))
                before = (self.folder / "ros2wasm.lock").read_text()
                self.succeed("pack", "--locked")
                self.succeed("lock", "--check")
                self.assertEqual((self.folder / "ros2wasm.lock").read_text(), before)

    def test_a_later_channel_is_hidden(self) -> None:
        for priority in ("", "strict"):
            self.write_manifest("lib >=2", priority)
            self.fail_with("R2W0301", "lock")
