"""Reads the YAML that parameter files and -p values are written in: maps, lists, flow forms, scalars, comments."""
from __future__ import annotations

import re
from typing import Any

INTEGER = re.compile(r'[-+]?(0|[1-9][0-9_]*)$|[-+]?0x[0-9a-fA-F_]+$|[-+]?0o?[0-7_]+$|[-+]?0b[01_]+$')
FLOAT = re.compile(
    r'[-+]?(\.[0-9]+|[0-9][0-9_]*(\.[0-9_]*)?)([eE][-+]?[0-9]+)?$|[-+]?\.(inf|Inf|INF)$|\.(nan|NaN|NAN)$')
KEY = re.compile(r'''("(?:[^"\\]|\\.)*"|'(?:[^']|'')*'|[^\s\[\]{},#&*!|>'"%@`][^#]*?)\s*:(?:\s+|$)''')
ESCAPES = {
    'n': '\n', 't': '\t', 'r': '\r', '0': '\0', '"': '"', '\\': '\\', '/': '/', 'a': '\a', 'b': '\b', 'e': '\x1b',
}
WORDS: dict[str, bool | None] = {
    **dict.fromkeys(('true', 'True', 'TRUE', 'yes', 'Yes', 'YES', 'on', 'On', 'ON'), True),
    **dict.fromkeys(('false', 'False', 'FALSE', 'no', 'No', 'NO', 'off', 'Off', 'OFF'), False),
    '': None, '~': None, 'null': None, 'Null': None, 'NULL': None,
}


class YamlError(ValueError):
    """Text that is not understood."""


def scalar(text: str) -> Any:
    """A plain scalar as a bool, an int, a float, None or a text."""
    if text in WORDS:
        return WORDS[text]
    if INTEGER.match(text):
        digits = text.replace('_', '')
        if re.match(r'[-+]?0[0-7]+$', digits):
            return int(digits, 8)
        return int(digits, 0)
    if FLOAT.match(text):
        return float(text.replace('_', '').replace('.inf', 'inf').replace('.Inf', 'inf').replace('.INF', 'inf')
                     .replace('.nan', 'nan').replace('.NaN', 'nan').replace('.NAN', 'nan'))
    return text


