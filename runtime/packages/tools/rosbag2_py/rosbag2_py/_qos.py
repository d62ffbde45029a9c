"""QoS of publishers, as bags keep it: in words since version 9, in numbers before."""
from __future__ import annotations

from enum import IntEnum
from typing import Any

from rclpy.duration import Duration as RclpyDuration
from rclpy.qos import QoSProfile
from ros2wasm.yaml import YamlError, parse

S_TO_NS = 1_000_000_000
#: What ROS 2 writes for no limit, and what implementations of Foxy wrote.
ENDLESS = (9_223_372_036, 854_775_807)
FOXY_ENDLESS = (ENDLESS, (0x7FFFFFFF, 0xFFFFFFFF), (0x7FFFFFFF, 0x7FFFFFFF))


class rmw_qos_history_policy_t(IntEnum):
    RMW_QOS_POLICY_HISTORY_SYSTEM_DEFAULT = 0
    RMW_QOS_POLICY_HISTORY_KEEP_LAST = 1
    RMW_QOS_POLICY_HISTORY_KEEP_ALL = 2
    RMW_QOS_POLICY_HISTORY_UNKNOWN = 3


class rmw_qos_reliability_policy_t(IntEnum):
    RMW_QOS_POLICY_RELIABILITY_SYSTEM_DEFAULT = 0
    RMW_QOS_POLICY_RELIABILITY_RELIABLE = 1
    RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT = 2
    RMW_QOS_POLICY_RELIABILITY_UNKNOWN = 3


class rmw_qos_durability_policy_t(IntEnum):
    RMW_QOS_POLICY_DURABILITY_SYSTEM_DEFAULT = 0
    RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL = 1
    RMW_QOS_POLICY_DURABILITY_VOLATILE = 2
    RMW_QOS_POLICY_DURABILITY_UNKNOWN = 3


class rmw_qos_liveliness_policy_t(IntEnum):
    RMW_QOS_POLICY_LIVELINESS_SYSTEM_DEFAULT = 0
    RMW_QOS_POLICY_LIVELINESS_AUTOMATIC = 1
    RMW_QOS_POLICY_LIVELINESS_MANUAL_BY_TOPIC = 3
    RMW_QOS_POLICY_LIVELINESS_UNKNOWN = 4


#: Field of a profile -> its policies.
POLICIES: dict[str, type[IntEnum]] = {
    'history': rmw_qos_history_policy_t, 'reliability': rmw_qos_reliability_policy_t,
    'durability': rmw_qos_durability_policy_t, 'liveliness': rmw_qos_liveliness_policy_t,
}


def word_of(policy: IntEnum) -> str:
    """`keep_last` for RMW_QOS_POLICY_HISTORY_KEEP_LAST."""
    return policy.name.split('_', 4)[4].lower()


class Duration:
    def __init__(self, seconds: int, nanoseconds: int) -> None:
        self.seconds, self.nanoseconds = seconds, nanoseconds


