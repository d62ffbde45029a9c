"""What both halves of an action are: three services and two topics, which the executor sees as one entity."""
from __future__ import annotations

from typing import Any

from action_msgs.msg import GoalStatus
from rclpy.callback_groups import CallbackGroup
from rclpy.type_support import check_is_valid_action_type
from rclpy.waitable import Waitable

#: States in which a goal stays.
OVER: tuple[int, ...] = (GoalStatus.STATUS_SUCCEEDED, GoalStatus.STATUS_CANCELED, GoalStatus.STATUS_ABORTED)


class ActionEntity(Waitable):
    """Knows the names of the parts, and destroys them."""

    def __init__(self, node: Any, action_type: Any, action_name: str, callback_group: CallbackGroup | None) -> None:
        super().__init__(callback_group or node.default_callback_group)
        check_is_valid_action_type(action_type)
        self._node = node
        self._action_type = action_type
        self._action_name = action_name
        self._full_name: str = node.resolve_service_name(action_name)
        #: What is destroyed with it.
        self._owned: list[Any] = []

    def _part(self, name: str) -> str:
        """The full name of a service or topic of the action."""
        return f'{self._full_name}/_action/{name}'

    def _begin(self, *owned: Any) -> None:
        """Be called by executors from now on."""
        self._owned = list(owned)
        self.callback_group.add_entity(self)
        self._node.add_waitable(self)

    def _rw_ready(self) -> bool:
        return False

    def destroy(self) -> None:
        if self._destroyed:
            return
        self._destroyed = True
        if self in self._node.waitables:
            self._node.remove_waitable(self)
        for one in self._owned:
            one.destroy()
