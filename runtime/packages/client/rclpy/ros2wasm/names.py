"""Name rules of ROS 2: validation in the order, and with the words, that users know; expansion of names."""
from __future__ import annotations

import re
import string

WORD = set(string.ascii_letters + string.digits + '_')
NUMERIC_TOKEN = re.compile(r'/\d')
LONGEST_NODE_NAME, LONGEST_NAMESPACE, LONGEST_TOPIC = 255, 245, 247

#: What is wrong, and where.
Problem = tuple[str, int]


def _numeric_token(name: str) -> int | None:
    match = NUMERIC_TOKEN.search(name)
    return None if match is None else match.start() + 1


def check_node_name(name: str) -> Problem | None:
    if not name:
        return 'node name must not be empty', 0
    for i, char in enumerate(name):
        if char not in WORD:
            return "node name must not contain characters other than alphanumerics or '_'", i
    if name[0].isdigit():
        return 'node name must not start with a number', 0
    if len(name) > LONGEST_NODE_NAME:
        return f"node name length should not exceed '{LONGEST_NODE_NAME}'", LONGEST_NODE_NAME
    return None


def check_namespace(name: str) -> Problem | None:
    if not name:
        return 'namespace must not be empty', 0
    if name == '/':
        return None
    if name[0] != '/':
        return "namespace must be absolute, it must lead with a '/'", 0
    if name.endswith('/'):
        return "namespace must not end with a '/', unless only a '/'", len(name) - 1
    for i, char in enumerate(name):
        if char not in WORD and char != '/':
            return "namespace must not contain characters other than alphanumerics, '_', or '/'", i
    if '//' in name:
        return "namespace must not contain repeated '/'", name.index('//') + 1
    numeric = _numeric_token(name)
    if numeric is not None:
        return 'namespace must not have a token that starts with a number', numeric
    if len(name) > LONGEST_NAMESPACE:
        return f"namespace should not exceed '{LONGEST_NAMESPACE}'", LONGEST_NAMESPACE
    return None


def _check_characters(name: str) -> Problem | None:
    opening: int | None = None
    in_braces = "substitution name must not contain characters other than alphanumerics or '_'"
    for i, char in enumerate(name):
        if char in WORD:
            if char.isdigit() and opening is not None and i == opening + 1:
                return 'substitution name must not start with a number', i
        elif char == '/':
            if opening is not None:
                return in_braces, i
        elif char == '~':
            if i != 0:
                return "topic name must not have tilde '~' unless it is the first character", i
        elif char == '{':
            if opening is not None:
                return in_braces, i
            opening = i
        elif char == '}':
            if opening is None:
                return "topic name must not have unmatched (unbalanced) curly braces '{}'", i
            opening = None
        else:
            other = "topic name must not contain characters other than alphanumerics, '_', '~', '{', or '}'"
            return (other if opening is None else in_braces), i
    if opening is not None:
        return "topic name must not have unmatched (unbalanced) curly braces '{}'", opening
    return None


def check_topic_name(name: str) -> Problem | None:
    if not name:
        return 'topic name must not be empty string', 0
    if name.endswith('/'):
        return 'topic name must not end with a forward slash', len(name) - 1
    if name[0].isdigit():
        return 'topic name token must not start with a number', 0
    problem = _check_characters(name)
    if problem is not None:
        return problem
    if len(name) > 1 and name[0] == '~' and name[1] != '/':
        return "topic name must not have a tilde '~' that is not followed by a forward slash '/'", 1
    numeric = _numeric_token(name)
    if numeric is not None:
        return 'topic name token must not start with a number', numeric
    return None


def check_full_topic_name(name: str) -> Problem | None:
    if not name:
        return 'topic name must not be empty string', 0
    if name[0] != '/':
        return "topic name must be absolute, it must lead with a '/'", 0
    if name.endswith('/'):
        return "topic name must not end with a '/'", len(name) - 1
    for i, char in enumerate(name):
        if char not in WORD and char != '/':
            return "topic name must not contain characters other than alphanumerics, '_', or '/'", i
    if '//' in name:
        return "topic name must not contain repeated '/'", name.index('//') + 1
    numeric = _numeric_token(name)
    if numeric is not None:
        return 'topic name token must not start with a number', numeric
    if len(name) > LONGEST_TOPIC:
        return f"topic length should not exceed '{LONGEST_TOPIC}'", LONGEST_TOPIC
    return None


def join(namespace: str, name: str) -> str:
    return namespace + name if namespace.endswith('/') else f'{namespace}/{name}'


def expand(name: str, node: str, namespace: str) -> str:
    """The full name of a topic or service. ValueError: an unknown substitution."""
    if name.startswith('~'):
        name = join(namespace, node) + name[1:]

    def value(match: re.Match[str]) -> str:
        known = {'node': node, 'ns': namespace, 'namespace': namespace}
        if match[1] not in known:
            raise ValueError(f'unknown substitution: {match[0]}')
        return known[match[1]]
    name = re.sub(r'\{(\w*)\}', value, name)
    return name if name.startswith('/') else join(namespace, name)
