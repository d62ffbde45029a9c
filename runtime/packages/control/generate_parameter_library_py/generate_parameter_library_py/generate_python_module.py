"""Writes the module for Python: `generate_parameter_library_python OUTPUT YAML [VALIDATORS]`."""
from __future__ import annotations

import argparse
import os

from generate_parameter_library_py.errors import reported
from generate_parameter_library_py.parameter_file import read_parameter_file
from generate_parameter_library_py.python_code import python_module


def run(output_file: str, yaml_file: str, validation_module: str = '') -> None:
    """Raises ParameterFileError. `validation_module`: of the user's functions, as Python imports it."""
    file = read_parameter_file(yaml_file, 'python', bool(validation_module))
    code = python_module(yaml_file, file, validation_module)
    folder = os.path.dirname(output_file) or '.'
    os.makedirs(folder, exist_ok=True)
    with open(output_file, 'w', encoding='utf-8') as stream:
        stream.write(code)
    with open(os.path.join(folder, '__init__.py'), 'a', encoding='utf-8'):
        pass  # it must be there, with whatever is in it


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument('output_python_module_file')
    parser.add_argument('input_yaml_file')
    parser.add_argument('validate_file', nargs='?', default='')
    given = parser.parse_args()
    return reported(lambda: run(given.output_python_module_file, given.input_yaml_file, given.validate_file))