class QoS:
    """A profile: each method sets one policy, and gives the profile."""

    def __init__(self, history_depth: int) -> None:
        self._depth = history_depth
        self._policies: dict[str, int] = {
            'history': rmw_qos_history_policy_t.RMW_QOS_POLICY_HISTORY_KEEP_LAST,
            'reliability': rmw_qos_reliability_policy_t.RMW_QOS_POLICY_RELIABILITY_RELIABLE,
            'durability': rmw_qos_durability_policy_t.RMW_QOS_POLICY_DURABILITY_VOLATILE,
            'liveliness': rmw_qos_liveliness_policy_t.RMW_QOS_POLICY_LIVELINESS_SYSTEM_DEFAULT,
        }
        self._times = {'deadline': (0, 0), 'lifespan': (0, 0), 'liveliness_lease_duration': (0, 0)}
        self._avoid = False

    def _policy(self, name: str, value: int) -> QoS:
        self._policies[name] = value
        return self

    def _time(self, name: str, value: Duration) -> QoS:
        self._times[name] = (value.seconds, value.nanoseconds)
        return self

    def keep_last(self, depth: int) -> QoS:
        self._depth = depth
        return self.history(rmw_qos_history_policy_t.RMW_QOS_POLICY_HISTORY_KEEP_LAST)

    def keep_all(self) -> QoS:
        self._depth = 0
        return self.history(rmw_qos_history_policy_t.RMW_QOS_POLICY_HISTORY_KEEP_ALL)

    def history(self, policy: rmw_qos_history_policy_t) -> QoS:
        return self._policy('history', policy)

    def reliable(self) -> QoS:
        return self.reliability(rmw_qos_reliability_policy_t.RMW_QOS_POLICY_RELIABILITY_RELIABLE)

    def best_effort(self) -> QoS:
        return self.reliability(rmw_qos_reliability_policy_t.RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT)

    def reliability(self, policy: rmw_qos_reliability_policy_t) -> QoS:
        return self._policy('reliability', policy)

    def durability_volatile(self) -> QoS:
        return self.durability(rmw_qos_durability_policy_t.RMW_QOS_POLICY_DURABILITY_VOLATILE)

    def transient_local(self) -> QoS:
        return self.durability(rmw_qos_durability_policy_t.RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL)

    def durability(self, policy: rmw_qos_durability_policy_t) -> QoS:
        return self._policy('durability', policy)

    def liveliness(self, policy: rmw_qos_liveliness_policy_t) -> QoS:
        return self._policy('liveliness', policy)

    def deadline(self, duration: Duration) -> QoS:
        return self._time('deadline', duration)

    def lifespan(self, duration: Duration) -> QoS:
        return self._time('lifespan', duration)

    def liveliness_lease_duration(self, duration: Duration) -> QoS:
        return self._time('liveliness_lease_duration', duration)

    def avoid_ros_namespace_conventions(self, avoids: bool) -> QoS:
        self._avoid = avoids
        return self


def profile_lines(qos: QoS, indent: str) -> list[str]:
    """YAML, in words."""
    def policy(name: str) -> str:
        return f'{indent}{name}: {word_of(POLICIES[name](qos._policies[name]))}'

    def time(name: str) -> list[str]:
        seconds, nanoseconds = qos._times[name]
        return [f'{indent}{name}:', f'{indent}  sec: {seconds}', f'{indent}  nsec: {nanoseconds}']
    return [
        policy('history'), f'{indent}depth: {qos._depth}', policy('reliability'), policy('durability'),
        *time('deadline'), *time('lifespan'), policy('liveliness'), *time('liveliness_lease_duration'),
        f'{indent}avoid_ros_namespace_conventions: {str(qos._avoid).lower()}',
    ]


def profiles_yaml(profiles: list[QoS], indent: str = '') -> str:
    """Lines without the last one's end; `[]` for none."""
    lines = []
    for one in profiles:
        first, *rest = profile_lines(one, indent + '  ')
        lines += [f'{indent}- {first.strip()}', *rest]
    return '\n'.join(lines) if lines else '[]'


def read_policy(name: str, value: Any) -> int:
    if isinstance(value, int):
        return POLICIES[name](value)
    for policy in POLICIES[name]:
        if word_of(policy) == value:
            return policy
    return list(POLICIES[name])[-1]


def read_time(node: Any) -> tuple[int, int]:
    time = int(node['sec']), int(node['nsec'])
    is_endless = time in FOXY_ENDLESS or time[0] * S_TO_NS + time[1] >= (1 << 63) - 1
    return ENDLESS if is_endless else time


def read_profiles(nodes: Any) -> list[QoS]:
    """ValueError, KeyError or TypeError: they are none."""
    profiles = []
    if not isinstance(nodes, list):
        raise ValueError('QoS profiles are no list')
    for node in nodes:
        qos = QoS(int(node['depth']))
        qos._policies = {name: read_policy(name, node[name]) for name in POLICIES}
        qos._times = {name: read_time(node[name]) for name in qos._times}
        qos._avoid = bool(node['avoid_ros_namespace_conventions'])
        profiles.append(qos)
    return profiles


def to_rclcpp_qos_vector(serialized: str, version: int) -> list[QoS]:
    """The profiles that a text in YAML has."""
    try:
        return read_profiles(parse(serialized)) if serialized else []
    except (YamlError, ValueError, KeyError, TypeError) as error:
        raise RuntimeError(f'bad conversion: {error}') from error


def convert_rclcpp_qos_to_rclpy_qos(qos: QoS) -> QoSProfile:
    """As rclpy has it."""
    times = {name: RclpyDuration(seconds=seconds, nanoseconds=nanoseconds)
             for name, (seconds, nanoseconds) in qos._times.items()}
    return QoSProfile(
        depth=qos._depth, **qos._policies, **times, avoid_ros_namespace_conventions=qos._avoid)
