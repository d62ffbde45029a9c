"""MANIFEST.in: which files of a package its lines select, as setuptools understands them."""
from __future__ import annotations

import os
import posixpath
import re
from collections.abc import Iterator
from dataclasses import dataclass, field

NAME = 'MANIFEST.in'
#: Nothing of these is ever selected: what a build made, and the records of version control.
NEVER = re.compile(r'(?:build/|(?:.*/)?(?:RCS|CVS|\.svn)/)')


@dataclass
class Selection:
    """Files relative to the package, and lines that could not be followed, each with its number."""

    files: list[str] = field(default_factory=list)
    warnings: list[tuple[int, str]] = field(default_factory=list)


def folders_once(root: str) -> Iterator[tuple[str, list[str]]]:
    """All folders with their files. Links are followed; a folder that several lead to comes once."""
    seen: set[str] = set()
    for parent, folders, names in os.walk(root, followlinks=True):
        real = os.path.realpath(parent)
        if real in seen:
            folders.clear()
            continue
        seen.add(real)
        folders.sort()
        yield parent, names


def pattern_of(text: str, has_ranges: bool) -> re.Pattern[str]:
    """
    `*` and `?` stay within a folder; a part `**` stands for any folders, at the end for everything below.

    `[0-9]` is a range only where setuptools reads the disk; where it looks at names, `-` stands for itself.
    """
    parts = text.split('/')
    takes_all_below = parts[-1] == '**'
    runs: list[list[str]] = [[]]  # of parts between those that are `**`
    for part in parts[:-1] if takes_all_below else parts:
        if part == '**':
            runs.append([])
        else:
            runs[-1].append(name_of(part, has_ranges))
    texts = [''.join(f'{name}/' for name in run) for run in runs]
    if takes_all_below:
        return re.compile(first_fit('(?:[^/]++/)', texts) + '.*', re.DOTALL)
    # The last part is followed by nothing.
    return re.compile(first_fit('(?:[^/]++/)', [*texts[:-1], texts[-1][:-1]], is_end_fixed=True), re.DOTALL)


def first_fit(any_one: str, texts: list[str], is_end_fixed: bool = False) -> str:
    """
    An expression for `texts` with any number of `any_one` between two of them.

    Each text is taken where it fits first, and no other place is tried when the rest does not fit: it could not fit
    further on either. So the time is bounded by the lengths of the pattern and of the path, whatever the pattern. Where
    what follows fixes the end, the last text is looked for from there.
    """
    first, *more = texts
    if not more:
        return first
    end = f'{any_one}*{more.pop()}' if is_end_fixed else ''
    return first + ''.join(f'(?>{any_one}*?{text})' for text in more) + end


def name_of(part: str, has_ranges: bool) -> str:
    """A regular expression for the name of a file or a folder."""
    texts = ['']
    for piece in pieces_of(part, has_ranges):
        if piece == '*':
            texts.append('')
        else:
            texts[-1] += piece
    return first_fit('[^/]', texts, is_end_fixed=True)


def pieces_of(part: str, has_ranges: bool) -> Iterator[str]:
    """Regular expressions for the letters of a name, and `*`. A set never stands for `/`."""
    at = 0
    last = part.rfind(']')
    while at < len(part):
        letter = part[at]
        at += 1
        # A set may begin with `!`, and with a `]` that belongs to it.
        end = part.find(']', at + 1 + part.startswith('!', at)) if letter == '[' and at < last else -1
        if letter == '*':
            yield '*'
        elif letter == '?':
            yield '[^/]'
        elif end >= 0:
            inner = part[at:end]
            special = r'([\\^\[\]])' if has_ranges else r'([\\^\[\]-])'
            escaped = re.sub(special, r'\\\1', inner.removeprefix('!'))
            yield f"(?!/)[{'^' if inner[0] == '!' else ''}{escaped}]"
            at = end + 1
        else:
            yield re.escape(letter)


def logical_lines(text: str) -> Iterator[tuple[int, str]]:
    """Lines without comments, each with the number of its first one; a backslash at the end joins the next."""
    begin, joined = 0, ''
    for number, line in enumerate([*text.splitlines(), ''], 1):
        line = re.sub(r'(?<!\\)#.*', '', line).replace('\\#', '#').strip()
        begin = begin if joined else number
        joined += f' {line}' if joined else line
        if joined.endswith('\\'):
            joined = joined[:-1]
            continue
        if joined.strip():
            yield begin, joined.strip()
        joined = ''


def clean(path: str) -> str:
    """Without `./` in front and `/` behind."""
    return posixpath.normpath(path)


class Reader:
    """Follows one line after the other."""

    def __init__(self, every: list[str]) -> None:
        self.every = every
        self.chosen: dict[str, None] = {}

    def add(self, pattern: str) -> None:
        # With `**/` in front it comes from `global-include`, which looks at names.
        matches = pattern_of(pattern, has_ranges=not pattern.startswith('**/')).fullmatch
        self.chosen.update(dict.fromkeys(path for path in self.every if matches(path)))

    def remove(self, pattern: str) -> None:
        matches = pattern_of(pattern, has_ranges=False).fullmatch
        self.chosen = {path: None for path in self.chosen if not matches(path)}

    def follow(self, command: str, words: list[str]) -> str:
        """What is wrong with the line, or nothing."""
        is_added = command in ('include', 'recursive-include', 'global-include', 'graft')
        change = self.add if is_added else self.remove
        if command in ('include', 'exclude', 'global-include', 'global-exclude'):
            if not words:
                return f'`{command}` expects patterns'
            front = '**/' if command.startswith('global-') else ''
            for word in words:
                change(front + clean(word))
        elif command in ('recursive-include', 'recursive-exclude'):
            if len(words) < 2:
                return f'`{command}` expects a folder and patterns'
            for word in words[1:]:
                change(below(words[0], clean(word), is_added))
        elif command in ('graft', 'prune'):
            if len(words) != 1:
                return f'`{command}` expects one folder'
            change(below(words[0], '**', is_added))
        else:
            return (f'`{command}` is not a command of MANIFEST.in: include, exclude, recursive-include, '
                    'recursive-exclude, global-include, global-exclude, graft, prune')
        return ''


def below(folder: str, pattern: str, is_added: bool) -> str:
    """In setuptools, what is below `.` can be selected so, but not be taken away: no file's name begins with `./`."""
    front = '' if is_added and clean(folder) == '.' else clean(folder) + '/'
    return f'{front}{pattern}' if pattern == '**' else f'{front}**/{pattern}'


def selection(is_wanted: object) -> Selection:
    """What MANIFEST.in of the current folder selects; nothing where setup() does not ask for it."""
    result = Selection()
    if not is_wanted or not os.path.isfile(NAME):
        return result
    with open(NAME, encoding='utf-8', errors='replace') as stream:
        lines = list(logical_lines(stream.read()))
    every = sorted(clean(f'{parent}/{name}') for parent, names in folders_once('.') for name in names)
    reader = Reader(every)
    for number, line in lines:
        command, *words = line.split()
        if wrong := reader.follow(command, words):
            result.warnings.append((number, wrong))
    result.files = [path for path in reader.chosen if not NEVER.match(path)]
    return result
