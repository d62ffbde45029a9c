"""The module for Python. Every text of the file stands in it as a literal that Python made."""
from __future__ import annotations

import math
import re
from collections.abc import Iterator
from typing import Any

from generate_parameter_library_py.errors import ParameterFileError
from generate_parameter_library_py.names import type_name
from generate_parameter_library_py.parameter_file import Group, Parameter, ParameterFile, all_parameters

#: Attributes that groups have themselves.
TAKEN = ('add_entry', 'get_entry', 'stamp_', 'entry_type')
SMALLEST, LARGEST = -2**63, 2**63 - 1
MODULE = re.compile(r'[A-Za-z_]\w*(\.[A-Za-z_]\w*)*', re.ASCII)


def literal(value: Any) -> str:
    if isinstance(value, float) and not math.isfinite(value):
        return f"float('{value}')"
    if isinstance(value, (list, tuple)):
        inner = ', '.join(map(literal, value))
        return f'[{inner}]' if isinstance(value, list) else f'({inner}{"," if len(value) == 1 else ""})'
    return ascii(value)


def type_of(parameter: Parameter) -> str:
    base = {'int': 'INTEGER'}.get(parameter.type.base, parameter.type.base.upper())
    return f'{base}_ARRAY' if parameter.type.is_array else base


def range_of(parameter: Parameter) -> tuple[Any, Any] | None:
    ends = parameter.range()
    if ends is None:
        return None
    if parameter.type.base == 'double':
        return (-math.inf if ends[0] is None else ends[0], math.inf if ends[1] is None else ends[1])
    return (SMALLEST if ends[0] is None else max(SMALLEST, ends[0]),
            LARGEST if ends[1] is None else min(LARGEST, ends[1]))


def group_class(group: Group, name: str, indent: str) -> Iterator[str]:
    maps = [one for one in group.groups if one.keys]
    yield f'{indent}class {name}{"(MapOf)" if maps else ""}:'
    inner = indent + '    '
    classes: dict[str, Group] = {}
    for one in group.groups:
        class_name = f'_{type_name(one.name)}'
        while class_name in classes:
            class_name += '_'
        classes[class_name] = one
        yield from group_class(one, class_name, inner)
        yield ''
    yield from (f'{inner}entry_type = {class_name}\n' for class_name, one in classes.items() if one.keys)
    yield f'{inner}def __init__(self) -> None:'
    body = [f'self.{one.name} = {literal(one.default)}' for one in group.parameters]
    body += [f'self.{one.name} = type(self).{class_name}()' for class_name, one in classes.items() if not one.keys]
    if not group.name:
        body.insert(0, 'self.stamp_ = Time()  # of the last change')
    yield from (f'{inner}    {one}' for one in body or ['pass'])


def path_of(parameter: Parameter, keys: dict[tuple[str, ...], str]) -> str:
    parts = [
        f'Each({literal(keys[parameter.path[:count]])})' if parameter.path[:count] in keys else literal(part)
        for count, part in enumerate(parameter.path, 1)]
    return f'({", ".join([*parts, literal(parameter.name)])},)'


def field(parameter: Parameter, keys: dict[tuple[str, ...], str]) -> str:
    arguments = [path_of(parameter, keys), literal(type_of(parameter))]
    for name, value in (('description', parameter.description),
                        ('additional_constraints', parameter.additional_constraints),
                        ('is_required', parameter.default is None), ('is_read_only', parameter.read_only),
                        ('range_', range_of(parameter))):
        if value:
            arguments.append(f'{name}={literal(value)}')
    checks = [
        ', '.join([f'ParameterValidators.{one.function}' if one.is_built_in else function_of(one.function),
                   *map(literal, one.arguments)]) for one in parameter.validators]
    if checks:
        arguments.append(f'checks=({"".join(f"({one},), " for one in checks).rstrip()})')
    return f'Field({", ".join(arguments)})'


def function_of(name: str) -> str:
    return re.sub('<.*>', '', name).removeprefix('::').replace('::', '.')


def map_keys(group: Group) -> Iterator[tuple[tuple[str, ...], str]]:
    for one in group.groups:
        if one.keys:
            yield (*one.path, one.name), one.keys
        yield from map_keys(one)


def check_groups(file: str, group: Group) -> None:
    """Of what C++ can do, Python cannot do all."""
    maps = [one for one in group.groups if one.keys]
    if len(maps) > 1:
        raise ParameterFileError(
            file, maps[1].line,
            f'`{maps[0].name}` and `{maps[1].name}` are maps in one group, where Python can have one',
            'put each of them into a group of its own')
    for one in group.members:
        if one.name in TAKEN:
            raise ParameterFileError(
                file, one.line, f'`{one.name}` is a name that groups have in Python', 'give it another name')
    for inner in group.groups:
        check_groups(file, inner)


def python_module(yaml_file: str, file: ParameterFile, validators: str = '') -> str:
    """`validators`: the module of the user's functions, which the file calls `custom_validators`."""
    check_groups(yaml_file, file.root)
    if validators and not MODULE.fullmatch(validators):
        raise ParameterFileError(
            yaml_file, 0, f'`{validators}` is not the name of a module', 'write `package.module`')
    keys = dict(map_keys(file.root))
    custom = [f'import {validators} as custom_validators'] if validators else []
    return '\n'.join([
        '# Made by generate_parameter_library from a YAML file: change that.', '# flake8: noqa',
        'from rclpy.time import Time',
        'from generate_parameter_library_py.param_listener import Each, Field, MapOf, ParameterListener',
        'from generate_parameter_library_py.python_validators import ParameterValidators', *custom, '', '',
        f'class {file.namespace}:',
        *group_class(file.root, 'Params', '    '), '',
        '    class ParamListener(ParameterListener):', f'        name = {literal(file.namespace)}',
        '        fields = (',
        *(f'            {field(one, keys)},' for one in all_parameters(file.root)), '        )', '',
        '    ParamListener.params_type = Params', ''])
