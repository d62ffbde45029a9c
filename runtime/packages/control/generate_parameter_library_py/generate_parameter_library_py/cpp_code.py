"""The header for C++. Every text of the file stands in it as a literal of which each special byte is escaped."""
from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from generate_parameter_library_py.names import type_name
from generate_parameter_library_py.parameter_file import Group, Parameter, ParameterFile, Type, Validator

SCALARS = {'bool': 'bool', 'double': 'double', 'int': 'int64_t', 'string': 'std::string'}
SMALLEST, LARGEST = -2**63, 2**63 - 1
#: What code of nodes has had through the header from the start.
INCLUDES = """\
#include <fmt/core.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <map>
#include <mutex>
#include <set>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "generate_parameter_library/listener.hpp"
#include "rclcpp/logger.hpp"
#include "rclcpp/node.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"
#include "rsl/parameter_validators.hpp"
#include "rsl/static_string.hpp"
#include "rsl/static_vector.hpp"
"""
VALIDATORS = (
    'bounds', 'element_bounds', 'fixed_size', 'gt', 'gt_eq', 'lower_bounds', 'lower_element_bounds', 'lt', 'lt_eq',
    'not_empty', 'one_of', 'size_gt', 'size_lt', 'subset_of', 'to_parameter_result_msg', 'unique', 'upper_bounds',
    'upper_element_bounds')


def text(value: str) -> str:
    """A literal. Octal escapes have three digits at most, so that what follows cannot join them."""
    bytes_ = (chr(one) if 32 <= one < 127 and one not in b'"\\?' else f'\\{one:03o}' for one in value.encode())
    return f'"{"".join(bytes_)}"'


def exact(value: str) -> str:
    """A std::string, with the zero bytes that a literal would end at."""
    return f'std::string({text(value)}, {len(value.encode())})'


def described(value: str) -> str:
    """A description as `ros2 param describe` shows it natively: without backquotes, lines indented."""
    return text(value.replace('`', '').replace('\n', '\n    '))


def number(value: float) -> str:
    if math.isnan(value):
        return 'std::numeric_limits<double>::quiet_NaN()'
    if math.isinf(value):
        return ('-' if value < 0 else '') + 'std::numeric_limits<double>::infinity()'
    return repr(value)


def literal(value: Any) -> str:
    if isinstance(value, bool):
        return 'true' if value else 'false'
    if isinstance(value, str):
        return exact(value) if '\0' in value else text(value)
    if isinstance(value, float):
        return number(value)
    if isinstance(value, list):
        return '{' + ', '.join(map(literal, value)) + '}'
    if value == SMALLEST:
        return 'std::numeric_limits<int64_t>::min()'
    return str(value) if abs(value) < 2**31 else f'{value}LL'


def type_of(type_: Type) -> str:
    if type_.is_array and type_.capacity:
        return f'rsl::StaticVector<{SCALARS[type_.base]}, {type_.capacity}>'
    if type_.capacity:
        return f'rsl::StaticString<{type_.capacity}>'
    return f'std::vector<{SCALARS[type_.base]}>' if type_.is_array else SCALARS[type_.base]


def initial(parameter: Parameter) -> str:
    if parameter.default is None:
        return '{}'
    value = parameter.default
    if not parameter.type.capacity:
        return f' = {literal(value)}'
    if parameter.type.is_array:
        # In two pairs of braces, two texts would be the ends of one.
        return f' = {literal(value)}' if value else '{}'
    return f'{{{exact(value)}}}'


class Structures:
    """`struct Params` or `struct StackParams`. `wanted`: which parameters are in it."""

    def __init__(self, is_on_stack: bool) -> None:
        self._is_on_stack = is_on_stack

    def wants(self, parameter: Parameter) -> bool:
        is_fixed = bool(parameter.type.capacity) or not (parameter.type.is_array or parameter.type.base == 'string')
        return is_fixed or not self._is_on_stack

    def groups(self, group: Group) -> list[Group]:
        """Those that are not empty."""
        return [one for one in group.groups if not (self._is_on_stack and one.keys) and self._has_any(one)]

    def _has_any(self, group: Group) -> bool:
        return any(map(self.wants, group.parameters)) or bool(self.groups(group))

    def lines(self, group: Group, around: str, indent: str) -> Iterator[str]:
        for parameter in filter(self.wants, group.parameters):
            yield f'{indent}{type_of(parameter.type)} {parameter.name}{initial(parameter)};'
        taken = {around}
        for one in self.groups(group):
            name = type_name(one.name)
            while name in taken:
                name += '_'
            taken.add(name)
            yield f'{indent}struct {name} {{'
            yield from self.lines(one, name, indent + '  ')
            if one.keys:
                yield f'{indent}}};'
                yield f'{indent}std::map<std::string, {name}> {one.key}_map;'
            else:
                yield f'{indent}}} {one.name};'


def call(validator: Validator, type_: Type) -> str:
    function = validator.function + (f'<{SCALARS[type_.base]}>' if validator.is_template else '')
    return f'{function}({", ".join(["param", *map(literal, validator.arguments)])})'


def check(parameter: Parameter, indent: str) -> Iterator[str]:
    if len(parameter.validators) == 1:
        yield f'{indent}[](const rclcpp::Parameter& param) -> Result {{'
        yield f'{indent}  return {call(parameter.validators[0], parameter.type)};'
    else:
        yield f'{indent}[](const rclcpp::Parameter& param) -> Result {{'
        for one in parameter.validators:
            yield f'{indent}  if (auto result = {call(one, parameter.type)}; !result) return result;'
        yield f'{indent}  return {{}};'
    yield f'{indent}}}'


