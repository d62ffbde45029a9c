"""Clients of actions."""
from __future__ import annotations

import time
import uuid
from collections.abc import Callable
from functools import partial
from types import TracebackType
from typing import Any

from action_msgs.msg import GoalStatus
from rclpy.callback_groups import CallbackGroup
from rclpy.client import Client
from rclpy.qos import (
    QoSProfile, qos_profile_action_status_default, qos_profile_default, qos_profile_services_default,
)
from rclpy.task import Future
from rclpy.type_support import check_is_valid_action_type
from rclpy.waitable import Waitable
from ros2wasm import background, host
from ros2wasm.constants import EndpointKind

NS = 1_000_000_000


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


class ActionClient(Waitable):
    """Sends goals. Three services and two topics, which the executor sees as one."""

    def __init__(
        self, node: Any, action_type: Any, action_name: str, *, callback_group: CallbackGroup | None = None,
        goal_service_qos_profile: QoSProfile = qos_profile_services_default,
        result_service_qos_profile: QoSProfile = qos_profile_services_default,
        cancel_service_qos_profile: QoSProfile = qos_profile_services_default,
        feedback_sub_qos_profile: QoSProfile = qos_profile_default,
        status_sub_qos_profile: QoSProfile = qos_profile_action_status_default
    ) -> None:
        super().__init__(callback_group or node.default_callback_group)
        check_is_valid_action_type(action_type)
        self._node = node
        self._action_type = action_type
        self._action_name = action_name
        impl = action_type.Impl
        full = node.resolve_service_name(action_name)

        def ask(service: Any, part: str, qos: QoSProfile) -> Client:
            name = f'{full}/_action/{part}'
            client = Client(
                node.context, node._endpoint(EndpointKind.CLIENT, service, name, qos), service, name, qos,
                self.callback_group, node.get_logger().name)
            client._find_executor = lambda: node.executor
            return client
        self._goal_client = ask(impl.SendGoalService, 'send_goal', goal_service_qos_profile)
        self._cancel_client = ask(impl.CancelGoalService, 'cancel_goal', cancel_service_qos_profile)
        self._result_client = ask(impl.GetResultService, 'get_result', result_service_qos_profile)
        self._clients = (self._goal_client, self._cancel_client, self._result_client)
        self._feedback = node._endpoint(
            EndpointKind.SUBSCRIPTION, impl.FeedbackMessage, f'{full}/_action/feedback', feedback_sub_qos_profile)
        self._statuses = node._endpoint(
            EndpointKind.SUBSCRIPTION, impl.GoalStatusMessage, f'{full}/_action/status', status_sub_qos_profile)
        self._readers = {
            self._feedback.handle: (self._feedback, impl.FeedbackMessage._codec, self._on_feedback),
            self._statuses.handle: (self._statuses, impl.GoalStatusMessage._codec, self._on_status),
        }
        self._feedback_callbacks: dict[bytes, Callable[[Any], Any]] = {}
        self._goal_handles: dict[bytes, ClientGoalHandle] = {}
        self.callback_group.add_entity(self)
        node.add_waitable(self)

    # ---- for the executor

    def _handles(self) -> list[int]:
        return [client._endpoint.handle for client in self._clients] + list(self._readers)

    def _ready(self) -> bool:
        return False

    def _take_call(self) -> Callable[[], Any] | None:
        for client in self._clients:
            if client._receive():
                return lambda: None
        for endpoint, codec, tell in self._readers.values():
            taken = endpoint.take(codec)
            if taken is not None:
                return partial(tell, taken[0])
        return None

    def _on_feedback(self, message: Any) -> Any:
        callback = self._feedback_callbacks.get(bytes(message.goal_id.uuid))
        return None if callback is None else callback(message)

    def _on_status(self, message: Any) -> None:
        for one in message.status_list:
            key = bytes(one.goal_info.goal_id.uuid)
            handle = self._goal_handles.get(key)
            if handle is None:
                continue
            handle._status = one.status
            if one.status in (GoalStatus.STATUS_SUCCEEDED, GoalStatus.STATUS_CANCELED, GoalStatus.STATUS_ABORTED):
                # Nothing more is told of it.
                del self._goal_handles[key]

    # ---- goals

    def send_goal(self, goal: Any, **kwargs: Any) -> Any:
        """
        Send a goal and wait until it is accepted or rejected.

        Must not be called where that would keep an executor from hearing the answer.
        """
        if not isinstance(goal, self._action_type.Goal):
            raise TypeError()
        return self._wait(self.send_goal_async(goal, **kwargs))

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
        future = Future(executor=self._node.executor)

        def answered(response: Future) -> None:
            error = response.exception()
            if error is not None:
                future.set_exception(error)
                return
            handle = ClientGoalHandle(self, request.goal_id, response.result())
            if handle.accepted:
                self._goal_handles[key] = handle
            else:
                self._feedback_callbacks.pop(key, None)
            future.set_result(handle)
        self._ask(self._goal_client, request, answered)
        return future

    def _ask(self, client: Client, request: Any, answered: Callable[[Future], None]) -> None:
        """Ask; `answered` runs as soon as the answer is there, before anybody else hears of it."""
        response = client.call_async(request)
        response._set_executor(None)
        response.add_done_callback(answered)

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
        future = Future(executor=self._node.executor)

        def answered(response: Future) -> None:
            error = response.exception()
            if error is not None:
                future.set_exception(error)
                return
            goal_handle._status = response.result().status
            self._feedback_callbacks.pop(key, None)
            future.set_result(response.result())
        self._ask(self._result_client, request, answered)
        return future

    def _wait(self, future: Future) -> Any:
        executor = self._node.executor
        while not future.done() and self._node.context.ok():
            token = host.wake_token()
            if any(client._receive() for client in self._clients) or future.done():
                continue
            if executor is not None and executor._run_meanwhile(token):
                continue
            background.run()
            host.wait(token, -1)
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
        end = None if timeout_sec is None or timeout_sec < 0 else time.monotonic_ns() + int(timeout_sec * NS)
        while self._node.context.ok():
            token = host.wake_token()
            if self.server_is_ready():
                return True
            left = -1 if end is None else end - time.monotonic_ns()
            if end is not None and left <= 0:
                return False
            background.run()
            host.wait(token, left)
        return self.server_is_ready()

    def destroy(self) -> None:
        if self._destroyed:
            return
        self._destroyed = True
        if self in self._node.waitables:
            self._node.remove_waitable(self)
        for client in self._clients:
            client.destroy()
        self._feedback.destroy()
        self._statuses.destroy()

    def __enter__(self) -> ActionClient:
        return self

    def __exit__(
        self, exc_type: type[BaseException] | None, exc_val: BaseException | None, exc_tb: TracebackType | None
    ) -> None:
        self.destroy()
