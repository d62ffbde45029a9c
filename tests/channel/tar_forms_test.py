"""A .tar.bz2 in any of its forms holds the same package; prefixes in text and binary files become the environment's."""
from __future__ import annotations

import bz2
import hashlib
import io
import json
import tarfile
from pathlib import Path

from tests.network.channel_fixture import ChannelCase

WASM = b"\0asm\1\0\0\0"
LONG = "share/" + "n" * 120 + "/\u00fc.txt"  # more than ustar has room for in a name
PLACEHOLDER = "/" + "p" * 254
FILES = {"lib/demo/talker.wasm": WASM, "share/demo/package.xml": b"<package/>", "share/empty": b"", LONG: b"long\n",
         "lib/demo.cmake": f"set(P {PLACEHOLDER}/lib;{PLACEHOLDER})\n".encode(),
         "lib/demo.bin": b"\x7f\0" + PLACEHOLDER.encode() + b"/lib:" + PLACEHOLDER.encode() + b"/bin\0tail\0"}


Member = tuple[tarfile.TarInfo, bytes]


def member(name: str, data: bytes = b"", kind: bytes = tarfile.REGTYPE, target: str = "") -> Member:
    info = tarfile.TarInfo(name)
    info.type, info.linkname, info.size = kind, target, len(data)
    return info, data


def tarred(members: list[Member], form: int = tarfile.PAX_FORMAT) -> bytes:
    made = io.BytesIO()
    with tarfile.open(fileobj=made, mode="w", format=form) as tar:
        for info, data in members:
            tar.addfile(info, io.BytesIO(data))
    return made.getvalue()


