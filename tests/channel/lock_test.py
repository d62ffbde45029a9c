"""`ros2wasm lock`: what is locked stays, until somebody asks for it anew."""
from __future__ import annotations

import json

from tests.network.channel_fixture import ChannelCase


class Locking(ChannelCase):
    def setUp(self) -> None:
        super().setUp()
        for name in ("one", "two"):
            self.add_package(name, {f"share/{name}": b"old"})
        self.write_index()
        (self.folder / "workspace.yaml").write_text(
            "schema: 1\nname: demo\nchannels: [./channel]\ndependencies: [one, two]\n"
            "launch:\n  - package: demo\n    executable: talker\n")
        self.succeed("lock")
        for name in ("one", "two"):
            self.add_package(name, {f"share/{name}": b"new"}, version="2.0")
        self.write_index()

    def lock(self, *words: str) -> tuple[bool, list[str]]:
        said = json.loads(self.succeed("lock", "--json", *words))
        self.assertEqual(said["lock"], str(self.folder.resolve() / "ros2wasm.lock"))
        return said["changed"], [f'{one["name"]} {one["version"]}' for one in said["packages"]]

    def test_what_is_locked_stays(self) -> None:
        before = (self.folder / "ros2wasm.lock").read_bytes()
        self.assertEqual(self.lock(), (False, ["one 1.0", "two 1.0"]))
        self.assertEqual((self.folder / "ros2wasm.lock").read_bytes(), before)

    def test_one_is_chosen_anew(self) -> None:
        self.assertEqual(self.lock("--update", "two"), (True, ["one 1.0", "two 2.0"]))
        self.assertEqual(self.lock(), (False, ["one 1.0", "two 2.0"]))

    def test_all_are_chosen_anew(self) -> None:
        self.assertEqual(self.lock("--update"), (True, ["one 2.0", "two 2.0"]))

    def test_a_check_asks_no_channel_and_sees_what_does_not_hold(self) -> None:
        manifest = self.folder / "workspace.yaml"
        self.assertEqual(self.lock("--check"), (False, ["one 1.0", "two 1.0"]))
        # Other words for what is there already: no hash of the request is compared.
        manifest.write_text(manifest.read_text().replace("[one, two]", "['two <2', 'one 1.*']"))
        self.channel.rename(self.folder / "away")
        self.lock("--check")
        manifest.write_text(manifest.read_text().replace("two <2", "two >=2"))
        text = self.fail_with("R2W0311", "lock", "--check")
        self.assertIn("two >=2", text)

    def test_other_words_for_the_same_are_no_change(self) -> None:
        manifest = self.folder / "workspace.yaml"
        text = manifest.read_text()
        manifest.write_text(text.replace("[one, two]", "['one <2', two]"))
        self.assertNotIn("R2W0320", self.run_cli("pack", "--locked").stderr)

    def test_what_would_change_is_named(self) -> None:
        manifest = self.folder / "workspace.yaml"
        text = manifest.read_text()
        manifest.write_text(text.replace("[one, two]", "[one]"))
        said = self.fail_with("R2W0320", "pack", "--locked")
        self.assertIn("nothing asks for `two-1.0-h_0` any more", said)
        manifest.write_text(text)
        (self.channel / "noarch/one-1.0-h_0.conda").unlink()
        self.write_index()
        said = self.fail_with("R2W0320", "pack", "--locked")
        self.assertIn("`one-2.0-h_0` would take the place of `one-1.0-h_0`", said)
        self.assertNotIn("two-", said)
