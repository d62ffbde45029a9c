"""
The tree of frames over time: takes transforms in, answers where one frame stands in another.

A lookup climbs from both frames to the first that stands above both, and multiplies what it meets on the way.
"""
from __future__ import annotations

import math
import threading
from typing import Any, NamedTuple

import rclpy.logging
from rclpy.time import Time

from tf2_py import frame_views
from tf2_py.conversions import message_of, nanoseconds, transform_of
from tf2_py.exceptions import (
    ConnectivityException, ExtrapolationException, InvalidArgumentException, LookupException, TransformException,
)
from tf2_py.frame_views import Frame
from tf2_py.time_cache import NS, Entry, StaticCache, TimeCache, seconds_text
from tf2_py.transform import (
    IDENTITY, Quaternion, Transform, Vector, cross, dot, minus, plus, scaled, settled, turned,
)

DEFAULT_CACHE_TIME_NS = 10 * NS
LENGTH_TOLERANCE = 10e-3
#: A path that is longer is taken as a loop.
MOST_FRAMES = 1000


class Step(NamedTuple):
    """From a frame to its parent."""

    frame: str
    entry: Entry


class Path(NamedTuple):
    """The way between two frames, up to the first that both have above them."""

    from_source: list[Step]
    from_target: list[Step]
    time: int

    def product(self) -> Transform:
        """Where the source stands in the target."""
        to_top = [IDENTITY, IDENTITY]
        for i, way in enumerate((self.from_source, self.from_target)):
            for step in way:
                to_top[i] = step.entry.transform.after(to_top[i])
        whole = to_top[1].inverse().after(to_top[0])
        return Transform(whole.shift, settled(whole.turn))


def faults(transform: Transform, parent: str, child: str, authority: str) -> list[str]:
    """All that is wrong with a transform."""
    found = []
    if child == parent:
        found.append(f'TF_SELF_TRANSFORM: Ignoring transform from authority "{authority}" with frame_id and  '
                     f'child_frame_id "{child}" because they are the same')
    if not child:
        found.append(f'TF_NO_CHILD_FRAME_ID: Ignoring transform from authority "{authority}" because child_frame_id '
                     'not set ')
    if not parent:
        found.append(f'TF_NO_FRAME_ID: Ignoring transform with child_frame_id "{child}"  from authority "{authority}" '
                     'because frame_id not set')
    turn = '({:f} {:f} {:f} {:f})'.format(*transform.turn)
    if any(math.isnan(one) for one in transform.shift + transform.turn):
        shift = '({:f} {:f} {:f})'.format(*transform.shift)
        found.append(f'TF_NAN_INPUT: Ignoring transform for child_frame_id "{child}" from authority "{authority}" '
                     f'because of a nan value in the transform {shift} {turn}')
    if not abs(dot(transform.turn, transform.turn) - 1) < LENGTH_TOLERANCE:
        found.append(f'TF_DENORMALIZED_QUATERNION: Ignoring transform for child_frame_id "{child}" from authority '
                     f'"{authority}" because of an invalid quaternion in the transform {turn}')
    return found


def check_text(argument: int, value: object) -> None:
    if not isinstance(value, str):
        raise TypeError(f'argument {argument} must be str, not {type(value).__name__}')


