"""Mirrors of a channel: asked first, for indexes and for archives, and left for the next when they fail.

A mirror can be a folder. Nothing of all this is in the lock or in the site."""
from __future__ import annotations

import shutil
import unittest

from tests.network.fault_server import FOREVER, Fault
from tests.network.fetch_test import FetchCase

FORMS = ("repodata_shards.msgpack.zst", "repodata.json.zst", "repodata.json.bz2", "repodata.json")
SUBDIRS = ("noarch", "emscripten-wasm32")


class Mirrors(FetchCase):
    def setUp(self) -> None:
        super().setUp()
        self.origin = self.server.url + "/channel"
        self.wanted = self.packed()
        for name in ("a", "b"):
            shutil.copytree(self.channel, self.folder / "mirror" / name)
        self.begin()

    def begin(self) -> None:
        shutil.rmtree(self.folder / "cache", ignore_errors=True)
        self.server.forget()

    def use(self, *places: str) -> None:
        listed = "".join(f"    - {place}\n" for place in places)
        self.write_manifest(self.origin, f"mirrors:\n  {self.origin}:\n{listed}")

    def asked(self, below: str) -> list[str]:
        return [one.path for one in self.server.behaviour.seen if one.path.startswith(below)]

    def plan_indexes(self, channel: str, fault: Fault) -> None:
        for subdir in SUBDIRS:
            for form in FORMS:
                self.server.plan(f"{channel}/{subdir}/{form}", fault, FOREVER)

    def test_all_comes_from_the_first_that_has_it(self) -> None:
        self.use(self.server.url + "/mirror/a/", self.server.url + "/mirror/b")
        self.assertEqual(self.packed(), self.wanted)
        self.assertEqual(self.asked("/channel"), [])
        self.assertEqual(self.asked("/mirror/b"), [])
        self.begin()
        self.assertEqual(self.packed("--frozen"), self.wanted)
        self.assertEqual(self.asked("/channel") + self.asked("/mirror/b"), [])

    def test_a_copy_is_asked_after_where_it_came_from(self) -> None:
        self.use(self.server.url + "/mirror/a")
        self.packed()
        self.server.forget()
        self.assertEqual(self.packed(), self.wanted)
        self.assertEqual({one.status for one in self.server.behaviour.seen if "/noarch/" in one.path}, {304})
        self.assertEqual(self.asked("/channel"), [])

    def test_archives_from_the_next_place(self) -> None:
        self.use(self.server.url + "/mirror/a", self.server.url + "/mirror/b")
        for fault in (Fault("other_bytes"), Fault("status", 404), Fault("status", 500), Fault("reset", 0),
                      Fault("truncate", 0), Fault("endless")):
            with self.subTest(fault=fault):
                self.begin()
                self.server.plan("/mirror/a/noarch/lib0-1.0-h_0.conda", fault, FOREVER)
                self.server.plan("/mirror/b/noarch/lib0-1.0-h_0.conda", Fault("status", 500), FOREVER)
                self.assertEqual(self.packed(), self.wanted)
                self.assertEqual(self.asked("/channel"), [self.archive])
                self.check_cache()

    def test_indexes_from_the_next_place(self) -> None:
        self.use(self.server.url + "/mirror/a")
        for fault in (Fault("status", 404), Fault("status", 403), Fault("status", 500), Fault("reset", 10),
                      Fault("truncate", 10), Fault("login_page"), Fault("redirect", "/elsewhere")):
            with self.subTest(fault=fault):
                self.begin()
                self.plan_indexes("/mirror/a", fault)
                self.assertEqual(self.packed(), self.wanted)
                self.assertNotEqual([one for one in self.asked("/channel") if "/repodata" in one], [])
                self.assertEqual([one for one in self.asked("/channel") if one.endswith(".conda")], [])
                self.check_cache()

    def test_a_mirror_with_a_plain_index_does_for_a_channel_that_is_gone(self) -> None:
        self.use(self.server.url + "/mirror/a")
        shutil.move(self.channel, self.folder / "gone")
        self.plan_indexes("/channel", Fault("status", 500))
        for subdir in (self.folder / "mirror/a").iterdir():
            for form in FORMS[:-1]:
                (subdir / form).unlink(missing_ok=True)
        self.assertEqual(self.packed(), self.wanted)

    # Guarantee, hostile input: a mirror that answers with other pages is passed by, and there is one clear error
    # when all fail
    def test_one_error_when_all_fail(self) -> None:
        self.use(self.server.url + "/mirror/a", "./mirror/empty")
        self.plan_indexes("/mirror/a", Fault("login_page"))
        self.plan_indexes("/channel", Fault("status", 500))
        text = self.fail_with("R2W0234", "pack")
        self.assertEqual(text.count("error["), 1, text)
        self.assertIn(self.origin, text)

    def test_a_folder_is_a_mirror(self) -> None:
        for place in ("./mirror/a", "mirror/a", f"file://{self.folder}/mirror/a"):
            with self.subTest(place=place):
                self.begin()
                self.use(place)
                self.assertEqual(self.packed(), self.wanted)
                self.assertEqual(self.server.behaviour.seen, [])
        self.begin()
        self.assertEqual(self.packed("--offline"), self.wanted)
        self.check_cache()

    def test_what_a_folder_lacks_comes_over_the_network(self) -> None:
        self.use("mirror/a")
        place = self.folder / "mirror/a/noarch"
        damaged = place / "lib0-1.0-h_0.conda"
        damaged.write_bytes(damaged.read_bytes()[:-1] + b"?")
        damaged.chmod(0o444)
        (place / "lib1-1.0-h_0.conda").unlink()
        self.assertEqual(self.packed(), self.wanted)
        self.assertEqual(sorted(self.asked("/channel")),
                         [f"/channel/noarch/lib{i}-1.0-h_0.conda" for i in range(2)])
        self.begin()
        for subdir in SUBDIRS:
            shutil.rmtree(self.folder / "mirror/a" / subdir, ignore_errors=True)
        self.assertEqual(self.packed(), self.wanted)


if __name__ == "__main__":
    unittest.main()
