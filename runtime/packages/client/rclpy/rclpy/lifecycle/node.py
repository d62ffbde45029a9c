"""Managed nodes."""
from __future__ import annotations

from collections.abc import Callable
from typing import Any

import lifecycle_msgs.msg
import lifecycle_msgs.srv
from rclpy._rclpy_pybind11 import RCLError
from rclpy.callback_groups import CallbackGroup
from rclpy.impl.elsewhere import names_of
from rclpy.lifecycle.managed_entity import ManagedEntity
from rclpy.lifecycle.publisher import LifecyclePublisher
from rclpy.lifecycle.state_machine import (
    ACTIVATING, CLEANINGUP, CONFIGURING, DEACTIVATING, ERRORPROCESSING, LABELS, SHUTDOWN, SHUTTINGDOWN, STATES, STEPS,
    LifecycleState, StateMachine, Step, TransitionCallbackReturn,
)
from rclpy.logging import get_logger
from rclpy.node import Node
from rclpy.qos import QoSProfile

__getattr__ = names_of(__name__, {
    'rclpy.service': 'Service',
    'rclpy.type_support': 'check_is_valid_srv_type',
    'typing': 'Dict NamedTuple Optional Set',
})

Callback = Callable[[LifecycleState], TransitionCallbackReturn]


def _state_message(state: int) -> Any:
    return lifecycle_msgs.msg.State(id=state, label=STATES[state])


def _descriptions(steps: list[Step]) -> list[Any]:
    return [lifecycle_msgs.msg.TransitionDescription(
        transition=lifecycle_msgs.msg.Transition(id=one.id, label=one.label), start_state=_state_message(one.start),
        goal_state=_state_message(one.goal)) for one in steps]


