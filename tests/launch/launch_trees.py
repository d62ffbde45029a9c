"""Launch descriptions as values, and how each is written in XML, YAML and Python."""
from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any, Union
from xml.sax.saxutils import quoteattr


@dataclass(frozen=True)
class Sub:
    """A substitution by its name in XML and YAML."""

    name: str
    arguments: tuple[Text, ...] = ()


#: A text, a substitution, or several put together.
Text = Union[str, Sub, tuple[Union[str, Sub], ...]]
Scalar = Union[bool, int, float, str]


@dataclass
class Action:
    tag: str
    attributes: dict[str, Any] = field(default_factory=dict)
    parts: list[Action] = field(default_factory=list)
    children: list[Action] = field(default_factory=list)


def part(tag: str, **attributes: Any) -> Action:
    return Action(tag, {key.rstrip('_'): value for key, value in attributes.items()})


def action(tag: str, *parts: Action, children: Iterable[Action] = (), **attributes: Any) -> Action:
    return Action(tag, {key.rstrip('_'): value for key, value in attributes.items()}, list(parts), list(children))


# Texts with `$(...)`.

def escaped(text: str) -> str:
    return text.replace('\\', '\\\\').replace('$', '\\$')


def written(text: Text, quoted: bool = False) -> str:
    if isinstance(text, str):
        return escaped(text).replace("'", "\\'") if quoted else escaped(text)
    if isinstance(text, Sub):
        return f'$({text.name}' + ''.join(f" '{written(one, True)}'" for one in text.arguments) + ')'
    return ''.join(written(one, quoted) for one in text)


def is_text(value: Any) -> bool:
    return isinstance(value, (str, Sub, tuple))


# XML: everything is text, and a parameter's text says its type.

def xml_value(value: Any) -> str:
    if isinstance(value, list):
        return escaped(json.dumps(value, ensure_ascii=False))
    return str(value) if not is_text(value) else written(value)


def to_xml(one: Action) -> str:
    attributes = dict(one.attributes)
    if one.tag == 'param' and isinstance(attributes.get('value'), str):
        attributes['type'] = 'str'
    head = ''.join(f' {name}={quoteattr(xml_value(value))}' for name, value in attributes.items())
    inner = ''.join(map(to_xml, one.parts + one.children))
    return f'<{one.tag}{head}>{inner}</{one.tag}>' if inner else f'<{one.tag}{head}/>'


# YAML, as JSON, which is YAML.

def yaml_value(value: Any) -> Any:
    if isinstance(value, list):
        return [yaml_value(one) for one in value]
    return written(value) if is_text(value) else value


def yaml_members(one: Action) -> dict[str, Any]:
    members = {name: yaml_value(value) for name, value in one.attributes.items()}
    for tag in dict.fromkeys(inner.tag for inner in one.parts):
        members[tag] = [yaml_members(inner) for inner in one.parts if inner.tag == tag]
    if one.children:
        members['children'] = [to_yaml(child) for child in one.children]
    return members


def to_yaml(one: Action) -> dict[str, Any]:
    return {one.tag: yaml_members(one)}


# Python.

SUBSTITUTIONS: dict[str, Callable[..., str]] = {
    'var': lambda name, default=None: f'LaunchConfiguration({name}' + (f', default={default})' if default else ')'),
    'env': lambda name, default=None: (
        f'EnvironmentVariable({name}' + (f', default_value={default})' if default else ')')),
    'eval': lambda text: f'PythonExpression({text})',
    'find-pkg-share': lambda name: f'FindPackageShare({name})',
    'dirname': lambda: 'ThisLaunchFileDir()',
    'not': lambda value: f'NotSubstitution({value})',
    'and': lambda a, b: f'AndSubstitution({a}, {b})',
    'or': lambda a, b: f'OrSubstitution({a}, {b})',
    'equals': lambda a, b: f'EqualsSubstitution({a}, {b})',
    'not-equals': lambda a, b: f'NotEqualsSubstitution({a}, {b})',
    'if': lambda condition, yes, no: f'IfElseSubstitution({condition}, {yes}, {no})',
    'anon': lambda name: f'AnonName({name})',
    'file-content': lambda path: f'FileContent({path})',
    'string-join': lambda delimiter, *parts: f'StringJoinSubstitution([{", ".join(parts)}], {delimiter})',
    'param': lambda name: f'Parameter({name})',
}


