"""A point in time."""
from __future__ import annotations

from typing import Any, overload

from rclpy.clock_type import ClockType
from rclpy.constants import S_TO_NS
from rclpy.duration import Duration
from rclpy.impl.elsewhere import names_of

__getattr__ = names_of(__name__, {'typing': 'Tuple Union'})

LARGEST = 2 ** 63
CONVERSION_CONSTANT = S_TO_NS  # its older name


class Time:
    """Nanoseconds since the zero of one kind of clock."""

    def __init__(
        self, *, seconds: int | float = 0, nanoseconds: int | float = 0, clock_type: ClockType = ClockType.SYSTEM_TIME
    ) -> None:
        if not isinstance(clock_type, ClockType):
            raise TypeError('Clock type must be a ClockType enum')
        if seconds < 0:
            raise ValueError('Seconds value must not be negative')
        if nanoseconds < 0:
            raise ValueError('Nanoseconds value must not be negative')
        total = int(seconds * S_TO_NS) + int(nanoseconds)
        if total >= LARGEST:
            raise OverflowError('Total nanoseconds value is too large to store in C time point.')
        self._nanoseconds = total
        self._clock_type = clock_type

    @property
    def nanoseconds(self) -> int:
        return self._nanoseconds

    def seconds_nanoseconds(self) -> tuple[int, int]:
        return self._nanoseconds // S_TO_NS, self._nanoseconds % S_TO_NS

    @property
    def clock_type(self) -> ClockType:
        return self._clock_type

    def __repr__(self) -> str:
        return f'Time(nanoseconds={self.nanoseconds}, clock_type={self.clock_type.name})'

    def __add__(self, other: object) -> Time:
        if isinstance(other, Duration):
            try:
                return Time(nanoseconds=self.nanoseconds + other.nanoseconds, clock_type=self.clock_type)
            except OverflowError as e:
                raise OverflowError('Addition leads to overflow in C storage.') from e
        return NotImplemented

    def __radd__(self, other: object) -> Time:
        return self.__add__(other)

    @overload
    def __sub__(self, other: Time) -> Duration: ...

    @overload
    def __sub__(self, other: Duration) -> Time: ...

    def __sub__(self, other: Time | Duration) -> Time | Duration:
        if isinstance(other, Time):
            if self.clock_type != other.clock_type:
                raise TypeError("Can't subtract times with different clock types")
            return Duration(nanoseconds=self.nanoseconds - other.nanoseconds)
        if isinstance(other, Duration):
            try:
                return Time(nanoseconds=self.nanoseconds - other.nanoseconds, clock_type=self.clock_type)
            except ValueError as e:
                raise ValueError('Subtraction leads to negative time') from e
        return NotImplemented

    def _comparable(self, other: object) -> bool:
        if not isinstance(other, Time):
            return False
        if self.clock_type != other.clock_type:
            raise TypeError("Can't compare times with different clock types")
        return True

    def __eq__(self, other: object) -> bool:
        if not self._comparable(other):
            return NotImplemented
        assert isinstance(other, Time)
        return self.nanoseconds == other.nanoseconds

    def __ne__(self, other: object) -> bool:
        if not isinstance(other, Time):
            return NotImplemented
        return not self == other

    def __lt__(self, other: Time) -> bool:
        if not self._comparable(other):
            return NotImplemented
        return self.nanoseconds < other.nanoseconds

    def __le__(self, other: Time) -> bool:
        if not self._comparable(other):
            return NotImplemented
        return self.nanoseconds <= other.nanoseconds

    def __gt__(self, other: Time) -> bool:
        if not self._comparable(other):
            return NotImplemented
        return self.nanoseconds > other.nanoseconds

    def __ge__(self, other: Time) -> bool:
        if not self._comparable(other):
            return NotImplemented
        return self.nanoseconds >= other.nanoseconds

    def __hash__(self) -> int:
        return hash((self._nanoseconds, self._clock_type))

    def to_msg(self) -> Any:
        from builtin_interfaces.msg import Time as TimeMsg
        seconds, nanoseconds = self.seconds_nanoseconds()
        return TimeMsg(sec=seconds, nanosec=nanoseconds)

    @classmethod
    def from_msg(cls, msg: Any, clock_type: ClockType = ClockType.ROS_TIME) -> Time:
        from builtin_interfaces.msg import Time as TimeMsg
        if not isinstance(msg, TimeMsg):
            raise TypeError('Must pass a builtin_interfaces.msg.Time object')
        return cls(seconds=msg.sec, nanoseconds=msg.nanosec, clock_type=clock_type)
