"""Standard input as nodes read it that drive a robot by keys: modes, select, poll, single characters."""
from __future__ import annotations

import importlib
import os
import sys
import time
import unittest
from typing import Any
from unittest import mock

from tests.unit.rclpy.fake_bus import BusTest


class TerminalTest(BusTest):
    def setUp(self) -> None:
        super().setUp()
        terminal = importlib.import_module('ros2wasm.terminal')
        self.select = importlib.import_module('select')
        for module, names in ((os, ('read', 'isatty')), (self.select, ('select', 'poll')), (sys, ('stdin',))):
            for name in names:
                self.enterContext(mock.patch.object(module, name, getattr(module, name)))
        self.enterContext(mock.patch.dict(sys.modules))
        self.enterContext(mock.patch.object(terminal, 'terminal', terminal.Terminal()))
        self.bus.typed.clear()
        self.bus.rest = b''
        terminal.install()
        sys.modules.pop('tty', None)
        self.termios: Any = importlib.import_module('termios')
        self.tty: Any = importlib.import_module('tty')

    def type(self, *texts: str) -> None:
        self.bus.typed.extend(text.encode() for text in texts)

    def there(self, timeout: float | None = 0) -> bool:
        return bool(self.select.select([sys.stdin], [], [], timeout)[0])

    def test_lines_are_lines(self) -> None:
        self.assertFalse(self.there())
        self.type('go on\n', 'x\n')
        self.assertTrue(self.there())
        self.assertEqual([sys.stdin.readline(), sys.stdin.readline()], ['go on\n', 'x\n'])
        self.assertTrue(sys.stdin.isatty() and os.isatty(sys.stdin.fileno()))

    def test_keys_come_one_by_one(self) -> None:
        before = self.termios.tcgetattr(sys.stdin)
        self.tty.setraw(sys.stdin.fileno())
        self.type('wä\n', '\n')
        keys = []
        while self.there():
            keys.append(sys.stdin.read(1))
        self.assertEqual(keys, ['w', 'ä', '\r'])
        self.termios.tcsetattr(sys.stdin, self.termios.TCSADRAIN, before)
        self.assertEqual(self.termios.tcgetattr(sys.stdin), before)
        self.tty.setcbreak(sys.stdin.fileno())
        # raw, cooked, cbreak: what the page sends by.
        self.assertEqual(self.bus.terminal_modes[-3:], [2, 0, 1])
        self.termios.tcsetattr(sys.stdin, self.termios.TCSADRAIN, before)
        self.type('line\n')
        self.assertEqual(sys.stdin.readline(), 'line\n')

    def test_the_way_of_teleop_twist_keyboard(self) -> None:
        settings = self.termios.tcgetattr(sys.stdin)

        def get_key() -> str:
            self.tty.setraw(sys.stdin.fileno())
            ready, _, _ = self.select.select([sys.stdin], [], [], 0.01)
            key = sys.stdin.read(1) if ready else ''
            self.termios.tcsetattr(sys.stdin, self.termios.TCSADRAIN, settings)
            return key
        self.type('i\n')
        self.assertEqual([get_key(), get_key()], ['i', ''])

    def test_a_read_may_give_up(self) -> None:
        modes = self.termios.tcgetattr(0)
        modes[3] &= ~(self.termios.ICANON | self.termios.ECHO)
        modes[6][self.termios.VMIN], modes[6][self.termios.VTIME] = 0, 1
        self.termios.tcsetattr(0, self.termios.TCSANOW, modes)
        begin = time.monotonic()
        self.assertEqual(sys.stdin.read(1), '')
        self.assertGreaterEqual(time.monotonic() - begin, 0.1)
        self.type('k\n')
        self.assertEqual([sys.stdin.read(1), os.read(0, 1)], ['k', b''])

    def test_poll_and_what_is_no_terminal(self) -> None:
        poll = self.select.poll()
        poll.register(sys.stdin, self.select.POLLIN)
        self.assertEqual(poll.poll(0), [])
        self.type('a\n')
        self.assertEqual(poll.poll(), [(0, self.select.POLLIN)])
        poll.unregister(0)
        poll.register(1, self.select.POLLOUT)
        self.assertEqual(poll.poll(), [(1, self.select.POLLOUT)])
        with self.assertRaises(self.termios.error):
            self.termios.tcgetattr(7)
        with self.assertRaises(OSError):
            self.select.select([7], [], [], 0)
        with self.assertRaises(TypeError):
            self.termios.tcsetattr(0, 0, [1, 2])

    def test_what_was_typed_is_dropped(self) -> None:
        self.type('abc\n', 'd\n')
        self.assertEqual(os.read(0, 1), b'a')
        self.termios.tcflush(sys.stdin, self.termios.TCIFLUSH)
        self.assertFalse(self.there())

    def test_select_without_input_only_waits(self) -> None:
        begin = time.monotonic()
        self.assertEqual(self.select.select([], [], [], 0.02), ([], [], []))
        self.assertGreaterEqual(time.monotonic() - begin, 0.02)
        self.assertEqual(self.select.select([0], [1], []), ([], [1], []))


if __name__ == '__main__':
    unittest.main()
