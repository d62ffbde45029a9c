"""
A file of parameters, checked: what the generators of code are given.

One key is the namespace. Below it a mapping with `type` is a parameter; other mappings are groups. The group
`__map_KEYS` is there once for each text in the array of texts `KEYS`.
"""
from __future__ import annotations

import dataclasses
import difflib
import math
import re
import sys
from collections.abc import Iterator
from typing import Any, Union

from generate_parameter_library_py import names
from generate_parameter_library_py.errors import ParameterFileError
from generate_parameter_library_py.yaml_tree import Mapping, Value, read_yaml

MAP = '__map_'
KEYS_OF_PARAMETER = ('type', 'default_value', 'description', 'read_only', 'additional_constraints', 'validation')
SCALARS = {'bool': bool, 'double': float, 'int': int, 'string': str}
TYPES = ('none', *SCALARS, *(f'{one}_array' for one in SCALARS), 'string_fixed_N', 'double_array_fixed_N',
         'int_array_fixed_N', 'string_array_fixed_N')
FIXED = re.compile(r'(string|(?:double|int|string)_array)_fixed_([0-9]{1,6})')
#: The built-in functions, and how many arguments each takes.
VALIDATORS = {
    'bounds': 2, 'element_bounds': 2, 'fixed_size': 1, 'gt': 1, 'gt_eq': 1, 'lower_bounds': 1,
    'lower_element_bounds': 1, 'lt': 1, 'lt_eq': 1, 'not_empty': 0, 'one_of': 1, 'size_gt': 1, 'size_lt': 1,
    'subset_of': 1, 'unique': 0, 'upper_bounds': 1, 'upper_element_bounds': 1}
FOR_ARRAYS = ('element_bounds', 'lower_element_bounds', 'upper_element_bounds')
FOR_SCALARS = ('bounds', 'gt', 'gt_eq', 'lower_bounds', 'lt', 'lt_eq', 'upper_bounds')
WITH_A_LIST = ('one_of', 'subset_of')
LONGEST = 2**63


@dataclasses.dataclass(frozen=True)
class Type:
    base: str  # of SCALARS
    is_array: bool
    capacity: int  # 0: without a limit

    def __str__(self) -> str:
        return self.base + ('_array' if self.is_array else '') + (f'_fixed_{self.capacity}' if self.capacity else '')


@dataclasses.dataclass(frozen=True)
class Validator:
    function: str  # without `<>`
    is_template: bool  # of the parameter's type
    arguments: tuple[Any, ...]  # texts, numbers, truth values, and lists of them

    @property
    def is_built_in(self) -> bool:
        return self.function in VALIDATORS


@dataclasses.dataclass(frozen=True)
class Parameter:
    name: str
    path: tuple[str, ...]  # of the groups around it, below the namespace
    type: Type
    default: Any  # None: required
    description: str
    additional_constraints: str
    read_only: bool
    validators: tuple[Validator, ...]
    line: int

    def range(self) -> tuple[Any, Any] | None:
        """The ends of the numbers that the built-in functions accept; None for an end that is open."""
        if self.type.base not in ('double', 'int'):
            return None
        number = SCALARS[self.type.base]
        lower, upper = None, None
        for one in self.validators:
            if one.function in ('bounds', 'element_bounds'):
                lower, upper = map(number, one.arguments)
            elif one.function in ('gt_eq', 'lower_bounds', 'lower_element_bounds'):
                lower = number(one.arguments[0])
            elif one.function in ('lt_eq', 'upper_bounds', 'upper_element_bounds'):
                upper = number(one.arguments[0])
            elif one.function == 'gt':
                lower = self._next(number(one.arguments[0]), 1)
            elif one.function == 'lt':
                upper = self._next(number(one.arguments[0]), -1)
        return None if lower is None and upper is None else (lower, upper)

    def _next(self, number: Any, step: int) -> Any:
        return number + step if self.type.base == 'int' else math.nextafter(number, step * math.inf)


