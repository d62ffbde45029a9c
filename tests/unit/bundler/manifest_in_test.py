"""Patterns of MANIFEST.in: what they select, against a reading of their own, and in which time."""
from __future__ import annotations

import random
import sys
import unittest
from functools import lru_cache
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / 'templates' / 'python'))

from manifest_in import pattern_of  # noqa: E402


def selects(pattern: str, path: str) -> bool:
    """By trying everything, without sets: `*` and `?` within a name, `**` as a part for any folders."""
    parts, names = pattern.split('/'), path.split('/')

    @lru_cache(None)
    def name(text: str, letters: str) -> bool:
        if text == '':
            return letters == ''
        if text[0] == '*':
            return name(text[1:], letters) or (letters != '' and name(text, letters[1:]))
        return letters != '' and text[0] in ('?', letters[0]) and name(text[1:], letters[1:])

    @lru_cache(None)
    def rest(part: int, at: int) -> bool:
        if part == len(parts):
            return at == len(names)
        if parts[part] == '**':
            if part == len(parts) - 1:
                return at < len(names)
            return rest(part + 1, at) or (at < len(names) - 1 and rest(part, at + 1))
        return at < len(names) and name(parts[part], names[at]) and rest(part + 1, at + 1)

    return rest(0, 0)


class Patterns(unittest.TestCase):
    def test_they_select_what_trying_everything_selects(self) -> None:
        chance = random.Random(1)
        hits = 0
        for _ in range(4_000):
            pattern = '/'.join(
                chance.choice(['**', *(''.join(chance.choices('ab*?', k=chance.randint(1, 4))) for _ in range(2))])
                for _ in range(chance.randint(1, 4)))
            path = '/'.join(''.join(chance.choices('ab', k=chance.randint(1, 4))) for _ in range(chance.randint(1, 5)))
            if any('**' in part and part != '**' for part in pattern.split('/')):
                continue
            hits += (wanted := selects(pattern, path))
            found = pattern_of(pattern, has_ranges=False).fullmatch(path) is not None
            self.assertEqual(found, wanted, (pattern, path))
        self.assertGreater(hits, 200)

    def test_sets_stand_for_one_letter_of_a_name(self) -> None:
        for pattern, path, wanted in (
                ('a[bc]d', 'acd', True), ('a[!bc]d', 'acd', False), ('a[!b]d', 'a/d', False), ('a[]]d', 'a]d', True),
                ('a[0-9]d', 'a5d', True), ('a[d', 'a[d', True), ('*[ab]*[cd]x', 'qabcdx', True)):
            self.assertEqual(pattern_of(pattern, has_ranges=True).fullmatch(path) is not None, wanted, pattern)
        self.assertIsNone(pattern_of('a[0-9]d', has_ranges=False).fullmatch('a5d'))

    # Guarantee, hostile input: a pattern of MANIFEST.in that would try every way to fit (`*a*a*a...b`, `**/a/**/a...`)
    # takes time by the lengths of the pattern and of the path
    def test_a_pattern_of_many_stars_ends(self) -> None:
        self.assertIsNone(pattern_of('*a' * 120 + 'b', has_ranges=True).fullmatch('a' * 5000))
        self.assertIsNone(pattern_of('**/a/' * 120 + 'b', has_ranges=True).fullmatch('a/' * 2000 + 'a'))
        self.assertIsNone(pattern_of('**/*a*/' * 60 + 'b', has_ranges=True).fullmatch('aaaa/' * 500 + 'a'))
        self.assertIsNone(pattern_of('[' * 200_000, has_ranges=True).fullmatch('a'))


if __name__ == '__main__':
    unittest.main()
