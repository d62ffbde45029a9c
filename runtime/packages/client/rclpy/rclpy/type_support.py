"""Checks that what is given as a type is one."""
from __future__ import annotations

from typing import Any, TypeVar

from rclpy.exceptions import NoTypeSupportImportedException
from ros2wasm.message_class import MessageMeta

MsgType = TypeVar('MsgType')
SrvType = TypeVar('SrvType')
SrvTypeRequest = TypeVar('SrvTypeRequest')
SrvTypeResponse = TypeVar('SrvTypeResponse')


def check_for_type_support(msg_or_srv_type: Any) -> None:
    """NoTypeSupportImportedException: it is not an interface."""
    if not isinstance(msg_or_srv_type, MessageMeta) and not hasattr(msg_or_srv_type, '_type_name'):
        raise NoTypeSupportImportedException()


def check_is_valid_msg_type(msg_type: Any) -> None:
    if not isinstance(msg_type, MessageMeta):
        raise RuntimeError(
            f'The message type provided is not valid ({msg_type}), this might be a service or action')


def check_is_valid_srv_type(srv_type: Any) -> None:
    check_for_type_support(srv_type)
    if any(getattr(srv_type, name, None) is None for name in ('Response', 'Request', 'Event')):
        raise RuntimeError(
            f'The service type provided is not valid ({srv_type}), this might be a message or action')


def check_is_valid_action_type(action_type: Any) -> None:
    check_for_type_support(action_type)
    if any(getattr(action_type, name, None) is None for name in ('Goal', 'Result', 'Feedback', 'Impl')):
        raise RuntimeError(
            f'The action type provided is not valid ({action_type}), this might be a service or message')