def py_text(text: Text) -> str:
    if isinstance(text, str):
        return repr(text)
    if isinstance(text, Sub):
        return SUBSTITUTIONS[text.name](*map(py_text, text.arguments))
    return '[' + ', '.join(py_text(one) for one in text) + ']'


def py_value(value: Any) -> str:
    return py_text(value) if is_text(value) else repr(value)


def _call(name: str, positional: Iterable[str] = (), named: Mapping[str, str | None] | None = None) -> str:
    words = [*positional, *(f'{key}={value}' for key, value in (named or {}).items() if value is not None)]
    return f'{name}({", ".join(words)})'


def _list(actions: Iterable[Action]) -> str:
    return '[' + ', '.join(map(to_python, actions)) + ']'


def _pairs(one: Action, tag: str, key: str = 'name', value: str = 'value') -> str | None:
    pairs = [f'({py_text(inner.attributes[key])}, {py_text(inner.attributes[value])})'
             for inner in one.parts if inner.tag == tag]
    return '[' + ', '.join(pairs) + ']' if pairs else None


def _condition(one: Action) -> dict[str, str | None]:
    for name, kind in (('if', 'IfCondition'), ('unless', 'UnlessCondition')):
        if name in one.attributes:
            value = one.attributes[name]
            return {'condition': f'{kind}({py_text(value if is_text(value) else str(value))})'}
    return {}


def _dictionary(params: Iterable[Action]) -> str:
    items = [f'{inner.attributes["name"]!r}: ' + (
        _dictionary(inner.parts) if inner.parts else py_value(inner.attributes['value'])) for inner in params]
    return '{' + ', '.join(items) + '}'


def _parameters(one: Action) -> str | None:
    """Dictionaries and files in their order."""
    groups: list[str] = []
    for inner in one.parts:
        if inner.tag == 'param' and 'from' in inner.attributes:
            file = py_text(inner.attributes['from'])
            groups.append(f'ParameterFile({file}, allow_substs=True)' if inner.attributes.get('allow_substs') else file)
        elif inner.tag == 'param':
            groups.append(_dictionary([inner]))
    return '[' + ', '.join(groups) + ']' if groups else None


def _optional(one: Action, **names: str) -> dict[str, str | None]:
    return {name: py_value(one.attributes[key]) for name, key in names.items() if key in one.attributes}


def _process(one: Action) -> dict[str, str | None]:
    environment = _pairs(one, 'env')
    return {**_optional(one, respawn='respawn', respawn_delay='respawn_delay', output='output'),
            'additional_env': environment and f'dict({environment})',
            'on_exit': 'Shutdown()' if one.attributes.get('on_exit') else None, **_condition(one)}


def _node(one: Action) -> str:
    words = one.attributes.get('args')
    return _call('Node', (), {
        **_optional(one, package='pkg', executable='exec', name='name', namespace='namespace'),
        'parameters': _parameters(one), 'remappings': _pairs(one, 'remap', 'from', 'to'),
        'arguments': words and '[' + ', '.join(repr(word) for word in words.split()) + ']', **_process(one)})


