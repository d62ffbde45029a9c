"""How the transforms of one frame are kept, found and interpolated. Times are nanoseconds; 0 asks for the latest."""
from __future__ import annotations

from bisect import bisect_left, bisect_right
from typing import NamedTuple

from tf2_py.exceptions import ExtrapolationException
from tf2_py.transform import Transform, between, slerp


NS = 1_000_000_000


class Entry(NamedTuple):
    """Where a frame stood in its parent at a time."""

    stamp: int
    transform: Transform
    parent: str


def seconds_text(stamp: int) -> str:
    """A time as messages show it."""
    return f'{stamp // NS + 1e-9 * (stamp % NS):.6f}'


class TimeCache:
    """Of a frame that moves."""

    def __init__(self, length: int) -> None:
        self._length = length
        # The oldest first. Of those of one time the last one came last.
        self._entries: list[Entry] = []
        self._stamps: list[int] = []

    def __len__(self) -> int:
        return len(self._entries)

    @property
    def latest(self) -> int:
        return self._stamps[-1] if self._stamps else 0

    @property
    def oldest(self) -> int:
        return self._stamps[0] if self._stamps else 0

    @property
    def latest_parent(self) -> str | None:
        return self._entries[-1].parent if self._entries else None

    def clear(self) -> None:
        self._entries.clear()
        self._stamps.clear()

    def insert(self, entry: Entry) -> bool:
        """False: it is older than what is kept."""
        oldest_kept = self.latest - self._length
        outdated = bisect_left(self._stamps, oldest_kept)
        del self._entries[:outdated], self._stamps[:outdated]
        if self._entries and entry.stamp < oldest_kept:
            return False
        first = bisect_left(self._stamps, entry.stamp)
        end = bisect_right(self._stamps, entry.stamp)
        if entry not in self._entries[first:end]:
            self._entries.insert(end, entry)
            self._stamps.insert(end, entry.stamp)
        return True

    def find(self, time: int) -> Entry:
        """At a time. Raises ExtrapolationException, without a text when there is nothing at all."""
        if not self._entries:
            raise ExtrapolationException()
        if time in (0, self.latest):
            return self._entries[-1]
        if len(self._entries) == 1:
            raise ExtrapolationException(
                f'Lookup would require extrapolation at time {seconds_text(time)}, but only time '
                f'{seconds_text(self.latest)} is in the buffer')
        for is_outside, where, which, end in (
                (time > self.latest, 'future', 'latest', self.latest),
                (time < self.oldest, 'past', 'earliest', self.oldest)):
            if is_outside:
                raise ExtrapolationException(
                    f'Lookup would require extrapolation into the {where}.  Requested time {seconds_text(time)} but '
                    f'the {which} data is at time {seconds_text(end)}')
        at = bisect_right(self._stamps, time)
        older, newer = self._entries[at - 1], self._entries[at]
        # Between two parents nothing can be interpolated: the older one still holds.
        if older.stamp == time or older.parent != newer.parent:
            return older
        ratio = (time - older.stamp) / (newer.stamp - older.stamp)
        return Entry(time, Transform(
            between(older.transform.shift, newer.transform.shift, ratio),
            slerp(older.transform.turn, newer.transform.turn, ratio)), older.parent)


class StaticCache:
    """Of a frame that stands still. It has no time, so that it never holds back the latest time of others."""

    latest = oldest = 0

    #: There from the first insert on, which comes as soon as it is made.
    _entry: Entry

    def __len__(self) -> int:
        return 1

    @property
    def latest_parent(self) -> str:
        return self._entry.parent

    def clear(self) -> None:
        """What stands still is not told again, and kept."""

    def insert(self, entry: Entry) -> bool:
        self._entry = entry
        return True

    def find(self, time: int) -> Entry:
        return self._entry
