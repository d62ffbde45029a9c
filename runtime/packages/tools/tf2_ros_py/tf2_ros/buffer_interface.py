"""What can be asked of a buffer, and how things of any type are taken from one frame to another."""
from __future__ import annotations

from collections.abc import Callable
from copy import deepcopy
from typing import Any

from rclpy.duration import Duration
from rclpy.impl.elsewhere import names_of
from rclpy.time import Time
from std_msgs.msg import Header

__getattr__ = names_of(__name__, {
    'geometry_msgs.msg': 'PointStamped PoseStamped PoseWithCovarianceStamped TransformStamped Vector3Stamped',
    'sensor_msgs.msg': 'PointCloud2',
    'typing': 'Optional Tuple TypeVar Union',
})


class TypeException(Exception):
    """Nobody said how a type is transformed or converted."""

    def __init__(self, errstr: str) -> None:
        super().__init__(errstr)
        self.errstr = errstr


class NotImplementedException(Exception):
    """A buffer lacks what it must have."""

    def __init__(self) -> None:
        self.errstr = 'CanTransform or LookupTransform not implemented'
        super().__init__(self.errstr)


def _registered(table: dict[Any, Callable[..., Any]], key: Any) -> Callable[..., Any]:
    if key not in table:
        raise TypeException(f'Type {key} is not loaded or supported')
    return table[key]


class TransformRegistration:
    """Type -> what transforms its objects. All registrations are the same one."""

    __types: dict[Any, Callable[[Any, Any], Any]] = {}

    def print_me(self) -> None:
        print(self.__types)

    def add(self, key: Any, callback: Callable[[Any, Any], Any]) -> None:
        self.__types[key] = callback

    def get(self, key: Any) -> Callable[[Any, Any], Any]:
        return _registered(self.__types, key)


class ConvertRegistration:
    """Type -> what makes a message of its objects, and what makes them of messages."""

    __to_msg: dict[Any, Callable[[Any], Any]] = {}
    __from_msg: dict[Any, Callable[[Any], Any]] = {}
    __convert: dict[Any, Callable[[Any], Any]] = {}

    def add_from_msg(self, key: Any, callback: Callable[[Any], Any]) -> None:
        self.__from_msg[key] = callback

    def add_to_msg(self, key: Any, callback: Callable[[Any], Any]) -> None:
        self.__to_msg[key] = callback

    def add_convert(self, key: tuple[Any, Any], callback: Callable[[Any], Any]) -> None:
        self.__convert[key] = callback

    def get_from_msg(self, key: Any) -> Callable[[Any], Any]:
        return _registered(self.__from_msg, key)

    def get_to_msg(self, key: Any) -> Callable[[Any], Any]:
        return _registered(self.__to_msg, key)

    def get_convert(self, key: tuple[Any, Any]) -> Callable[[Any], Any]:
        return _registered(self.__convert, key)


def convert(a: Any, b_type: Any) -> Any:
    """The object as one of another type: at once where somebody said how, else by way of a message."""
    known = ConvertRegistration()
    try:
        directly = known.get_convert((type(a), b_type))
    except TypeException:
        if type(a) is b_type:
            return deepcopy(a)
        to_msg = known.get_to_msg(type(a))
        return known.get_from_msg(b_type)(to_msg(a))
    return directly(a)


def Stamped(obj: Any, stamp: Any, frame_id: str) -> Any:
    """The object itself, with a header."""
    obj.header = Header(frame_id=frame_id, stamp=stamp)
    return obj


class BufferInterface:
    """What transforms come from."""

    def __init__(self) -> None:
        self.registration = TransformRegistration()

    def transform(
        self, object_stamped: Any, target_frame: str, timeout: Duration = Duration(), new_type: Any = None
    ) -> Any:
        """The object in another frame, at its own time."""
        do_transform = self.registration.get(type(object_stamped))
        header = object_stamped.header
        result = do_transform(
            object_stamped, self.lookup_transform(target_frame, header.frame_id, header.stamp, timeout))
        return result if new_type is None else convert(result, new_type)

    def transform_full(
        self, object_stamped: Any, target_frame: str, target_time: Time, fixed_frame: str,
        timeout: Duration = Duration(), new_type: Any = None
    ) -> Any:
        """The object in another frame, at another time."""
        do_transform = self.registration.get(type(object_stamped))
        header = object_stamped.header
        result = do_transform(object_stamped, self.lookup_transform_full(
            target_frame, target_time, header.frame_id, header.stamp, fixed_frame, timeout))
        return result if new_type is None else convert(result, new_type)

    def lookup_transform(
        self, target_frame: str, source_frame: str, time: Time, timeout: Duration = Duration()
    ) -> Any:
        raise NotImplementedException()

    def lookup_transform_full(
        self, target_frame: str, target_time: Time, source_frame: str, source_time: Time, fixed_frame: str,
        timeout: Duration = Duration()
    ) -> Any:
        raise NotImplementedException()

    def can_transform(
        self, target_frame: str, source_frame: str, time: Time, timeout: Duration = Duration()
    ) -> Any:
        raise NotImplementedException()

    def can_transform_full(
        self, target_frame: str, target_time: Time, source_frame: str, source_time: Time, fixed_frame: str,
        timeout: Duration = Duration()
    ) -> Any:
        raise NotImplementedException()
