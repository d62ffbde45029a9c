"""A backend of matplotlib whose windows are Figure panels: it renders with Agg, and pictures go out by a surface.

Zoom, pan and history are matplotlib's own toolbar, which the buttons of the panel control. At most one picture per
PERIOD is sent. As with other backends, a figure reacts while an event loop runs: in show() and pause().
"""
from __future__ import annotations

import inspect
import io
import sys
import threading
import time
import weakref
from typing import Any

from matplotlib import is_interactive
from matplotlib._pylab_helpers import Gcf
from matplotlib.backend_bases import (
    CloseEvent, FigureManagerBase, KeyEvent, LocationEvent, MouseEvent, NavigationToolbar2, ResizeEvent, TimerBase)
from matplotlib.backend_tools import Cursors
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from ros2wasm.side_node import has_page
from ros2wasm_figures import loop
from ros2wasm_figures.events import PanelEvent, read_event
from ros2wasm_figures.keys import key_name
from ros2wasm_figures.surface import Surface, desk

#: Seconds between two pictures of a figure: 15 a second.
PERIOD = 1 / 15
CURSORS = {
    Cursors.HAND: 'pointer', Cursors.POINTER: 'default', Cursors.SELECT_REGION: 'crosshair', Cursors.MOVE: 'move',
    Cursors.WAIT: 'wait', Cursors.RESIZE_HORIZONTAL: 'ew-resize', Cursors.RESIZE_VERTICAL: 'ns-resize',
}
MOUSE = {
    'press': 'button_press_event', 'release': 'button_release_event', 'move': 'motion_notify_event',
    'scroll': 'scroll_event',
}
CROSSINGS = {'enter': 'figure_enter_event', 'leave': 'figure_leave_event'}
KEYS = {'press': 'key_press_event', 'release': 'key_release_event'}
#: Buttons of the panel, and the toolbar's methods behind them.
TOOLS = {
    'home': 'home', 'back': 'back', 'forward': 'forward', 'pan': 'pan', 'zoom': 'zoom', 'save': 'save_figure'}
#: Since matplotlib 3.7, events know the keys that are held.
HAS_MODIFIERS = 'modifiers' in inspect.signature(LocationEvent).parameters


class Timer(TimerBase):
    """A timer that runs while an event loop of this backend runs."""

    running: weakref.WeakSet[Timer] = weakref.WeakSet()
    due: float | None = None

    def _timer_start(self) -> None:
        self.due = time.monotonic() + self.interval / 1000
        self.running.add(self)

    def _timer_stop(self) -> None:
        self.due = None
        self.running.discard(self)

    def _timer_set_interval(self) -> None:
        if self.due is not None:
            self._timer_start()

    def run(self) -> None:
        now = time.monotonic()
        if self.due is None or self.due > now:
            return
        if self.single_shot:
            self._timer_stop()
        else:
            # Missed periods are skipped.
            self.due = max(now, self.due + self.interval / 1000)
        self._on_timer()


class Toolbar(NavigationToolbar2):
    """The toolbar of matplotlib. Its buttons are in the panel."""

    def set_message(self, s: object) -> None:
        self.canvas.tell(message=str(s))

    def draw_rubberband(self, event: Any, x0: float, y0: float, x1: float, y1: float) -> None:
        height = self.canvas.figure.bbox.height
        self.canvas.tell(rubberband=[float(one) for one in (x0, height - y0, x1, height - y1)])

    def remove_rubberband(self) -> None:
        self.canvas.tell(rubberband=None)

    def pan(self, *args: Any) -> None:
        super().pan(*args)
        self.canvas.tell(mode=self.mode.name.lower())

    def zoom(self, *args: Any) -> None:
        super().zoom(*args)
        self.canvas.tell(mode=self.mode.name.lower())

    def set_history_buttons(self) -> None:
        at = self._nav_stack._pos
        self.canvas.tell(back=at > 0, forward=at < len(self._nav_stack) - 1)

    def save_figure(self, *args: Any) -> None:
        """To the visitor, as PNG, with the options of savefig."""
        file = io.BytesIO()
        self.canvas.figure.savefig(file, format='png')
        self.canvas.give(self.canvas.get_default_filename(), file.getvalue())


