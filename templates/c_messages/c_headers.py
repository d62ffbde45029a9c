"""
Writes the C headers of messages, services and actions that a package includes, and of all that these hold.

  c_headers.py --output DIR --share DIR [--share DIR ...] [--own-package NAME --own-source DIR] PACKAGE/KIND/NAME [...]

NAME is that of the header, in small letters. Structures and functions are those of Debian's rosidl_generator_c; the
functions' definitions stand in the headers, weak, so that no library is to be linked. A name that no folder of
`--share` has is passed over: the compiler says so. Messages of the package that is built are not installed yet: they
are read from its sources, in folders `msg`, `srv` and `action`.
"""
from __future__ import annotations

import argparse
import json
import re
import shutil
import tempfile
from pathlib import Path

from rosidl_adapter import convert_to_idl
from rosidl_generator_c import generate_c
from rosidl_pycommon import convert_camel_case_to_lower_case_underscore as small

TEMPLATES = Path('/usr/share/rosidl_generator_c/resource')
HEADERS = Path(__file__).resolve().parent / 'include'
#: `#include "std_msgs/msg/Header.idl"` of an .idl file.
INCLUDE = re.compile(r'^#include "(\w+)/(msg|srv|action)/(\w+)\.idl"$', re.MULTILINE)
#: What a function's definition begins with.
DEFINITION = re.compile(r'^((?:bool|void|\w+ \*)\n\w+\()', re.MULTILINE)

Interface = tuple[str, str, str]  #: package, kind, name as in the .idl file


def interface_of(header: str, shares: list[Path]) -> Interface | None:
    package, kind, name = header.split('/')
    for share in shares:
        for file in sorted((share / package / kind).glob('*.idl')):
            if small(file.stem) == name:
                return package, kind, file.stem
    return None


def idl_file(interface: Interface, shares: list[Path]) -> Path:
    package, kind, name = interface
    for share in shares:
        file = share / package / kind / f'{name}.idl'
        if file.is_file():
            return file
    raise FileNotFoundError(f'{package}/{kind}/{name}.idl')


def with_needs(wanted: list[Interface], shares: list[Path]) -> list[Interface]:
    """Those and all that they hold, sorted."""
    found: set[Interface] = set()
    pending = list(wanted)
    while pending:
        one = pending.pop()
        if one in found:
            continue
        found.add(one)
        text = idl_file(one, shares).read_text(encoding='utf-8')
        pending += [(package, kind, name) for package, kind, name in INCLUDE.findall(text)]
    return sorted(found)


def own_share(package: str, source: Path, share: Path) -> None:
    """Writes `share/PACKAGE/KIND/NAME.idl` of each definition among the package's sources."""
    for kind in ('msg', 'srv', 'action'):
        for file in sorted([*source.rglob(f'{kind}/*.{kind}'), *source.rglob(f'{kind}/*.idl')]):
            inside = file.relative_to(source)
            place = share / package / kind / f'{file.stem}.idl'
            # A pipe or a device in the place of a file never ends.
            if any(part.startswith('.') for part in inside.parts) or place.exists() or not file.is_file():
                continue
            place.parent.mkdir(parents=True, exist_ok=True)
            if file.suffix == '.idl':
                shutil.copyfile(file, place)
            else:
                convert_to_idl(source, package, inside, share / package)


def visibility(package: str) -> str:
    return f'#pragma once\n#define ROSIDL_GENERATOR_C_PUBLIC_{package}\n'


def definitions(text: str) -> str:
    """The text of a .c file as a header."""
    lines = text.replace('rcutils_get_default_allocator', 'ros2wasm_default_allocator') \
                .replace('rcutils_allocator_t', 'ros2wasm_allocator_t').splitlines()
    includes = [line for line in lines if line.startswith('#include ') and 'rcutils/allocator.h' not in line]
    rest = '\n'.join(line for line in lines if not line.startswith('#include '))
    body = DEFINITION.sub(r'__attribute__((weak)) \1', rest)
    return '\n'.join(['#pragma once', *includes, '#include "ros2wasm_c_messages/allocation.h"',
                      '#include "ros2wasm_c_messages/runtime.h"', '#ifdef __cplusplus', 'extern "C" {', '#endif',
                      body, '#ifdef __cplusplus', '}', '#endif', ''])


def write_package(package: str, interfaces: list[Interface], shares: list[Path], output: Path) -> None:
    files = [idl_file(one, shares) for one in interfaces]
    arguments = output / f'{package}.json'
    arguments.write_text(json.dumps({
        'package_name': package,
        'idl_tuples': [f'{file.parent.parent}:{kind}/{name}.idl' for file, (_, kind, name) in zip(files, interfaces)],
        'output_dir': str(output / package),
        'template_dir': str(TEMPLATES),
        'target_dependencies': [str(file) for file in files],
    }), encoding='utf-8')
    generate_c(str(arguments))
    arguments.unlink()
    control = output / package / 'msg' / 'rosidl_generator_c__visibility_control.h'
    control.parent.mkdir(parents=True, exist_ok=True)
    control.write_text(visibility(package), encoding='utf-8')
    for _, kind, name in interfaces:
        detail = output / package / kind / 'detail'
        source = detail / f'{small(name)}__functions.c'
        header = detail / f'{small(name)}__functions.h'
        made = detail / f'{small(name)}__definitions.h'
        made.write_text(definitions(source.read_text(encoding='utf-8-sig')), encoding='utf-8')
        source.unlink()
        text = header.read_text(encoding='utf-8-sig').rstrip()
        guard = text.rindex('#endif')
        include = f'#include "{package}/{kind}/detail/{made.name}"'
        header.write_text(f'{text[:guard]}{include}\n\n{text[guard:]}\n', encoding='utf-8')


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--output', type=Path, required=True)
    parser.add_argument('--share', type=Path, action='append', default=[])
    parser.add_argument('--own-package')
    parser.add_argument('--own-source', type=Path)
    parser.add_argument('headers', nargs='+')
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix='ros2wasm-c-messages-') as folder:
        shares = list(options.share)
        if options.own_package is not None:
            own_share(options.own_package, options.own_source, Path(folder))
            shares.insert(0, Path(folder))
        write_all(options.headers, shares, options.output)


def write_all(headers: list[str], shares: list[Path], output: Path) -> None:
    asked = (interface_of(header, shares) for header in headers)
    interfaces = with_needs([one for one in asked if one is not None], shares)
    shutil.rmtree(output, ignore_errors=True)
    shutil.copytree(HEADERS, output)
    for package in sorted({one[0] for one in interfaces}):
        write_package(package, [one for one in interfaces if one[0] == package], shares, output)


if __name__ == '__main__':
    main()
