"""Figures of matplotlib below the cells of a notebook."""
from __future__ import annotations

import base64
import importlib
import io
import os
import sys
from typing import Any

import matplotlib
from PIL import Image

from tests.unit.rclpy.notebook_test import KernelTest
from tests.figures.figure_bus import FigureTest

SETUP = "import matplotlib.pyplot as plt\nplt.switch_backend(__import__('os').environ['MPLBACKEND'])"


class InlineTest(KernelTest, FigureTest):
    def run_in_notebook(self, *cells: str) -> list[list[dict[str, Any]]]:
        os.environ.pop('MPLBACKEND', None)
        sys.modules.pop('ros2wasm_figures.inline', None)
        display = self.notebook.display
        display.attach(lambda *_: None, lambda *_: None)
        importlib.import_module('ros2wasm.window_hook').choose_backend()
        self.addCleanup(display.attach, None, None)
        self.addCleanup(display.after_cell.clear)
        return self.run_cells(SETUP, *cells)[1:]

    # Compatibility, works: notebooks: figures of matplotlib below the cell that made them
    def test_figures_come_after_the_cell_and_are_closed(self) -> None:
        first, second, third = self.run_in_notebook(
            '%matplotlib inline\nplt.plot([1, 2]);', 'plt.get_fignums()', 'plt.plot([3]); 1 / 0')
        shown, = first
        picture = Image.open(io.BytesIO(base64.b64decode(shown['data']['image/png'])))
        self.assertEqual((shown['event'], picture.format), ('display', 'PNG'))
        self.assertGreater(picture.width, 300)
        self.assertEqual(second[0]['data'], {'text/plain': '[]'})
        self.assertEqual([event['event'] for event in third], ['error', 'display'])

    def test_show_and_figures_as_values(self) -> None:
        first, second = self.run_in_notebook(
            "plt.plot([1]); plt.show(); print('after')", 'figure = plt.figure(); plt.close(); figure')
        self.assertEqual([event['event'] for event in first], ['display', 'stream'])
        self.assertIn('image/png', second[0]['data'])
        self.assertEqual(matplotlib.get_backend(), 'module://ros2wasm_figures.inline')
