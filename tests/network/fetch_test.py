"""Fetching archives over HTTP with a server that misbehaves, and a pack that is killed at any moment.

Every case ends in success or one clear error, the cache verifies clean afterwards, and the next pack gives the same
bytes."""
from __future__ import annotations

import hashlib
import json
import os
import random
import shutil
import signal
import subprocess
import threading
import time
import unittest

from tests.network.channel_fixture import CLI, ChannelCase
from tests.network.fault_server import FOREVER, Fault, FaultServer, self_signed_certificate

WASM = b"\0asm\1\0\0\0"
# How often a pack is killed; ROS2WASM_KILLS=200 for a long run.
KILLS = int(os.environ.get("ROS2WASM_KILLS", "30"))


class FetchCase(ChannelCase):
    def setUp(self) -> None:
        super().setUp()
        noise = random.Random(7)  # bytes that cannot be compressed, so that archives have a size
        names = [f"lib{i}" for i in range(4)]
        for name in names:
            self.add_package(name, {f"share/{name}/data": noise.randbytes(200_000)})
        self.add_package("ros-jazzy-demo", {"share/demo/package.xml": b"<package/>",
                                            "lib/demo/talker.wasm": WASM}, names)
        self.write_index()
        self.server = self.enterContext(FaultServer(self.folder))
        self.archive = "/channel/noarch/lib0-1.0-h_0.conda"
        self.write_manifest(self.server.url + "/channel")

    def write_manifest(self, channel: str, more: str = "") -> None:
        (self.folder / "workspace.yaml").write_text(
            f"schema: 1\nname: demo\nchannels: [\"{channel}\"]\n"
            f"launch:\n  - package: demo\n    executable: talker\n{more}")

    def site(self) -> str:
        """The hash of the site and its lock."""
        hasher = hashlib.sha256()
        files = [file for file in (self.folder / "site").rglob("*") if file.is_file()]
        for file in sorted(files) + [self.folder / "ros2wasm.lock"]:
            hasher.update(f"{file.relative_to(self.folder)} ".encode() + file.read_bytes())
        return hasher.hexdigest()

    def packed(self, *words: str, **variables: str) -> str:
        self.succeed("pack", *words, **variables)
        return self.site()

    def check_cache(self) -> None:
        self.assertIn(" 0 damaged", self.succeed("cache", "verify"))

    def forget_everything(self) -> None:
        for name in ("cache/ros2wasm/packages", "cache/ros2wasm/archives", "cache/ros2wasm/environments", "site"):
            shutil.rmtree(self.folder / name, ignore_errors=True)
        self.server.forget()