@dataclasses.dataclass(frozen=True)
class Group:
    name: str
    path: tuple[str, ...]
    members: tuple[Union[Parameter, Group], ...]
    keys: str | None  # of a map: the path of its array of keys, with dots
    line: int

    @property
    def parameters(self) -> list[Parameter]:
        return [one for one in self.members if isinstance(one, Parameter)]

    @property
    def groups(self) -> list[Group]:
        return [one for one in self.members if isinstance(one, Group)]

    @property
    def key(self) -> str:
        """The name of the array of keys of a map: `joints` for `__map_joints`."""
        return self.name.removeprefix(MAP)


@dataclasses.dataclass(frozen=True)
class ParameterFile:
    namespace: str
    root: Group


def is_parameter(mapping: Mapping) -> bool:
    """Whether it is not a group: its `type` is not a parameter by that name, or it has only what a parameter has."""
    if 'type' in mapping.members:
        return not isinstance(mapping.members['type'].content, Mapping)
    first = next(iter(mapping.members.values()), None)
    return first is not None and not isinstance(first.content, Mapping)


def all_parameters(group: Group) -> Iterator[Parameter]:
    for member in group.members:
        if isinstance(member, Parameter):
            yield member
        else:
            yield from all_parameters(member)


class FileReader:
    """`language`: `cpp` or `python`. `has_validators`: whether the user gives functions of their own."""

    def __init__(self, file: str, language: str, has_validators: bool) -> None:
        self._file = file
        self._language = language
        self._has_validators = has_validators
        self._keys: set[str] = set()  # the paths of arrays that can be keys of maps

    def error(self, line: int, what: str, *ways_out: str) -> ParameterFileError:
        return ParameterFileError(self._file, line, what, *ways_out)

    def warn(self, line: int, what: str) -> None:
        print(f'{self._file}:{line}: warning: {what}', file=sys.stderr)

    def read(self) -> ParameterFile:
        tree = read_yaml(self._file)
        roots = tree.content.members if isinstance(tree.content, Mapping) else {}
        if len(roots) != 1:
            raise self.error(tree.line, 'The yaml definition must only have one root element',
                             'put all parameters below one key, the namespace of the generated code')
        namespace, content = next(iter(roots.items()))
        self._check_name(namespace, tree.line, 'the namespace')
        if not isinstance(content.content, Mapping) or is_parameter(content.content):
            raise self.error(content.line, f'`{namespace}` has no parameters below it',
                             f'write `{namespace}:`, and below it a name with `type:` for each parameter')
        self._find_keys(content.content, ())
        return ParameterFile(namespace, self._group('', (), content.content, content.line))

    def _find_keys(self, mapping: Mapping, path: tuple[str, ...]) -> None:
        for name, value in mapping.members.items():
            if not isinstance(value.content, Mapping) or name.startswith(MAP):
                continue
            if not is_parameter(value.content):
                self._find_keys(value.content, (*path, name))
            elif str(value.content.members.get('type', value).content).startswith('string_array'):
                self._keys.add('.'.join((*path, name)))

    def _check_name(self, name: str, line: int, what: str) -> None:
        if name.startswith('__') or not names.is_name(name, self._language):
            language = {'cpp': 'C++', 'python': 'Python'}[self._language]
            raise self.error(line, f'{what} `{name}` cannot be a name in {language}',
                             f'name it `{names.suggestion(name)}`')

    def _group(self, name: str, path: tuple[str, ...], mapping: Mapping, line: int) -> Group:
        inner = (*path, name) if name else path
        shown = '.'.join(inner)
        keys = self._keys_of(name, path, line) if name.startswith(MAP) else None
        members: list[Union[Parameter, Group]] = []
        self._warn_of_repeated(mapping)
        for key, value in mapping.members.items():
            at = mapping.lines[key]
            beside = f'{key.removeprefix(MAP)}_map'
            if self._language == 'cpp' and key.startswith(MAP) and beside in mapping.members:
                raise self.error(at, f'the member for `{key}` in C++ has the name of `{beside}` beside it',
                                 f'give `{beside}` another name')
            if not isinstance(value.content, Mapping):
                self.warn(at, f'`{key}` is neither a parameter nor a group, and is passed over')
                continue
            self._check_name(key.removeprefix(MAP), at, 'the group or parameter')
            if is_parameter(value.content):
                if key.startswith(MAP):
                    raise self.error(at, f'`{key}` is a parameter, and a map is a group',
                                     'put the parameters that each key has below it')
                parameter = self._parameter(key, inner, value.content, at)
                members += [parameter] if parameter else []
            else:
                group = self._group(key, inner, value.content, at)
                members += [group] if group.members else []  # it may describe parameters of others only
        if not mapping.members:
            raise self.error(line, f'`{shown}` is empty', 'give it `type:`, or parameters below it')
        return Group(name, path, tuple(members), keys, line)

    def _warn_of_repeated(self, mapping: Mapping) -> None:
        for key, line in mapping.repeated.items():
            self.warn(line, f'`{key}` is there twice, and this one counts')

    def _keys_of(self, name: str, path: tuple[str, ...], line: int) -> str:
        """As upstream looks for it: in the group around the outermost map, then further out."""
        key = name.removeprefix(MAP)
        scope = [one for one in path]
        for place, one in enumerate(path):
            if one.startswith(MAP):
                scope = scope[:place]
                break
        while True:
            candidate = '.'.join([*scope, key])
            if candidate in self._keys:
                return candidate
            if not scope:
                break
            scope.pop()
        near = difflib.get_close_matches(key, [one.rpartition('.')[2] for one in self._keys], 1)
        raise self.error(line, f'`{name}` needs an array of texts `{key}`, and there is none here or further out',
                         f'name the map `{MAP}{near[0]}`' if near else f'add `{key}: {{type: string_array, '
                         'default_value: []}` outside of the maps')

    def _parameter(self, name: str, path: tuple[str, ...], mapping: Mapping, line: int) -> Parameter | None:
        shown = '.'.join((*path, name))
        self._warn_of_repeated(mapping)
        for key in mapping.members:
            if key not in KEYS_OF_PARAMETER:
                near = difflib.get_close_matches(key, KEYS_OF_PARAMETER, 1)
                raise self.error(
                    mapping.lines[key], f"Invalid syntax in parameter {shown}. '{key}' is not valid syntax",
                    f'write `{near[0]}`' if near else 'it can have ' + ', '.join(KEYS_OF_PARAMETER))
        if 'type' not in mapping.members:
            raise self.error(line, f'No type defined for parameter {shown}', 'add `type:`: ' + ', '.join(TYPES))
        type_ = self._type(shown, mapping.members['type'])
        if type_ is None:
            return None
        default = mapping.members.get('default_value')
        validators = self._validators(shown, type_, mapping.members.get('validation'))
        return Parameter(
            name, path, type_, None if default is None else self._default(shown, type_, default),
            self._text(mapping, 'description'), self._text(mapping, 'additional_constraints'),
            self._is_read_only(shown, mapping), validators, line)

    def _type(self, shown: str, value: Value) -> Type | None:
        text = value.content
        if text in ('none', None):  # YAML's null is none too
            return None
        if isinstance(text, str):
            base = text.removesuffix('_array')
            if base in SCALARS:
                return Type(base, base != text, 0)
            fixed = FIXED.fullmatch(text)
            if fixed and int(fixed[2]) > 0:
                return Type(fixed[1].removesuffix('_array'), fixed[1].endswith('_array'), int(fixed[2]))
        near = difflib.get_close_matches(str(text), TYPES, 1)
        raise self.error(
            value.line, f'Invalid parameter type `{shown_value(text)}` for parameter {shown}. Allowed types are: '
            + ', '.join(TYPES), *([f'write `type: {near[0]}`'] if near else []))

    def _text(self, mapping: Mapping, key: str) -> str:
        value = mapping.members.get(key)
        if value is None or value.content is None:
            return ''
        if isinstance(value.content, (list, Mapping)):
            raise self.error(value.line, f'`{key}` must be a text', 'put it in quotes')
        return str(value.content)

    def _is_read_only(self, shown: str, mapping: Mapping) -> bool:
        value = mapping.members.get('read_only')
        if value is None or value.content is None:
            return False
        if not isinstance(value.content, bool):
            raise self.error(value.line, f'`read_only` of {shown} is {shown_value(value.content)}',
                             'write `true` or `false`')
        return value.content

    def _default(self, shown: str, type_: Type, value: Value) -> Any:
        if value.content is None:
            return None
        content = value.content
        is_list = isinstance(content, list)
        parts = [one.content for one in content] if isinstance(content, list) else [content]
        good = is_list == type_.is_array and all(is_of(type_.base, one) for one in parts)
        if not good:
            wrong = next((one for one in parts if not is_of(type_.base, one)), None)
            got = f'an array with {type_of(Value(wrong, 0))}' if is_list and type_.is_array else type_of(value)
            text = parts[0] if parts and isinstance(parts[0], str) else ''
            raise self.error(
                value.line, f'Parameter {shown} has incorrect type. Expected: {type_}, got: {got}',
                *self._way_out(type_, is_list, text))
        converted = [float(one) if type_.base == 'double' else one for one in parts]
        length = len(converted) if type_.is_array else len(str(converted[0]).encode())
        if type_.capacity and length > type_.capacity:
            unit = 'elements' if type_.is_array else 'bytes'
            raise self.error(
                value.line, f'the default of {shown} has {length} {unit}, and `{type_}` holds {type_.capacity}',
                f'make it shorter, or the type `{dataclasses.replace(type_, capacity=length)}`')
        return converted if type_.is_array else converted[0]

    def _way_out(self, type_: Type, is_list: bool, text: str) -> list[str]:
        if type_.is_array and not is_list:
            return ['write a list, in brackets']
        if not type_.is_array and is_list:
            return [f'write one value, or `type: {type_.base}_array`']
        if type_.base == 'string':
            return ['put it in quotes']
        if re.fullmatch(r'[+-]?[0-9]+e[+-]?[0-9]+', text, re.IGNORECASE):
            mantissa, _, exponent = text.lower().partition('e')
            return [f'write `{mantissa}.0e{exponent if exponent[0] in "+-" else "+" + exponent}`: YAML wants the dot']
        return []

    def _validators(self, shown: str, type_: Type, value: Value | None) -> tuple[Validator, ...]:
        result: list[Validator] = []
        if value is not None and value.content is not None:
            if not isinstance(value.content, Mapping):
                raise self.error(value.line, f'`validation` of {shown} is not a mapping',
                                 'write each function with its arguments, as `gt<>: [0.0]`')
            for name, arguments in value.content.members.items():
                result.append(self._validator(shown, type_, name, arguments, value.content.lines[name]))
            self._check_combination(shown, {one.function for one in result}, value.line)
        if type_.capacity:
            result.append(Validator('size_lt', True, (type_.capacity + 1,)))
        return tuple(result)

    def _check_combination(self, shown: str, functions: set[str], line: int) -> None:
        if 'element_bounds' in functions and functions & {'lower_element_bounds', 'upper_element_bounds'}:
            raise self.error(line, f"Parameter {shown} cannot combine 'element_bounds' with "
                             "'lower_element_bounds/upper_element_bounds'.", 'leave out one of them')
        if 'bounds' in functions and functions & {'gt', 'gt_eq', 'lt', 'lt_eq'}:
            raise self.error(line, f"Parameter {shown} cannot combine 'bounds' with scalar bound validators "
                             '(gt/gt_eq/lt/lt_eq).', 'leave out one of them')

    def _validator(self, shown: str, type_: Type, name: str, value: Value, line: int) -> Validator:
        if not names.FUNCTION.fullmatch(name):
            raise self.error(line, f'`{name}` in the validation of {shown} is not the name of a function',
                             'write `gt<>`, or `my_namespace::my_function`')
        function, is_template = name.removesuffix('<>'), name.endswith('<>')
        if function not in VALIDATORS and '::' not in function and not self._has_validators:
            near = difflib.get_close_matches(function, VALIDATORS, 1)
            raise self.error(line, f'`{function}`, the validation of {shown}, is not a known function',
                             f'write `{near[0]}<>`' if near else 'write one of ' + ', '.join(sorted(VALIDATORS)),
                             'functions of your own have their namespace in front, and come in the file that is the '
                             'third argument')
        if self._language == 'python' and function not in VALIDATORS:
            self._check_python_function(shown, function, line)
        contents = value.content if isinstance(value.content, list) else [] if value.content is None else [value]
        arguments = tuple(self._argument(shown, one) for one in contents)
        wanted = VALIDATORS.get(function)
        if wanted is not None:
            if function in WITH_A_LIST:
                good = len(arguments) == 1 and isinstance(arguments[0], list)
                way_out = f'write `{function}<>: [[a, b]]`, a list in the list of arguments'
            else:
                good = len(arguments) == wanted and not any(isinstance(one, list) for one in arguments)
                way_out = f'it takes {("none", "one", "two")[wanted]}'
            if not good:
                raise self.error(line, f'`{function}` of {shown} has other arguments than it takes', way_out)
            self._check_arguments(shown, type_, function, arguments, line)
        return Validator(function, is_template, arguments)

    def _check_python_function(self, shown: str, function: str, line: int) -> None:
        """The generated module knows the user's functions as attributes of `custom_validators` only."""
        last = function.rpartition('::')[2].partition('<')[0]
        if self._has_validators and function == f'custom_validators::{last}' and names.is_name(last, 'python'):
            return
        raise self.error(
            line, f'`{function}`, the validation of {shown}, cannot be called from Python',
            f'write `{last}<>`' if last in VALIDATORS else
            f'write `custom_validators::{names.suggestion(last)}`, and name the module that has it')

    def _check_arguments(self, shown: str, type_: Type, function: str, arguments: tuple[Any, ...], line: int) -> None:
        flat = arguments[0] if function in WITH_A_LIST else arguments
        is_length = function in ('fixed_size', 'size_gt', 'size_lt')
        wanted = 'int' if is_length else type_.base
        accepted = 'double' if wanted == 'int' and not is_length else wanted  # C++ converts numbers
        if type_.is_array and function in FOR_SCALARS or not type_.is_array and function in FOR_ARRAYS:
            other = f'element_{function}' if f'element_{function}' in VALIDATORS else function.replace('element_', '')
            raise self.error(line, f'`{function}` of {shown} is not for the type {type_}',
                             *([f'write `{other}<>`'] if other != function and other in VALIDATORS else []))
        for one in flat:
            if is_length and is_of('int', one) and one < 0:
                raise self.error(line, f'`{function}` of {shown} compares a length with {one}', 'write 0 or more')
            if wanted == 'int' and isinstance(one, float) and not math.isfinite(one):
                raise self.error(line, f'`{function}` of {shown} compares {one} with int', 'write a value of type int')
            if not is_of(accepted, one):
                raise self.error(line, f'`{function}` of {shown} compares {type_of(Value(one, line))} with {wanted}',
                                 f'write a value of type {wanted}')

    def _argument(self, shown: str, value: Value) -> Any:
        plain = value.content
        parts = [one.content for one in plain] if isinstance(plain, list) else [plain]
        if not all(is_of('int', one) or isinstance(one, (bool, float, str)) for one in parts):
            raise self.error(value.line, f'an argument in the validation of {shown} is neither a text, a number, a '
                             'truth value nor a list of them', 'write one of these')
        return parts if isinstance(plain, list) else plain


def is_of(base: str, content: Any) -> bool:
    if base == 'double':
        return isinstance(content, float) or is_number(content) and abs(content) <= sys.float_info.max
    if base == 'int':
        return is_number(content) and -LONGEST <= content < LONGEST
    return isinstance(content, SCALARS[base])


def is_number(content: Any) -> bool:
    return isinstance(content, int) and not isinstance(content, bool)


def type_of(value: Value) -> str:
    content = value.content
    if isinstance(content, list):
        return f'{type_of(content[0])}_array' if content and not isinstance(content[0].content, list) else 'a list'
    if is_number(content) and not is_of('int', content):
        return 'an integer of more than 64 bits'
    for base, python in (('bool', bool), ('int', int), ('double', float), ('string', str)):
        if isinstance(content, python):
            return base
    return 'a mapping' if isinstance(content, Mapping) else 'nothing'


def shown_value(content: Any) -> str:
    return 'a mapping' if isinstance(content, Mapping) else 'a list' if isinstance(content, list) else str(content)


def read_parameter_file(file: str, language: str, has_validators: bool = False) -> ParameterFile:
    """Raises ParameterFileError."""
    return FileReader(file, language, has_validators).read()