class BufferCore:
    """May be used from several threads."""

    def __init__(self, cache_time: Any = None) -> None:
        self._cache_time = DEFAULT_CACHE_TIME_NS if cache_time is None else nanoseconds(cache_time, 'duration')
        self._frames: frame_views.Frames = {}
        self._frames_lock = threading.RLock()

    # ---- taking in

    def clear(self) -> None:
        with self._frames_lock:
            for frame in self._frames.values():
                if frame.cache is not None:
                    frame.cache.clear()

    def set_transform(self, transform: Any, authority: str) -> None:
        self._insert(transform, authority, False)

    def set_transform_static(self, transform: Any, authority: str) -> None:
        self._insert(transform, authority, True)

    def _insert(self, message: Any, authority: str, is_static: bool) -> None:
        check_text(2, authority)
        parent, child = message.header.frame_id.removeprefix('/'), message.child_frame_id.removeprefix('/')
        transform, stamp = transform_of(message), nanoseconds(message.header.stamp, 'time')
        logger = rclpy.logging._root_logger
        wrong = faults(transform, parent, child, authority)
        for fault in wrong:
            logger.error(fault)
        if wrong:
            return
        with self._frames_lock:
            self._frames.setdefault(parent, Frame())
            frame = self._frames.setdefault(child, Frame())
            if frame.cache is None or isinstance(frame.cache, StaticCache) != is_static:
                frame.cache = StaticCache() if is_static else TimeCache(self._cache_time)
            if frame.cache.insert(Entry(stamp, transform, parent)):
                frame.authority = authority
                return
        logger.warning(
            f'TF_OLD_DATA ignoring data from the past for frame {child} at time {seconds_text(stamp)} according to '
            f'authority {authority}\nPossible reasons are listed at http://wiki.ros.org/tf/Errors%20explained')

    # ---- finding

    def _checked(self, argument: str, name: str) -> None:
        text = f'"{name}" passed to {argument}'
        if not name:
            raise InvalidArgumentException(f'Invalid argument {text} - in tf2 frame_ids cannot be empty')
        if name.startswith('/'):
            raise InvalidArgumentException(f"Invalid argument {text} - in tf2 frame_ids cannot start with a '/'")
        if name not in self._frames:
            raise LookupException(f'{text} does not exist. ')

    def _path(self, target: str, source: str, time: int) -> Path:
        """Raises LookupException, ConnectivityException or ExtrapolationException."""
        if time == 0 and source != target:
            time = self._latest_common_time(target, source)
        place = f', when looking up transform from frame [{source}] to frame [{target}]'
        # A frame without data at this time may yet be above the target too.
        missing: ExtrapolationException | None = None
        from_source: list[Step] = []
        index: dict[str, int] = {}
        top = source
        while top != target:
            cache = self._frames[top].cache
            if cache is None:
                break
            try:
                entry = cache.find(time)
            except ExtrapolationException as error:
                missing = error
                break
            index[top] = len(from_source)
            from_source.append(Step(top, entry))
            self._check_length(from_source)
            top = entry.parent
        from_target: list[Step] = []
        frame = target
        while frame != top:
            if frame in index:
                del from_source[index[frame]:]
                break
            cache = self._frames[frame].cache
            if cache is None:
                if missing is None:
                    raise ConnectivityException(frame_views.unconnected_error(target, source))
                raise ExtrapolationException(f'{missing}{place}')
            try:
                entry = cache.find(time)
            except ExtrapolationException as error:
                raise ExtrapolationException(f'{error}{place}') from None
            from_target.append(Step(frame, entry))
            self._check_length(from_target)
            frame = entry.parent
        return Path(from_source, from_target, time)

    def _check_length(self, way: list[Step]) -> None:
        if len(way) > MOST_FRAMES:
            raise LookupException(frame_views.loop_error(self._frames))

    def _latest_common_time(self, target: str, source: str) -> int:
        """The latest time that all frames between two have; 0 when they all stand still."""
        if source == target:
            return self._latest(source)
        from_source, from_target = self._latest_times(source), self._latest_times(target)
        common = next((frame for frame in from_source if frame in from_target), None)
        if common is None:
            if any(self._parent(list(way)[-1]) is not None for way in (from_source, from_target)):
                raise LookupException(frame_views.loop_error(self._frames))
            raise ConnectivityException(frame_views.unconnected_error(target, source))
        times = []
        for way in (from_source, from_target):
            for frame, time in way.items():
                if frame == common:
                    break
                if time:
                    times.append(time)
        return min(times, default=0)

    def _latest_times(self, frame: str) -> dict[str, int]:
        """The frames from one up to the root, or once around, each with its latest time."""
        way: dict[str, int] = {}
        above: str | None = frame
        while above is not None and above not in way:
            way[above] = self._latest(above)
            above = self._parent(above)
        return way

    def _latest(self, frame: str) -> int:
        cache = self._frames[frame].cache
        return cache.latest if cache is not None else 0

    def _parent(self, frame: str) -> str | None:
        cache = self._frames[frame].cache
        return cache.latest_parent if cache is not None else None

    def _find(self, target: str, source: str, time: int) -> tuple[Transform, int]:
        if target == source:
            return IDENTITY, self._latest(target) if time == 0 and target in self._frames else time
        self._checked('lookupTransform argument target_frame', target)
        self._checked('lookupTransform argument source_frame', source)
        path = self._path(target, source, time)
        return path.product(), path.time

    # ---- asking

    def lookup_transform_core(self, target_frame: str, source_frame: str, time: Any) -> Any:
        """Where the source stands in the target. Time zero: the latest common time."""
        check_text(1, target_frame)
        check_text(2, source_frame)
        with self._frames_lock:
            transform, stamp = self._find(target_frame, source_frame, nanoseconds(time, 'time'))
        return message_of(transform, stamp, target_frame, source_frame)

    def lookup_transform_full_core(
        self, target_frame: str, target_time: Any, source_frame: str, source_time: Any, fixed_frame: str
    ) -> Any:
        """Across time, by way of a frame that does not move."""
        for argument, name in ((1, target_frame), (3, source_frame), (5, fixed_frame)):
            check_text(argument, name)
        with self._frames_lock:
            self._checked('lookupTransform argument target_frame', target_frame)
            self._checked('lookupTransform argument source_frame', source_frame)
            self._checked('lookupTransform argument fixed_frame', fixed_frame)
            to_fixed, _ = self._find(fixed_frame, source_frame, nanoseconds(source_time, 'time'))
            from_fixed, stamp = self._find(target_frame, fixed_frame, nanoseconds(target_time, 'time'))
        whole = from_fixed.after(to_fixed)
        return message_of(Transform(whole.shift, settled(whole.turn)), stamp, target_frame, source_frame)

    def _can(self, target: str, source: str, time: int) -> None:
        """Raises TransformException: it cannot."""
        if target != source:
            self._path(target, source, time)

    def _fault_of_name(self, argument: str, name: str) -> str:
        why = ('in tf2 frame_ids cannot be empty' if not name else
               "in tf2 frame_ids cannot start with a '/'" if name.startswith('/') else
               'frame does not exist' if name not in self._frames else '')
        return why and f'Invalid frame ID "{name}" passed to canTransform argument {argument} - {why}'

    def can_transform_core(self, target_frame: str, source_frame: str, time: Any) -> tuple[int, str]:
        """Whether it can, as 1 or 0, and why not."""
        check_text(1, target_frame)
        check_text(2, source_frame)
        at = nanoseconds(time, 'time')
        with self._frames_lock:
            if target_frame == source_frame:
                return 1, ''
            fault = self._fault_of_name('target_frame', target_frame) or \
                self._fault_of_name('source_frame', source_frame)
            if fault:
                return 0, fault
            try:
                self._can(target_frame, source_frame, at)
            except TransformException as error:
                return 0, str(error)
        return 1, ''

    def can_transform_full_core(
        self, target_frame: str, target_time: Any, source_frame: str, source_time: Any, fixed_frame: str
    ) -> tuple[int, str]:
        for argument, name in ((1, target_frame), (3, source_frame), (5, fixed_frame)):
            check_text(argument, name)
        at_target, at_source = nanoseconds(target_time, 'time'), nanoseconds(source_time, 'time')
        with self._frames_lock:
            for what, name in (('target_frame', target_frame), ('source_frame', source_frame),
                               ('fixed_frame', fixed_frame)):
                fault = self._fault_of_name(what, name)
                if fault:
                    return 0, fault
            try:
                self._can(target_frame, fixed_frame, at_target)
                self._can(fixed_frame, source_frame, at_source)
            except TransformException as error:
                return 0, str(error)
        return 1, ''

    def get_latest_common_time(self, target_frame: str, source_frame: str) -> Time:
        check_text(1, target_frame)
        check_text(2, source_frame)
        with self._frames_lock:
            self._checked('get_latest_common_time', target_frame)
            self._checked('get_latest_common_time', source_frame)
            try:
                return Time(nanoseconds=self._latest_common_time(target_frame, source_frame))
            except TransformException as error:
                raise TransformException(str(error)) from None

    # ---- velocities

    def lookupVelocityCore(
        self, tracking_frame: str, observation_frame: str, time: Any, averaging_interval: Any
    ) -> tuple[Vector, Vector]:
        return self.lookupVelocityFullCore(tracking_frame, observation_frame, observation_frame, (0.0, 0.0, 0.0),
                                           tracking_frame, time, averaging_interval)

    def lookupVelocityFullCore(
        self, tracking_frame: str, observation_frame: str, reference_frame: str, reference_point: Vector,
        reference_point_frame: str, time: Any, averaging_interval: Any
    ) -> tuple[Vector, Vector]:
        """Linear and angular velocity of a frame as seen from another one, in a third one, at a point."""
        at, interval = nanoseconds(time, 'time'), nanoseconds(averaging_interval, 'duration') / NS
        with self._frames_lock:
            latest = 0
            if tracking_frame in self._frames and observation_frame in self._frames:
                latest = self._latest_common_time(observation_frame, tracking_frame)
            # Half of the interval on each side, but never after what is known, nor before time began.
            end = min(at / NS + interval / 2, latest / NS)
            start = max(0.00001 + interval, end) - interval
            before, _ = self._find(observation_frame, tracking_frame, round(start * NS))
            after, _ = self._find(observation_frame, tracking_frame, round(end * NS))
            reference, _ = self._find(reference_frame, tracking_frame, at)
            to_reference, _ = self._find(reference_frame, reference_point_frame, at)
        linear = scaled(minus(after.shift, before.shift), 1 / (end - start))
        way = settled(before.inverse().after(after).turn)
        angular = scaled(turned(before.turn, rotation_vector(way)), 1 / (end - start))
        point = to_reference.of_point(reference_point)
        rotation = turned(reference.turn, angular)
        speed = plus(turned(reference.turn, linear), cross(reference.shift, rotation))
        away = minus(point, reference.shift)
        # Number by number and no cross product, as ROS 2 has it.
        return plus(speed, (rotation[0] * away[0], rotation[1] * away[1], rotation[2] * away[2])), rotation

    # ---- views

    def _chain(
        self, target_frame: str, target_time: Any, source_frame: str, source_time: Any, fixed_frame: str
    ) -> list[str]:
        """The frames from the source by way of the fixed one to the target."""
        with self._frames_lock:
            for name in (target_frame, source_frame, fixed_frame):
                self._checked('_chain', name)
            first = self._path(fixed_frame, source_frame, nanoseconds(source_time, 'time'))
            second = self._path(target_frame, fixed_frame, nanoseconds(target_time, 'time'))
        return frames_on(first, source_frame) + frames_on(second, fixed_frame)[1:]

    def all_frames_as_yaml(self) -> str:
        with self._frames_lock:
            return frame_views.as_yaml(self._frames)

    def all_frames_as_string(self) -> str:
        with self._frames_lock:
            return frame_views.as_string(self._frames)

    def _allFramesAsDot(self, time: Any = None) -> str:
        with self._frames_lock:
            return frame_views.as_dot(self._frames, 0 if time is None else nanoseconds(time, 'time'))

    def _frameExists(self, frame_id: str) -> bool:
        with self._frames_lock:
            return frame_id in self._frames

    def _getFrameStrings(self) -> list[str]:
        with self._frames_lock:
            return list(self._frames)


def frames_on(path: Path, source: str) -> list[str]:
    top = path.from_source[-1].entry.parent if path.from_source else source
    return [step.frame for step in path.from_source] + [top] + [step.frame for step in reversed(path.from_target)]


def rotation_vector(turn: Quaternion) -> Vector:
    """Axis times angle."""
    x, y, z, w = turn
    length = math.sqrt(max(0.0, 1 - w * w))
    return scaled((x, y, z), 2 * math.acos(max(-1.0, min(1.0, w))) / length) if length > 1e-10 else (0.0, 0.0, 0.0)
