"""Import hook for libraries that open windows: they get panels of the page if the site has ros2wasm_figures."""
from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from importlib.machinery import ModuleSpec, PathFinder
from importlib.util import find_spec
from types import ModuleType
from typing import Any

BACKEND, INLINE = 'module://ros2wasm_figures.backend', 'module://ros2wasm_figures.inline'
#: Modules of matplotlib for toolkits that a page does not have.
TOOLKITS = frozenset(
    f'matplotlib.backends.backend_{name}' for name in (
        'gtk3agg', 'gtk3cairo', 'gtk4agg', 'gtk4cairo', 'macosx', 'nbagg', 'qt5agg', 'qt5cairo', 'qtagg', 'qtcairo',
        'tkagg', 'tkcairo', 'webagg', 'wx', 'wxagg', 'wxcairo'))
NO_TKINTER = (
    "No module named 'tkinter': a page has no windows for it. Pictures are shown by cv2.imshow, matplotlib.pyplot or "
    'PIL.Image.show, each in a panel; values are set by parameters of the node, in the panel Parameters')


class ToolkitLoader:
    def create_module(self, spec: ModuleSpec) -> ModuleType:
        from ros2wasm_figures.stand_ins import ToolkitBackend
        return ToolkitBackend(spec.name)

    def exec_module(self, module: ModuleType) -> None:
        from ros2wasm_figures.stand_ins import fill
        fill(module)


class PillowLoader:
    """Loads the original module and registers our viewer."""

    def __init__(self, own: Any) -> None:
        self.own = own

    def create_module(self, spec: ModuleSpec) -> Any:
        return self.own.create_module(spec)

    def exec_module(self, module: ModuleType) -> None:
        self.own.exec_module(module)
        from ros2wasm_figures.pictures import register
        register()


class WindowFinder:
    """The first finder of sys.meta_path; ignores all other modules."""

    def find_spec(self, name: str, path: Sequence[str] | None, target: ModuleType | None = None) -> ModuleSpec | None:
        if name == 'matplotlib':
            choose_backend()
        elif name in TOOLKITS and has_panels():
            return ModuleSpec(name, ToolkitLoader())  # type: ignore[arg-type]
        elif name == 'PIL.ImageShow' and has_panels():
            found = PathFinder.find_spec(name, path)
            if found is not None:
                found.loader = PillowLoader(found.loader)  # type: ignore[assignment]
            return found
        elif name == 'tkinter' and PathFinder.find_spec(name, path) is None:
            raise ModuleNotFoundError(NO_TKINTER, name=name)
        return None


def has_panels() -> bool:
    return find_spec('ros2wasm_figures') is not None


def choose_backend() -> None:
    """Set MPLBACKEND, unless the environment of the program has it."""
    if has_panels():
        from ros2wasm import display
        os.environ.setdefault('MPLBACKEND', INLINE if display.is_in_notebook() else BACKEND)


def install() -> None:
    if not any(isinstance(finder, WindowFinder) for finder in sys.meta_path):
        sys.meta_path.insert(0, WindowFinder())
