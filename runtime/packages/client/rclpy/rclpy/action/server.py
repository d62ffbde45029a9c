"""Servers of actions."""
from __future__ import annotations

import traceback
from collections.abc import Callable
from enum import Enum
from functools import partial
from typing import Any

from action_msgs.msg import GoalInfo, GoalStatus
from action_msgs.srv import CancelGoal
from rclpy.action.entity import OVER, ActionEntity
from rclpy.callback_groups import CallbackGroup
from rclpy.executors import await_or_execute
from rclpy.impl.elsewhere import names_of
from rclpy.qos import (
    QoSProfile, qos_profile_action_status_default, qos_profile_default, qos_profile_services_default,
)
from rclpy.service import Service
from rclpy.task import Future
from rclpy.time import Time
from ros2wasm.constants import EndpointKind

__getattr__ = names_of(__name__, {
    'rclpy._rclpy_pybind11': 'RCLError',
    'rclpy.type_support': 'check_for_type_support',
    'rclpy.waitable': 'NumberOfEntities Waitable',
})

NS = 1_000_000_000
NO_ID = bytes(16)


class GoalResponse(Enum):
    """Whether a goal is taken on."""

    REJECT = 1
    ACCEPT = 2


class CancelResponse(Enum):
    """Whether a goal is to be cancelled."""

    REJECT = 1
    ACCEPT = 2


class GoalEvent(Enum):
    """What brings a goal from one state to the next."""

    EXECUTE = 1
    CANCEL_GOAL = 2
    SUCCEED = 3
    ABORT = 4
    CANCELED = 5


_S = GoalStatus
#: (state, event) -> state. What is not here is not a transition.
TRANSITIONS = {
    (_S.STATUS_ACCEPTED, GoalEvent.EXECUTE): _S.STATUS_EXECUTING,
    (_S.STATUS_ACCEPTED, GoalEvent.CANCEL_GOAL): _S.STATUS_CANCELING,
    (_S.STATUS_EXECUTING, GoalEvent.CANCEL_GOAL): _S.STATUS_CANCELING,
    (_S.STATUS_EXECUTING, GoalEvent.SUCCEED): _S.STATUS_SUCCEEDED,
    (_S.STATUS_EXECUTING, GoalEvent.ABORT): _S.STATUS_ABORTED,
    (_S.STATUS_CANCELING, GoalEvent.SUCCEED): _S.STATUS_SUCCEEDED,
    (_S.STATUS_CANCELING, GoalEvent.ABORT): _S.STATUS_ABORTED,
    (_S.STATUS_CANCELING, GoalEvent.CANCELED): _S.STATUS_CANCELED,
}


class ServerGoalHandle:
    """A goal that was accepted."""

    def __init__(self, action_server: ActionServer, goal_info: Any, goal_request: Any) -> None:
        self._action_server = action_server
        self._goal_info = goal_info
        self._goal_request = goal_request
        self._status = int(GoalStatus.STATUS_ACCEPTED)
        #: When it came to its end, in ns; 0: it has not.
        self._ended_ns = 0
        #: Its result is what its callback returns, if none is given before.
        self._callback_decides = False

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ServerGoalHandle) and bool(self.goal_id == other.goal_id)

    __hash__ = None  # type: ignore[assignment]

    @property
    def request(self) -> Any:
        return self._goal_request

    @property
    def goal_id(self) -> Any:
        return self._goal_info.goal_id

    @property
    def is_active(self) -> bool:
        return self._status not in OVER

    @property
    def is_cancel_requested(self) -> bool:
        canceling: int = GoalStatus.STATUS_CANCELING
        return self._status == canceling

    @property
    def _is_cancelable(self) -> bool:
        return (self._status, GoalEvent.CANCEL_GOAL) in TRANSITIONS

    @property
    def status(self) -> int:
        return self._status

    def _update_state(self, event: GoalEvent) -> None:
        after = TRANSITIONS.get((self._status, event))
        if after is None:
            from rclpy._rclpy_pybind11 import RCLError
            raise RCLError(
                f'Failed to update goal state: goal_handle attempted invalid transition from state '
                f'{self._action_server._state_name(self._status)} with event {event.name}')
        self._status = int(after)
        if not self.is_active:
            self._ended_ns = self._action_server._now_ns()
        self._action_server._publish_status()

    def execute(self, execute_callback: Callable[[ServerGoalHandle], Any] | None = None) -> None:
        """Have the callback run; the server's own when none is given."""
        # A goal that is being cancelled stays so; its callback is to find out.
        if not self.is_cancel_requested:
            self._update_state(GoalEvent.EXECUTE)
        self._action_server.notify_execute(self, execute_callback)

    def publish_feedback(self, feedback: Any) -> None:
        """Tell the client how far it is."""
        if not isinstance(feedback, self._action_server.action_type.Feedback):
            raise TypeError()
        message = self._action_server.action_type.Impl.FeedbackMessage()
        message.goal_id = self.goal_id
        message.feedback = feedback
        self._action_server._publish_feedback(message)

    def _end(self, event: GoalEvent, response: Any) -> None:
        self._update_state(event)
        if response is not None or not self._callback_decides:
            self._action_server._set_result(self, response)

    def succeed(self, response: Any = None) -> None:
        """It is done; with its result, if that is not what its callback returns."""
        self._end(GoalEvent.SUCCEED, response)

    def abort(self, response: Any = None) -> None:
        """It failed."""
        self._end(GoalEvent.ABORT, response)

    def canceled(self, response: Any = None) -> None:
        """It was cancelled."""
        self._end(GoalEvent.CANCELED, response)

    #: As courses for ROS 2 Dashing and older write it.
    set_succeeded, set_aborted, set_canceled = succeed, abort, canceled

    def destroy(self) -> None:
        """Nothing is held for it."""