class FigureCanvas(FigureCanvasAgg):
    """Renders with Agg. Pictures are limited to one per PERIOD."""

    _timer_cls = Timer
    toolbar: Toolbar | None = None

    def __init__(self, figure: Any = None) -> None:
        #: None until the figure is shown.
        self.surface: Surface | None = None
        #: The state of the panel, also before it is open.
        self.words: dict[str, Any] = {}
        #: is_stale: the figure must be drawn. is_fresh: a drawing must be sent.
        self.is_stale = self.is_fresh = False
        #: Earliest time of the next picture.
        self.next_picture = 0.0
        super().__init__(figure)

    # ---- to the panel

    def tell(self, **words: Any) -> None:
        self.words.update(words)
        if self.surface is not None:
            self.surface.tell(**words)

    def give(self, name: str, data: bytes) -> None:
        if self.surface is not None:
            self.surface.give(name, data, 'png')

    def open(self, name: str) -> None:
        if self.surface is None:
            self.surface = desk.open(name)
            self.surface.tell(**self.words, tools=self.toolbar is not None)
            self.draw_idle()

    def close(self) -> None:
        if self.surface is not None:
            self.surface.close()
        self.surface = None
        self.is_stale = self.is_fresh = False

    def set_cursor(self, cursor: Any) -> None:
        self.tell(cursor=CURSORS.get(cursor, 'default'))

    # ---- pictures

    def draw(self) -> None:
        super().draw()
        # In interactive mode, drawing itself calls draw_idle().
        self.is_stale = False
        self.is_fresh = True

    def draw_idle(self, *args: Any, **kwargs: Any) -> None:
        self.is_stale = True

    def blit(self, bbox: Any = None) -> None:
        self.is_fresh = True

    def due(self) -> float | None:
        """The time of the next picture; None if nothing is new."""
        is_new = self.surface is not None and (self.is_stale or self.is_fresh)
        return self.next_picture if is_new else None

    def refresh(self) -> None:
        """Send the newest picture if it is due."""
        began = time.monotonic()
        due = self.due()
        if due is None or due > began:
            return
        if self.is_stale:
            self.draw()
        self.is_fresh = False
        if self.surface is not None:
            width, height = self.get_width_height()
            self.surface.show(self.buffer_rgba(), width, height)
        now = time.monotonic()
        # A figure that is slow to draw leaves time for the rest of the program.
        self.next_picture = max(began + PERIOD, now + (now - began) / 2)

    # ---- from the panel

    def take_events(self) -> None:
        while self.surface is not None and self.surface.events:
            event = read_event(self.surface.events.popleft())
            if event is not None:
                self.take(event)

    def take(self, event: PanelEvent) -> None:
        kind = event.kind
        if event.what == 'close':
            Gcf.destroy(self.manager)
        elif event.what == 'size':
            self.resize_to(event.x, event.y)
        elif event.what == 'tool' and self.toolbar is not None and kind in TOOLS:
            getattr(self.toolbar, TOOLS[kind])()
        elif event.what == 'key' and kind in KEYS:
            name = key_name(event.key, event.modifiers)
            if name is not None:
                self.process(KeyEvent(KEYS[kind], self, name, *self.last_place))
        elif event.what == 'mouse':
            self.take_mouse(event)

    #: The last position of the pointer, for key events.
    last_place: tuple[float, float] = (0, 0)

    def take_mouse(self, event: PanelEvent) -> None:
        place = event.x, self.figure.bbox.height - event.y
        self.last_place = place
        held: Any = {'modifiers': event.modifiers} if HAS_MODIFIERS else {}
        if event.kind in CROSSINGS:
            self.process(LocationEvent(CROSSINGS[event.kind], self, *place, **held))
        elif event.kind in MOUSE:
            if event.kind in ('press', 'release'):
                held |= {'button': event.button + 1, 'dblclick': event.is_double}
            elif event.kind == 'scroll':
                held |= {'step': event.step}
            self.process(MouseEvent(MOUSE[event.kind], self, *place, **held))

    def process(self, event: Any) -> None:
        self.callbacks.process(event.name, event)

    def resize_to(self, width: float, height: float) -> None:
        """The panel's size becomes the figure's."""
        self.figure.set_size_inches(width / self.figure.dpi, height / self.figure.dpi, forward=False)
        self.process(ResizeEvent('resize_event', self))
        self.draw_idle()

    # ---- the event loop

    def flush_events(self) -> None:
        loop.turn(0)

    def start_event_loop(self, timeout: float = 0) -> None:
        self.is_looping = True
        loop.run(lambda: self.is_looping, timeout if timeout > 0 else None)

    def stop_event_loop(self) -> None:
        self.is_looping = False

    is_looping = False


class FigureManager(FigureManagerBase):
    """Opens one panel per figure number."""

    _toolbar2_class = Toolbar

    def show(self) -> None:
        if self.canvas.figure.stale:
            self.canvas.draw_idle()
        self.canvas.open(f'figure_{self.num}')
        loop.finish_later()

    def destroy(self, *args: Any) -> None:
        if getattr(self, 'is_destroyed', False):
            return
        self.is_destroyed = True
        self.canvas.process(CloseEvent('close_event', self.canvas))
        self.canvas.stop_event_loop()
        self.canvas.close()

    def resize(self, w: float, h: float) -> None:
        self.canvas.draw_idle()

    def get_window_title(self) -> str:
        return str(self.canvas.words.get('title', ''))

    def set_window_title(self, title: str) -> None:
        self.canvas.tell(title=str(title))


FigureCanvas.manager_class = FigureManager


def new_figure_manager_given_figure(num: int, figure: Figure) -> FigureManager:
    manager = FigureManager(FigureCanvas(figure), num)
    if is_interactive():
        manager.show()
    return manager


def new_figure_manager(num: int, *args: Any, FigureClass: type[Figure] = Figure, **kwargs: Any) -> FigureManager:
    return new_figure_manager_given_figure(num, FigureClass(*args, **kwargs))


def draw_if_interactive() -> None:
    manager = Gcf.get_active()
    if is_interactive() and manager is not None:
        manager.canvas.draw_idle()


def show(*, block: bool | None = None) -> None:
    """Show all figures; block until all are closed, unless pyplot is interactive."""
    managers = Gcf.get_all_fig_managers()
    for manager in managers:
        manager.show()
    if not managers or not (not is_interactive() if block is None else block):
        return
    while Gcf.get_num_fig_managers() > 0:
        loop.turn(None)
        if not has_page() and not goes_on():
            print('[matplotlib] a headless run has no page: show() returns as if all figures were closed',
                  file=sys.stderr, flush=True)
            Gcf.destroy_all()


def goes_on() -> bool:
    """Whether an animation or another thread can still change a figure while show() blocks."""
    return bool(Timer.running) or threading.active_count() > 1