def to_python(one: Action) -> str:
    at = one.attributes
    condition = _condition(one)
    match one.tag:
        case 'node':
            return _node(one)
        case 'executable':
            return _call('ExecuteProcess', (), {'cmd': repr(at['cmd'].split()), **_process(one)})
        case 'arg':
            choices = [inner.attributes['value'] for inner in one.parts]
            return _call('DeclareLaunchArgument', [py_text(at['name'])], {
                **_optional(one, default_value='default', description='description'),
                'choices': repr(choices) if choices else None})
        case 'let':
            return _call('SetLaunchConfiguration', [py_text(at['name']), py_text(at['value'])], condition)
        case 'set_env':
            return _call('SetEnvironmentVariable', [py_text(at['name']), py_text(at['value'])], condition)
        case 'unset_env':
            return _call('UnsetEnvironmentVariable', [py_text(at['name'])], condition)
        case 'append_env':
            return _call('AppendEnvironmentVariable', [py_text(at['name']), py_text(at['value'])],
                         {**_optional(one, prepend='prepend', separator='separator'), **condition})
        case 'reset_env':
            return _call('ResetEnvironment', (), condition)
        case 'reset':
            return _call('ResetLaunchConfigurations', (), condition)
        case 'group':
            kept = _pairs(one, 'keep')
            return _call('GroupAction', [_list(one.children)], {
                **_optional(one, scoped='scoped', forwarding='forwarding'),
                'launch_configurations': kept and f'dict({kept})', **condition})
        case 'include':
            return _call('IncludeLaunchDescription', [f'AnyLaunchDescriptionSource({py_text(at["file"])})'],
                         {'launch_arguments': _pairs(one, 'arg'), **condition})
        case 'log':
            return _call('LogInfo', (), {'msg': py_text(at['message']), **condition})
        case 'shutdown':
            return _call('Shutdown', (), {**_optional(one, reason='reason'), **condition})
        case 'timer':
            return _call('TimerAction', (), {'period': repr(at['period']), 'actions': _list(one.children), **condition})
        case 'push_ros_namespace':
            return _call('PushRosNamespace', [py_text(at['namespace'])], condition)
        case 'set_parameter':
            return _call('SetParameter', [py_text(at['name']), py_value(at['value'])], condition)
        case 'set_remap':
            return _call('SetRemap', [py_text(at['from']), py_text(at['to'])], condition)
        case 'set_use_sim_time':
            return _call('SetUseSimTime', [repr(at['value'])], condition)
        case 'node_container':
            components = ', '.join(_component(inner) for inner in one.parts if inner.tag == 'composable_node')
            return _call('ComposableNodeContainer', (), {
                **_optional(one, package='pkg', executable='exec', name='name', namespace='namespace'),
                'composable_node_descriptions': f'[{components}]', **_process(one)})
        case 'load_composable_node':
            components = ', '.join(map(_component, one.parts))
            return _call('LoadComposableNodes', (), {'target_container': py_text(at['target']),
                                                     'composable_node_descriptions': f'[{components}]'})
    raise ValueError(one.tag)


def _component(one: Action) -> str:
    return _call('ComposableNode', (), {
        **_optional(one, package='pkg', plugin='plugin', name='name', namespace='namespace'),
        'parameters': _parameters(one), 'remappings': _pairs(one, 'remap', 'from', 'to')})


PYTHON = """\
from launch import LaunchDescription
from launch.actions import (AppendEnvironmentVariable, ExecuteProcess, GroupAction,
                            IncludeLaunchDescription, LogInfo, ResetEnvironment, ResetLaunchConfigurations,
                            SetEnvironmentVariable, SetLaunchConfiguration, Shutdown, TimerAction,
                            UnsetEnvironmentVariable)
from launch.conditions import IfCondition, UnlessCondition
from launch.launch_description import DeclareLaunchArgument
from launch.launch_description_sources import AnyLaunchDescriptionSource
from launch.substitutions import (AndSubstitution, AnonName, EnvironmentVariable, EqualsSubstitution, FileContent,
                                  IfElseSubstitution, LaunchConfiguration, NotEqualsSubstitution, NotSubstitution,
                                  OrSubstitution, PythonExpression, StringJoinSubstitution, ThisLaunchFileDir)
from launch_ros.actions import (ComposableNodeContainer, LoadComposableNodes, Node, PushRosNamespace, SetParameter,
                                SetRemap, SetUseSimTime)
from launch_ros.descriptions import ComposableNode
from launch_ros.parameter_descriptions import ParameterFile
from launch_ros.substitutions import FindPackageShare, Parameter


def generate_launch_description():
    return LaunchDescription([
        {actions},
    ])
"""


def file_texts(actions: list[Action]) -> dict[str, str]:
    """The same description by the ending of its file."""
    return {
        'xml': '<launch>\n' + '\n'.join(map(to_xml, actions)) + '\n</launch>\n',
        'yaml': json.dumps({'launch': [to_yaml(one) for one in actions]}, ensure_ascii=False, indent=1) + '\n',
        'py': PYTHON.format(actions=',\n        '.join(map(to_python, actions))),
    }
