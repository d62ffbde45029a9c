"""Qualities of service."""
from __future__ import annotations

import warnings
from enum import Enum, IntEnum
from typing import Any

from rclpy.duration import Duration
from rclpy.impl.elsewhere import names_of
from ros2wasm.graph_snapshot import Qos

__getattr__ = names_of(__name__, {'typing': 'Union'})


class QoSPolicyKind(IntEnum):
    """Which policy."""

    INVALID = 1 << 0
    DURABILITY = 1 << 1
    DEADLINE = 1 << 2
    LIVELINESS = 1 << 3
    RELIABILITY = 1 << 4
    HISTORY = 1 << 5
    LIFESPAN = 1 << 6
    DEPTH = 1 << 7
    LIVELINESS_LEASE_DURATION = 1 << 8
    AVOID_ROS_NAMESPACE_CONVENTIONS = 1 << 9


def qos_policy_name_from_kind(policy_kind: QoSPolicyKind | int) -> str:
    """DURABILITY and the like."""
    return QoSPolicyKind(policy_kind).name


class InvalidQoSProfileException(Exception):
    """Policies that do not go together."""

    def __init__(self, *args: object) -> None:
        super().__init__('Invalid QoSProfile', *args)


class QoSPolicyEnum(IntEnum):
    """What the enumerations of policies share; the numbers are those of rmw."""

    @classmethod
    def short_keys(cls) -> list[str]:
        return [name.lower() for name in cls.__members__ if not name.startswith('RMW')]

    @classmethod
    def get_from_short_key(cls, name: str) -> int:
        return cls[name.upper()].value

    @property
    def short_key(self) -> str:
        for name, member in type(self).__members__.items():
            if member is self:
                return name.lower()
        raise AttributeError('failed to find value {self} in {enum}')


class HistoryPolicy(QoSPolicyEnum):
    """How many samples are kept."""

    SYSTEM_DEFAULT = 0
    KEEP_LAST = 1
    KEEP_ALL = 2
    UNKNOWN = 3


class ReliabilityPolicy(QoSPolicyEnum):
    """Whether samples may be lost."""

    SYSTEM_DEFAULT = 0
    RELIABLE = 1
    BEST_EFFORT = 2
    UNKNOWN = 3
    BEST_AVAILABLE = 4


class DurabilityPolicy(QoSPolicyEnum):
    """Whether those who come later get samples."""

    SYSTEM_DEFAULT = 0
    TRANSIENT_LOCAL = 1
    VOLATILE = 2
    UNKNOWN = 3
    BEST_AVAILABLE = 4


class LivelinessPolicy(QoSPolicyEnum):
    """How a publisher is known to be alive."""

    SYSTEM_DEFAULT = 0
    AUTOMATIC = 1
    MANUAL_BY_TOPIC = 3
    UNKNOWN = 4
    BEST_AVAILABLE = 5


# Names by which they are known too.
QoSHistoryPolicy = HistoryPolicy
QoSReliabilityPolicy = ReliabilityPolicy
QoSDurabilityPolicy = DurabilityPolicy
QoSLivelinessPolicy = LivelinessPolicy

#: In place of a Duration: what the others have.
BEST_AVAILABLE_NS = 9223372036854775806
DeadlineBestAvailable = Duration(nanoseconds=BEST_AVAILABLE_NS)
LivelinessLeaseDurationeBestAvailable = Duration(nanoseconds=BEST_AVAILABLE_NS)  # as upstream spells it


