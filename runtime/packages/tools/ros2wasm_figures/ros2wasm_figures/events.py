"""Reads the events of a panel. Any program can publish on its topic, so that invalid events are ignored."""
from __future__ import annotations

import math
from typing import Any, NamedTuple

#: Pixels; coordinates are limited to this distance from the corner.
FARTHEST = 1e5
#: Limits of the sides of a figure, in pixels.
SMALLEST, LARGEST = 50, 4096
MOST_STEPS = 100
MOST_BUTTON = 8
MOST_NAME = 20


class PanelEvent(NamedTuple):
    #: mouse, key, tool, size or close.
    what: str
    #: press, release and others for mouse and key events; the name of a tool.
    kind: str = ''
    #: Pixels from the upper left corner, or width and height.
    x: float = 0
    y: float = 0
    button: int = 0
    is_double: bool = False
    step: float = 0
    key: str = ''
    modifiers: tuple[str, ...] = ()


def _number(value: Any, least: float, most: float) -> float:
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value):
        raise ValueError
    return max(least, min(value, most))


def _word(value: Any) -> str:
    if not isinstance(value, str) or not 0 < len(value) <= MOST_NAME:
        raise ValueError
    return value


def _held(event: dict[str, Any]) -> tuple[str, ...]:
    held = event.get('modifiers', ())
    if not isinstance(held, list):
        return ()
    return tuple(one for one in ('ctrl', 'alt', 'shift', 'super') if one in held)


def read_event(event: dict[str, Any]) -> PanelEvent | None:
    """Returns None if the event is not valid."""
    try:
        if 'mouse' in event:
            return PanelEvent(
                'mouse', _word(event['mouse']), _number(event['x'], -FARTHEST, FARTHEST),
                _number(event['y'], -FARTHEST, FARTHEST), int(_number(event.get('button', 0), 0, MOST_BUTTON)),
                event.get('double') is True, _number(event.get('step', 0), -MOST_STEPS, MOST_STEPS),
                modifiers=_held(event))
        if 'key' in event:
            return PanelEvent('key', _word(event['key']), key=_word(event['name']), modifiers=_held(event))
        if 'tool' in event:
            return PanelEvent('tool', _word(event['tool']))
        if 'size' in event:
            width, height = event['size']
            return PanelEvent(
                'size', x=round(_number(width, SMALLEST, LARGEST)), y=round(_number(height, SMALLEST, LARGEST)))
        return PanelEvent('close') if event.get('close') is True else None
    except (KeyError, TypeError, ValueError):
        return None
