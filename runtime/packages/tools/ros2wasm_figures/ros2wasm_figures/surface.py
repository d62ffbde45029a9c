"""Connects a window of a library with its panel: publishes pictures and state, receives events.

A surface NAME of the program PROGRAM has four topics below /figures/PROGRAM/NAME: the picture itself (the newest
one is latched), `controls` and `input` (JSON in std_msgs/msg/String), and `saved` (files for the visitor).
"""
from __future__ import annotations

import json
import os
import re
import sys
import time
from collections import deque
from typing import Any

from ros2wasm.side_node import SideNode, has_page, newest

#: Longest single wait, in seconds: another thread may have drawn something in the meantime.
LOOK = 0.05
#: Upper bound on queued events; the oldest are dropped.
MOST_EVENTS = 1000
#: Upper bound on the wait for a panel to open, in seconds.
PATIENCE = 2.0
ROOT = '/figures'

Event = dict[str, Any]


def word(text: object) -> str:
    """Converts a text to one element of a topic name."""
    found = re.sub(r'[^A-Za-z0-9]+', '_', str(text)).strip('_')
    return found if found[:1].isalpha() else f'n{found}'


class Surface:
    """One window of a library."""

    def __init__(self, desk: Desk, name: str) -> None:
        from sensor_msgs.msg import CompressedImage, Image
        from std_msgs.msg import String
        self.desk = desk
        self.events: deque[Event] = deque(maxlen=MOST_EVENTS)
        self.told: dict[str, Any] = {}
        topic = f'{desk.place()}/{name}'
        side = desk.side
        self.pictures = side.publisher(Image, topic, newest())
        self.controls = side.publisher(String, f'{topic}/controls', newest())
        self.files = side.publisher(CompressedImage, f'{topic}/saved', 1)
        self.inputs = side.subscription(String, f'{topic}/input', self._take, 100)

    def _take(self, message: Any) -> None:
        """An event of the panel, or of any other program that publishes on the topic."""
        try:
            event = json.loads(message.data)
        except ValueError:
            return
        if isinstance(event, dict):
            self.events.append(event)

    def show(self, rgba: bytes | memoryview, width: int, height: int) -> None:
        """Publish a picture. `rgba`: four bytes per pixel, row by row."""
        from sensor_msgs.msg import Image
        message = Image(height=height, width=width, encoding='rgba8', step=4 * width)
        message.header.frame_id = str(self.told.get('title', ''))
        message.data = bytes(rgba)
        self.pictures.publish(message)

    def tell(self, **words: Any) -> None:
        """Change the state of the panel: title, message, mode and others."""
        from std_msgs.msg import String
        told = {**self.told, **words}
        if told != self.told:
            self.told = told
            self.controls.publish(String(data=json.dumps(told)))

    def give(self, name: str, data: bytes, form: str) -> None:
        """Send a file for the visitor to save."""
        from sensor_msgs.msg import CompressedImage
        message = CompressedImage(format=form)
        message.header.frame_id = name
        message.data = data
        self.files.publish(message)

    def wait_for_panel(self) -> None:
        """Wait until the panel has subscribed: a program that ends earlier would show nothing."""
        end = time.monotonic() + PATIENCE
        while has_page() and not self.pictures.get_subscription_count() and time.monotonic() < end:
            self.desk.wait(LOOK)

    def close(self) -> None:
        self.desk.side.destroy(self.pictures, self.controls, self.files, self.inputs)


class Desk:
    """All windows of the program, and the node that publishes them."""

    def __init__(self) -> None:
        self.side = SideNode('_figures')
        self._place = ''

    def open(self, name: str) -> Surface:
        return Surface(self, word(name))

    def place(self) -> str:
        """The prefix of this program's topics. A second program of the same name gets another one."""
        if self._place == '':
            wanted = f'{ROOT}/{program_name()}'
            topics = [name for name, _ in self.side.node.get_topic_names_and_types()]
            place, number = wanted, 1
            while any(one.startswith(f'{place}/') for one in topics):
                number += 1
                place = f'{wanted}_{number}'
            self._place = place
        return self._place

    def wait(self, seconds: float) -> None:
        """Wait for an event, for at most that time; take all events that have arrived."""
        self.side.wait(seconds)


def program_name() -> str:
    """The node name from the launch file, or else the name of the executable."""
    named = next((one.partition('__node:=')[2] for one in reversed(sys.argv) if one.startswith('__node:=')), '')
    return word(named or os.path.splitext(os.path.basename(sys.argv[0] if sys.argv else ''))[0] or 'program')


desk = Desk()
