"""Clients of actions."""
from __future__ import annotations

import uuid
from collections import deque
from collections.abc import Callable
from functools import partial
from typing import Any

from action_msgs.msg import GoalStatus
from rclpy.action.entity import OVER, ActionEntity
from rclpy.callback_groups import CallbackGroup
from rclpy.client import Client
from rclpy.impl.elsewhere import names_of
from rclpy.impl.waiting import wait_for_answer, wait_until
from rclpy.qos import (
    QoSProfile, qos_profile_action_status_default, qos_profile_default, qos_profile_services_default,
)
from rclpy.task import Future
from ros2wasm.constants import EndpointKind

__getattr__ = names_of(__name__, {
    'action_msgs.srv': 'CancelGoal',
    'rclpy.executors': 'await_or_execute',
    'rclpy.type_support': 'check_for_type_support',
    'rclpy.waitable': 'NumberOfEntities Waitable',
    'unique_identifier_msgs.msg': 'UUID',
})


class ClientGoalHandle:
    """A goal that was sent, and what the server said of it."""

    def __init__(self, action_client: ActionClient, goal_id: Any, goal_response: Any) -> None:
        self._action_client = action_client
        self._goal_id = goal_id
        self._goal_response = goal_response
        self._status = int(GoalStatus.STATUS_UNKNOWN)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ClientGoalHandle) and bool(self._goal_id == other.goal_id)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f'ClientGoalHandle <id={self.goal_id.uuid}, accepted={self.accepted}, status={self.status}>'

    @property
    def goal_id(self) -> Any:
        return self._goal_id

    @property
    def stamp(self) -> Any:
        return self._goal_response.stamp

    @property
    def accepted(self) -> bool:
        return bool(self._goal_response.accepted)

    @property
    def status(self) -> int:
        return self._status

    def cancel_goal(self) -> Any:
        """Ask to cancel it, and wait for the answer. Must not be called where that would keep an executor."""
        return self._action_client._cancel_goal(self)

    def cancel_goal_async(self) -> Future:
        return self._action_client._cancel_goal_async(self)

    def get_result(self) -> Any:
        """Wait for its end. Must not be called where that would keep an executor."""
        return self._action_client._get_result(self)

    def get_result_async(self) -> Future:
        return self._action_client._get_result_async(self)


