"""Figures of matplotlib in panels: pictures, events, the toolbar, animations, headless runs."""
from __future__ import annotations

import contextlib
import importlib
import io
import os
import tempfile
import time
from typing import Any

import numpy

from tests.figures.figure_bus import BACKEND, FigureTest

PNG = b'\x89PNG\r\n\x1a\n'


class PictureTest(FigureTest):
    # Compatibility, works: Python: `matplotlib.pyplot.show` opens a Figure panel and blocks until it is closed
    def test_show_blocks_until_the_panel_is_closed(self) -> None:
        panel = self.panel()
        figure, axes = self.plt.subplots(figsize=(3, 2), dpi=100)
        axes.plot([1, 2, 3])
        closed: list[str] = []
        figure.canvas.mpl_connect('close_event', lambda event: closed.append(event.name))

        def has_picture() -> bool:
            panel.look()
            return bool(panel.pictures)
        with self.visitor(figure, has_picture, lambda: panel.send({'close': True})):
            self.plt.show()
        picture = panel.pictures[0]
        self.assertEqual((picture.width, picture.height, picture.encoding, picture.step), (300, 200, 'rgba8', 1200))
        self.assertTrue((panel.rgba() == numpy.asarray(figure.canvas.buffer_rgba())).all())
        self.assertGreater(len({tuple(pixel) for row in panel.rgba() for pixel in row}), 20)
        self.assertEqual((closed, self.plt.get_fignums()), (['close_event'], []))
        self.assertEqual((panel.controls['title'], panel.controls['tools']), ('Figure 1', True))

    def test_each_number_has_a_panel_and_a_title(self) -> None:
        panels = [self.panel('figure_1'), self.panel('figure_7')]
        first = self.plt.figure()
        self.plt.figure(7)
        first.canvas.manager.set_window_title('Odometry')
        self.plt.show(block=False)
        self.plt.pause(0.05)
        self.settle()
        for panel in panels:
            panel.look()
        self.assertEqual([panel.controls['title'] for panel in panels], ['Odometry', 'Figure 7'])
        self.assertEqual(panels[0].pictures[0].header.frame_id, 'Odometry')
        self.assertEqual([len(panel.pictures) for panel in panels], [1, 1])

    # Compatibility, works: Python: `matplotlib.pyplot.pause` draws and waits; at most 15 pictures a second
    def test_pause_draws_at_most_fifteen_times_a_second_and_the_last_state(self) -> None:
        panel = self.panel()
        figure, axes = self.plt.subplots(figsize=(2, 1.5))
        line, = axes.plot([0, 1], [0, 0])
        self.plt.pause(0.2)
        panel.look()
        panel.pictures.clear()
        began = time.monotonic()
        for step in range(40):
            line.set_ydata([0, step / 40])
            self.plt.pause(0.001)
        lasted = time.monotonic() - began
        panel.look()
        self.assertLessEqual(len(panel.pictures), int(lasted * 15) + 1)
        self.settle()
        panel.look()
        figure.canvas.draw()
        self.assertTrue((panel.rgba() == numpy.asarray(figure.canvas.buffer_rgba())).all())
        began = time.monotonic()
        self.plt.pause(0.3)
        self.assertGreaterEqual(time.monotonic() - began, 0.3)

    def test_interactive_figures_are_shown_at_once(self) -> None:
        panel = self.panel()
        self.plt.ion()
        self.plt.plot([1, 3, 2])
        self.plt.show()
        self.plt.gcf().canvas.flush_events()
        panel.look()
        self.assertEqual(len(panel.pictures), 1)
        self.plt.title('later')
        self.plt.pause(0.1)
        self.settle()
        panel.look()
        self.assertEqual(len(panel.pictures), 2)

    # Compatibility, works: Python: `matplotlib.animation.FuncAnimation` while `show` or `pause` blocks
    def test_animations_run_while_show_blocks(self) -> None:
        animation = importlib.import_module('matplotlib.animation')
        panel = self.panel()
        figure, axes = self.plt.subplots(figsize=(2, 1.5))
        line, = axes.plot([0, 1], [0, 0])
        frames: list[int] = []

        def step(frame: int) -> tuple[Any]:
            frames.append(frame)
            line.set_ydata([0, frame / 10])
            return line,
        for blit in (False, True):
            frames.clear()
            running = animation.FuncAnimation(figure, step, frames=8, interval=20, repeat=False, blit=blit)
            figure.canvas.draw_idle()
            self.plt.show(block=False)

            def is_over() -> bool:
                panel.look()
                return frames[-1:] == [7] and len(panel.pictures) > 2
            with self.visitor(figure, is_over, figure.canvas.stop_event_loop):
                figure.canvas.start_event_loop()
            self.assertEqual(frames[-8:], list(range(8)))
            panel.pictures.clear()
            del running

    def test_savefig_writes_files(self) -> None:
        self.plt.plot([1, 2])
        with tempfile.TemporaryDirectory() as folder:
            for ending, begin in (('png', PNG), ('svg', b'<?xml'), ('pdf', b'%PDF')):
                path = os.path.join(folder, f'plot.{ending}')
                self.plt.savefig(path)
                with open(path, 'rb') as file:
                    self.assertTrue(file.read(8).startswith(begin[:8]), ending)


