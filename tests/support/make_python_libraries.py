#!/usr/bin/env python3
"""Makes a small distribution of compiled Python libraries in the form of Pyodide's, with its lock file.

  make_python_libraries.py FOLDER [--numpy]

In it: `gear-box`, a wheel with an extension module in C that needs `libteeth.so`; `teeth`, the archive of that
library; `springs`, a wheel for the stable ABI with two libraries of its own; `rods`, plain Python; `liar`, `cut` and
`outsider`, whose modules a site must not load; with --numpy, npm's numpy as a wheel. The lock is
FOLDER/pyodide-lock.json. Side modules are linked by this machine's Emscripten, whose calls of plain C functions are
those of the one that Pyodide was built with; the few declarations of Python's C API that they need are their own.
"""
from __future__ import annotations

import argparse
import base64
import hashlib
import json
import os
import shutil
import subprocess
import tarfile
import tempfile
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PLATFORM = "pyodide_2024_0_wasm32"
API = """
typedef struct PyObject PyObject;
struct PyMethodDef { const char* name; PyObject* (*call)(PyObject*, PyObject*); int flags; const char* text; };
struct PyModuleDef { int references; void* type; void* init; int index; void* copy; const char* name; const char* text;
  int size; struct PyMethodDef* methods; void* slots; void* traverse; void* clear; void* free; };
extern PyObject* PyModule_Create2(struct PyModuleDef*, int);
extern PyObject* PyLong_FromLong(long);
extern long PyLong_AsLong(PyObject*);
#define ONE_FUNCTION(module, function, version) \\
  static struct PyMethodDef methods[] = {{#function, function, 8, 0}, {0, 0, 0, 0}}; \\
  static struct PyModuleDef definition = {1, 0, 0, 0, 0, #module, 0, -1, methods, 0, 0, 0, 0}; \\
  __attribute__((visibility("default"))) PyObject* PyInit_##module(void) { \\
    return PyModule_Create2(&definition, version); }
"""
GEAR = API + """
extern int teeth_of(int);
static PyObject* teeth(PyObject* self, PyObject* number) { return PyLong_FromLong(teeth_of(PyLong_AsLong(number))); }
ONE_FUNCTION(_gear, teeth, 1013)
"""
SPRINGS = API + """
extern int stiffness_of(int);
static PyObject* stiffness(PyObject* self, PyObject* number) {
  return PyLong_FromLong(stiffness_of(PyLong_AsLong(number))); }
ONE_FUNCTION(springs, stiffness, 3)
"""
COIL = """
extern int turns;
extern int wire_of(int);
__attribute__((visibility("default"))) int stiffness_of(int number) { return turns * wire_of(number); }
"""
WIRE = """
__attribute__((visibility("default"))) int turns = 8;
__attribute__((visibility("default"))) int wire_of(int number) { return 5 * number; }
"""
TEETH = """
static int table[4] = {7, 11, 13, 17};
__attribute__((visibility("default"))) int teeth_of(int number) { return table[number & 3] * number; }
"""


def side_module(folder: Path, name: str, text: str, function: str, *libraries: Path) -> Path:
    source = folder / f"{name}.c"
    source.write_text(text, encoding="utf-8")
    out = folder / name
    subprocess.run(["emcc", "-O2", "-sSIDE_MODULE=2", f"-sEXPORTED_FUNCTIONS={function}", str(source),
                    *map(str, libraries), "-o", str(out)],
                   check=True, env={**os.environ, "NODE_PATH": "/usr/share/nodejs"})
    return out


def archive(path: Path, files: dict[str, bytes]) -> None:
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as out:
        for name, content in sorted(files.items()):
            out.writestr(zipfile.ZipInfo(name), content)


def wheel(folder: Path, project: str, version: str, tags: str, files: dict[str, bytes], requires: list[str]) -> str:
    info = f"{project}-{version}.dist-info"
    needs = "".join(f"Requires-Dist: {one}\n" for one in requires)
    text = f"Metadata-Version: 2.1\nName: {project}\nVersion: {version}\nLicense: MIT\n{needs}"
    files = {**files, f"{info}/METADATA": text.encode(),
             f"{info}/WHEEL": f"Wheel-Version: 1.0\nRoot-Is-Purelib: false\nTag: {tags}\n".encode()}
    record = f"{info}/RECORD,,\n"
    for path, content in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        record += f"{path},sha256={digest},{len(content)}\n"
    name = f"{project}-{version}-{tags}.whl"
    archive(folder / name, {**files, f"{info}/RECORD": record.encode()})
    return name


