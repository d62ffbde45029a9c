"""The viewer of Pillow: Image.show() opens a panel with the picture."""
from __future__ import annotations

from typing import Any

from PIL import ImageShow
from ros2wasm_figures.surface import Surface, desk

#: Later pictures reuse the panels of the first ones.
MOST_PICTURES = 10


class PanelViewer(ImageShow.Viewer):
    """Opens a panel for each call of show(), numbered."""

    def __init__(self) -> None:
        self.surfaces: list[Surface] = []
        self.count = 0

    def show(self, image: Any, **options: Any) -> int:
        at = self.count % MOST_PICTURES
        self.count += 1
        if at == len(self.surfaces):
            self.surfaces.append(desk.open(f'picture_{at + 1}'))
        surface = self.surfaces[at]
        rgba = image.convert('RGBA')
        surface.tell(title=str(options.get('title') or f'Picture {at + 1}'), tools=False)
        surface.show(rgba.tobytes(), rgba.width, rgba.height)
        surface.wait_for_panel()
        return 1


def register() -> None:
    ImageShow.register(PanelViewer, 0)
