"""`pack --with-channel`: the packages of a site lie beside it as a channel, from which the same site can be packed."""
from __future__ import annotations

import hashlib
import json
import re
import shutil
from pathlib import Path

from tests.network.channel_fixture import ChannelCase
from tests.network.fault_server import FaultServer

WASM = b"\0asm\1\0\0\0"


class ShippedChannel(ChannelCase):
    def setUp(self) -> None:
        super().setUp()
        self.add_package("lib", {"share/lib": b"1"})
        self.add_package("lib", {"share/lib": b"2"}, version="2.0")
        self.add_package("unused", {"share/unused": b"u"})
        self.add_package("ros-jazzy-demo", {"share/demo/package.xml": b"<package/>",
                                            "lib/demo/talker.wasm": WASM}, ["lib"])
        self.write_index()
        self.patch_index()
        self.write_manifest("./channel")

    def patch_index(self) -> None:
        """The index of a channel may be newer than what its archives say of themselves."""
        self.keep_forms("repodata.json")
        file = self.channel / "noarch/repodata.json"
        index = json.loads(file.read_text())
        index["packages.conda"]["ros-jazzy-demo-1.0-h_0.conda"]["depends"] = ["lib <2"]
        index["packages.conda"]["lib-1.0-h_0.conda"] |= {"timestamp": 1700000000123, "track_features": "slow"}
        file.write_text(json.dumps(index))

    def write_manifest(self, channel: str) -> None:
        (self.folder / "workspace.yaml").write_text(
            f"schema: 1\nname: demo\nchannels: ['{channel}']\nlaunch:\n  - package: demo\n    executable: talker\n")

    def site(self, name: str = "site") -> dict[str, str]:
        """The sha256 of every file of a site, without the channel beside it."""
        root = self.folder / name
        files = {str(file.relative_to(root)): file for file in root.rglob("*") if file.is_file()}
        return {path: hashlib.sha256(file.read_bytes()).hexdigest()
                for path, file in files.items() if not path.startswith("channel/")}

    def lock(self, without_places: bool = False) -> str:
        text = (self.folder / "ros2wasm.lock").read_text()
        return re.sub(r"(?m)^ +(- \S*channel|channel: .*|url: .*)\n", "", text) if without_places else text

    def forget_all_but(self, *kept: str) -> None:
        for path in self.folder.iterdir():
            if path.name not in kept:
                shutil.rmtree(path) if path.is_dir() else path.unlink()

    def check_channel(self, channel: Path) -> list[str]:
        """Its archives, after a look at every part of it."""
        self.assertEqual(sorted(p.name for p in channel.iterdir()), ["emscripten-wasm32", "noarch"])
        archives = []
        for subdir in channel.iterdir():
            index = json.loads((subdir / "repodata.json").read_text())
            self.assertEqual(index["info"]["subdir"], subdir.name)
            self.assertTrue((subdir / "repodata.json.zst").is_file())
            self.assertTrue((subdir / "repodata_shards.msgpack.zst").is_file())
            for name, record in index["packages.conda"].items():
                archive = (subdir / name).read_bytes()
                self.assertEqual(record["sha256"], hashlib.sha256(archive).hexdigest())
                self.assertEqual(record["size"], len(archive))
                self.assertEqual((subdir / name).stat().st_mode & 0o444, 0o444)
                archives.append(name)
            self.assertEqual(sorted(p.name for p in subdir.glob("*.conda")), sorted(index["packages.conda"]))
        self.succeed("channel", "check", str(channel))
        return sorted(archives)

    def test_the_site_stays_the_same(self) -> None:
        self.succeed("pack")
        plain = self.site()
        self.succeed("pack", "--with-channel")
        self.assertEqual(self.site(), plain)
        self.assertNotIn("channel/", (self.folder / "site/site.json").read_text())
        self.assertEqual(self.check_channel(self.folder / "site/channel"),
                         ["lib-1.0-h_0.conda", "ros-jazzy-demo-1.0-h_0.conda"])
        self.succeed("pack")
        self.assertFalse((self.folder / "site/channel").exists())

    def test_the_same_channel_name_gives_the_same_lock(self) -> None:
        self.succeed("pack", "--with-channel")
        site, lock = self.site(), self.lock()
        (self.folder / "site/channel").rename(self.folder / "shipped")
        self.forget_all_but("workspace.yaml", "shipped")
        (self.folder / "shipped").rename(self.channel)
        self.succeed("pack", "--offline", "--with-channel")
        self.assertEqual(self.lock(), lock)
        self.assertEqual(self.site(), site)
        # And what it ships is what it came from.
        for file in self.channel.rglob("*"):
            if file.is_file():
                again = self.folder / "site/channel" / file.relative_to(self.channel)
                self.assertEqual(again.read_bytes(), file.read_bytes(), file)

    def test_from_the_channel_where_it_lies(self) -> None:
        self.succeed("pack", "--with-channel")
        site, lock = self.site(), self.lock(without_places=True)
        self.assertIn("sha256: ", lock)
        self.forget_all_but("site")
        for form in ("repodata_shards.msgpack.zst", "repodata.json.zst", "repodata.json"):
            with self.subTest(form=form):
                self.forget_all_but("site")
                self.write_manifest("./site/channel")
                self.succeed("pack", "--offline", "-o", "again")
                self.assertEqual(self.lock(without_places=True), lock)
                self.assertEqual(self.site("again"), site)
            for file in (self.folder / "site/channel").glob(f"*/{form}"):
                file.unlink()

    def test_from_the_network(self) -> None:
        with FaultServer(self.folder) as server:
            self.write_manifest(server.url + "/channel")
            self.succeed("pack")
            site = self.site()
            self.succeed("cache", "prune")  # the archives are gone, and come again
            self.succeed("pack", "--with-channel")
        self.assertEqual(self.check_channel(self.folder / "site/channel"),
                         ["lib-1.0-h_0.conda", "ros-jazzy-demo-1.0-h_0.conda"])
        self.forget_all_but("site")
        self.write_manifest("./site/channel")
        self.succeed("pack", "--offline", "-o", "again")
        self.assertEqual(self.site("again"), site)

    def test_a_channel_is_not_packed_away(self) -> None:
        self.succeed("pack", "--with-channel")
        self.write_manifest("./site/channel")
        self.fail_with("R2W0603", "pack")
        self.write_manifest((self.folder / "site/channel").as_uri())
        self.fail_with("R2W0603", "pack", "-o", "./site/")
        self.succeed("pack", "--plan")
        self.succeed("pack", "--with-channel")
        self.check_channel(self.folder / "site/channel")

    def test_a_frozen_pack_does_not_pack_its_channel_away(self) -> None:
        """The packages are where the lock says, whatever the manifest has for a channel by now."""
        self.succeed("pack", "--with-channel")
        self.write_manifest("./site/channel")
        self.succeed("lock")
        self.write_manifest("./channel")
        self.fail_with("R2W0603", "pack", "--frozen")
        self.check_channel(self.folder / "site/channel")
        self.succeed("pack", "--frozen", "-o", "again")
        self.succeed("pack", "--frozen", "--with-channel")
        self.check_channel(self.folder / "site/channel")
