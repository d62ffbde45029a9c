"""Which of several files and rules a node's parameter comes from."""
from __future__ import annotations

import tempfile
import unittest
from pathlib import Path
from typing import Any

from tests.unit.rclpy.fake_bus import BusTest


def document(**values: int) -> str:
    """A parameter file: `a_b` is said for the node /a_b, `any` for every node."""
    return ''.join(f'{"/**" if name == "any" else name}:\n  ros__parameters:\n    blue: {value}\n'
                   for name, value in values.items())


class ParameterOverridesTest(BusTest):
    def setUp(self) -> None:
        super().setUp()
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def blue(self, full_name: str, *said: str) -> Any:
        """The parameter blue for a node, of rules and of files, whose texts end in a newline."""
        from ros2wasm.arguments import Arguments, ParameterRule
        from ros2wasm.parameter_overrides import overrides
        arguments = Arguments()
        for number, text in enumerate(said):
            if text.endswith('\n'):
                file = self.folder / f'{number}.yaml'
                file.write_text(text)
                arguments.parameters.append(ParameterRule(file=str(file)))
            else:
                node, _, value = text.rpartition(':')
                arguments.parameters.append(ParameterRule(node=node, name='blue', value=value))
        return overrides([arguments], full_name)['blue']

    def test_the_own_name_of_a_node_wins_wherever_it_stands(self) -> None:
        self.assertEqual(self.blue('/show_a', '100', document(show_a=5), '200'), 5)
        self.assertEqual(self.blue('/show_c', document(show_c=7), '200'), 7)
        self.assertEqual(self.blue('/show', document(show=1), document(any=2)), 1)
        self.assertEqual(self.blue('/deep/show', 'show:3', '/**:4'), 3)

    def test_the_last_of_one_name_wins(self) -> None:
        self.assertEqual(self.blue('/robot/show_b', '/robot/show_b:100', '/robot/show_b:6', '/robot/show_b:200'), 200)
        self.assertEqual(self.blue('/show', '1', document(any=2)), 2)

    def test_a_wildcard_that_comes_again_keeps_its_place(self) -> None:
        self.assertEqual(self.blue('/robot/show', '1', '/robot/*:2', '3'), 2)
        self.assertEqual(self.blue('/robot/show', '/robot/*:2', '3'), 3)


if __name__ == '__main__':
    unittest.main()