def field(parameter: Parameter) -> str:
    result = f'Field({described(parameter.description)})'
    if parameter.default is None:
        result += '.required()'
    if parameter.read_only:
        result += '.read_only()'
    if parameter.additional_constraints:
        result += f'.constraints({described(parameter.additional_constraints)})'
    ends = parameter.range()
    if ends:
        lower, upper = ends
        if parameter.type.base == 'double':
            limits = 'std::numeric_limits<double>'
            result += (f'.range({f"{limits}::lowest()" if lower is None else number(lower)}, '
                       f'{f"{limits}::max()" if upper is None else number(upper)})')
        else:
            clamped = [min(max(one, SMALLEST), LARGEST) for one in (
                SMALLEST if lower is None else lower, LARGEST if upper is None else upper)]
            result += f'.integer_range({literal(clamped[0])}, {literal(clamped[1])})'
    return result


class Walk:
    """The bodies of add_fields() and add_entries(): calls of Fields::add(), in the order of the file."""

    def fields(self, group: Group, place: str, prefix: str) -> Iterator[str]:
        for member in group.members:
            if isinstance(member, Parameter):
                yield from self._add(member, place, text(prefix + member.name), '    ')
            elif not member.keys:
                yield from self.fields(member, f'{place}.{member.name}', f'{prefix}{member.name}.')

    def entries(self, group: Group, place: str, prefix: str) -> Iterator[str]:
        """Of the maps in a group that is in none."""
        for one in group.groups:
            if one.keys:
                yield from self._loop(one, place, text(prefix), 1)
            else:
                yield from self.entries(one, f'{place}.{one.name}', f'{prefix}{one.name}.')

    def _loop(self, group: Group, place: str, prefix: str, depth: int) -> Iterator[str]:
        indent = '    ' + '  ' * (depth - 1)
        yield f'{indent}for (const std::string& key_{depth} : params.{group.keys}) {{'
        yield f'{indent}  [[maybe_unused]] auto& entry_{depth} = {place}.{group.key}_map[key_{depth}];'
        yield f'{indent}  const std::string prefix_{depth} = std::string({prefix}) + key_{depth} + ".";'
        yield from self._in_map(group, f'entry_{depth}', f'prefix_{depth}', '', depth)
        yield f'{indent}}}'

    def _in_map(self, group: Group, place: str, start: str, path: str, depth: int) -> Iterator[str]:
        indent = '    ' + '  ' * depth
        for member in group.members:
            joined = f'{start} + {text(path)}' if path else start
            if isinstance(member, Parameter):
                yield from self._add(member, place, f'{start} + {text(path + member.name)}', indent)
            elif member.keys:
                yield from self._loop(member, place, joined, depth + 1)
            else:
                yield from self._in_map(member, f'{place}.{member.name}', start, f'{path}{member.name}.', depth)

    def _add(self, parameter: Parameter, place: str, name: str, indent: str) -> Iterator[str]:
        start = f'{indent}fields.add({name}, {place}.{parameter.name}, {field(parameter)}'
        if not parameter.validators:
            yield f'{start});'
            return
        yield f'{start},'
        lines = list(check(parameter, indent + '    '))
        yield from lines[:-1]
        yield f'{lines[-1]});'


def stack_lines(structures: Structures, group: Group, place: str) -> Iterator[str]:
    for parameter in filter(structures.wants, group.parameters):
        yield f'    stack{place}.{parameter.name} = params{place}.{parameter.name};'
    for one in structures.groups(group):
        yield from stack_lines(structures, one, f'{place}.{one.name}')


def cpp_header(file: ParameterFile, validators: str = '') -> str:
    """`validators`: the file name of the user's functions, beside the header."""
    root, name = file.root, file.namespace
    everything, on_stack, walk = Structures(False), Structures(True), Walk()
    lines = ['// Made by generate_parameter_library from a YAML file: change that.', '#pragma once', '', INCLUDES]
    if validators:
        lines += [f'#include "{validators}"', '']
    lines += [f'namespace {name} {{', '', *(f'using rsl::{one};' for one in VALIDATORS), '']
    lines += ['struct Params {', *everything.lines(root, 'Params', '  '),
              '  rclcpp::Time __stamp;  ///< of the last change', '};', '']
    lines += ['/// The parameters that allocate no memory.', 'struct StackParams {',
              *on_stack.lines(root, 'StackParams', '  '), '};', '']
    lines += [
        '/// Used by ParamListener only.', 'struct ParamDescription {',
        f'  static constexpr const char* kName = "{name}";', '  using Field = generate_parameter_library::Field;',
        '  using Result = generate_parameter_library::Result;', '',
        '  static void add_fields([[maybe_unused]] generate_parameter_library::Fields& fields,',
        '                         [[maybe_unused]] Params& params) {', *walk.fields(root, 'params', ''), '  }',
        '  static void add_entries([[maybe_unused]] generate_parameter_library::Fields& fields,',
        '                          [[maybe_unused]] Params& params) {', *walk.entries(root, 'params', ''), '  }', '};',
        '']
    lines += [
        '/// Declares the parameters of a node, checks them, and follows their changes.',
        'class ParamListener : public generate_parameter_library::Listener<Params, ParamDescription> {', ' public:',
        '  using generate_parameter_library::Listener<Params, ParamDescription>::Listener;', '',
        '  StackParams get_stack_params() const {', '    [[maybe_unused]] const Params params = get_params();',
        '    StackParams stack;', *stack_lines(on_stack, root, ''), '    return stack;', '  }', '};', '',
        f'}}  // namespace {name}', '']
    return '\n'.join(lines)
