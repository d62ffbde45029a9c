"""Reads a package's .idl files once and writes its type support: codecs, handles, descriptions.

Called by CMake with the JSON arguments file that all rosidl generators get.
"""

import argparse
import json
from pathlib import Path
import sys
from typing import Any, Dict, List, Set, Tuple

from rosidl_parser import definition as idl
from rosidl_parser.parser import parse_idl_file
from rosidl_pycommon import convert_camel_case_to_lower_case_underscore as snake_case

from cpp_source import NAME, header, source
from layout import LayoutTable
import own_constants  # noqa: F401: the parser is mended
import type_description as td


class Interface:
    """One .idl file: what it defines, by kind, and where its code goes."""

    def __init__(self, package: str, base: str, relative: str) -> None:
        path = Path(relative)
        self.folder = path.parent.as_posix()
        self.stem = path.stem
        self.include_base = f'{package}/{self.folder}/detail/{snake_case(self.stem)}'
        self.messages: List[str] = []
        self.services: List[str] = []
        self.actions: List[str] = []
        self.descriptions: List[td.Description] = []
        for element in parse_idl_file(idl.IdlLocator(base, path)).content.elements:
            if isinstance(element, idl.Message):
                self._add(self.messages, td.describe_message(element))
            elif isinstance(element, idl.Service):
                self._add_service(td.describe_service(element))
            elif isinstance(element, idl.Action):
                described = td.describe_action(element)
                name = described[0]['type_name']
                self._add(self.actions, described[:1])
                self._add(self.messages, described[1:4])
                self._add_service(described[4:8])
                self._add_service(described[8:12])
                self._add(self.messages, described[12:])
                assert described[12]['type_name'] == name + '_FeedbackMessage'

    def _add(self, names: List[str], described: List[td.Description]) -> None:
        names += [d['type_name'] for d in described]
        self.descriptions += described

    def _add_service(self, described: List[td.Description]) -> None:
        self._add(self.services, described[:1])
        self._add(self.messages, described[1:])

    def sources(self, package: str, places: Dict[str, Path]) -> Dict[str, Tuple[str, str]]:
        """Return encoding and text of each type; parts of services and actions have no text."""
        whole = f'{package}/{self.folder}/{self.stem}'
        place = places[f'{self.folder}/{self.stem}']
        return {
            name: (place.suffix[1:], place.read_text(encoding='utf-8'))
            if name == whole else ('implicit', '')
            for name in (d['type_name'] for d in self.descriptions)
        }


def source_places(arguments: Dict[str, Any]) -> Dict[str, Path]:
    """Return the files that people wrote, by folder and stem; .idl files that were made of others
    come first and give way."""
    tuples = [*arguments['idl_tuples'], *arguments.get('non_idl_tuples', [])]
    paths = [(Path(relative), Path(base, relative))
             for base, relative in (one.rsplit(':', 1) for one in tuples)]
    return {relative.with_suffix('').as_posix(): path for relative, path in paths}


def interface_of(type_name: str) -> str:
    """Return the include base of the interface file that defines a message."""
    package, folder, name = type_name.split('/')
    if folder in ('srv', 'action'):
        name = name.split('_')[0]
    return f'{package}/{folder}/detail/{snake_case(name)}'


def nested_types(interface: Interface) -> Set[str]:
    return {
        field['type']['nested_type_name']
        for description in interface.descriptions
        if description['type_name'] in interface.messages
        for field in description['fields'] if field['type']['nested_type_name']
    }


def load_dependencies(dependencies: List[str], needed: Set[str], types: td.TypeTable) -> None:
    """Add the descriptions, installed beside the .idl files of other packages, that are needed."""
    places: Dict[str, Path] = {}
    for dependency in dependencies:
        package, path = dependency.split(':', 1)
        file = Path(path)
        places[f'{package}/{file.parent.name}/{file.stem}'] = file.with_suffix('.json')
    for name in sorted(needed):
        if name in types:
            continue
        if name not in places:
            raise ValueError(
                f"type '{name}' is not known: is its package missing in DEPENDENCIES of "
                'rosidl_generate_interfaces?')
        full = json.loads(places[name].read_text(encoding='utf-8'))['type_description_msg']
        types.add([full['type_description'], *full['referenced_type_descriptions']])


def write_if_changed(path: Path, text: str) -> None:
    if path.exists() and path.read_text(encoding='utf-8') == text:
        path.touch()
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding='utf-8')


def generate(arguments: Dict[str, Any]) -> None:
    package = arguments['package_name']
    output = Path(arguments['output_dir'])
    interfaces = [
        Interface(package, *idl_tuple.rsplit(':', 1)) for idl_tuple in arguments['idl_tuples']]
    types = td.TypeTable()
    for interface in interfaces:
        types.add(interface.descriptions)
    needed = set().union(*(nested_types(interface) for interface in interfaces))
    load_dependencies(arguments.get('ros_interface_dependencies', []), needed, types)
    layouts = LayoutTable(types)

    places = source_places(arguments)
    sources: Dict[str, Tuple[str, str]] = {}
    headers = []
    for interface in interfaces:
        sources.update(interface.sources(package, places))
        own = interface.include_base
        nested = sorted({interface_of(n) for n in nested_types(interface)} - {own})
        text = header(
            own, [f'{own}__struct.hpp'], [f'{path}__{NAME}.hpp' for path in nested],
            interface.messages, [d['type_name'] for d in interface.descriptions], layouts)
        headers.append(f'{own}__{NAME}.hpp')
        write_if_changed(output.parent / headers[-1], text)
        name = f'{package}/{interface.folder}/{interface.stem}'
        write_if_changed(output / interface.folder / f'{interface.stem}.json', types.to_json(name))
    write_if_changed(
        output / f'{arguments["target"]}__{NAME}.cpp',
        source(
            headers,
            [n for i in interfaces for n in i.messages],
            [n for i in interfaces for n in i.services],
            [n for i in interfaces for n in i.actions], sources, types, layouts))


def main() -> int:
    parser = argparse.ArgumentParser(description='Generate type support for ros2wasm')
    parser.add_argument('--generator-arguments-file', required=True)
    parser.add_argument('--target', required=True, help='names the generated source file')
    options = parser.parse_args()
    arguments = json.loads(Path(options.generator_arguments_file).read_text(encoding='utf-8'))
    try:
        generate({**arguments, 'target': options.target})
    except ValueError as error:
        print(f'{arguments["package_name"]}: {error}', file=sys.stderr)
        return 1
    return 0


if __name__ == '__main__':
    sys.exit(main())