class TarForms(ChannelCase):
    def setUp(self) -> None:
        super().setUp()
        self.placeholder = PLACEHOLDER
        (self.folder / "workspace.yaml").write_text(
            "schema: 1\nname: demo\nchannels: [./channel]\nlaunch:\n  - package: demo\n    executable: talker\n")

    def info(self, **changes: object) -> list[Member]:
        """info/ of the package; `share/same` is another name of `share/empty`, `share/link` leads to package.xml."""
        paths: list[dict[str, object]] = [
            {"_path": path, "path_type": "hardlink", "sha256": hashlib.sha256(data).hexdigest(),
             "size_in_bytes": len(data)} for path, data in (FILES | {"share/same": b""}).items()]
        for entry in paths:
            if str(entry["_path"]).startswith("lib/demo."):
                entry |= {"prefix_placeholder": self.placeholder,
                          "file_mode": "binary" if str(entry["_path"]).endswith("bin") else "text"}
        paths.append({"_path": "share/link", "path_type": "softlink", "file_mode": "text",
                      "prefix_placeholder": self.placeholder,  # as some old packages say; a link is not rewritten
                      "sha256": hashlib.sha256(FILES["share/demo/package.xml"]).hexdigest(), "size_in_bytes": 10})
        index = {"name": "ros-jazzy-demo", "version": "1.0", "build": "h_0", "build_number": 0, "subdir": "noarch",
                 "depends": []}
        return [member("info/index.json", json.dumps(index | changes).encode()),
                member("info/paths.json", json.dumps({"paths": paths, "paths_version": 1}).encode())]

    def files(self, before: str = "") -> list[Member]:
        return [*(member(before + path, data) for path, data in FILES.items()),
                member(before + "share/link", kind=tarfile.SYMTYPE, target="demo/package.xml"),
                member(before + "share/same", kind=tarfile.LNKTYPE, target=before + "share/empty")]

    def add(self, packed: bytes) -> Path:
        archive = self.folder / "ros-jazzy-demo-1.0-h_0.tar.bz2"
        archive.write_bytes(packed)
        self.succeed("channel", "add", str(self.channel), str(archive))
        self.write_index()
        (self.folder / "ros2wasm.lock").unlink(missing_ok=True)
        return archive

    def made_environment(self) -> Path:
        """Of the last pack; there is no other."""
        prefix, = (p for p in (self.folder / "cache/ros2wasm/environments").iterdir()
                   if p.is_dir() and p.name != "unfinished")
        return prefix

    def test_every_form_holds_the_same(self) -> None:
        dotted = [(info, data) for info, data in self.info()]
        for info, _ in dotted:
            info.name = "./" + info.name
        whole = tarred(self.info() + self.files())
        forms = {
            "info first": bz2.compress(whole),
            "info last": bz2.compress(tarred(self.files() + self.info())),
            "dots before the names": bz2.compress(tarred(
                [member(".", kind=tarfile.DIRTYPE), *self.files("./"), *dotted])),
            "folders too": bz2.compress(tarred(
                [member("lib/", kind=tarfile.DIRTYPE), member("share/", kind=tarfile.DIRTYPE),
                 *self.files(), *self.info()])),
            "GNU": bz2.compress(tarred(self.info() + self.files(), tarfile.GNU_FORMAT)),
            "two streams": bz2.compress(whole[:3000]) + bz2.compress(whole[3000:]),
            "without an end": bz2.compress(whole.rstrip(b"\0") + bytes(-len(whole.rstrip(b"\0")) % 512)),
        }
        sites = set()
        for form, packed in forms.items():
            with self.subTest(form):
                archive = self.add(packed)
                said = json.loads(self.succeed("inspect", "archive", str(archive)))
                self.assertEqual(said["faults"], [])
                self.succeed("pack")
                sites.add((self.folder / "site/site.json").read_bytes())
                self.succeed("cache", "verify")
                package, = (self.folder / "cache/ros2wasm/packages").glob("??/*[0-9a-f]")
                self.assertEqual((package / "share/same").read_bytes(), b"")
                self.assertEqual((package / "share/link").readlink(), Path("demo/package.xml"))
                self.assertEqual((package / LONG).read_bytes(), b"long\n")
                self.succeed("cache", "prune", "--all")
        self.assertEqual(len(sites), 1)

    def test_cut_and_foreign_archives_are_refused(self) -> None:
        packed = bz2.compress(tarred(self.info() + self.files()))
        bad = self.folder / "ros-jazzy-demo-1.0-h_0.tar.bz2"
        for what, data in (("cut", packed[:len(packed) // 2]), ("empty", b""), ("text", b"no archive\n" * 100),
                           ("no info", bz2.compress(tarred(self.files())))):
            with self.subTest(what):
                bad.write_bytes(data)
                self.fail_with("R2W0221", "channel", "add", str(self.channel), str(bad))

    def test_prefixes(self) -> None:
        archive = self.add(bz2.compress(tarred(self.info() + self.files())))
        self.succeed("pack")
        prefix = self.made_environment()
        self.assertEqual((prefix / "lib/demo.cmake").read_text(), f"set(P {prefix}/lib;{prefix})\n")
        binary = (prefix / "lib/demo.bin").read_bytes()
        self.assertEqual(len(binary), len(FILES["lib/demo.bin"]))
        self.assertEqual(binary[2:].split(b"\0")[0], f"{prefix}/lib:{prefix}/bin".encode())
        self.assertTrue(binary.endswith(b"\0tail\0"))
        self.assertEqual((prefix / "share/link").readlink(), Path("demo/package.xml"))
        # A file without a prefix inside is a link to the store's file; the store has the archive's bytes.
        package, = (self.folder / "cache/ros2wasm/packages").glob("??/*[0-9a-f]")
        self.assertTrue((prefix / LONG).samefile(package / LONG))
        self.assertEqual((package / "lib/demo.bin").read_bytes(), FILES["lib/demo.bin"])
        said = json.loads(self.succeed("inspect", "archive", str(archive)))
        self.assertEqual(said["faults"], [])

    def test_a_binary_file_without_room(self) -> None:
        self.placeholder = "/ppp"  # the files hold it too, at the beginning of the long one
        self.add(bz2.compress(tarred(self.info() + self.files())))
        self.assertIn("`lib/demo.bin` cannot be moved", self.fail_with("R2W0230", "pack"))
        self.assertFalse((self.folder / "site").exists())
