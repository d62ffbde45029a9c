"""Several filters as one."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from message_filters.simple_filter import SimpleFilter


@dataclass
class Link:
    """A filter of a chain, and the connection that leads out of it."""

    message_filter: Any
    connection: int


class Chain(SimpleFilter):
    """What comes in passes all filters, in the order in which they were added."""

    def __init__(self, message_filter: SimpleFilter | None = None) -> None:
        super().__init__()
        self.incoming_connection: int | None = None
        self._links: list[Link] = []
        if message_filter is not None:
            self.connectInput(message_filter)

    def connectInput(self, message_filter: SimpleFilter) -> None:
        if self.incoming_connection is not None:
            raise RuntimeError('Already connected')
        self.incoming_connection = message_filter.registerCallback(self.add)

    def add(self, message: Any) -> None:
        if self._links:
            self._links[0].message_filter.add(message)
        else:
            self.signalMessage(message)

    def addFilter(self, message_filter: Any) -> None:
        if self._links:
            last = self._links[-1]
            last.message_filter.callbacks.pop(last.connection)
            last.connection = last.message_filter.registerCallback(message_filter.add)
        self._links.append(Link(message_filter, message_filter.registerCallback(self.signalMessage)))

    def getFilter(self, index: int) -> Any:
        return self._links[index].message_filter