def hostile_modules(good: bytes) -> dict[str, bytes]:
    """By what is wrong with them: more data than memory, cut, functions of the page."""
    begin = good.index(b"dylink.0") + len(b"dylink.0")
    assert good[begin] == 1 and 0 < good[begin + 2] < 128, "the memory's size is a number of one byte"
    outside = bytes([2, 16, 1, 6]) + b"window" + bytes([5]) + b"fetch" + bytes([0, 0])
    head = good[:8] + bytes([0, 15, 8]) + b"dylink.0" + bytes([1, 4, 0, 0, 0, 0])
    return {"liar": good[:begin + 2] + b"\0" + good[begin + 3:], "cut": good[:-5], "outsider": head + outside}


def numpy_files() -> dict[str, bytes]:
    packed = next((ROOT / "node_modules/@emscripten-forge/numpy/pkg").glob("numpy-*.tar.gz"))
    files = {}
    with tarfile.open(packed) as members:
        for member in members:
            place = member.name.removeprefix("./").removeprefix("lib/python3.12/site-packages/")
            kept = place.startswith("numpy/") and not place.endswith((".a", ".pyc", ".h", ".pyi"))
            if member.isfile() and kept and "/tests/" not in place:
                files[place] = members.extractfile(member).read()  # type: ignore[union-attr]
    return files


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--numpy", action="store_true")
    options = parser.parse_args()
    folder = options.folder
    folder.mkdir(parents=True, exist_ok=True)
    packages: dict[str, dict[str, object]] = {}

    def add(name: str, version: str, file: str, imports: list[str], depends: list[str], kind: str = "package") -> None:
        packages[name] = {"name": name, "version": version, "file_name": file, "package_type": kind,
                          "install_dir": "site" if kind == "package" else "dynlib", "imports": imports,
                          "depends": depends, "sha256": hashlib.sha256((folder / file).read_bytes()).hexdigest()}

    work = Path(tempfile.mkdtemp())
    try:
        teeth = side_module(work, "libteeth.so", TEETH, "_teeth_of")
        gear = side_module(work, "_gear.so", GEAR, "_PyInit__gear", teeth)
        wire = side_module(work, "libwire.so", WIRE, "_wire_of,_turns")
        coil = side_module(work, "libcoil.so", COIL, "_stiffness_of", wire)
        springs = side_module(work, "springs.so", SPRINGS, "_PyInit_springs", coil)
        own = {f"springs.libs/{one.name}": one.read_bytes() for one in (coil, wire)}
        archive(folder / "teeth-1.0.zip", {"libteeth.so": teeth.read_bytes()})
        add("teeth", "1.0", "teeth-1.0.zip", [], [], "shared_library")
        gearbox = {"gearbox/__init__.py": b"from gearbox._gear import teeth\nfrom rods import LENGTH\n",
                   "gearbox/_gear.cpython-312-wasm32-emscripten.so": gear.read_bytes()}
        add("gear-box", "2.0", wheel(folder, "gear_box", "2.0", f"cp312-cp312-{PLATFORM}", gearbox, ["rods"]),
            ["gearbox"], ["rods", "teeth"])
        add("springs", "1.1", wheel(folder, "springs", "1.1", f"cp39-abi3-{PLATFORM}",
                                    {"springs.abi3.so": springs.read_bytes(), **own}, []), ["springs"], [])
        add("rods", "3.0", wheel(folder, "rods", "3.0", "py3-none-any", {"rods.py": b"LENGTH = 5\n"}, []), ["rods"], [])
        for name, module in hostile_modules(wire.read_bytes()).items():
            files = {f"{name}.abi3.so": module}
            add(name, "1.0", wheel(folder, name, "1.0", f"cp39-abi3-{PLATFORM}", files, []), [name], [])
        if options.numpy:
            add("numpy", "2.0.1", wheel(folder, "numpy", "2.0.1", f"cp312-cp312-{PLATFORM}", numpy_files(), []),
                ["numpy"], [])
    finally:
        shutil.rmtree(work)
    info = {"abi_version": "2024_0", "arch": "wasm32", "platform": "emscripten_3_1_58", "python": "3.12.7",
            "version": "0.27.8"}
    lock = json.dumps({"info": info, "packages": packages}, indent=1)
    (folder / "pyodide-lock.json").write_text(lock, encoding="utf-8")


if __name__ == "__main__":
    main()
