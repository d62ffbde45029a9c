"""Policies that are left open: the highest that fits those who are on the topic now."""
from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from rclpy.duration import Duration
from rclpy.qos import BEST_AVAILABLE_NS, DurabilityPolicy, LivelinessPolicy, QoSProfile, ReliabilityPolicy
from ros2wasm.graph_snapshot import Qos


def is_open(profile: QoSProfile) -> bool:
    """Whether a policy is left open."""
    return profile.reliability == ReliabilityPolicy.BEST_AVAILABLE or \
        profile.durability == DurabilityPolicy.BEST_AVAILABLE or \
        profile.liveliness == LivelinessPolicy.BEST_AVAILABLE or \
        BEST_AVAILABLE_NS in (profile.deadline.nanoseconds, profile.liveliness_lease_duration.nanoseconds)


def _limit(open_: Duration, others: list[int], longest: bool) -> Duration:
    """The longest or shortest that the others have set; 0 is none."""
    if open_.nanoseconds != BEST_AVAILABLE_NS:
        return open_
    found = sorted(one for one in others if one)
    return Duration(nanoseconds=0 if not found else found[-1] if longest else found[0])


def choose(profile: QoSProfile, others: Sequence[Qos], for_subscription: bool) -> QoSProfile:
    """A profile without open policies. `others`: the publishers of a subscription, the subscriptions of a publisher."""
    kept: dict[str, Any] = {slot[1:]: getattr(profile, slot) for slot in QoSProfile.__slots__}
    manual, local = LivelinessPolicy.MANUAL_BY_TOPIC, DurabilityPolicy.TRANSIENT_LOCAL
    # A subscription asks for more only when all offer it; a publisher's best fits every subscription.
    if profile.reliability == ReliabilityPolicy.BEST_AVAILABLE:
        reliable = not for_subscription or all(one.reliability == ReliabilityPolicy.RELIABLE for one in others)
        kept['reliability'] = ReliabilityPolicy.RELIABLE if reliable else ReliabilityPolicy.BEST_EFFORT
    if profile.durability == DurabilityPolicy.BEST_AVAILABLE:
        keeps = not for_subscription or all(one.durability == local for one in others)
        kept['durability'] = local if keeps else DurabilityPolicy.VOLATILE
    if profile.liveliness == LivelinessPolicy.BEST_AVAILABLE:
        by_topic = [one.liveliness == manual for one in others]
        kept['liveliness'] = manual if (all if for_subscription else any)(by_topic) else LivelinessPolicy.AUTOMATIC
    kept['deadline'] = _limit(profile.deadline, [one.deadline_ns for one in others], for_subscription)
    kept['liveliness_lease_duration'] = _limit(
        profile.liveliness_lease_duration, [one.lease_ns for one in others], for_subscription)
    return QoSProfile(**kept)
