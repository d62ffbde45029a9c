"""Lets users change the qualities of service of a topic by parameters."""
from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

from rcl_interfaces.msg import ParameterDescriptor, SetParametersResult
from rclpy.duration import Duration
from rclpy.exceptions import ParameterAlreadyDeclaredException
from rclpy.parameter import Parameter
from rclpy.publisher import Publisher
from rclpy.qos import (
    DurabilityPolicy, HistoryPolicy, LivelinessPolicy, QoSPolicyEnum, QoSPolicyKind, QoSProfile, ReliabilityPolicy,
)


class InvalidQosOverridesError(Exception):
    """The callback refuses the profile."""


@dataclass
class QosCallbackResult:
    successful: bool = False
    reason: str = ''


QosCallbackType = Callable[[QoSProfile], Any]


class QoSOverridingOptions:
    """Which policies of an endpoint parameters may change, and who checks the outcome."""

    def __init__(
        self, policy_kinds: Iterable[QoSPolicyKind], *, callback: QosCallbackType | None = None,
        entity_id: str | None = None
    ) -> None:
        self._policy_kinds = tuple(policy_kinds)
        self._callback = callback
        self._entity_id = entity_id

    @property
    def policy_kinds(self) -> tuple[QoSPolicyKind, ...]:
        return self._policy_kinds

    @property
    def callback(self) -> QosCallbackType | None:
        return self._callback

    @property
    def entity_id(self) -> str | None:
        return self._entity_id

    @classmethod
    def with_default_policies(
        cls, *, callback: QosCallbackType | None = None, entity_id: str | None = None
    ) -> QoSOverridingOptions:
        return cls((QoSPolicyKind.HISTORY, QoSPolicyKind.DEPTH, QoSPolicyKind.RELIABILITY), callback=callback,
                   entity_id=entity_id)


_ENUMS: dict[QoSPolicyKind, type[QoSPolicyEnum]] = {
    QoSPolicyKind.HISTORY: HistoryPolicy, QoSPolicyKind.RELIABILITY: ReliabilityPolicy,
    QoSPolicyKind.DURABILITY: DurabilityPolicy, QoSPolicyKind.LIVELINESS: LivelinessPolicy,
}
_DURATIONS = {QoSPolicyKind.DEADLINE, QoSPolicyKind.LIFESPAN, QoSPolicyKind.LIVELINESS_LEASE_DURATION}


def _to_parameter(kind: QoSPolicyKind, qos: QoSProfile) -> Any:
    value = getattr(qos, kind.name.lower())
    if kind in _ENUMS:
        return value.short_key
    return value.nanoseconds if kind in _DURATIONS else value


def _apply(kind: QoSPolicyKind, value: Any, qos: QoSProfile) -> None:
    if kind in _ENUMS:
        value = _ENUMS[kind].get_from_short_key(value)
    elif kind in _DURATIONS:
        value = Duration(nanoseconds=value)
    setattr(qos, kind.name.lower(), value)


def declare_qos_parameters(
    entity_type: type[Any], node: Any, topic_name: str, qos: QoSProfile, options: QoSOverridingOptions
) -> QoSProfile:
    """Declare the parameters and return the profile that they say."""
    if not options.policy_kinds:
        return qos
    chosen = QoSProfile(depth=1)
    for slot in QoSProfile.__slots__:
        setattr(chosen, slot, getattr(qos, slot))
    kind_name = 'publisher' if issubclass(entity_type, Publisher) else 'subscription'
    suffix = f'_{options.entity_id}' if options.entity_id is not None else ''
    for kind in options.policy_kinds:
        name = f'qos_overrides.{topic_name}.{kind_name}{suffix}.{kind.name.lower()}'
        descriptor = ParameterDescriptor(
            description=f'{kind.name.lower()} policy of the {kind_name} of {topic_name}', read_only=True)
        try:
            parameter: Parameter = node.declare_parameter(name, _to_parameter(kind, qos), descriptor)
        except ParameterAlreadyDeclaredException:
            parameter = node.get_parameter(name)
        _apply(kind, parameter.value, chosen)
    if options.callback is not None:
        result: SetParametersResult = options.callback(chosen)
        if not result.successful:
            raise InvalidQosOverridesError(
                f"{options.callback}: Provided QoS overrides, are not valid: {result.reason}")
    return chosen
