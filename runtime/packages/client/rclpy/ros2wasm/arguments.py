"""The ROS part of a command line: `--ros-args -r from:=to -p name:=value ... --`."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from ros2wasm import log, names


class ArgumentError(RuntimeError):
    """A rule that cannot be read, with text for people."""


@dataclass(frozen=True)
class RemapRule:
    """`[node:]from:=to`. `kind`: name, namespace, topic, service or both. `node` empty: for all nodes."""

    kind: str
    node: str
    source: str
    target: str


@dataclass(frozen=True)
class ParameterRule:
    """`[node:]name:=value`, the value as YAML text; or, with `file`, a file of parameters."""

    node: str = ''
    name: str = ''
    value: str = ''
    file: str = ''


@dataclass
class Arguments:
    remaps: list[RemapRule] = field(default_factory=list)
    #: In the order given: the later wins.
    parameters: list[ParameterRule] = field(default_factory=list)
    log_levels: list[tuple[str, int]] = field(default_factory=list)
    log_stdout: bool = True
    log_rosout: bool = True
    #: What stood between --ros-args and -- without being understood.
    unknown: list[str] = field(default_factory=list)
    #: Everything outside of --ros-args ... --
    others: list[str] = field(default_factory=list)


def _split_node(text: str) -> tuple[str, str]:
    """Take "node:" off the front, unless it is the colon of an URL scheme."""
    node, colon, rest = text.partition(':')
    if not colon or text.startswith(('rostopic://', 'rosservice://')):
        return '', text
    return node, rest


def _parse_remap(flag: str, rule: str) -> RemapRule:
    source, sign, target = rule.partition(':=')
    if not sign or not source:
        raise ArgumentError(f"Couldn't parse remap rule: '{flag} {rule}'. Error: expected 'name:=value'")
    node, source = _split_node(source)

    def check(problem: names.Problem | None) -> None:
        if problem is not None:
            raise ArgumentError(f"Couldn't parse remap rule: '{flag} {rule}'. Error: {problem[0]}")
    if source in ('__node', '__name'):
        check(names.check_node_name(target))
        return RemapRule('name', node, source, target)
    if source == '__ns':
        check(names.check_namespace(target))
        return RemapRule('namespace', node, source, target)
    kind = 'both'
    for scheme, of in (('rostopic://', 'topic'), ('rosservice://', 'service')):
        if source.startswith(scheme):
            kind, source = of, source[len(scheme):]
    check(names.check_topic_name(source))
    check(names.check_topic_name(target))
    return RemapRule(kind, node, source, target)


def _parse_parameter(flag: str, rule: str) -> ParameterRule:
    left, sign, value = rule.partition(':=')
    node, colon, name = left.partition(':')
    if not colon:
        node, name = '', left
    if not sign or not name or ':' in name or (colon and not node):
        raise ArgumentError(f"Couldn't parse parameter override rule: '{flag} {rule}'. "
                            "Error: expected 'node:name:=value' or 'name:=value'")
    return ParameterRule(node, name, value)


def _parse_log_level(flag: str, rule: str) -> tuple[str, int]:
    name, sign, level = rule.rpartition(':=')
    for number, word in log.NAMES.items():
        if word == level.upper():
            return name if sign else '', number
    raise ArgumentError(f"Couldn't parse log level: '{flag} {rule}'. "
                        'Error: Argument does not use a valid severity level')


def parse(arguments: Sequence[str]) -> Arguments:
    result = Arguments()
    in_ros = False
    rest = iter(arguments)
    for argument in rest:
        if not in_ros:
            if argument == '--ros-args':
                in_ros = True
            else:
                result.others.append(argument)
            continue
        if argument == '--ros-args':
            continue
        if argument == '--':
            in_ros = False
            continue
        if argument in VALUED:
            value = next(rest, None)
            if value is None:
                raise ArgumentError(f"Couldn't parse trailing {argument} flag. No value found.")
            _take(result, argument, value)
        elif argument in ('--enable-rosout-logs', '--disable-rosout-logs'):
            result.log_rosout = argument.startswith('--enable')
        elif argument in ('--enable-stdout-logs', '--disable-stdout-logs'):
            result.log_stdout = argument.startswith('--enable')
        elif argument in ('--enable-external-lib-logs', '--disable-external-lib-logs'):
            continue
        elif ':=' in argument:
            result.remaps.append(_parse_remap('--remap', argument))
        else:
            result.unknown.append(argument)
    return result


VALUED = {'-r', '--remap', '-p', '--param', '--params-file', '--log-level', '-e', '--enclave', '--log-config-file',
          '--log-file-name'}


def _take(result: Arguments, flag: str, value: str) -> None:
    if flag in ('-r', '--remap'):
        result.remaps.append(_parse_remap(flag, value))
    elif flag in ('-p', '--param'):
        result.parameters.append(_parse_parameter(flag, value))
    elif flag == '--params-file':
        result.parameters.append(ParameterRule(file=value))
    elif flag == '--log-level':
        result.log_levels.append(_parse_log_level(flag, value))


def _find(
    sources: Sequence[Arguments], kinds: Sequence[str], node: str, fits: str | None, namespace: str
) -> str | None:
    """The target of the first rule that fits, local rules first."""
    for arguments in sources:
        for rule in arguments.remaps:
            if rule.kind not in kinds or (rule.node and rule.node != node):
                continue
            if fits is None or names.expand(rule.source, node, namespace) == fits:
                return rule.target
    return None


def remap_name(sources: Sequence[Arguments], name: str) -> str:
    return _find(sources, ['name'], name, None, '') or name


def remap_namespace(sources: Sequence[Arguments], name: str, namespace: str) -> str:
    return _find(sources, ['namespace'], name, None, '') or namespace


def remap_topic(sources: Sequence[Arguments], full_name: str, is_service: bool, node: str, namespace: str) -> str:
    kinds = ['both', 'service' if is_service else 'topic']
    target = _find(sources, kinds, node, full_name, namespace)
    return full_name if target is None else names.expand(target, node, namespace)
