#!/usr/bin/env python3
"""Makes a wheel for py3-none-any and prints its sha256.

  make_wheel.py FOLDER NAME VERSION [--requires TEXT]... PATH=TEXT...
"""
from __future__ import annotations

import argparse
import base64
import hashlib
import zipfile
from pathlib import Path


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("name")
    parser.add_argument("version")
    parser.add_argument("--requires", action="append", default=[])
    parser.add_argument("members", nargs="*")
    options = parser.parse_intermixed_args()
    info = f"{options.name}-{options.version}.dist-info"
    requires = "".join(f"Requires-Dist: {one}\n" for one in options.requires)
    files = dict(member.split("=", 1) for member in options.members)
    files[f"{info}/METADATA"] = f"Metadata-Version: 2.1\nName: {options.name}\nVersion: {options.version}\n{requires}"
    files[f"{info}/WHEEL"] = "Wheel-Version: 1.0\nRoot-Is-Purelib: true\nTag: py3-none-any\n"
    record = f"{info}/RECORD,,\n"
    for path, text in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(text.encode()).digest()).rstrip(b"=").decode()
        record += f"{path},sha256={digest},{len(text.encode())}\n"
    files[f"{info}/RECORD"] = record
    options.folder.mkdir(parents=True, exist_ok=True)
    wheel = options.folder / f"{options.name}-{options.version}-py3-none-any.whl"
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for path, text in files.items():
            archive.writestr(zipfile.ZipInfo(path), text)
    print(hashlib.sha256(wheel.read_bytes()).hexdigest())


if __name__ == "__main__":
    main()
