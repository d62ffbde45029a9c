"""matplotlib itself with our backend, on a bus within the process; the test is the panel."""
from __future__ import annotations

import importlib
import json
import os
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any
from unittest import mock

# A second import in one process fails in part: the modules of a test class are forgotten after it.
import matplotlib.pyplot
import PIL.ImageShow  # noqa: F401

from tests.unit.rclpy.fake_bus import BusTest
from tests.unit.rclpy.installation import ROOT

BACKEND = 'module://ros2wasm_figures.backend'


class Panel:
    """What the page shows of a surface, and what its visitor does."""

    def __init__(self, test: FigureTest, name: str) -> None:
        from sensor_msgs.msg import CompressedImage, Image
        from std_msgs.msg import String
        self.test = test
        self.pictures: list[Any] = []
        self.files: list[Any] = []
        self.controls: dict[str, Any] = {}
        topic = f'/figures/plot/{name}'
        node = test.node('panel')
        node.create_subscription(Image, topic, self.pictures.append, 100)
        node.create_subscription(CompressedImage, f'{topic}/saved', self.files.append, 100)
        node.create_subscription(String, f'{topic}/controls', self.take, 100)
        self.inputs = node.create_publisher(String, f'{topic}/input', 100)

    def take(self, message: Any) -> None:
        self.controls = json.loads(message.data)

    def look(self) -> None:
        """Take what has come."""
        count = -1
        while count != self.test.bus.wakes:
            count = self.test.bus.wakes
            self.test.executor.spin_once(timeout_sec=0)
        for _ in range(20):
            self.test.executor.spin_once(timeout_sec=0)

    def send(self, *events: Any) -> None:
        from std_msgs.msg import String
        for event in events:
            self.inputs.publish(String(data=event if isinstance(event, str) else json.dumps(event)))

    def rgba(self) -> Any:
        """The newest picture as an array."""
        import numpy
        last = self.pictures[-1]
        return numpy.frombuffer(bytes(last.data), numpy.uint8).reshape(last.height, last.width, 4)


class FigureTest(BusTest):
    plt: Any

    @classmethod
    def setUpClass(cls) -> None:
        super().setUpClass()
        sys.path.insert(0, str(ROOT / 'runtime/packages/tools/ros2wasm_figures'))
        cls.enterClassContext(mock.patch.dict(os.environ))
        os.environ.pop('MPLBACKEND', None)
        importlib.import_module('ros2wasm.window_hook').install()
        cls.plt = matplotlib.pyplot
        cls.plt.switch_backend(BACKEND)
        cls.addClassCleanup(cls.plt.switch_backend, 'agg')

    def setUp(self) -> None:
        super().setUp()
        self.enterContext(mock.patch.object(sys, 'argv', ['/ros/lib/course/plot']))
        self.bus.page = True
        surface = importlib.import_module('ros2wasm_figures.surface')
        surface.desk.__init__()
        self.addCleanup(self.end)

    def end(self) -> None:
        self.plt.close('all')
        self.plt.ioff()
        setattr(importlib.import_module('ros2wasm.host'), 'before_wait', None)

    def settle(self) -> None:
        """What is not drawn yet is drawn when the program waits for something else."""
        host = importlib.import_module('ros2wasm.host')
        self.spin_until(lambda: host.before_wait is None)

    def panel(self, name: str = 'figure_1') -> Panel:
        return Panel(self, name)

    @contextmanager
    def visitor(self, figure: Any, *steps: Callable[[], Any]) -> Iterator[None]:
        """While an event loop runs, calls one step after the other; a step that returns False is repeated."""
        left = list(steps)
        timer = figure.canvas.new_timer(interval=5)
        end = time.monotonic() + 20

        def step() -> None:
            self.assertLess(time.monotonic(), end, 'the visitor waits for something that does not come')
            if left and left[0]() is not False:
                del left[0]
            if not left:
                timer.stop()
        timer.add_callback(step)
        timer.start()
        yield
        self.assertEqual(left, [])