class Fetching(FetchCase):
    def test_faults_that_pass(self) -> None:
        wanted = self.packed()
        for faults in (
            [Fault("truncate", 90_000)], [Fault("truncate", 70_000), Fault("truncate", 70_000)],
            [Fault("reset", 50_000)], [Fault("status", 503)], [Fault("retry_after", (429, "1"))],
            [Fault("shorter_than_real", 10)], [Fault("longer_than_real", 10)], [Fault("other_bytes")],
            [Fault("truncate_without_ranges", 90_000), Fault("truncate_without_ranges", 200_000)],
            [Fault("truncate", 90_000), Fault("wrong_range")],
            [Fault("truncate", 90_000), Fault("whole_despite_range")],
            [Fault("redirect", self.archive + "?again")],
        ):
            with self.subTest(faults=[fault.kind for fault in faults]):
                self.forget_everything()
                self.server.plan(self.archive, *faults)
                self.assertEqual(self.packed(), wanted)
                self.assertEqual(self.server.behaviour.plan[self.archive], [])
                self.check_cache()

    def test_what_is_all_there_is_taken_whatever_was_promised(self) -> None:
        wanted = self.packed()
        self.forget_everything()
        self.server.plan(self.archive, Fault("longer_than_real", 10), FOREVER)
        self.assertEqual(self.packed(), wanted)
        self.assertEqual(len(self.server.seen(self.archive)), 1)
        self.check_cache()

    def test_a_drip_is_given_up(self) -> None:
        wanted = self.packed()
        self.forget_everything()
        self.server.plan(self.archive, Fault("drip"))
        self.assertEqual(self.packed(ROS2WASM_STALL_SECONDS="1"), wanted)
        self.assertGreater(len(self.server.seen(self.archive)), 1)
        self.check_cache()

    def test_a_server_that_asks_for_a_pause_has_it(self) -> None:
        self.server.plan(self.archive, Fault("retry_after", (429, "2")))
        self.packed()
        first, second = self.server.seen(self.archive)
        self.assertGreater(second.at - first.at, 2)

    def test_a_broken_transfer_goes_on_where_it_ended(self) -> None:
        self.server.plan(self.archive, Fault("truncate", 90_000))
        self.packed()
        first, second = self.server.seen(self.archive)
        self.assertNotIn("range", first.headers)
        self.assertEqual(second.headers["range"], "bytes=90000-")
        self.assertEqual(second.status, 206)

    # Guarantee, hostile input: a server that truncates, drips, resets, redirects in circles, lies about
    # lengths or sends other bytes: one clear error, and a clean cache
    def test_faults_that_stay(self) -> None:
        wanted = self.packed()
        for code, fault in (
            ("R2W0220", Fault("other_bytes")), ("R2W0220", Fault("endless")),
            ("R2W0228", Fault("status", 404)), ("R2W0234", Fault("status", 500)),
            ("R2W0234", Fault("retry_after", (503, "86400"))), ("R2W0233", Fault("truncate", 0)),
            ("R2W0233", Fault("reset", 0)), ("R2W0236", Fault("redirect", self.archive)),
            ("R2W0220", Fault("shorter_than_real", 10)),
        ):
            with self.subTest(fault=fault):
                self.forget_everything()
                self.server.plan(self.archive, fault, FOREVER)
                text = self.fail_with(code, "pack")
                self.assertEqual(text.count("error["), 1, text)
                self.assertFalse((self.folder / "site").exists())
                self.check_cache()
                self.server.plan(self.archive)
                self.assertEqual(self.packed(), wanted)

    def archives_at(self, base_url: str) -> None:
        """The index stays where it is and says that its archives are there."""
        self.keep_forms("repodata.json")
        index = self.channel / "noarch/repodata.json"
        flat = json.loads(index.read_text())
        flat["info"]["base_url"] = base_url
        index.write_text(json.dumps(flat))
        (self.folder / "ros2wasm.lock").unlink(missing_ok=True)
        self.forget_everything()

    def test_certificates_of_archives(self) -> None:
        pem = self_signed_certificate(self.folder)
        with FaultServer(self.folder, certificate=pem) as server:
            self.archives_at(server.url + "/channel/noarch")
            trusted = {"SSL_CERT_FILE": str(self.folder / "cert.pem")}
            wanted = self.packed(**trusted)
            self.forget_everything()
            text = self.fail_with("R2W0235", "pack")
            self.assertEqual(text.count("error["), 1, text)  # not one for each archive
            self.assertIn("the same is true of 4 more archives", text)
            self.assertFalse((self.folder / "site").exists())
            self.check_cache()
            self.assertEqual(self.packed(**trusted), wanted)

    def test_each_server_that_fails_is_told_once(self) -> None:
        names = ["extra0", "extra1"]
        for name in names:
            self.add_package(name, {f"share/{name}/data": b"data"}, channel=self.folder / "others")
        self.write_index(self.folder / "others")
        with FaultServer(self.folder) as other:
            self.write_manifest(f'{self.server.url}/channel", "{other.url}/others',
                                f"dependencies: [{', '.join(names)}]\n")
            for server, archive in ((self.server, "channel/noarch/lib"), (other, "others/noarch/extra")):
                for i in range(2):
                    server.plan(f"/{archive}{i}-1.0-h_0.conda", Fault("reset", 0), FOREVER)
            text = self.fail_with("R2W0233", "pack")
            self.assertEqual(text.count("error["), 2, text)
            for first in (f"{self.server.url}/channel/noarch/lib0", f"{other.url}/others/noarch/extra0"):
                self.assertIn(first, text)
            self.assertEqual(text.count("the same is true of 1 more archive\n"), 2, text)

    def test_archives_from_a_server_without_tls(self) -> None:
        self.archives_at(self.server.url.replace("http://", "https://") + "/channel/noarch")
        text = self.fail_with("R2W0233", "pack")
        self.assertEqual(text.count("error["), 1, text)
        self.assertFalse((self.folder / "site").exists())
        self.check_cache()
        self.archives_at(self.server.url + "/channel/noarch")
        self.packed()
        self.check_cache()

    def test_offline(self) -> None:
        wanted = self.packed()
        self.server.forget()
        self.assertEqual(self.packed("--offline"), wanted)
        self.assertEqual(self.server.behaviour.seen, [])
        self.forget_everything()
        self.fail_with("R2W0232", "pack", "--offline")
        self.assertEqual(self.server.behaviour.seen, [])

    # Guarantee, robust: a damaged package of the cache is found and made again
    def test_a_damaged_package_is_made_again(self) -> None:
        wanted = self.packed()
        for file in (self.folder / "cache").rglob("share/lib0/data"):
            file.chmod(0o644)
            file.write_bytes(b"x" + file.read_bytes()[1:])
        self.fail_with("R2W0239", "cache", "verify")
        self.assertEqual(self.packed(), wanted)
        self.check_cache()

    # Guarantee, robust: packs at once with one cache all succeed
    def test_two_packs_at_once(self) -> None:
        wanted = self.packed()
        self.forget_everything()
        others = [subprocess.Popen([CLI, "pack", "-o", f"site{i}"], cwd=self.folder, env=self.environment,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) for i in range(3)]
        for other in others:
            _, text = other.communicate(timeout=120)
            self.assertEqual(other.returncode, 0, text)
        self.check_cache()
        self.assertEqual(self.packed(), wanted)

    def test_prune(self) -> None:
        wanted = self.packed()
        self.succeed("cache", "prune")
        self.assertEqual(list((self.folder / "cache/ros2wasm/archives").rglob("*.conda")), [])
        self.assertEqual(self.packed("--offline"), wanted)
        self.succeed("cache", "prune", "--all")
        self.assertIn("0 checked", self.succeed("cache", "verify"))
        self.assertEqual(self.packed(), wanted)
        self.assertIn("packages", self.succeed("cache", "info"))


