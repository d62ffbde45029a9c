"""Launch files in XML, YAML and Python come to the same.

All descriptions of one language are evaluated by one call, each in a group of its own. Random ones: as many as
ROS2WASM_LAUNCH_TREES says, from the seed ROS2WASM_SEED.
"""
from __future__ import annotations

import difflib
import json
import os
import random
import subprocess
import sys
import tempfile
import unittest
from collections.abc import Callable
from pathlib import Path
from typing import Any

from tests.launch.launch_cases import CASES, node, var
from tests.launch.launch_trees import Action, Sub, Text, action, file_texts, part

CLI = Path(os.environ.get('ROS2WASM_CLI', 'build/ros2wasm')).resolve()
EVALUATOR = Path(os.environ.get('ROS2WASM_BUILD', 'build')).resolve() / 'runtime' / 'launch_evaluator.wasm'
IN_SITE = Path(__file__).with_name('evaluate_in_site.ts')
GOLDEN = Path(__file__).with_name('launch_cases.golden')
ENDINGS = ('xml', 'yaml', 'py')

PACKAGE = """<package format="3"><name>demo</name><version>1.2.3</version><description>A package of a test</description>
<maintainer email="someone@example.org">Someone</maintainer><license>Apache-2.0</license></package>
"""
NUMBERS = ('0.0', '-0.0', '0e5', '0.0001', '1.0', '-2.5', '1e-400', '1.5e-7', '1e300', '3', '0x1f')
INNER = {
    'inner.launch.xml': '<launch><arg name="x"/><arg name="y" default="z"/>'
                        '<log message="inner $(var x) $(var y)"/></launch>\n',
    'inner.launch.yaml': 'launch:\n- arg: {name: x}\n- log: {message: "inner $(var x)"}\n',
    'inner.launch.py': 'from launch import LaunchDescription\nfrom launch.actions import LogInfo\n'
                       'from launch.substitutions import LaunchConfiguration\n\n\ndef generate_launch_description():\n'
                       '    return LaunchDescription([LogInfo(msg=["inner ", LaunchConfiguration("x")])])\n',
}


class Languages:
    """A workspace with the descriptions in every language."""

    def __init__(self, folder: Path, descriptions: list[list[Action]]) -> None:
        self.folder = folder
        (folder / 'demo').mkdir()
        files = {'demo/package.xml': PACKAGE, 'p.yaml': '/**:\n  ros__parameters: {v: $(var v)}\n', 'note.txt': 'noted',
                 **INNER}
        for number, description in enumerate(descriptions):
            for ending, text in file_texts(description).items():
                files[f'case_{number}.launch.{ending}'] = text
        for ending in ENDINGS:
            files[f'all_{ending}.launch.xml'] = '<launch>\n' + '\n'.join(
                f'<group><include file="case_{number}.launch.{ending}"/></group>'
                for number in range(len(descriptions))) + '\n</launch>\n'
        for name, text in files.items():
            (folder / name).write_text(text, encoding='utf-8')

    def run(self, ending: str, *options: str) -> str:
        result = subprocess.run([str(CLI), 'launch', f'all_{ending}.launch.xml', *options], cwd=self.folder,
                                capture_output=True, text=True, check=False)
        if result.returncode != 0:
            raise AssertionError(f'{ending}: {result.stderr}')
        return result.stdout

    def in_site(self, ending: str, *given: str) -> Any:
        """What a site makes of it: packed without launch arguments, started with these."""
        data, share = self.folder / f'launch_{ending}.json', self.folder / 'share'
        if not data.exists():
            data.write_text(self.run(ending, '--site-data'), encoding='utf-8')
        if not share.exists():
            share.mkdir()
            (share / 'demo').symlink_to('../demo')
        result = subprocess.run(['node', str(IN_SITE), str(EVALUATOR), str(data), str(self.folder), *given],
                                capture_output=True, text=True, check=False)
        if result.returncode != 0:
            raise AssertionError(f'{ending}: {result.stderr}')
        return json.loads(result.stdout)

    def whole(self, ending: str, *given: str) -> Any:
        return json.loads(self.run(ending, *given, '--json').splitlines()[0])

    def tree(self, ending: str) -> str:
        """Without places."""
        return ''.join(line.rsplit('  [', 1)[0] + '\n' for line in self.run(ending).splitlines())

    def data(self, ending: str) -> Any:
        return without_places(json.loads(self.run(ending, '--json').splitlines()[0]))


