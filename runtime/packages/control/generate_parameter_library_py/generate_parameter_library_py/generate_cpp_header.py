"""Writes the header for C++: `generate_parameter_library_cpp OUTPUT YAML [VALIDATORS]`."""
from __future__ import annotations

import argparse
import os

from generate_parameter_library_py.cpp_code import cpp_header
from generate_parameter_library_py.errors import ParameterFileError, reported
from generate_parameter_library_py.parameter_file import read_parameter_file


def run(output_file: str, yaml_file: str, validate_header: str = '') -> None:
    """Raises ParameterFileError. `validate_header`: as the header includes it."""
    if any(one in validate_header for one in '"\\\n'):
        raise ParameterFileError(yaml_file, 0, f'`{validate_header}` cannot be included', 'name the file plainly')
    code = cpp_header(read_parameter_file(yaml_file, 'cpp', bool(validate_header)), validate_header)
    os.makedirs(os.path.dirname(output_file) or '.', exist_ok=True)
    with open(output_file, 'w', encoding='utf-8') as stream:
        stream.write(code)


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument('output_cpp_header_file')
    parser.add_argument('input_yaml_file')
    parser.add_argument('validate_header', nargs='?', default='')
    given = parser.parse_args()
    return reported(lambda: run(given.output_cpp_header_file, given.input_yaml_file, given.validate_header))