class ManyArchives(ChannelCase):
    def test_as_many_at_once_as_a_host_is_asked_for(self) -> None:
        at_once = 6  # DownloadSettings::per_host
        names = [f"lib{i}" for i in range(3 * at_once)]
        for name in names:
            self.add_package(name, {f"share/{name}/data": name.encode()})
        self.add_package("ros-jazzy-demo", {"lib/demo/talker.wasm": WASM}, names)
        self.write_index()
        with FaultServer(self.folder) as server:
            barrier = threading.Barrier(at_once, timeout=30)
            for name in names:
                server.plan(f"/channel/noarch/{name}-1.0-h_0.conda", Fault("together", barrier))
            (self.folder / "workspace.yaml").write_text(
                f"schema: 1\nname: demo\nchannels: [\"{server.url}/channel\"]\n"
                "launch:\n  - package: demo\n    executable: talker\n")
            self.succeed("lock")
            self.succeed("cache", "fetch", ROS2WASM_RETRIES="0")
            self.assertEqual(server.behaviour.most_connections, at_once)


class Killing(FetchCase):
    # Guarantee, robust: `pack` killed (SIGKILL) at random moments: the next one gives the same bytes
    def test_killed_at_any_moment(self) -> None:
        started = time.monotonic()
        wanted = self.packed()
        whole = time.monotonic() - started
        seed = int(os.environ.get("ROS2WASM_KILL_SEED", str(random.SystemRandom().randrange(1 << 32))))
        print(f"\nkilling {KILLS} packs, ROS2WASM_KILL_SEED={seed}", flush=True)
        moments = random.Random(seed)
        for number in range(KILLS):
            self.forget_everything()
            pack = subprocess.Popen([CLI, "pack"], cwd=self.folder, env=self.environment, start_new_session=True,
                                    stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            try:
                pack.wait(moments.uniform(0, whole))  # the moment is what this test varies
            except subprocess.TimeoutExpired:
                os.killpg(pack.pid, signal.SIGKILL)
                pack.wait(10)
            with self.subTest(number=number, seed=seed):
                self.check_cache()
                self.assertEqual(self.packed(), wanted)
                self.check_cache()


if __name__ == "__main__":
    unittest.main()
