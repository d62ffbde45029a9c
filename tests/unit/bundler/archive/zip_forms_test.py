"""A .conda is a zip in any of its forms: order of members, ZIP64, data descriptors, compressed, with a folder or a
comment. All of them hold the same package."""
from __future__ import annotations

import io
import json
import os
import subprocess
import tempfile
import unittest
import zipfile
from pathlib import Path

CLI = os.environ.get("ROS2WASM_CLI", "")


class Unseekable(io.BytesIO):
    """As a pipe: zipfile then puts sizes behind the data."""

    def seekable(self) -> bool:
        return False

    def tell(self) -> int:
        raise io.UnsupportedOperation


class ZipForms(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        stage = self.folder / "stage"
        (stage / "share").mkdir(parents=True)
        (stage / "share" / "a").write_text("hello\n")
        (stage / "share" / "b").symlink_to("a")
        made = subprocess.run(
            [CLI, "channel", "add", str(self.folder / "channel"), "--prefix", str(stage), "--noarch", "--name", "demo",
             "--version", "1.0", "--build", "h_0", "--license", "MIT"],
            check=True, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        with zipfile.ZipFile(made.stdout.strip()) as archive:
            self.members = {name: archive.read(name) for name in archive.namelist()}
        self.wanted = self.inspect(Path(made.stdout.strip()).read_bytes())

    def inspect(self, data: bytes) -> list[dict[str, str]]:
        file = self.folder / "demo-1.0-h_0.conda"
        file.write_bytes(data)
        done = subprocess.run([CLI, "inspect", "archive", str(file)], check=False, text=True, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        answer = json.loads(done.stdout)
        self.assertEqual(answer["faults"], [])
        members: list[dict[str, str]] = answer["members"]
        return sorted(members, key=lambda member: member["path"])

    def zipped(self, names: list[str], *, zip64: bool = False, streamed: bool = False,
               method: int = zipfile.ZIP_STORED, folder: bool = False, comment: bytes = b"") -> bytes:
        made = Unseekable() if streamed else io.BytesIO()
        with zipfile.ZipFile(made, "w", method) as archive:
            if folder:
                archive.writestr(zipfile.ZipInfo("demo/"), b"")
            for name in names:
                info = zipfile.ZipInfo(name)
                info.compress_type = method
                with archive.open(info, "w", force_zip64=zip64) as member:
                    member.write(self.members[name])
            archive.comment = comment
        return made.getvalue()

    def test_every_form_holds_the_same(self) -> None:
        names = sorted(self.members)
        self.assertEqual(len(names), 3)
        without_metadata = [name for name in names if name != "metadata.json"]
        forms = {
            "sorted": self.zipped(names),
            "the other way round": self.zipped(names[::-1]),
            "no metadata.json": self.zipped(without_metadata),
            "ZIP64": self.zipped(names, zip64=True),
            "data descriptors": self.zipped(names, streamed=True),
            "compressed": self.zipped(names, method=zipfile.ZIP_DEFLATED),
            "compressed with descriptors": self.zipped(names, streamed=True, method=zipfile.ZIP_DEFLATED),
            "ZIP64 with descriptors": self.zipped(names, zip64=True, streamed=True),
            "a folder first": self.zipped(names, folder=True),
            "a comment like an end": self.zipped(names, comment=b"PK\x05\x06 and more"),
        }
        for form, data in forms.items():
            with self.subTest(form):
                self.assertEqual(self.inspect(data), self.wanted)


if __name__ == "__main__":
    unittest.main()