class QoSProfile:
    """A value for each policy."""

    __slots__ = [
        '_history', '_depth', '_reliability', '_durability', '_lifespan', '_deadline', '_liveliness',
        '_liveliness_lease_duration', '_avoid_ros_namespace_conventions',
    ]

    def __init__(self, **kwargs: Any) -> None:
        assert all('_' + key in self.__slots__ for key in kwargs), \
            f'Invalid arguments passed to constructor: {sorted(kwargs)}'
        if 'history' not in kwargs:
            if 'depth' not in kwargs:
                raise InvalidQoSProfileException('History and/or depth settings are required.')
            kwargs['history'] = HistoryPolicy.KEEP_LAST
        self.history = kwargs['history']
        if self.history == HistoryPolicy.KEEP_LAST:
            if 'depth' not in kwargs:
                raise InvalidQoSProfileException('History set to KEEP_LAST without a depth setting.')
            if kwargs['depth'] == 0:
                warnings.warn("A zero depth with KEEP_LAST doesn't make sense; no data could be stored. "
                              'This will be interpreted as SYSTEM_DEFAULT', stacklevel=2)
        self.depth = kwargs.get('depth', 0)
        self.reliability = kwargs.get('reliability', ReliabilityPolicy.RELIABLE)
        self.durability = kwargs.get('durability', DurabilityPolicy.VOLATILE)
        self.lifespan = kwargs.get('lifespan', Duration())
        self.deadline = kwargs.get('deadline', Duration())
        self.liveliness = kwargs.get('liveliness', LivelinessPolicy.SYSTEM_DEFAULT)
        self.liveliness_lease_duration = kwargs.get('liveliness_lease_duration', Duration())
        self.avoid_ros_namespace_conventions = kwargs.get('avoid_ros_namespace_conventions', False)

    @property
    def history(self) -> HistoryPolicy:
        return self._history

    @history.setter
    def history(self, value: HistoryPolicy | int) -> None:
        assert isinstance(value, (HistoryPolicy, int))
        self._history = HistoryPolicy(value)

    @property
    def reliability(self) -> ReliabilityPolicy:
        return self._reliability

    @reliability.setter
    def reliability(self, value: ReliabilityPolicy | int) -> None:
        assert isinstance(value, (ReliabilityPolicy, int))
        self._reliability = ReliabilityPolicy(value)

    @property
    def durability(self) -> DurabilityPolicy:
        return self._durability

    @durability.setter
    def durability(self, value: DurabilityPolicy | int) -> None:
        assert isinstance(value, (DurabilityPolicy, int))
        self._durability = DurabilityPolicy(value)

    @property
    def depth(self) -> int:
        return self._depth

    @depth.setter
    def depth(self, value: int) -> None:
        assert isinstance(value, int)
        if value < 0:
            raise ValueError('Depth must be greater than or equal to zero')
        self._depth = value

    @property
    def lifespan(self) -> Duration:
        return self._lifespan

    @lifespan.setter
    def lifespan(self, value: Duration) -> None:
        assert isinstance(value, Duration)
        self._lifespan = value

    @property
    def deadline(self) -> Duration:
        return self._deadline

    @deadline.setter
    def deadline(self, value: Duration) -> None:
        assert isinstance(value, Duration)
        self._deadline = value

    @property
    def liveliness(self) -> LivelinessPolicy:
        return self._liveliness

    @liveliness.setter
    def liveliness(self, value: LivelinessPolicy | int) -> None:
        assert isinstance(value, (LivelinessPolicy, int))
        self._liveliness = LivelinessPolicy(value)

    @property
    def liveliness_lease_duration(self) -> Duration:
        return self._liveliness_lease_duration

    @liveliness_lease_duration.setter
    def liveliness_lease_duration(self, value: Duration) -> None:
        assert isinstance(value, Duration)
        self._liveliness_lease_duration = value

    @property
    def avoid_ros_namespace_conventions(self) -> bool:
        return self._avoid_ros_namespace_conventions

    @avoid_ros_namespace_conventions.setter
    def avoid_ros_namespace_conventions(self, value: bool) -> None:
        assert isinstance(value, bool)
        self._avoid_ros_namespace_conventions = value

    def get_c_qos_profile(self) -> QoSProfile:
        return self

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, QoSProfile):
            return False
        return all(getattr(self, slot) == getattr(other, slot) for slot in QoSProfile.__slots__)

    __hash__ = None  # type: ignore[assignment]

    def __str__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{slot[1:]}={getattr(self, slot)}' for slot in self.__slots__)})"


