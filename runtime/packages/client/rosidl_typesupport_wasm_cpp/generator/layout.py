"""What the wire form of a type looks like: its fewest bytes, and whether memory equals wire form."""

from dataclasses import dataclass
from typing import Any, Dict

import type_description as td

# type number -> bytes in CDR
SIZES = {2: 1, 3: 1, 4: 2, 5: 2, 6: 4, 7: 4, 8: 8, 9: 8, 10: 4, 11: 8, 13: 1, 15: 1, 16: 1}
BOOLEAN = 15


@dataclass(frozen=True)
class Layout:
    """Sizes in bytes. `plain_alignment` is 0 for a type that cannot be copied as it lies."""

    minimum_size: int
    plain_size: int
    plain_alignment: int


def container_of(type_id: int) -> int:
    """Return ARRAY, BOUNDED_SEQUENCE, UNBOUNDED_SEQUENCE, or 0."""
    return type_id // 48 * 48


class LayoutTable:
    """Layouts of message types, computed when asked for."""

    def __init__(self, types: td.TypeTable) -> None:
        self._types = types
        self._known: Dict[str, Layout] = {}

    def of(self, name: str) -> Layout:
        if name not in self._known:
            self._known[name] = self._compute(self._types[name])
        return self._known[name]

    def _compute(self, description: td.Description) -> Layout:
        minimum, size, alignment, plain = 0, 0, 0, True
        for field in description['fields']:
            part = self._field(field['type'])
            minimum += part.minimum_size
            if part.plain_alignment == 0:
                plain = False
                continue
            # The first member has the largest alignment and no member needs padding: then C++ and
            # CDR agree on every offset, wherever the value begins.
            if alignment == 0:
                alignment = part.plain_alignment
            if part.plain_alignment > alignment or size % part.plain_alignment != 0:
                plain = False
            size += part.plain_size
        if not plain or alignment == 0 or size % alignment != 0:
            return Layout(max(minimum, 1), 0, 0)
        return Layout(minimum, size, alignment)

    def _field(self, type_: Dict[str, Any]) -> Layout:
        container = container_of(type_['type_id'])
        if container in (td.BOUNDED_SEQUENCE, td.UNBOUNDED_SEQUENCE):
            return Layout(4, 0, 0)
        element_id = type_['type_id'] - container
        if element_id == td.NESTED_TYPE:
            one = self.of(type_['nested_type_name'])
        elif element_id in SIZES:
            size = SIZES[element_id]
            one = Layout(size, size, 0 if element_id == BOOLEAN else size)
        else:
            one = Layout(4, 0, 0)  # strings
        count = type_['capacity'] if container == td.ARRAY else 1
        return Layout(one.minimum_size * count, one.plain_size * count, one.plain_alignment)
