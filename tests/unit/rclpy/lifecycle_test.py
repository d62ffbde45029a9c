"""Managed nodes: what is switched on and off with them."""
from __future__ import annotations

import importlib
import unittest
from typing import Any

from tests.unit.rclpy.fake_bus import BusTest


class LifecycleTest(BusTest):
    def setUp(self) -> None:
        super().setUp()
        self.lifecycle: Any = importlib.import_module('rclpy.lifecycle')
        self.string: Any = importlib.import_module('std_msgs.msg').String
        self.managed = self.lifecycle.Node('managed', context=self.context)
        self.addCleanup(self.managed.destroy_node)
        self.executor.add_node(self.managed)

    def test_a_publisher_sends_from_the_next_activation_on(self) -> None:
        heard: list[str] = []
        self.managed.create_subscription(self.string, 'chatter', lambda said: heard.append(said.data), 10)
        self.managed.trigger_configure()
        early = self.managed.create_lifecycle_publisher(self.string, 'chatter', 10)
        early.publish(self.string(data='too early'))
        self.managed.trigger_activate()
        late = self.managed.create_lifecycle_publisher(self.string, 'chatter', 10)
        late.publish(self.string(data='not yet'))
        early.publish(self.string(data='first'))
        self.managed.trigger_deactivate()
        early.publish(self.string(data='too late'))
        self.managed.trigger_activate()
        late.publish(self.string(data='second'))
        self.spin_until(lambda: len(heard) >= 2)
        self.assertEqual(heard, ['first', 'second'])
        self.assertTrue(self.managed.destroy_publisher(late))
        self.assertEqual(self.managed._managed_entities, [early])

    def test_who_is_not_enabled_says_so_without_arguments(self) -> None:
        said: list[str] = []
        entity: Any = self.lifecycle.SimpleManagedEntity

        class Lamp(entity):  # type: ignore[misc]
            @entity.when_enabled(when_not_enabled=lambda: said.append('dark'))  # type: ignore[misc]
            def shine(self, colour: str) -> None:
                said.append(colour)
        lamp = Lamp()
        self.assertIsNone(lamp.shine('red'))
        lamp.on_activate(None)
        lamp.shine('red')
        self.assertEqual(said, ['dark', 'red'])


if __name__ == '__main__':
    unittest.main()