class ActionClient(ActionEntity):
    """Sends goals."""

    def __init__(
        self, node: Any, action_type: Any, action_name: str, *, callback_group: CallbackGroup | None = None,
        goal_service_qos_profile: QoSProfile = qos_profile_services_default,
        result_service_qos_profile: QoSProfile = qos_profile_services_default,
        cancel_service_qos_profile: QoSProfile = qos_profile_services_default,
        feedback_sub_qos_profile: QoSProfile = qos_profile_default,
        status_sub_qos_profile: QoSProfile = qos_profile_action_status_default
    ) -> None:
        super().__init__(node, action_type, action_name, callback_group)
        impl = action_type.Impl

        def ask(service: Any, part: str, qos: QoSProfile) -> Client:
            client: Client = node._rw_client(service, self._part(part), qos, self.callback_group)
            return client

        def read(message: Any, part: str, qos: QoSProfile) -> Any:
            return node._rw_endpoint(EndpointKind.SUBSCRIPTION, message, self._part(part), qos)
        self._goal_client = ask(impl.SendGoalService, 'send_goal', goal_service_qos_profile)
        self._cancel_client = ask(impl.CancelGoalService, 'cancel_goal', cancel_service_qos_profile)
        self._result_client = ask(impl.GetResultService, 'get_result', result_service_qos_profile)
        self._clients = (self._goal_client, self._cancel_client, self._result_client)
        self._feedback = read(impl.FeedbackMessage, 'feedback', feedback_sub_qos_profile)
        self._statuses = read(impl.GoalStatusMessage, 'status', status_sub_qos_profile)
        self._feedback_callbacks: dict[bytes, Callable[[Any], Any]] = {}
        #: Feedback that came before its goal's result, and is still to be told.
        self._late: deque[Callable[[], Any]] = deque()
        self._goal_handles: dict[bytes, ClientGoalHandle] = {}
        self._begin(*self._clients, self._feedback, self._statuses)

    # ---- for the executor

    def _rw_handles(self) -> list[int]:
        return [one.handle for one in (*(client._endpoint for client in self._clients), self._feedback, self._statuses)]

    def _rw_ready(self) -> bool:
        return bool(self._late)

    def _rw_take_call(self) -> Callable[[], Any] | None:
        if self._goal_client._receive() or self._cancel_client._receive() or self._take_status():
            return lambda: None
        # Before a result, with which a goal has no feedback any more.
        feedback = self._late.popleft() if self._late else self._take_feedback()
        if feedback is None and self._result_client._receive():
            return lambda: None
        return feedback

    def _take_feedback(self) -> Callable[[], Any] | None:
        """The next message of feedback, and whom it is to be told; None: there is none."""
        taken = self._feedback.take(self._action_type.Impl.FeedbackMessage._codec)
        if taken is None:
            return None
        callback = self._feedback_callbacks.get(bytes(taken[0].goal_id.uuid))
        return (lambda: None) if callback is None else partial(callback, taken[0])

    def _end_feedback(self, key: bytes) -> None:
        """No feedback of a goal comes any more, beside what is there already."""
        if key not in self._feedback_callbacks:
            return
        while (feedback := self._take_feedback()) is not None:
            self._late.append(feedback)
        del self._feedback_callbacks[key]

    def _take_status(self) -> bool:
        taken = self._statuses.take(self._action_type.Impl.GoalStatusMessage._codec)
        if taken is not None:
            self._on_status(taken[0])
        return taken is not None

    def _on_status(self, message: Any) -> None:
        for one in message.status_list:
            key = bytes(one.goal_info.goal_id.uuid)
            handle = self._goal_handles.get(key)
            if handle is None:
                continue
            handle._status = one.status
            if one.status in OVER:
                # Nothing more is told of it.
                del self._goal_handles[key]
                self._end_feedback(key)

    # ---- goals

    def send_goal(self, goal: Any, **kwargs: Any) -> Any:
        """
        Send a goal and wait for its end; the response with status and result.

        Must not be called where that would keep an executor from hearing the answers.
        """
        handle = self._wait(self.send_goal_async(goal, **kwargs))
        # The context may have been shut down meanwhile.
        return None if handle is None else self._get_result(handle)

    def send_goal_async(
        self, goal: Any, feedback_callback: Callable[[Any], Any] | None = None, goal_uuid: Any = None
    ) -> Future:
        """Send a goal; a Future of its ClientGoalHandle."""
        if not isinstance(goal, self._action_type.Goal):
            raise TypeError()
        request = self._action_type.Impl.SendGoalService.Request()
        request.goal_id = self._generate_random_uuid() if goal_uuid is None else goal_uuid
        request.goal = goal
        key = bytes(request.goal_id.uuid)
        if feedback_callback is not None:
            self._feedback_callbacks[key] = feedback_callback

        def answered(response: Any) -> ClientGoalHandle:
            handle = ClientGoalHandle(self, request.goal_id, response)
            if handle.accepted:
                self._goal_handles[key] = handle
            else:
                self._feedback_callbacks.pop(key, None)
            return handle

        def given_up(done: Future) -> None:
            if done.cancelled():
                self._feedback_callbacks.pop(key, None)
        future = self._ask(self._goal_client, request, answered)
        future.add_done_callback(given_up)
        return future

    def _ask(self, client: Client, request: Any, then: Callable[[Any], Any]) -> Future:
        """Ask; a Future of what `then` makes of the answer as soon as it is there, before anybody else hears of it."""
        future = Future(executor=self._node.executor)
        response = client.call_async(request)
        response._set_executor(None)

        def answered(done: Future) -> None:
            # Nobody wants the answer to what was given up.
            if not future.cancelled():
                future.set_result(then(done.result()))
        response.add_done_callback(answered)
        return future

    def _cancel_goal(self, goal_handle: ClientGoalHandle) -> Any:
        return self._wait(self._cancel_goal_async(goal_handle))

    def _cancel_goal_async(self, goal_handle: ClientGoalHandle) -> Future:
        if not isinstance(goal_handle, ClientGoalHandle):
            raise TypeError(f'Expected type ClientGoalHandle but received {type(goal_handle)}')
        request = self._action_type.Impl.CancelGoalService.Request()
        request.goal_info.goal_id = goal_handle.goal_id
        return self._cancel_client.call_async(request)

    def _get_result(self, goal_handle: ClientGoalHandle) -> Any:
        return self._wait(self._get_result_async(goal_handle))

    def _get_result_async(self, goal_handle: ClientGoalHandle) -> Future:
        if not isinstance(goal_handle, ClientGoalHandle):
            raise TypeError(f'Expected type ClientGoalHandle but received {type(goal_handle)}')
        request = self._action_type.Impl.GetResultService.Request()
        request.goal_id = goal_handle.goal_id
        key = bytes(goal_handle.goal_id.uuid)

        def answered(response: Any) -> Any:
            goal_handle._status = response.status
            self._end_feedback(key)
            return response
        return self._ask(self._result_client, request, answered)

    def _wait(self, future: Future) -> Any:
        wait_for_answer(future, self._node.context, self._node.executor, self, 'an ActionClient')
        return future.result()

    def _generate_random_uuid(self) -> Any:
        from unique_identifier_msgs.msg import UUID
        return UUID(uuid=list(uuid.uuid4().bytes))

    # ---- the server

    def server_is_ready(self) -> bool:
        """Is there a server, with all of its services and topics?"""
        return all(client.service_is_ready() for client in self._clients) and \
            all(endpoint.matched() > 0 for endpoint in (self._feedback, self._statuses))

    def wait_for_server(self, timeout_sec: float | None = None) -> bool:
        """Wait for a server. False: the time was over before."""
        return wait_until(self.server_is_ready, self._node.context, timeout_sec)
