"""What parameter files and -p rules say for a node, as plain Python values."""
from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from ros2wasm.arguments import Arguments
from ros2wasm.yaml import YamlError, parse, parse_value

LEAF = 'ros__parameters'


def matches(pattern: str, name: str) -> bool:
    """Whether a node name, in which "*" is one token and "**" any number of them, means this node."""
    if not pattern:
        return not name
    if pattern.startswith('/**'):
        rest = pattern[3:]
        at = 0
        while at >= 0:
            if matches(rest, name[at:]):
                return True
            at = name.find('/', at + 1)
        return matches(rest, '')
    if not name or pattern[0] != '/' or name[0] != '/':
        return False
    token, _, pattern_rest = pattern[1:].partition('/')
    wanted, _, name_rest = name[1:].partition('/')
    if token not in ('*', wanted):
        return False
    return matches(f'/{pattern_rest}' if pattern_rest else '', f'/{name_rest}' if name_rest else '')


def flatten(tree: dict[str, Any], prefix: str, out: dict[str, Any]) -> None:
    for key, value in tree.items():
        name = f'{prefix}.{key}' if prefix else key
        if isinstance(value, dict):
            flatten(value, name, out)
        else:
            out[name] = value


def visit(path: str, tree: Any, found: Callable[[str, dict[str, Any]], None]) -> None:
    """Call `found` with each node name of a document and its parameters. Namespaces may be nested."""
    if not isinstance(tree, dict):
        raise YamlError(f"value '{tree}' stands outside of {LEAF}")
    for key, value in tree.items():
        if key == LEAF:
            found(path, value or {})
        else:
            visit(path + (key if key.startswith('/') else f'/{key}'), value, found)


def overrides(sources: Sequence[Arguments], full_name: str) -> dict[str, Any]:
    """
    Global arguments, then the node's own, by the node names that they say something for.

    The later one wins for the same name; among names that mean the node its own wins, wherever it stands, else the one
    that appeared last.
    """
    named: dict[str, dict[str, Any]] = {}

    def take(pattern: str, parameters: dict[str, Any]) -> None:
        if matches(pattern, full_name):
            flatten(parameters, '', named.setdefault(pattern, {}))
    for arguments in reversed(sources):
        for rule in arguments.parameters:
            if rule.file:
                with open(rule.file, encoding='utf-8') as file:
                    visit('', parse(file.read()) or {}, take)
                continue
            node = rule.node if rule.node.startswith('/') else f'/{rule.node or "**"}'
            if '/' not in rule.node and rule.node == full_name.rpartition('/')[2]:
                node = full_name
            if matches(node, full_name):
                named.setdefault(node, {})[rule.name] = parse_value(rule.value)
    out: dict[str, Any] = {}
    for pattern in named:
        if pattern != full_name:
            out |= named[pattern]
    return out | named.get(full_name, {})