class Flow:
    """Reads one value in flow form, or a quoted or plain scalar."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.at = 0

    def blank(self) -> None:
        while self.at < len(self.text):
            if self.text[self.at] == '#' and (self.at == 0 or self.text[self.at - 1].isspace()):
                end = self.text.find('\n', self.at)
                self.at = len(self.text) if end < 0 else end
            elif self.text[self.at].isspace():
                self.at += 1
            else:
                return

    def peek(self) -> str:
        self.blank()
        return self.text[self.at:self.at + 1]

    def take(self, char: str) -> None:
        if self.peek() != char:
            raise YamlError(f"'{char}' is wanted in: {self.text}")
        self.at += 1

    def quoted(self, quote: str) -> str:
        self.take(quote)
        out = ''
        while True:
            char = self.text[self.at:self.at + 1]
            self.at += 1
            if char == '':
                raise YamlError(f'a quote is open: {self.text}')
            if char == quote:
                if quote == "'" and self.text[self.at:self.at + 1] == "'":
                    self.at += 1
                    out += "'"
                    continue
                return out
            if char == '\\' and quote == '"':
                escape = self.text[self.at:self.at + 1]
                self.at += 1
                width = {'x': 2, 'u': 4, 'U': 8}.get(escape, 0)
                if width:
                    out += chr(int(self.text[self.at:self.at + width], 16))
                    self.at += width
                elif escape in ESCAPES:
                    out += ESCAPES[escape]
                else:
                    raise YamlError(f'unknown escape: \\{escape}')
            else:
                out += char

    def value(self, inside: bool) -> Any:
        char = self.peek()
        if char in ('"', "'"):
            return self.quoted(char)
        if char == '[':
            return self.items(']', lambda: self.value(True))
        if char == '{':
            return dict(self.items('}', self.pair))
        start = self.at
        while self.at < len(self.text):
            here = self.text[self.at]
            if inside and here in ',]}':
                break
            if inside and here == ':' and self.text[self.at + 1:self.at + 2] in (' ', '', '\n'):
                break
            if here == '#' and self.at > start and self.text[self.at - 1].isspace():
                break
            if here == ':' and not inside and self.text[self.at + 1:self.at + 2] in (' ', ''):
                raise YamlError(f'a map is not expected here: {self.text}')
            self.at += 1
        return scalar(self.text[start:self.at].strip())

    def pair(self) -> tuple[str, Any]:
        key = self.value(True)
        self.take(':')
        return str(key), self.value(True)

    def items(self, end: str, read: Any) -> list[Any]:
        self.at += 1
        found: list[Any] = []
        while self.peek() != end:
            found.append(read())
            if self.peek() == ',':
                self.at += 1
            elif self.peek() != end:
                raise YamlError(f"'{end}' is wanted in: {self.text}")
        self.at += 1
        return found

    def whole(self) -> Any:
        value = self.value(False)
        if self.peek():
            raise YamlError(f'not understood: {self.text[self.at:]}')
        return value


def parse_value(text: str) -> Any:
    """One value, as after `-p name:=`."""
    return Flow(text).whole()


class Block:
    """Reads lines by their indentation."""

    def __init__(self, text: str) -> None:
        self.lines: list[tuple[int, str]] = []
        for line in text.splitlines():
            stripped = line.strip()
            if not stripped or stripped.startswith('#') or stripped in ('---', '...') or stripped.startswith('%'):
                continue
            if '\t' in line[:len(line) - len(line.lstrip())]:
                raise YamlError('a tab cannot indent')
            self.lines.append((len(line) - len(line.lstrip(' ')), stripped))
        self.at = 0

    def value(self, least: int) -> Any:
        """The value at the present line, when it is indented enough."""
        if self.at >= len(self.lines) or self.lines[self.at][0] < least:
            return None
        indent, text = self.lines[self.at]
        if text == '-' or text.startswith('- '):
            return self.sequence(indent)
        if KEY.match(text) is not None:
            return self.mapping(indent)
        return self.scalar(text)

    def scalar(self, text: str) -> Any:
        """A value that begins here; one in flow form may go on in the next lines."""
        self.at += 1
        while text[:1] in ('[', '{') and not self.closed(text) and self.at < len(self.lines):
            text += '\n' + self.lines[self.at][1]
            self.at += 1
        if text[:1] in ('|', '>'):
            raise YamlError('block scalars are not read here')
        return parse_value(text)

    def closed(self, text: str) -> bool:
        try:
            Flow(text).value(True)
        except YamlError:
            return False
        return True

    def sequence(self, indent: int) -> list[Any]:
        found = []
        while self.at < len(self.lines) and self.lines[self.at][0] == indent:
            text = self.lines[self.at][1]
            if text != '-' and not text.startswith('- '):
                break
            rest = text[1:].lstrip()
            if not rest or rest.startswith('#'):
                self.at += 1
                found.append(self.value(indent + 1))
            else:
                # The text after the dash is a block of its own, indented by the column where it begins.
                self.lines[self.at] = (indent + len(text) - len(rest), rest)
                found.append(self.value(indent + 1))
        return found

    def mapping(self, indent: int) -> dict[str, Any]:
        found: dict[str, Any] = {}
        while self.at < len(self.lines) and self.lines[self.at][0] == indent:
            text = self.lines[self.at][1]
            match = KEY.match(text)
            if match is None:
                raise YamlError(f'a key is wanted: {text}')
            key = str(Flow(match[1]).value(False))
            rest = text[match.end():].strip()
            if rest and not rest.startswith('#'):
                found[key] = self.scalar(rest)
                continue
            self.at += 1
            # A list may stand at the indentation of its key.
            at_key = self.at < len(self.lines) and self.lines[self.at][0] == indent and \
                self.lines[self.at][1].startswith('-')
            found[key] = self.value(indent if at_key else indent + 1)
        if self.at < len(self.lines) and self.lines[self.at][0] > indent:
            raise YamlError(f'wrong indentation: {self.lines[self.at][1]}')
        return found


def parse(text: str) -> Any:
    """A whole document."""
    block = Block(text)
    value = block.value(0)
    if block.at < len(block.lines):
        raise YamlError(f'not understood: {block.lines[block.at][1]}')
    return value