class QoSPresetProfiles(Enum):
    """The profiles of ROS 2, by name."""

    UNKNOWN = QoSProfile(
        history=HistoryPolicy.UNKNOWN, depth=0, reliability=ReliabilityPolicy.UNKNOWN,
        durability=DurabilityPolicy.UNKNOWN, liveliness=LivelinessPolicy.UNKNOWN)
    DEFAULT = QoSProfile(
        history=HistoryPolicy.KEEP_LAST, depth=10, reliability=ReliabilityPolicy.RELIABLE,
        durability=DurabilityPolicy.VOLATILE)
    SYSTEM_DEFAULT = QoSProfile(
        history=HistoryPolicy.SYSTEM_DEFAULT, depth=0, reliability=ReliabilityPolicy.SYSTEM_DEFAULT,
        durability=DurabilityPolicy.SYSTEM_DEFAULT)
    SENSOR_DATA = QoSProfile(
        history=HistoryPolicy.KEEP_LAST, depth=5, reliability=ReliabilityPolicy.BEST_EFFORT,
        durability=DurabilityPolicy.VOLATILE)
    SERVICES_DEFAULT = QoSProfile(
        history=HistoryPolicy.KEEP_LAST, depth=10, reliability=ReliabilityPolicy.RELIABLE,
        durability=DurabilityPolicy.VOLATILE, avoid_ros_namespace_conventions=False)
    PARAMETERS = QoSProfile(
        history=HistoryPolicy.KEEP_LAST, depth=1000, reliability=ReliabilityPolicy.RELIABLE,
        durability=DurabilityPolicy.VOLATILE, avoid_ros_namespace_conventions=True)
    PARAMETER_EVENTS = QoSProfile(
        history=HistoryPolicy.KEEP_LAST, depth=1000, reliability=ReliabilityPolicy.RELIABLE,
        durability=DurabilityPolicy.VOLATILE, liveliness=LivelinessPolicy.SYSTEM_DEFAULT)
    ACTION_STATUS_DEFAULT = QoSProfile(
        history=HistoryPolicy.KEEP_LAST, depth=1, reliability=ReliabilityPolicy.RELIABLE,
        durability=DurabilityPolicy.TRANSIENT_LOCAL, liveliness=LivelinessPolicy.SYSTEM_DEFAULT)
    BEST_AVAILABLE = QoSProfile(
        history=HistoryPolicy.KEEP_LAST, depth=10, reliability=ReliabilityPolicy.BEST_AVAILABLE,
        durability=DurabilityPolicy.BEST_AVAILABLE, liveliness=LivelinessPolicy.BEST_AVAILABLE,
        deadline=DeadlineBestAvailable, liveliness_lease_duration=LivelinessLeaseDurationeBestAvailable)

    @classmethod
    def short_keys(cls) -> list[str]:
        return [name.lower() for name in cls.__members__]

    @classmethod
    def get_from_short_key(cls, name: str) -> QoSProfile:
        return cls[name.upper()].value


qos_profile_unknown = QoSPresetProfiles.UNKNOWN.value
qos_profile_default = QoSPresetProfiles.DEFAULT.value
qos_profile_system_default = QoSPresetProfiles.SYSTEM_DEFAULT.value
qos_profile_sensor_data = QoSPresetProfiles.SENSOR_DATA.value
qos_profile_services_default = QoSPresetProfiles.SERVICES_DEFAULT.value
qos_profile_parameters = QoSPresetProfiles.PARAMETERS.value
qos_profile_parameter_events = QoSPresetProfiles.PARAMETER_EVENTS.value
qos_profile_action_status_default = QoSPresetProfiles.ACTION_STATUS_DEFAULT.value
qos_profile_best_available = QoSPresetProfiles.BEST_AVAILABLE.value
#: What /rosout has.
qos_profile_rosout_default = QoSProfile(
    depth=1000, durability=DurabilityPolicy.TRANSIENT_LOCAL, lifespan=Duration(seconds=10))


class QoSCompatibility(IntEnum):
    """Whether two profiles work together."""

    OK = 0
    WARNING = 1
    ERROR = 2