def without_places(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: without_places(one) for key, one in value.items() if key not in ('source', 'files')}
    return [without_places(one) for one in value] if isinstance(value, list) else value


def differences(one: Any, other: Any) -> list[str]:
    first, second = (json.dumps(value, indent=1, ensure_ascii=False).splitlines() for value in (one, other))
    return list(difflib.unified_diff(first, second, lineterm='', n=4))[:60]


class RandomTrees:
    """Descriptions of all that the three languages share."""

    def __init__(self, seed: int) -> None:
        self.random = random.Random(seed)
        self.count = 0

    def name(self) -> str:
        self.count += 1
        return f'r{self.count}'

    def plain(self) -> str:
        return ''.join(self.random.choice('ab1 .-_/$()\\\'"#:{},é') for _ in range(self.random.randrange(1, 8)))

    def text(self, depth: int = 0) -> Text:
        kind = self.random.randrange(4 if depth < 2 else 1)
        if kind == 0:
            return self.plain()
        if kind == 1:
            return (self.plain(), self.sub(depth + 1))
        return self.sub(depth + 1)

    def sub(self, depth: int) -> Sub:
        inner = self.text(depth)
        return self.random.choice([
            Sub('var', ('unset', inner)), Sub('var', (f'v{self.random.randrange(3)}', inner)),
            Sub('env', ('UNSET', inner)), Sub('equals', (inner, self.plain())),
            Sub('if', (self.random.choice(['true', '0', 'yes']), inner, self.plain())),
            Sub('string-join', (self.plain(), inner, self.plain())), Sub('find-pkg-share', ('demo',)),
            Sub('not', (self.random.choice(['true', 'off', '1']),)),
            Sub('eval', (f'{self.random.randrange(9)} * {self.random.randrange(9)}',))])

    def value(self) -> Any:
        one = self.random.choice
        return one([True, False, self.random.randrange(-9, 9), self.random.randrange(-8, 8) / 4, self.plain(),
                    [self.random.randrange(9) for _ in range(3)], [self.plain(), self.plain()], [0.5, 2.0],
                    Sub('var', ('unset', one(['1', '2.5', 'true', 'word', "'1'"])))])

    def parameter(self, depth: int = 0) -> Action:
        if depth < 2 and self.random.random() < 0.2:
            return Action('param', {'name': self.name()}, [self.parameter(depth + 1) for _ in range(2)])
        return part('param', name=self.name(), value=self.value())

    def condition(self) -> dict[str, Any]:
        if self.random.random() < 0.7:
            return {}
        truths: list[Text] = ['true', '0', Sub('equals', ('a', self.random.choice('ab'))),
                              Sub('not', ('false',))]
        return {self.random.choice(['if_', 'unless']): self.random.choice(truths)}

    def maybe(self, **attributes: Any) -> dict[str, Any]:
        return {name: value for name, value in attributes.items() if self.random.random() < 0.4}

    def node(self) -> Action:
        parts = [self.parameter() for _ in range(self.random.randrange(3))]
        parts += [part('remap', from_='x', to=self.name()) for _ in range(self.random.randrange(2))]
        parts += [part('env', name='V', value=self.text()) for _ in range(self.random.randrange(2))]
        return action('node', *parts, pkg='demo', exec='talker', name=self.name(), **self.condition(), **self.maybe(
            namespace=self.random.choice(['a', '/b', 'c/d']), output=self.random.choice(['screen', 'log', 'both']),
            respawn=True, args='--x y'))

    def action(self, depth: int) -> Action:
        def inner() -> list[Action]:
            return [self.action(depth + 1) for _ in range(self.random.randrange(1, 4))]

        makers: list[Callable[[], Action]] = [
            self.node, self.node, lambda: action('log', message=self.text(), **self.condition()),
            lambda: action('let', name=f'v{self.random.randrange(3)}', value=self.text(), **self.condition()),
            lambda: action('set_env', name='S', value=self.text()),
            lambda: action('append_env', name='S', value=self.text(), prepend=self.random.random() < 0.5),
            lambda: action('push_ros_namespace', namespace=self.random.choice(['p', '/q', 'r/s'])),
            lambda: action('set_remap', from_='all', to=self.name()),
            lambda: action('set_parameter', name=self.name(), value=self.random.choice([1, True, 0.5])),
            lambda: action('include', part('arg', name='x', value=self.text()),
                           file=f'inner.launch.{self.random.choice(ENDINGS)}', **self.condition()),
            lambda: action('arg', name=self.name(), default=self.text())]
        if depth < 3:
            makers += [
                lambda: action('group', children=inner(), **self.maybe(scoped=False, forwarding=True),
                               **self.condition()),
                lambda: action('timer', period=self.random.randrange(1, 9) / 2, children=inner())]
        return self.random.choice(makers)()

    def description(self) -> list[Action]:
        return [self.action(0) for _ in range(self.random.randrange(1, 6))]


