"""Converts key names of browsers to those of matplotlib."""
from __future__ import annotations

from collections.abc import Sequence

NAMES = {
    'Alt': 'alt', 'AltGraph': 'alt', 'ArrowDown': 'down', 'ArrowLeft': 'left', 'ArrowRight': 'right', 'ArrowUp': 'up',
    'Backspace': 'backspace', 'CapsLock': 'caps_lock', 'Control': 'control', 'Delete': 'delete', 'End': 'end',
    'Enter': 'enter', 'Escape': 'escape', 'Home': 'home', 'Insert': 'insert', 'Meta': 'super', 'PageDown': 'pagedown',
    'PageUp': 'pageup', 'Shift': 'shift', 'Tab': 'tab', **{f'F{number}': f'f{number}' for number in range(1, 13)},
}
#: In the order of matplotlib's key names.
MODIFIERS = ('ctrl', 'alt', 'shift', 'super')
#: A modifier key is not prefixed with itself.
ITSELF = {'control': 'ctrl', 'alt': 'alt', 'shift': 'shift', 'super': 'super'}


def key_name(key: str, modifiers: Sequence[str]) -> str | None:
    """Returns None for keys that matplotlib does not know."""
    name = key if len(key) == 1 else NAMES.get(key)
    if name is None:
        return None
    # Shift already changes a letter or sign.
    held = [one for one in MODIFIERS if one in modifiers and not (one == 'shift' and len(name) == 1)]
    return '+'.join([one for one in held if one != ITSELF.get(name)] + [name])
