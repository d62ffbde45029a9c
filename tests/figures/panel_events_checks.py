"""What visitors do in a Figure panel: the mouse, keys, the toolbar, its size."""
from __future__ import annotations

import io
from typing import Any

from PIL import Image

from tests.figures.figure_bus import FigureTest


class PanelEventsTest(FigureTest):
    def setUp(self) -> None:
        super().setUp()
        self.shown = self.panel()
        self.figure, self.axes = self.plt.subplots(figsize=(4, 3), dpi=100)
        self.axes.set_position((0, 0, 1, 1))
        self.axes.set(xlim=(0, 4), ylim=(0, 3))
        self.heard: list[tuple[Any, ...]] = []
        self.plt.show(block=False)
        self.settle()

    def do(self, *events: Any) -> None:
        self.shown.send(*events)
        self.figure.canvas.flush_events()
        self.shown.look()

    def hear(self, name: str, *what: str) -> None:
        self.figure.canvas.mpl_connect(
            name, lambda event: self.heard.append((event.name, *(getattr(event, one) for one in what))))

    # Compatibility, works: Python: events of matplotlib figures: mouse, scroll, keys, resize, close
    def test_the_mouse(self) -> None:
        for name in ('button_press_event', 'button_release_event', 'motion_notify_event'):
            self.hear(name, 'x', 'y', 'xdata', 'ydata', 'button', 'dblclick')
        self.hear('scroll_event', 'step', 'button')
        self.hear('figure_enter_event', 'x')
        self.do({'mouse': 'enter', 'x': 0, 'y': 9}, {'mouse': 'move', 'x': 100, 'y': 50},
                {'mouse': 'press', 'x': 100, 'y': 50, 'button': 0}, {'mouse': 'move', 'x': 200, 'y': 50},
                {'mouse': 'release', 'x': 200, 'y': 50, 'button': 0},
                {'mouse': 'press', 'x': 200, 'y': 50, 'button': 2, 'double': True},
                {'mouse': 'scroll', 'x': 200, 'y': 50, 'step': -1})
        numbers = [tuple(round(one, 6) if isinstance(one, float) else one for one in event) for event in self.heard]
        self.assertEqual(numbers, [
            ('figure_enter_event', 0),
            ('motion_notify_event', 100, 250, 1, 2.5, None, False),
            ('button_press_event', 100, 250, 1, 2.5, 1, False),
            ('motion_notify_event', 200, 250, 2, 2.5, 1, False),
            ('button_release_event', 200, 250, 2, 2.5, 1, False),
            ('button_press_event', 200, 250, 2, 2.5, 3, True),
            ('scroll_event', -1, 'down')])

    def test_keys(self) -> None:
        self.hear('key_press_event', 'key', 'x')
        self.hear('key_release_event', 'key')
        self.do({'mouse': 'move', 'x': 10, 'y': 10},
                {'key': 'press', 'name': 'x', 'modifiers': []}, {'key': 'release', 'name': 'x', 'modifiers': []},
                {'key': 'press', 'name': 'A', 'modifiers': ['shift']},
                {'key': 'press', 'name': 'a', 'modifiers': ['alt', 'ctrl']},
                {'key': 'press', 'name': 'ArrowLeft', 'modifiers': ['shift']},
                {'key': 'press', 'name': 'Control', 'modifiers': ['ctrl']},
                {'key': 'press', 'name': 'Unidentified', 'modifiers': []})
        self.assertEqual(self.heard, [
            ('key_press_event', 'x', 10), ('key_release_event', 'x'), ('key_press_event', 'A', 10),
            ('key_press_event', 'ctrl+alt+a', 10), ('key_press_event', 'shift+left', 10),
            ('key_press_event', 'control', 10)])

    # Compatibility, works: Python: matplotlib's own zoom, pan, home, back, forward and save in a Figure panel
    def test_zoom_back_forward_and_home(self) -> None:
        self.do({'tool': 'zoom'})
        self.assertEqual(self.shown.controls['mode'], 'zoom')
        self.do({'mouse': 'press', 'x': 100, 'y': 100, 'button': 0}, {'mouse': 'move', 'x': 200, 'y': 200})
        self.assertEqual(self.shown.controls['rubberband'], [100, 100, 200, 200])
        self.assertEqual(self.shown.controls['cursor'], 'crosshair')
        self.do({'mouse': 'release', 'x': 200, 'y': 200, 'button': 0})
        self.assertIsNone(self.shown.controls['rubberband'])
        self.limits(1, 2, 1, 2)
        self.history(True, False)
        self.do({'tool': 'back'})
        self.limits(0, 4, 0, 3)
        self.history(False, True)
        self.do({'tool': 'forward'})
        self.limits(1, 2, 1, 2)
        self.do({'tool': 'home'})
        self.limits(0, 4, 0, 3)

    def test_pan(self) -> None:
        self.do({'tool': 'pan'})
        self.assertEqual(self.shown.controls['mode'], 'pan')
        self.do({'mouse': 'press', 'x': 100, 'y': 100, 'button': 0}, {'mouse': 'move', 'x': 200, 'y': 100},
                {'mouse': 'release', 'x': 200, 'y': 100, 'button': 0})
        self.limits(-1, 3, 0, 3)
        self.do({'tool': 'pan'})
        self.assertEqual(self.shown.controls['mode'], 'none')

    def test_the_place_of_the_pointer_is_told(self) -> None:
        self.do({'mouse': 'move', 'x': 100, 'y': 150})
        self.assertRegex(self.shown.controls['message'], r'x=1\.00\d* y=1\.50')

    def test_save(self) -> None:
        self.do({'tool': 'save'}, {'key': 'press', 'name': 's', 'modifiers': []})
        files = self.shown.files
        self.assertEqual([(file.header.frame_id, file.format) for file in files], [('Figure_1.png', 'png')] * 2)
        self.assertEqual(Image.open(io.BytesIO(bytes(files[0].data))).size, (400, 300))

    def test_the_size_of_the_panel(self) -> None:
        self.hear('resize_event', 'width', 'height')
        self.do({'size': [320, 200]})
        self.settle()
        self.shown.look()
        self.assertEqual(self.heard, [('resize_event', 320, 200)])
        self.assertEqual((self.shown.pictures[-1].width, self.shown.pictures[-1].height), (320, 200))

    def test_what_is_no_event_does_nothing(self) -> None:
        for name in ('button_press_event', 'key_press_event', 'resize_event', 'close_event', 'scroll_event'):
            self.hear(name)
        self.do('', '[', '7', '[1]', 'null', {}, {'mouse': 'press'}, {'mouse': 7, 'x': 1, 'y': 1},
                {'mouse': 'press', 'x': 'a', 'y': 1}, '{"mouse": "press", "x": NaN, "y": 1}',
                {'mouse': '__init__', 'x': 1, 'y': 1},
                {'key': 'press', 'name': 'x' * 1000}, {'key': 'press', 'name': 5}, {'tool': 'destroy'}, {'tool': []},
                {'size': [1]}, {'size': 'ab'}, {'size': [float('inf'), 9]}, {'close': 1}, {'close': 'true'})
        self.assertEqual(self.heard, [])
        self.do({'size': [1e9, 1]})
        self.assertEqual(tuple(self.figure.bbox.size), (4096, 50))

    def limits(self, *expected: float) -> None:
        found = (*self.axes.get_xlim(), *self.axes.get_ylim())
        for one, wanted in zip(found, expected, strict=True):
            self.assertAlmostEqual(one, wanted, 6)

    def history(self, back: bool, forward: bool) -> None:
        self.assertEqual((self.shown.controls['back'], self.shown.controls['forward']), (back, forward))
