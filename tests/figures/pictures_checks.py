"""Pillow's Image.show() and the import of tkinter."""
from __future__ import annotations

import importlib
import sys
from unittest import mock

import PIL
from PIL import Image

from tests.figures.figure_bus import FigureTest


class PillowTest(FigureTest):
    def setUp(self) -> None:
        super().setUp()
        # As in a site: the hook is there when Pillow first imports it.
        self.enterContext(mock.patch.dict(sys.modules))
        self.enterContext(mock.patch.object(PIL, 'ImageShow'))
        del sys.modules['PIL.ImageShow'], PIL.ImageShow

    # Compatibility, works: Python: `PIL.Image.show` opens a panel with the picture
    def test_show_opens_a_panel_for_each_picture(self) -> None:
        first, second = self.panel('picture_1'), self.panel('picture_2')
        Image.new('RGB', (4, 3), (200, 10, 20)).show()
        Image.new('L', (2, 2), 7).show(title='map')
        for panel in (first, second):
            panel.look()
        self.assertEqual(first.rgba().tolist(), [[[200, 10, 20, 255]] * 4] * 3)
        self.assertEqual(second.rgba().tolist(), [[[7, 7, 7, 255]] * 2] * 2)
        self.assertEqual([(panel.controls['title'], panel.controls['tools']) for panel in (first, second)],
                         [('Picture 1', False), ('map', False)])

    def test_the_eleventh_picture_takes_the_panel_of_the_first(self) -> None:
        self.bus.page = False
        panel = self.panel('picture_1')
        for number in range(11):
            Image.new('L', (1, 1), number).show()
        panel.look()
        self.assertEqual([bytes(picture.data)[0] for picture in panel.pictures], [0, 10])


class TkinterTest(FigureTest):
    # Compatibility, cannot: Python: `tkinter` -> R2W0518 and the error of the import; use `cv2.imshow`, matplotlib or
    # `PIL.Image.show` for pictures, and parameters for values
    def test_the_error_names_what_to_do_instead(self) -> None:
        hook = importlib.import_module('ros2wasm.window_hook')
        self.enterContext(mock.patch.dict(sys.modules))
        sys.modules.pop('tkinter', None)
        self.enterContext(mock.patch.object(hook.PathFinder, 'find_spec', lambda *_: None))
        with self.assertRaisesRegex(ModuleNotFoundError, "No module named 'tkinter': .*matplotlib.pyplot.*Parameters"):
            importlib.import_module('tkinter')
