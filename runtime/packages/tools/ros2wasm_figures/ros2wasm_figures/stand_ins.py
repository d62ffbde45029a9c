"""The modules of matplotlib's backends for desktop toolkits: all draw into panels instead."""
from __future__ import annotations

import sys
from types import ModuleType
from typing import Any

_told: set[str] = set()


class ToolkitBackend(ModuleType):
    """Has the interface of a backend. Widgets of the toolkit cannot be imported."""

    def __getattr__(self, name: str) -> Any:
        if name.startswith('__'):
            raise AttributeError(f'module {self.__name__!r} has no attribute {name!r}')
        toolkit = self.__name__.rpartition('.backend_')[2]
        raise ImportError(
            f'{self.__name__}.{name} needs a toolkit of desktops, which a page does not have: make figures by '
            f'matplotlib.pyplot, which draws into Figure panels in place of {toolkit}', name=self.__name__)


def fill(module: ModuleType) -> None:
    from ros2wasm_figures import backend
    for name in ('FigureCanvas', 'FigureManager', 'new_figure_manager', 'new_figure_manager_given_figure',
                 'draw_if_interactive', 'show'):
        setattr(module, name, getattr(backend, name))
    toolkit = module.__name__.rpartition('.backend_')[2]
    if toolkit not in _told:
        _told.add(toolkit)
        print(f'[matplotlib] the backend {toolkit} draws into Figure panels of the page', file=sys.stderr, flush=True)