def default_handle_accepted_callback(goal_handle: ServerGoalHandle) -> None:
    """Execute it at once."""
    goal_handle.execute()


def default_goal_callback(goal_request: Any) -> GoalResponse:
    """Accept all goals."""
    return GoalResponse.ACCEPT


def default_cancel_callback(cancel_request: Any) -> CancelResponse:
    """Cancel no goal."""
    return CancelResponse.REJECT


class ActionServer(ActionEntity):
    """Takes goals."""

    def __init__(
        self, node: Any, action_type: Any, action_name: str,
        execute_callback: Callable[[ServerGoalHandle], Any] | None = None, *,
        callback_group: CallbackGroup | None = None, goal_callback: Callable[[Any], Any] = default_goal_callback,
        handle_accepted_callback: Callable[[ServerGoalHandle], Any] = default_handle_accepted_callback,
        cancel_callback: Callable[[Any], Any] = default_cancel_callback,
        goal_service_qos_profile: QoSProfile = qos_profile_services_default,
        result_service_qos_profile: QoSProfile = qos_profile_services_default,
        cancel_service_qos_profile: QoSProfile = qos_profile_services_default,
        feedback_pub_qos_profile: QoSProfile = qos_profile_default,
        status_pub_qos_profile: QoSProfile = qos_profile_action_status_default, result_timeout: float = 900
    ) -> None:
        super().__init__(node, action_type, action_name, callback_group)
        self.register_handle_accepted_callback(handle_accepted_callback)
        self.register_goal_callback(goal_callback)
        self.register_cancel_callback(cancel_callback)
        self._execute_callback: Callable[[ServerGoalHandle], Any] | None = None
        if execute_callback is not None:
            self.register_execute_callback(execute_callback)
        self._logger = node.get_logger().get_child('action_server')
        self._result_timeout_ns = int(result_timeout * NS)
        self._goal_handles: dict[bytes, ServerGoalHandle] = {}
        self._result_futures: dict[bytes, Future] = {}
        impl = action_type.Impl

        def serve(service: Any, part: str, act: Callable[[Any, Any], Any], qos: QoSProfile) -> Service:
            # Answered when there is an answer, so that `act` gets the request's header in place of a response.
            made: Service = node._rw_service(service, self._part(part), act, qos, self.callback_group)
            return made

        def publish(message: Any, part: str, qos: QoSProfile) -> Any:
            return node._rw_endpoint(EndpointKind.PUBLISHER, message, self._part(part), qos)
        self._goal_service = serve(impl.SendGoalService, 'send_goal', self._on_goal, goal_service_qos_profile)
        self._cancel_service = serve(
            impl.CancelGoalService, 'cancel_goal', self._on_cancel, cancel_service_qos_profile)
        self._result_service = serve(impl.GetResultService, 'get_result', self._on_result, result_service_qos_profile)
        self._services = (self._goal_service, self._cancel_service, self._result_service)
        self._feedback = publish(impl.FeedbackMessage, 'feedback', feedback_pub_qos_profile)
        self._statuses = publish(impl.GoalStatusMessage, 'status', status_pub_qos_profile)
        self._begin(*self._services, self._feedback, self._statuses)

    @property
    def action_type(self) -> Any:
        return self._action_type

    # ---- callbacks

    def _checked(self, callback: Any, what: str) -> Any:
        if not callable(callback):
            raise TypeError(f"Failed to register {what} callback: not callable")
        return callback

    def register_handle_accepted_callback(self, handle_accepted_callback: Any) -> None:
        """What is called with a goal that was accepted. None: it is executed at once."""
        callback = default_handle_accepted_callback if handle_accepted_callback is None else handle_accepted_callback
        self._handle_accepted_callback = self._checked(callback, 'handle accepted')

    def register_goal_callback(self, goal_callback: Any) -> None:
        """What says whether a goal is accepted. None: all are."""
        callback = default_goal_callback if goal_callback is None else goal_callback
        self._goal_callback = self._checked(callback, 'goal')

    def register_cancel_callback(self, cancel_callback: Any) -> None:
        """What says whether a goal is cancelled. None: none is."""
        callback = default_cancel_callback if cancel_callback is None else cancel_callback
        self._cancel_callback = self._checked(callback, 'cancel')

    def register_execute_callback(self, execute_callback: Any) -> None:
        """What does the work of a goal and returns its result."""
        self._execute_callback = self._checked(execute_callback, 'execute')

    # ---- for the executor

    def _rw_handles(self) -> list[int]:
        return [service._endpoint.handle for service in self._services]

    def _rw_take_call(self) -> Callable[[], Any] | None:
        for service in self._services:
            taken = service._take_request()
            if taken is not None:
                return partial(service.callback, *taken)
        return None

    def _reply(self, service: Service, response: Any, header: Any) -> None:
        if not self._destroyed:
            service.send_response(response, header)

    # ---- goals

    def _now_ns(self) -> int:
        return int(self._node.get_clock().now().nanoseconds)

    def _state_name(self, status: int) -> str:
        for name in ('ACCEPTED', 'EXECUTING', 'CANCELING', 'SUCCEEDED', 'CANCELED', 'ABORTED'):
            if getattr(GoalStatus, f'STATUS_{name}') == status:
                return name
        return 'UNKNOWN'

    async def _on_goal(self, request: Any, header: Any) -> None:
        self._forget_old_goals()
        key = bytes(request.goal_id.uuid)
        handle: ServerGoalHandle | None = None
        info = GoalInfo(goal_id=request.goal_id)
        if key not in self._goal_handles:
            said = await await_or_execute(self._goal_callback, request.goal)
            if not isinstance(said, GoalResponse):
                self._logger.warning('Goal request callback did not return a GoalResponse type. Rejecting goal.')
            elif said is GoalResponse.ACCEPT:
                info.stamp = self._node.get_clock().now().to_msg()
                handle = ServerGoalHandle(self, info, request.goal)
                self._goal_handles[key] = handle
                self._result_futures[key] = Future()
        response = self._goal_service.srv_type.Response(accepted=handle is not None, stamp=info.stamp)
        self._reply(self._goal_service, response, header)
        if handle is None:
            self._logger.debug(f'New goal rejected: {request.goal_id.uuid}')
            return
        self._logger.debug(f'New goal accepted: {request.goal_id.uuid}')
        self._publish_status()
        await await_or_execute(self._handle_accepted_callback, handle)

    def notify_execute(self, goal_handle: ServerGoalHandle, execute_callback: Any) -> None:
        """Have the executor run a goal's callback; without one, somebody else leads the goal to its end."""
        callback = self._execute_callback if execute_callback is None else self._checked(execute_callback, 'execute')
        if callback is None:
            return
        goal_handle._callback_decides = True
        self._node.executor.create_task(self._execute_goal, callback, goal_handle)

    async def _execute_goal(self, execute_callback: Any, goal_handle: ServerGoalHandle) -> None:
        goal_uuid = goal_handle.goal_id.uuid
        self._logger.debug(f'Executing goal with ID {goal_uuid}')
        try:
            result = await await_or_execute(execute_callback, goal_handle)
        except Exception as error:
            # The client hears of the end all the same.
            result = self._action_type.Result()
            self._logger.error(f'Error raised in execute callback: {error}')
            traceback.print_exc()
        if goal_handle.is_active:
            self._logger.warning(f'Goal state not set, assuming aborted. Goal ID: {goal_uuid}')
            if goal_handle.status == GoalStatus.STATUS_ACCEPTED:
                goal_handle._update_state(GoalEvent.EXECUTE)
            goal_handle.abort()
        self._logger.debug(f'Goal with ID {goal_uuid} finished with state {goal_handle.status}')
        self._set_result(goal_handle, result)

    def _set_result(self, goal_handle: ServerGoalHandle, result: Any) -> None:
        """Answer those who ask for a goal's result, if nothing was answered before."""
        future = self._result_futures.get(bytes(goal_handle.goal_id.uuid))
        if future is None or future.done():
            return
        response = self._action_type.Impl.GetResultService.Response(status=goal_handle.status)
        if result is not None:
            response.result = result
        future.set_result(response)

    def _on_result(self, request: Any, header: Any) -> None:
        future = self._result_futures.get(bytes(request.goal_id.uuid))
        if future is None:
            self._logger.debug(f'Sending result response for unknown goal ID: {request.goal_id.uuid}')
            unknown = self._result_service.srv_type.Response(status=GoalStatus.STATUS_UNKNOWN)
            self._reply(self._result_service, unknown, header)
            return

        def answer(done: Future) -> None:
            self._reply(self._result_service, done.result(), header)
        future.add_done_callback(answer)

    def _forget_old_goals(self) -> None:
        """The result of a goal is kept for some time after its end."""
        if self._result_timeout_ns < 0:
            return
        now = self._now_ns()
        for key, handle in list(self._goal_handles.items()):
            if handle._ended_ns and now - handle._ended_ns > self._result_timeout_ns:
                del self._goal_handles[key], self._result_futures[key]

    # ---- cancelling

    def _asked_to_cancel(self, info: Any) -> list[ServerGoalHandle]:
        """An id names one goal, a stamp all that were accepted until then, both the union, none all."""
        wanted, until = bytes(info.goal_id.uuid), Time.from_msg(info.stamp).nanoseconds
        if wanted == NO_ID and until == 0:
            return list(self._goal_handles.values())
        return [handle for key, handle in self._goal_handles.items() if key == wanted or
                (until and Time.from_msg(handle._goal_info.stamp).nanoseconds <= until)]

    def _why_none(self, info: Any) -> int:
        """What is said when no goal is to be asked: an error only to who wants one goal."""
        wanted, until = bytes(info.goal_id.uuid), Time.from_msg(info.stamp).nanoseconds
        codes = CancelGoal.Response
        if wanted == NO_ID or until != 0:
            return int(codes.ERROR_NONE)
        return int(codes.ERROR_GOAL_TERMINATED if wanted in self._goal_handles else codes.ERROR_UNKNOWN_GOAL_ID)

    async def _on_cancel(self, request: Any, header: Any) -> None:
        response = CancelGoal.Response()
        asked = [handle for handle in self._asked_to_cancel(request.goal_info) if handle._is_cancelable]
        if not asked:
            response.return_code = self._why_none(request.goal_info)
        for handle in asked:
            said = await await_or_execute(self._cancel_callback, handle)
            # It may have come to its end meanwhile.
            if said is CancelResponse.ACCEPT and handle._is_cancelable:
                handle._update_state(GoalEvent.CANCEL_GOAL)
                response.goals_canceling.append(handle._goal_info)
        if asked and not response.goals_canceling:
            response.return_code = CancelGoal.Response.ERROR_REJECTED
        self._reply(self._cancel_service, response, header)

    # ---- what clients are told

    def _publish_feedback(self, message: Any) -> None:
        self._feedback.publish(self._action_type.Impl.FeedbackMessage._codec, message)

    def _publish_status(self) -> None:
        kind = self._action_type.Impl.GoalStatusMessage
        self._statuses.publish(kind._codec, kind(status_list=[
            GoalStatus(goal_info=handle._goal_info, status=handle.status) for handle in self._goal_handles.values()]))