def _is_set(duration: Duration) -> bool:
    return 0 < duration.nanoseconds < BEST_AVAILABLE_NS


def qos_check_compatible(publisher_qos: QoSProfile, subscription_qos: QoSProfile) -> tuple[QoSCompatibility, str]:
    """Whether they match, and the reasons why not."""
    errors, doubts = [], []
    offered, wanted = publisher_qos, subscription_qos
    unsure = (ReliabilityPolicy.SYSTEM_DEFAULT, ReliabilityPolicy.UNKNOWN)
    if offered.reliability == ReliabilityPolicy.BEST_EFFORT and wanted.reliability == ReliabilityPolicy.RELIABLE:
        errors.append('ERROR: Best effort publisher and reliable subscription')
    elif offered.reliability in unsure or wanted.reliability in unsure:
        doubts.append('WARNING: Reliability is not known')
    unsure_durability = (DurabilityPolicy.SYSTEM_DEFAULT, DurabilityPolicy.UNKNOWN)
    if offered.durability == DurabilityPolicy.VOLATILE and wanted.durability == DurabilityPolicy.TRANSIENT_LOCAL:
        errors.append('ERROR: Volatile publisher and transient local subscription')
    elif offered.durability in unsure_durability or wanted.durability in unsure_durability:
        doubts.append('WARNING: Durability is not known')
    if _is_set(wanted.deadline) and not _is_set(offered.deadline):
        errors.append('ERROR: Subscription has a deadline, but publisher does not')
    elif _is_set(wanted.deadline) and offered.deadline > wanted.deadline:
        errors.append('ERROR: Subscription deadline is less than publisher deadline')
    if offered.liveliness == LivelinessPolicy.AUTOMATIC and wanted.liveliness == LivelinessPolicy.MANUAL_BY_TOPIC:
        errors.append("ERROR: Publisher's liveliness is automatic and subscription's is manual by topic")
    if _is_set(wanted.liveliness_lease_duration) and not _is_set(offered.liveliness_lease_duration):
        errors.append('ERROR: Subscription has a liveliness lease duration, but publisher does not')
    elif _is_set(wanted.liveliness_lease_duration) and \
            offered.liveliness_lease_duration > wanted.liveliness_lease_duration:
        errors.append("ERROR: Subscription liveliness lease duration is less than publisher's")
    kind = QoSCompatibility.ERROR if errors else QoSCompatibility.WARNING if doubts else QoSCompatibility.OK
    return kind, ''.join(f'{one};' for one in errors + doubts)


def to_bus(profile: QoSProfile) -> Qos:
    """What the bus is told; open policies get their defaults."""
    def time(duration: Duration) -> int:
        return 0 if duration.nanoseconds >= BEST_AVAILABLE_NS else duration.nanoseconds
    keep_all = profile.history == HistoryPolicy.KEEP_ALL
    return Qos(
        reliability=2 if profile.reliability == ReliabilityPolicy.BEST_EFFORT else 1,
        durability=1 if profile.durability == DurabilityPolicy.TRANSIENT_LOCAL else 2,
        history=2 if keep_all else 1,
        depth=profile.depth if keep_all else max(1, profile.depth),
        liveliness=3 if profile.liveliness == LivelinessPolicy.MANUAL_BY_TOPIC else 1,
        deadline_ns=time(profile.deadline),
        lifespan_ns=time(profile.lifespan),
        lease_ns=time(profile.liveliness_lease_duration))


def from_bus(qos: Qos) -> QoSProfile:
    """What the graph says of an endpoint."""
    def time(nanoseconds: int) -> Duration:
        return Duration(nanoseconds=nanoseconds or 2 ** 63 - 1)
    return QoSProfile(
        history=HistoryPolicy(qos.history), depth=qos.depth, reliability=ReliabilityPolicy(qos.reliability),
        durability=DurabilityPolicy(qos.durability), liveliness=LivelinessPolicy(qos.liveliness),
        deadline=time(qos.deadline_ns), lifespan=time(qos.lifespan_ns), liveliness_lease_duration=time(qos.lease_ns))