class HeadlessTest(FigureTest):
    def setUp(self) -> None:
        super().setUp()
        self.bus.page = False

    # Compatibility, differs: Python: `matplotlib.pyplot.show` in a headless run -> returns as if all figures were
    # closed, once no animation and no other thread can change them; prints a line
    def test_show_goes_on_when_nothing_changes_figures(self) -> None:
        said = io.StringIO()
        closed: list[str] = []
        figure = self.plt.figure()
        figure.canvas.mpl_connect('close_event', lambda event: closed.append(event.name))
        with contextlib.redirect_stderr(said):
            self.plt.show()
        self.assertIn('show() returns as if all figures were closed', said.getvalue())
        self.assertEqual((closed, self.plt.get_fignums()), (['close_event'], []))

    def test_show_goes_on_after_the_last_frame_of_an_animation(self) -> None:
        animation = importlib.import_module('matplotlib.animation')
        frames: list[int] = []
        figure = self.plt.figure(figsize=(1, 1))

        def step(frame: int) -> list[Any]:
            frames.append(frame)
            return []
        running = animation.FuncAnimation(figure, step, frames=4, interval=5, repeat=False)
        with contextlib.redirect_stderr(io.StringIO()):
            self.plt.show()
        self.assertEqual(frames[-4:], [0, 1, 2, 3])
        del running


class ToolkitTest(FigureTest):
    def test_the_default_is_ours_unless_the_environment_names_another(self) -> None:
        hook = importlib.import_module('ros2wasm.window_hook')
        self.assertIsNone(hook.WindowFinder().find_spec('matplotlib', None))
        self.assertEqual(os.environ['MPLBACKEND'], BACKEND)
        os.environ['MPLBACKEND'] = 'TkAgg'
        hook.WindowFinder().find_spec('matplotlib', None)
        self.assertEqual(os.environ['MPLBACKEND'], 'TkAgg')

    # Compatibility, differs: Python: `matplotlib.use('TkAgg')` and other toolkits of desktops -> draws into Figure
    # panels; prints a line. Widgets of a toolkit cannot be imported
    def test_backends_of_toolkits_draw_into_panels(self) -> None:
        matplotlib = importlib.import_module('matplotlib')
        said = io.StringIO()
        with contextlib.redirect_stderr(said):
            for name in ('TkAgg', 'Qt5Agg', 'TkAgg'):
                matplotlib.use(name)
                self.assertEqual(matplotlib.get_backend(), name)
                self.assertEqual(type(self.plt.figure().canvas).__module__, 'ros2wasm_figures.backend')
        self.assertEqual(said.getvalue().splitlines(), [
            '[matplotlib] the backend tkagg draws into Figure panels of the page',
            '[matplotlib] the backend qt5agg draws into Figure panels of the page'])
        with self.assertRaisesRegex(ImportError, 'backend_qt5agg.FigureCanvasQTAgg needs a toolkit of desktops'):
            from matplotlib.backends.backend_qt5agg import FigureCanvasQTAgg  # noqa: F401
        self.plt.switch_backend('agg')
        self.assertEqual(type(self.plt.figure().canvas).__name__, 'FigureCanvasAgg')
        self.plt.switch_backend(BACKEND)
