"""The time of a message."""
from __future__ import annotations

from typing import Any

from rclpy.clock import ROSClock
from rclpy.logging import LoggingSeverity, get_logger
from rclpy.time import Time

NO_STAMP = (
    "can not use message filters messages without timestamp infomation when 'allow_headerless' is disabled. auto "
    "assign ROSTIME to headerless messages once enabling constructor option of 'allow_headerless'.")


def time_of(stamp: Any) -> Time:
    """Of a message or of rclpy, as rclpy's."""
    rclpys: Time = stamp if hasattr(stamp, 'nanoseconds') else Time.from_msg(stamp)
    return rclpys


def stamp_of(msg: Any, allow_headerless: bool, logger: str) -> Time | None:
    """The time in the header; of a message without one the present, where that is allowed, else None and a warning."""
    if hasattr(msg, 'header') and hasattr(msg.header, 'stamp'):
        return time_of(msg.header.stamp)
    if allow_headerless:
        return ROSClock().now()
    log = get_logger(logger)
    log.set_level(LoggingSeverity.INFO)
    log.warning(NO_STAMP)
    return None
