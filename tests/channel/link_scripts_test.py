"""Packages with link scripts: never run, shown, refused unless the manifest names them."""
from __future__ import annotations

import json

from tests.network.channel_fixture import ChannelCase

WASM = b"\0asm\1\0\0\0"
SCRIPT = b"#!/bin/sh\ntouch \"$HOME/it-was-run\"\n"


class LinkScripts(ChannelCase):
    def setUp(self) -> None:
        super().setUp()
        self.archive = self.add_package(
            "fonts", {"share/fonts/a": b"a", "bin/.fonts-post-link.sh": SCRIPT, "bin/.fonts-pre-unlink.sh": SCRIPT})
        self.add_package("ros-jazzy-demo", {"share/demo/package.xml": b"<package/>",
                                            "lib/demo/talker.wasm": WASM}, ["fonts"])
        self.write_index()

    def write_manifest(self, more: str = "") -> None:
        (self.folder / "workspace.yaml").write_text(
            "schema: 1\nname: demo\nchannels: [./channel]\n" + more +
            "launch:\n  - package: demo\n    executable: talker\n")

    def test_refused_with_the_script_shown(self) -> None:
        self.write_manifest()
        text = self.fail_with("R2W0227", "pack")
        self.assertEqual(text.count("error[R2W0227]"), 2, text)
        self.assertIn("`fonts` has a link script, `bin/.fonts-post-link.sh`", text)
        self.assertIn('touch "$HOME/it-was-run"', text)
        self.assertIn("name `fonts` under `ignore_link_scripts:`", text)
        self.assertFalse((self.folder / "site").exists())
        self.assertFalse((self.folder / "it-was-run").exists())

    def test_used_without_running_it(self) -> None:
        self.write_manifest("ignore_link_scripts: [fonts]\n")
        done = self.run_cli("pack")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("did not run bin/.fonts-post-link.sh of fonts", done.stderr)
        self.assertTrue((self.folder / "site/site.json").exists())
        self.assertFalse((self.folder / "it-was-run").exists())
        # The package is cached by now; that changes nothing for a workspace that does not name it.
        self.write_manifest("ignore_link_scripts: [other]\n")
        self.fail_with("R2W0227", "pack")

    def test_named_for_another_and_with_capitals(self) -> None:
        """A script belongs to who brought it; the manifest can name that one, whatever the file is called."""
        self.add_package("other", {"bin/.Fonts+-post-link.sh": SCRIPT})
        self.write_index()
        self.write_manifest("ignore_link_scripts: [fonts]\ndependencies: [other]\n")
        text = self.fail_with("R2W0227", "pack")
        self.assertIn("`other` has a link script, `bin/.Fonts+-post-link.sh`", text)
        self.assertIn("name `other` under `ignore_link_scripts:`", text)
        self.write_manifest("ignore_link_scripts: [fonts, other]\ndependencies: [other]\n")
        done = self.run_cli("pack")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("did not run bin/.Fonts+-post-link.sh of other", done.stderr)

    def test_listed_by_inspect(self) -> None:
        said = json.loads(self.succeed("inspect", "archive", str(self.archive)))
        self.assertEqual(said["link_scripts"], ["bin/.fonts-post-link.sh", "bin/.fonts-pre-unlink.sh"])