class LaunchLanguages(unittest.TestCase):
    def languages(self, descriptions: list[list[Action]]) -> Languages:
        return Languages(Path(self.enterContext(tempfile.TemporaryDirectory())), descriptions)

    def test_cases(self) -> None:
        self.assertGreaterEqual(len(CASES), 30)
        languages = self.languages(list(CASES.values()))
        expected = GOLDEN.read_text(encoding='utf-8')
        for ending in ENDINGS:
            with self.subTest(ending):
                self.assertEqual(languages.tree(ending), expected)
                whole, given = languages.whole(ending), ('c:=True', 'x:=given')
                self.assertEqual([], differences(whole, languages.in_site(ending)))
                other = languages.whole(ending, *given)
                self.assertNotEqual(other, whole)
                self.assertEqual([], differences(other, languages.in_site(ending, *given)))

    def test_numbers_are_the_same_in_a_site(self) -> None:
        lets = [action('let', name=f'v{i}', value=number) for i, number in enumerate(NUMBERS)]
        parts = [part('param', name=f'n{i}', value=var(f'v{i}')) for i in range(len(NUMBERS))]
        languages = self.languages([[*lets, node('n', *parts)]])
        for ending in ENDINGS:
            with self.subTest(ending):
                whole = languages.whole(ending)
                values = {one['name']: one['value'] for one in whole['processes'][0]['parameters']}
                self.assertEqual([0.0, -0.0, 0.0, 0.0001, 1.0, -2.5], [values[f'n{i}'] for i in range(6)])
                self.assertEqual([], differences(whole, languages.in_site(ending)))

    def test_random_trees(self) -> None:
        seed = int(os.environ.get('ROS2WASM_SEED', '1'))
        count = int(os.environ.get('ROS2WASM_LAUNCH_TREES', '100'))
        trees = RandomTrees(seed)
        languages = self.languages([trees.description() for _ in range(count)])
        xml, yaml, python = (languages.data(ending) for ending in ENDINGS)
        self.assertGreater(len(xml['processes']), count // 4)
        for other in (yaml, python):
            self.assertEqual([], differences(xml, other), f'seed {seed}')
        for ending in ENDINGS:
            self.assertEqual([], differences(languages.whole(ending), languages.in_site(ending)), f'seed {seed}')


if __name__ == '__main__':
    if sys.argv[1:] == ['--bless']:
        with tempfile.TemporaryDirectory() as where:
            GOLDEN.write_text(Languages(Path(where), list(CASES.values())).tree('xml'), encoding='utf-8')
    else:
        unittest.main()
