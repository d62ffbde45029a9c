"""What a node makes: clients that wait, messages that are waited for."""
from __future__ import annotations

import importlib
import inspect
import struct
import unittest
from collections import Counter
from typing import Any
from unittest import mock

from tests.unit.rclpy.fake_bus import BusTest


#: Names between the lines that rclpy's nodes have too: those who take them for their own break their node natively.
UPSTREAM_PRIVATE = frozenset('''
    _allow_undeclared_parameters _clients _clock _context _default_callback_group _descriptors _guards _logger
    _logger_service _managed_entities _on_set_parameters_callbacks _parameter_event_publisher _parameter_overrides
    _parameter_service _parameters _post_set_parameters_callbacks _pre_set_parameters_callbacks _publishers _services
    _state_machine _subscriptions _time_source _timers _type_description_service _validate_qos_or_depth_parameter
    _wake_executor
'''.split())


class NodeTest(BusTest):
    def setUp(self) -> None:
        super().setUp()
        self.own = self.node('own')
        self.trigger = importlib.import_module('std_srvs.srv').Trigger

    def test_a_message_costs_few_calls_of_the_host(self) -> None:
        string = importlib.import_module('std_msgs.msg').String
        heard: list[Any] = []
        node = self.node('quiet')
        node.create_subscription(string, 'words', heard.append, 10)
        publisher = node.create_publisher(string, 'words', 10)
        calls: Counter[str] = Counter()

        def counted(name: str) -> None:
            function = getattr(self.bus, name)

            def call(*args: Any) -> Any:
                calls[name] += 1
                return function(*args)
            self.replace(name, call)
        for name in dir(type(self.bus)):
            if not name.startswith('_') and inspect.ismethod(getattr(self.bus, name)):
                counted(name)
        self.spin_until(lambda: not self.bus.ready(0, 0))
        # The second one comes with the look, by a function that is asked for once.
        for _ in range(3):
            calls.clear()
            publisher.publish(string(data='x'))
            self.executor.spin_once(timeout_sec=0)
        # The bus itself calls some of its functions.
        for name in ('wake', 'wake_token', 'ready', 'status_version'):
            del calls[name]
        self.assertEqual(dict(calls), {'write': 1, 'look': 1})
        self.assertEqual(len(heard), 3)

    # Compatibility, works: any name for attributes and methods of one's own in a node (rclpy) that natively is free; in
    # managed nodes too

    def test_a_node_may_have_any_name_of_its_own(self) -> None:
        lifecycle = importlib.import_module('rclpy.lifecycle')
        for kind in (self.rclpy.node.Node, lifecycle.LifecycleNode):
            node = kind(f'plain_{kind.__name__}', context=self.context)
            taken = {name for name in dir(node) if name.startswith('_') and not name.startswith(('__', '_rw_'))}
            self.assertLessEqual(taken, UPSTREAM_PRIVATE)
            node.destroy_node()

    def test_names_of_a_users_node_do_not_reach_into_ours(self) -> None:
        string = importlib.import_module('std_msgs.msg').String
        fibonacci = importlib.import_module('example_interfaces.action').Fibonacci
        action = importlib.import_module('rclpy.action')
        trigger, context = self.trigger, self.context

        class Robot(self.rclpy.node.Node):  # type: ignore[name-defined,misc]
            def __init__(self) -> None:
                super().__init__('robot', namespace='lab', context=context)
                self._name, self._namespace, self._executor = 'bob', '/elsewhere', object()
                self._client = self.create_client(trigger, 'first')
                self._service = self.create_service(trigger, 'second', self._call)
                self._count = self._check = self._set = self._store = self._tell = self._add = self._ask = 0
                self._endpoint = self._closed = self._resolve = self._expand = self._destroyed = self._rates = None
                self.more = (self.create_client(trigger, 'third'), self.create_service(trigger, 'fourth', self._call),
                             self.create_publisher(string, 'words', 1), self.create_rate(1.0),
                             action.ActionClient(self, fibonacci, 'count'),
                             action.ActionServer(self, fibonacci, 'count', lambda goal: fibonacci.Result()))
                self.declare_parameter('speed', 1.0)
                self.set_parameters([importlib.import_module('rclpy.parameter').Parameter('speed', value=2.0)])

            def _begin(self) -> None:
                raise AssertionError

            def _call(self, request: Any, response: Any) -> Any:
                return response

        robot = Robot()
        self.executor.add_node(robot)
        self.assertEqual(robot.get_fully_qualified_name(), '/lab/robot')
        self.assertEqual(robot.resolve_topic_name('words'), '/lab/words')
        robot.count_publishers('words')
        self.assertEqual(robot.get_parameter('speed').value, 2.0)
        self.executor.remove_node(robot)
        robot.destroy_node()

    def test_errors_of_the_c_extension_are_caught_by_their_names_there(self) -> None:
        extension = importlib.import_module('rclpy._rclpy_pybind11')
        self.assertIs(self.rclpy._rclpy_pybind11, extension)
        context = self.rclpy.context.Context()
        context.init(args=[])
        context.shutdown()
        with self.assertRaises(extension.RCLError):
            context.shutdown()
        with self.assertRaises(extension.NodeNameNonExistentError):
            self.own.get_publisher_names_and_types_by_node('nobody', '/')
        publisher = self.own.create_publisher(importlib.import_module('std_msgs.msg').String, 'gone', 1)
        self.own.destroy_publisher(publisher)
        with self.assertRaises(extension.InvalidHandle):
            publisher.publish(importlib.import_module('std_msgs.msg').String())

    def test_bytes_that_end_before_their_message_are_refused(self) -> None:
        """What an earlier, longer message left behind them is not read."""
        string = importlib.import_module('std_msgs.msg').String
        error = importlib.import_module('ros2wasm.codec').CdrError
        heard: list[Any] = []
        node = self.node('short')
        node.create_subscription(string, 'short', heard.append, 10)
        publisher = node.create_publisher(string, 'short', 10)
        whole = self.rclpy.serialization.serialize_message(string(data='x' * 24))
        publisher.publish(whole)
        self.spin_until(lambda: bool(heard))
        for _ in range(2):
            publisher.publish(whole[:16])
            with self.assertRaises(error):
                self.executor.spin_once(timeout_sec=0)
        publisher.publish(whole)
        self.spin_until(lambda: len(heard) == 2)
        with self.assertRaises(error):
            self.rclpy.serialization.deserialize_message(whole[:16], string)

    def test_a_destroyed_publisher_sends_nothing_for_the_next_of_its_handle(self) -> None:
        string = importlib.import_module('std_msgs.msg').String
        publisher = self.node('brief').create_publisher(string, 'brief', 10)
        endpoint = publisher._endpoint
        publisher.publish(string())
        publisher.destroy()
        self.replace('write', lambda handle, *_: -3 if handle == -1 else 0)
        with self.assertRaises(importlib.import_module('ros2wasm.host').BusError):
            endpoint.publish(publisher._codec, string())

    def flood(self) -> tuple[Any, list[str], Any]:
        """A publisher of texts, what was called back, and the node; one was heard, so the next comes with a look."""
        string = importlib.import_module('std_msgs.msg').String
        called: list[str] = []
        node = self.node('flooded')
        node.create_subscription(string, 'flood', lambda message: called.append(message.data), 10)
        publisher = node.create_publisher(string, 'flood', 10)

        def publish(*texts: str) -> None:
            for text in texts:
                publisher.publish(string(data=text))
        publish('first')
        self.spin_until(lambda: called == ['first'])
        called.clear()
        return publish, called, node

    def spin(self, times: int) -> None:
        for _ in range(times):
            self.executor.spin_once(timeout_sec=0)

    def test_a_flood_of_messages_keeps_nothing_else_from_its_turn(self) -> None:
        publish, called, node = self.flood()
        string = importlib.import_module('std_msgs.msg').String
        node.create_subscription(string, 'other', lambda message: called.append('other'), 10)
        other = node.create_publisher(string, 'other', 10)
        publish(*'12345678')
        self.spin(2)
        self.assertEqual(called, ['1', '2'])
        other.publish(string(data='x'))
        self.spin(3)
        self.assertEqual(sorted(called[2:]), ['3', '4', 'other'])
        called.clear()
        self.spin(1)
        self.executor.create_task(lambda: called.append('task'))
        self.spin(2)
        self.assertEqual(called, ['5', 'task', '6'])
        called.clear()
        node.create_timer(0, lambda: called.append('timer'))
        self.spin(4)
        self.assertEqual(called, ['timer', '7', 'timer', '8'])

    def test_events_come_between_the_messages_of_a_flood(self) -> None:
        publish, called, node = self.flood()
        events = importlib.import_module('rclpy.event_handler')
        string = importlib.import_module('std_msgs.msg').String
        matched = int(importlib.import_module('ros2wasm.constants').StatusKind.PUBLICATION_MATCHED)
        version, change = 0, 0

        def fill(_handle: int, kind: int, out: int) -> int:
            nonlocal change
            if kind != matched:
                return -1
            self.bus._memory(out, 32)[:] = struct.pack('<8i', version, change, version, change, 0, 0, 0, 0)
            change = 0
            return 0
        self.replace('endpoint_status', fill)
        self.replace('status_version', lambda: version)
        node.create_publisher(string, 'told', 10, event_callbacks=events.PublisherEventCallbacks(
            matched=lambda _: called.append('event'), use_default_callbacks=False))
        publish('1', '2', '3', '4')
        self.spin(2)
        self.assertEqual(called, ['1', '2'])
        version, change = 1, 1
        self.spin(2)
        self.assertEqual(called[2:], ['3', 'event'])

    def test_a_group_that_is_taken_gets_no_message(self) -> None:
        publish, called, node = self.flood()
        publish('1')
        group, busy = node.default_callback_group, object()
        group.beginning_execution(busy)
        self.spin(2)
        self.assertEqual(called, [])
        group.ending_execution(busy)
        self.spin(1)
        self.assertEqual(called, ['1'])

    def test_a_failed_callback_and_a_broken_message_leave_their_group(self) -> None:
        publish, called, node = self.flood()
        subscription, = [one for one in node.subscriptions if one.topic.endswith('flood')]
        good, codec = subscription.callback, subscription._codec

        def fail(_: Any) -> None:
            raise ZeroDivisionError
        subscription.callback = fail
        publish('1', '2', '3')
        with self.assertRaises(ZeroDivisionError):
            self.spin(1)
        subscription.callback = good
        with mock.patch.object(codec, 'read', fail, create=True), self.assertRaises((TypeError, ZeroDivisionError)):
            self.spin(1)
        self.spin(1)
        self.assertEqual(called, ['3'])

    def test_a_message_larger_than_all_before_comes_after_small_ones(self) -> None:
        publish, called, _ = self.flood()
        large = 'x' * 300_000
        publish('1', large, '2', large)
        self.spin(4)
        self.assertEqual(called, ['1', large, '2', large])

    def test_events_are_told_when_statuses_change(self) -> None:
        events = importlib.import_module('rclpy.event_handler')
        string = importlib.import_module('std_msgs.msg').String
        matched = int(importlib.import_module('ros2wasm.constants').StatusKind.PUBLICATION_MATCHED)
        version, status = 0, (0, 0, 0, 0, 0)
        told: list[int] = []

        def fill(_handle: int, kind: int, out: int) -> int:
            nonlocal status
            if kind != matched:
                return -1
            self.bus._memory(out, 32)[:] = struct.pack('<8i', *status, 0, 0, 0)
            status = (status[0], 0, status[2], 0, 0)
            return 0
        self.replace('endpoint_status', fill)
        self.replace('status_version', lambda: version)
        self.node('told').create_publisher(string, 'words', 10, event_callbacks=events.PublisherEventCallbacks(
            matched=lambda info: told.append(info.total_count), use_default_callbacks=False))
        for count in (1, 2):
            for _ in range(3):
                self.executor.spin_once(timeout_sec=0)
            self.assertEqual(len(told), count - 1)
            version, status = version + 1, (count, 1, count, 1, 0)
            self.spin_until(lambda: len(told) == count)
        self.assertEqual(told, [1, 2])

    def test_bytes_of_messages_larger_than_all_before(self) -> None:
        serialization = importlib.import_module('rclpy.serialization')
        string = importlib.import_module('std_msgs.msg').String
        for power in (4, 16, 17, 18, 19, 5):
            text = 'x' * (2 ** power + 1)
            data = serialization.serialize_message(string(data=text))
            self.assertEqual(len(data), 4 + 4 + len(text) + 1)
            self.assertEqual(serialization.deserialize_message(data, string).data, text)

    def test_a_call_that_nobody_answers_in_time_brings_nothing(self) -> None:
        client = self.own.create_client(self.trigger, 'nobody')
        for timeout in (0.01, 0, -1):
            with self.subTest(timeout=timeout):
                self.assertIsNone(client.call(self.trigger.Request(), timeout_sec=timeout))
                self.assertEqual(client._pending_requests, {})

    def test_a_service_is_waited_for_no_longer_than_said(self) -> None:
        client = self.own.create_client(self.trigger, 'service')
        for timeout in (0.01, 0, -1):
            self.assertFalse(client.wait_for_service(timeout))
        self.own.create_service(self.trigger, 'service', lambda _, answer: answer)
        for maybe in (None, 0, -1):
            self.assertTrue(client.wait_for_service(maybe))

    def test_messages_in_a_row_are_heard_whatever_their_callbacks_do(self) -> None:
        string = importlib.import_module('std_msgs.msg').String
        executors = importlib.import_module('rclpy.executors')
        node = self.node('row')
        executor = executors.SingleThreadedExecutor(context=node.context)
        executor.add_node(node)
        heard: list[str] = []
        after = importlib.import_module('rclpy.task').Future(executor=executor)

        async def wait(word: str) -> None:
            await after
            heard.append(f'{word} at last')

        def hear(message: Any) -> Any:
            heard.append(message.data)
            if message.data == 'fails':
                raise ZeroDivisionError(message.data)
            if message.data == 'ends':
                executor.remove_node(node)
            return wait(message.data) if message.data == 'waits' else None
        node.create_subscription(string, 'words', hear, 10)
        publisher = node.create_publisher(string, 'words', 10)
        words = ['a', 'b', 'fails', 'c', 'waits', 'd', 'ends', 'e']
        for word in words:
            publisher.publish(string(data=word))
        for word in words[:5]:
            if word == 'fails':
                with self.assertRaises(ZeroDivisionError):
                    executor.spin_once(0.01)
            else:
                executor.spin_once(0.01)
        self.assertEqual(heard, words[:5])
        # Its group is held until the coroutine ends.
        executor.spin_once(0.01)
        self.assertEqual(heard, words[:5])
        after.set_result(None)
        for _ in range(8):
            executor.spin_once(0.01)
        self.assertEqual(heard, [*words[:5], 'waits at last', 'd', 'ends'])
        node.context.shutdown()
        with self.assertRaises(executors.ExternalShutdownException):
            executor.spin_once(0.01)

    def test_a_double_is_nearly_at_an_end_or_a_step_of_its_range_and_an_integer_is(self) -> None:
        msg = importlib.import_module('rcl_interfaces.msg')
        parameter = importlib.import_module('rclpy.parameter').Parameter
        self.own.declare_parameter('gain', 0.5, msg.ParameterDescriptor(
            floating_point_range=[msg.FloatingPointRange(from_value=1.0, to_value=0.0, step=0.1)]))
        self.own.declare_parameter('count', 4, msg.ParameterDescriptor(
            integer_range=[msg.IntegerRange(from_value=2, to_value=9, step=2)]))

        def reason(name: str, value: float) -> str:
            result = self.own.set_parameters([parameter(name, value=value)])[0]
            self.assertEqual(result.successful, not result.reason)
            return str(result.reason)
        for value in (0.0, 1.0000005, 0.3, 0.7000004):
            self.assertEqual(reason('gain', value), '')
        self.assertEqual(reason('gain', 0.70001), 'The parameter value for gain is not close enough to a valid step. '
                         'Min: 0.0, max: 1.0, value: 0.70001, step: 0.1')
        self.assertEqual(reason('gain', 1.00001), 'Parameter gain out of range Min: 0.0, Max: 1.0, value: 1.00001')
        self.assertEqual([reason('count', value) for value in (2, 8, 9)], ['', '', ''])
        self.assertEqual(reason('count', 7), 'The parameter value for count is not a valid step. '
                         'Min: 2, max: 9, value: 7, step: 2')
        self.assertEqual(reason('count', 10), 'Parameter count out of range. Min: 2, Max: 9, value: 10')

    def test_parameters_of_another_node_are_listed_and_heard_of(self) -> None:
        module = importlib.import_module('rclpy.parameter_client')
        client = module.AsyncParameterClient(self.own, self.node('other').get_name())
        self.assertTrue(client.wait_for_services(0))
        listed = self.result(client.list_parameters([], None))
        self.assertIn('use_sim_time', listed.result.names)
        events: list[str] = []
        client.on_parameter_event(lambda event: events.extend(one.name for one in event.changed_parameters))
        parameter = importlib.import_module('rclpy.parameter').Parameter('use_sim_time', value=True)
        self.result(client.set_parameters([parameter]))
        self.spin_until(lambda: events == ['use_sim_time'])

    def test_a_wait_for_a_message_leaves_nothing_behind(self) -> None:
        wait: Any = importlib.import_module('rclpy.wait_for_message').wait_for_message
        string = importlib.import_module('std_msgs.msg').String
        publisher = self.own.create_publisher(string, 'chatter', 1)
        before = list(self.own.waitables), list(self.own.subscriptions), set(self.bus.endpoints)
        self.assertEqual(wait(string, self.own, 'chatter', time_to_wait=0.01), (False, None))
        create = self.own.create_subscription

        def create_and_publish(*args: Any, **options: Any) -> Any:
            made = create(*args, **options)
            publisher.publish(string(data='heard'))
            return made
        self.own.create_subscription = create_and_publish
        self.assertEqual(wait(string, self.own, 'chatter'), (True, string(data='heard')))
        self.assertEqual((list(self.own.waitables), list(self.own.subscriptions), set(self.bus.endpoints)), before)

    def test_what_a_node_has_is_handed_out_one_by_one(self) -> None:
        string = importlib.import_module('std_msgs.msg').String
        empty = importlib.import_module('std_srvs.srv').Empty
        made = {
            'publishers': self.own.create_publisher(string, 'out', 1),
            'subscriptions': self.own.create_subscription(string, 'in', lambda _: None, 1),
            'clients': self.own.create_client(empty, 'ask'),
            'services': self.own.create_service(empty, 'answer', lambda _, response: response),
            'timers': self.own.create_timer(1.0, lambda: None),
            'guards': self.own.create_guard_condition(lambda: None),
        }
        for name, entity in made.items():
            several = getattr(self.own, name)
            self.assertIn(entity, [next(several), *several], name)
        self.own.add_waitable(made)
        self.assertIn(made, self.own.waitables)
        self.own.remove_waitable(made)

    def test_a_value_of_a_wrong_type_is_named_when_it_is_published(self) -> None:
        std, geometry = importlib.import_module('std_msgs.msg'), importlib.import_module('geometry_msgs.msg')
        wrong_twist = geometry.Twist()
        wrong_twist.linear.y = 'fast'
        part = geometry.Point()
        part.z = None
        layout = std.MultiArrayLayout(dim=[std.MultiArrayDimension(label='x'), std.MultiArrayDimension(label=3)])
        for message, text in (
            (std.String(data=5), "The 'data' field must be of type 'str': std_msgs/msg/String has a 'int', 5"),
            (std.String(data=None), "The 'data' field must be of type 'str': std_msgs/msg/String has a 'NoneType'"),
            (std.Int32(data=1.5), "The 'data' field must be of type 'int': std_msgs/msg/Int32 has a 'float', 1.5"),
            (std.UInt8(data=256), r"The 'data' field must be an unsigned integer in \[0, 255\]"),
            (std.Bool(data='no'), "The 'data' field must be of type 'bool'"),
            (std.Header(stamp=4.2), "The 'stamp' field must be a sub message of type 'Time': std_msgs/msg/Header has"),
            (wrong_twist, "The 'y' field must be of type 'float': geometry_msgs/msg/Vector3 has a 'str', 'fast', "
                          "in 'linear' of geometry_msgs/msg/Twist"),
            (geometry.Polygon(points=[geometry.Point32(), 7]), "The 'points' field must be a set or sequence and each"),
            (geometry.Polygon(points=3), "The 'points' field must be a set or sequence and each value of type"),
            (geometry.Pose(position=part), "The 'z' field must be of type 'float'.*in 'position' of geometry_msgs"),
            (std.Int32MultiArray(layout=layout), r"The 'label' .* in 'dim\[1\]' of .*, in 'layout' of std_msgs"),
        ):
            publisher = self.own.create_publisher(type(message), 'wrong', 1)
            with self.assertRaisesRegex(AssertionError, text):
                publisher.publish(message)
            # The next one that is right goes out.
            publisher.publish(type(message)())
        service = importlib.import_module('example_interfaces.srv').AddTwoInts
        with self.assertRaisesRegex(AssertionError, "The 'a' field must be of type 'int'"):
            self.own.create_client(service, 'add').call_async(service.Request(a='1'))


if __name__ == '__main__':
    unittest.main()