class LifecycleNodeMixin(ManagedEntity):
    """Gives a node a managed life, and services by which others lead it."""

    def __init__(
        self, *, enable_communication_interface: bool = True, callback_group: CallbackGroup | None = None
    ) -> None:
        node: Any = self
        self._state_machine = StateMachine()
        self._managed_entities: list[ManagedEntity] = []
        self._rw_lifecycle_callbacks: dict[int, Callback] = {
            CONFIGURING: self.on_configure, CLEANINGUP: self.on_cleanup, SHUTTINGDOWN: self.on_shutdown,
            ACTIVATING: self.on_activate, DEACTIVATING: self.on_deactivate, ERRORPROCESSING: self.on_error,
        }
        self._rw_transition_event_publisher: Any = None
        if not enable_communication_interface:
            return
        self._rw_transition_event_publisher = node.create_publisher(
            lifecycle_msgs.msg.TransitionEvent, '~/transition_event', 10, callback_group=callback_group)
        srv = lifecycle_msgs.srv
        for type_, name, answer in (
            (srv.ChangeState, 'change_state', self._rw_on_change_state),
            (srv.GetState, 'get_state', self._rw_on_get_state),
            (srv.GetAvailableStates, 'get_available_states', self._rw_on_get_available_states),
            (srv.GetAvailableTransitions, 'get_available_transitions', self._rw_on_get_available_transitions),
            (srv.GetAvailableTransitions, 'get_transition_graph', self._rw_on_get_transition_graph),
        ):
            node.create_service(type_, f'~/{name}', answer, callback_group=callback_group)

    # ---- entities

    def add_managed_entity(self, entity: ManagedEntity) -> None:
        """Tell it of all transitions too."""
        self._managed_entities.append(entity)

    def create_lifecycle_publisher(
        self, msg_type: Any, topic: str, qos_profile: QoSProfile | int, **kwargs: Any
    ) -> LifecyclePublisher:
        """A publisher that sends from the next activation on, while the node is active."""
        node: Any = self
        publisher: LifecyclePublisher = node.create_publisher(
            msg_type, topic, qos_profile, publisher_class=LifecyclePublisher, **kwargs)
        self._managed_entities.append(publisher)
        return publisher

    def destroy_lifecycle_publisher(self, publisher: LifecyclePublisher) -> bool:
        if publisher in self._managed_entities:
            self._managed_entities.remove(publisher)
        node: Any = super()
        return bool(node.destroy_publisher(publisher))

    def destroy_publisher(self, publisher: Any) -> bool:
        return self.destroy_lifecycle_publisher(publisher)

    # ---- callbacks

    def _rw_tell_entities(self, name: str, state: LifecycleState) -> TransitionCallbackReturn:
        """The first that does not succeed decides."""
        for entity in list(self._managed_entities):
            result: TransitionCallbackReturn = getattr(entity, name)(state)
            if result != TransitionCallbackReturn.SUCCESS:
                return result
        return TransitionCallbackReturn.SUCCESS

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        return self._rw_tell_entities('on_configure', state)

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        return self._rw_tell_entities('on_cleanup', state)

    def on_shutdown(self, state: LifecycleState) -> TransitionCallbackReturn:
        return self._rw_tell_entities('on_shutdown', state)

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        return self._rw_tell_entities('on_activate', state)

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        return self._rw_tell_entities('on_deactivate', state)

    def on_error(self, state: LifecycleState) -> TransitionCallbackReturn:
        return self._rw_tell_entities('on_error', state)

    # ---- transitions

    def trigger_configure(self) -> TransitionCallbackReturn:
        return self._rw_change_state('configure')

    def trigger_cleanup(self) -> TransitionCallbackReturn:
        return self._rw_change_state('cleanup')

    def trigger_shutdown(self) -> TransitionCallbackReturn:
        return self._rw_change_state(SHUTDOWN)

    def trigger_activate(self) -> TransitionCallbackReturn:
        return self._rw_change_state('activate')

    def trigger_deactivate(self) -> TransitionCallbackReturn:
        return self._rw_change_state('deactivate')

    def _rw_change_state(self, key: int | str) -> TransitionCallbackReturn:
        """Begin a transition and call back. RCLError: there is none such from here."""
        step = self._rw_find(key)
        before = self._state_machine.current
        self._rw_make(step)
        result = self._rw_call(before)
        self._rw_make(self._rw_find(LABELS[result]))
        if result == TransitionCallbackReturn.ERROR:
            handled = self._rw_call(before)
            self._rw_make(self._rw_find(LABELS[handled]))
        return result

    def _rw_find(self, key: int | str) -> Step:
        step = self._state_machine.find(key)
        if step is None:
            label = self._state_machine.current.label
            get_logger('rcl_lifecycle').warning(f'No transition matching {key} found for current state {label}')
            raise RCLError(f'Failed to trigger lifecycle state machine transition: Transition is not registered., '
                           f'current state {label}')
        return step

    def _rw_make(self, step: Step) -> None:
        self._state_machine.state = step.goal
        if self._rw_transition_event_publisher is not None:
            described = _descriptions([step])[0]
            self._rw_transition_event_publisher.publish(lifecycle_msgs.msg.TransitionEvent(
                transition=described.transition, start_state=described.start_state, goal_state=described.goal_state))

    def _rw_call(self, before: LifecycleState) -> TransitionCallbackReturn:
        callback = self._rw_lifecycle_callbacks.get(self._state_machine.state)
        if callback is None:
            return TransitionCallbackReturn.SUCCESS
        try:
            return TransitionCallbackReturn(callback(before))
        except Exception as error:
            node: Any = self
            node.get_logger().error(f'Exception in lifecycle callback: {error!r}')
            return TransitionCallbackReturn.ERROR

    # ---- services

    def _rw_on_change_state(self, request: Any, response: Any) -> Any:
        # A label goes before the number, which is 0 when it was not given.
        key: int | str = request.transition.label or int(request.transition.id)
        response.success = self._state_machine.find(key) is not None
        if not response.success:
            get_logger('rcl_lifecycle').warning(
                f'No transition matching {key} found for current state {self._state_machine.current.label}')
            return response
        response.success = self._rw_change_state(key) == TransitionCallbackReturn.SUCCESS
        return response

    def _rw_on_get_state(self, request: Any, response: Any) -> Any:
        response.current_state = _state_message(self._state_machine.state)
        return response

    def _rw_on_get_available_states(self, request: Any, response: Any) -> Any:
        response.available_states = [_state_message(one) for one in STATES]
        return response

    def _rw_on_get_available_transitions(self, request: Any, response: Any) -> Any:
        response.available_transitions = _descriptions(self._state_machine.available())
        return response

    def _rw_on_get_transition_graph(self, request: Any, response: Any) -> Any:
        response.available_transitions = _descriptions(STEPS)
        return response


class LifecycleNode(LifecycleNodeMixin, Node):
    """A node with a managed life."""

    def __init__(self, node_name: str, *, enable_communication_interface: bool = True, **kwargs: Any) -> None:
        Node.__init__(self, node_name, **kwargs)
        LifecycleNodeMixin.__init__(self, enable_communication_interface=enable_communication_interface)
