"""A backend of matplotlib for notebooks: figures are shown below the cell that made them, and closed, as in Jupyter."""
from __future__ import annotations

import io
from typing import Any

from matplotlib._pylab_helpers import Gcf
from matplotlib.backends.backend_agg import FigureCanvasAgg as FigureCanvas  # noqa: F401
from matplotlib.backends.backend_agg import FigureManagerBase as FigureManager  # noqa: F401
from matplotlib.figure import Figure
from ros2wasm import display


def picture_of(figure: Figure) -> bytes:
    """A PNG, cropped to the drawing."""
    file = io.BytesIO()
    figure.savefig(file, format='png', bbox_inches='tight')
    return file.getvalue()


def show(*, block: bool | None = None, close: bool = True) -> None:
    """Show all figures below the cell, and close them."""
    managers = Gcf.get_all_fig_managers()
    try:
        for manager in managers:
            figure = manager.canvas.figure
            if figure.get_axes() or figure.get_children()[1:]:
                display.display({'image/png': picture_of(figure), 'text/plain': repr(figure)}, raw=True)
    finally:
        if close and managers:
            Gcf.destroy_all()


def _form_of(figure: Any) -> bytes:
    return picture_of(figure)


# Displays a figure that is the value of a cell.
setattr(Figure, '_repr_png_', _form_of)
if show not in display.after_cell:
    display.after_cell.append(show)
