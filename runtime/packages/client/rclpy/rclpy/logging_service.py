"""The services ~/get_logger_levels and ~/set_logger_levels."""
from __future__ import annotations

from typing import Any

from rcl_interfaces.msg import LoggerLevel, SetLoggerLevelsResult
from rcl_interfaces.srv import GetLoggerLevels, SetLoggerLevels
from rclpy.impl.logging_severity import LoggingSeverity
from rclpy.qos import qos_profile_services_default
from ros2wasm.log import logging


class LoggingService:
    """Made by a node that was asked to have them."""

    def __init__(self, node: Any) -> None:
        node.create_service(
            GetLoggerLevels, '~/get_logger_levels', self._get_logger_levels, qos_profile=qos_profile_services_default)
        node.create_service(
            SetLoggerLevels, '~/set_logger_levels', self._set_logger_levels, qos_profile=qos_profile_services_default)

    def _get_logger_levels(self, request: Any, response: Any) -> Any:
        for name in request.names:
            response.levels.append(LoggerLevel(name=name, level=logging.own_level(name)))
        return response

    def _set_logger_levels(self, request: Any, response: Any) -> Any:
        for level in request.levels:
            result = SetLoggerLevelsResult()
            try:
                logging.set_level(level.name, int(LoggingSeverity(level.level)))
                result.successful = True
            except ValueError as error:
                result.reason = str(error)
            response.results.append(result)
        return response
