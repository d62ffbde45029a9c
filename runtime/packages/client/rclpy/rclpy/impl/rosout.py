"""What nodes log goes to /rosout too, by the publisher of the node whose logger it is."""
from __future__ import annotations

from typing import Any

from rcl_interfaces.msg import Log
from ros2wasm import log

NS = 1_000_000_000
_publishers: dict[str, Any] = {}
_publishing = False


def add(logger_name: str, publisher: Any) -> None:
    _publishers.setdefault(logger_name, publisher)
    log.logging.listener = _tell


def remove(logger_name: str, publisher: Any) -> None:
    if _publishers.get(logger_name) is publisher:
        del _publishers[logger_name]


def _tell(severity: int, name: str, text: str, now: int, place: log.Place) -> None:
    global _publishing
    # Messages that publishing itself logs do not go to /rosout: that would recurse without end.
    if _publishing:
        return
    owner, publisher = name, _publishers.get(name)
    while publisher is None and '.' in owner:
        owner = owner.rpartition('.')[0]
        publisher = _publishers.get(owner)
    if publisher is None:
        return
    message = Log(level=severity, name=name, msg=text, file=place[0], function=place[1], line=place[2])
    message.stamp.sec, message.stamp.nanosec = divmod(now, NS)
    _publishing = True
    try:
        publisher.publish(message)
    finally:
        _publishing = False
