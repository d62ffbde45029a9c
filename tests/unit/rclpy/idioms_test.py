"""Idioms of course code that others have written: what their nodes call and read of rclpy, in the ways they do."""
from __future__ import annotations

import importlib
import math
import sys
import threading
import unittest
import unittest.mock
from functools import partial
from typing import Any

from tests.unit.rclpy.fake_bus import BusTest


class IdiomsTest(BusTest):
    def setUp(self) -> None:
        super().setUp()
        self.own: Any = self.node('idioms', parameter_overrides=[])
        self.said: list[Any] = []

    def test_modules_are_there_without_an_import_of_their_own(self) -> None:
        for name in (
            'time.Time', 'duration.Duration', 'qos.qos_profile_sensor_data', 'executors.MultiThreadedExecutor',
            'parameter.Parameter', 'clock.Clock', 'logging.get_logger', 'logging.LoggingSeverity.DEBUG',
            'exceptions.ROSInterruptException', 'get_default_context', 'spin_once', 'uninstall_signal_handlers',
            'task.Future', 'callback_groups.ReentrantCallbackGroup', 'node.Node', 'timer.Timer', 'publisher.Publisher',
            'subscription.Subscription', 'service.Service', 'client.Client', 'context.Context',
            'utilities.get_default_context',
            'signals.SignalHandlerOptions', 'validate_topic_name.validate_topic_name', 'get_global_executor',
            'create_node', 'ok', 'try_shutdown', 'spin_until_future_complete', 'clock.ClockType.STEADY_TIME',
            'constants.S_TO_NS',
        ):
            found = self.rclpy
            for part in name.split('.'):
                found = getattr(found, part)
        importlib.import_module('rclpy.action.server').ServerGoalHandle
        importlib.import_module('rclpy.action.client').ClientGoalHandle

    # Compatibility, differs: content filters of rclpy's subscriptions (since rclpy 7.1.8), and the look at the
    # signature of parameter callbacks (since 7.1.4) -> missing; rclcpp's content filters are there
    def test_what_is_newer_in_rclpy_is_missing_by_its_name(self) -> None:
        self.assertFalse(hasattr(self.rclpy.subscription.Subscription, 'set_content_filter'))
        self.own.add_on_set_parameters_callback(lambda: None)

    def test_utilities(self) -> None:
        utilities = importlib.import_module('rclpy.utilities')
        args = ['prog', '--name', 'x', '--ros-args', '-r', '__node:=n', '-p', 'a:=1', '--', '--last']
        self.assertEqual(utilities.remove_ros_args(args), ['prog', '--name', 'x', '--last'])
        self.assertEqual(utilities.remove_ros_args(['prog', '--ros-args', '--log-level', 'debug']), ['prog'])
        self.assertEqual(utilities.remove_ros_args([]), [])
        with unittest.mock.patch.object(sys, 'argv', ['prog', '--ros-args', '-p', 'a:=1', '--', 'more']):
            self.assertEqual(utilities.remove_ros_args(), ['prog', 'more'])
        self.assertEqual([utilities.timeout_sec_to_nsec(one) for one in (None, -1, 0, 0.5)], [-1, -1, 0, 500_000_000])

    def test_parameters(self) -> None:
        rclpy, own = self.rclpy, self.own
        Parameter = rclpy.parameter.Parameter
        msg = importlib.import_module('rcl_interfaces.msg')
        self.assertEqual(own.declare_parameter('frame', 'base').get_parameter_value().string_value, 'base')
        own.declare_parameters(namespace='', parameters=[
            ('kp', 1.0), ('gains', [1.0, 2.0]), ('names', ['a', 'b']), ('open', Parameter.Type.STRING),
            ('limit', 3, msg.ParameterDescriptor(integer_range=[msg.IntegerRange(from_value=0, to_value=5, step=1)]))])
        self.assertEqual([one.value for one in own.get_parameters(['kp', 'limit'])], [1.0, 3])
        self.assertEqual(list(own.get_parameter('gains').get_parameter_value().double_array_value), [1.0, 2.0])
        self.assertEqual(own.get_parameter('names').value, ['a', 'b'])
        self.assertEqual(own.get_parameter_or('nobody', Parameter('nobody', Parameter.Type.INTEGER, 7)).value, 7)
        self.assertTrue(own.has_parameter('kp'))

        def changed(parameters: Any) -> Any:
            for one in parameters:
                self.said.append((one.name, one.value, one.type_ == Parameter.Type.DOUBLE))
            return msg.SetParametersResult(successful=all(one.value != 13.0 for one in parameters), reason='')
        own.add_on_set_parameters_callback(changed)
        results = own.set_parameters([Parameter('kp', Parameter.Type.DOUBLE, 2.0), Parameter('kp', value=13.0)])
        self.assertEqual([one.successful for one in results], [True, False])
        self.assertFalse(own.set_parameters([Parameter('limit', value=6)])[0].successful)
        self.assertEqual(self.said[:2], [('kp', 2.0, True), ('kp', 13.0, True)])
        self.assertEqual(own._parameters.get('kp').value, 2.0)
        self.assertEqual(Parameter.from_parameter_msg(Parameter('x', value=[True]).to_parameter_msg()).value, [True])
        own.declare_parameter('arm.speed', 1)
        self.assertEqual([*own.get_parameters_by_prefix('arm')], ['speed'])
        own.undeclare_parameter('frame')
        with self.assertRaises(rclpy.exceptions.ParameterNotDeclaredException):
            own.get_parameter('frame')
        own.remove_on_set_parameters_callback(changed)

    def test_time(self) -> None:
        rclpy, own = self.rclpy, self.own
        Time, Duration = rclpy.time.Time, rclpy.duration.Duration
        begin = own.get_clock().now()
        self.assertGreaterEqual((own.get_clock().now() - begin).nanoseconds * 1e-9, 0.0)
        self.assertEqual((Time(seconds=3) + Duration(seconds=0.5)).nanoseconds, 3_500_000_000)
        self.assertEqual(Time(seconds=1.5).seconds_nanoseconds(), (1, 500_000_000))
        stamp = begin.to_msg()
        self.assertEqual(Time.from_msg(stamp, clock_type=begin.clock_type), begin)
        self.assertEqual(stamp.sec * 10**9 + stamp.nanosec, begin.nanoseconds)
        self.assertTrue(begin < begin + Duration(nanoseconds=1) and Duration(seconds=1) > Duration())
        self.assertEqual(Duration(seconds=2).to_msg().sec, 2)
        self.assertGreater(rclpy.clock.Clock(clock_type=rclpy.clock.ClockType.STEADY_TIME).now().nanoseconds, 0)
        self.assertTrue(own.get_clock().sleep_for(Duration(seconds=0.001), self.context))

    def test_messages_in_the_ways_of_students(self) -> None:
        nav, geometry, sensor, std = (
            importlib.import_module(f'{name}_msgs.msg') for name in ('nav', 'geometry', 'sensor', 'std'))
        heard: dict[str, Any] = {}

        def through(message: Any) -> Any:
            name = f'topic_{len(heard)}'
            own = self.own
            own.create_subscription(
                msg_type=type(message), topic=name, callback=partial(heard.__setitem__, name), qos_profile=10)
            own.create_publisher(msg_type=type(message), topic=name, qos_profile=10).publish(message)
            self.spin_until(lambda: name in heard)
            return heard[name]
        scan = sensor.LaserScan()
        scan.angle_min, scan.angle_max = -math.pi, math.pi
        scan.ranges = [1, 2.5, float('inf'), 4]
        scan = through(scan)
        self.assertEqual(min(scan.ranges), 1.0)
        self.assertEqual(sorted(scan.ranges[1:3]) + list(scan.intensities), [2.5, float('inf')])
        self.assertEqual([i for i, one in enumerate(scan.ranges) if math.isinf(one)], [2])
        twist = geometry.Twist()
        twist.linear.x = 2
        twist.angular = geometry.Vector3(z=min(1.0, 5))
        self.assertEqual((through(twist).linear.x, twist == through(twist)), (2.0, True))
        grid = nav.OccupancyGrid(info=nav.MapMetaData(width=2, height=1))
        grid.info.origin.position.x, grid.info.origin.position.y = -1.0, -2.0
        grid.data = [-1, 100]
        self.assertEqual(list(through(grid).data), [-1, 100])
        path = nav.Path()
        for x in range(3):
            pose = geometry.PoseStamped()
            pose.header.frame_id, pose.pose.position.x = 'map', float(x)
            path.poses.append(pose)
        self.assertEqual([one.pose.position.x for one in through(path).poses], [0.0, 1.0, 2.0])
        field = sensor.PointField(name='x', datatype=sensor.PointField.FLOAT32)
        cloud = sensor.PointCloud2(data=b'\1\2', fields=[field])
        self.assertEqual(bytes(through(cloud).data), b'\1\2')
        joints = sensor.JointState(name=['a'], position=(1.0,))
        self.assertEqual(dict(zip(through(joints).name, joints.position)), {'a': 1.0})
        array = std.Float64MultiArray()
        array.data.extend(float(x) for x in range(2))
        self.assertEqual(through(array).data.tolist(), [0.0, 1.0])
        self.assertTrue(bool(array.data) and len(through(std.Int32MultiArray(data=[1, 2])).data) == 2)
        odometry = nav.Odometry()
        odometry.pose.covariance[0] = 0.1
        self.assertEqual(through(odometry).pose.covariance[0], 0.1)
        self.assertIn('linear=geometry_msgs.msg.Vector3(x=2', str(twist))

    def test_names_and_what_else_a_node_tells(self) -> None:
        string = importlib.import_module('std_msgs.msg').String
        own = self.own
        publisher = own.create_publisher(string, 'out', 10)
        names = own.get_name(), own.get_namespace(), own.get_fully_qualified_name()
        self.assertEqual(names, ('idioms', '/', '/idioms'))
        self.assertEqual((publisher.topic_name, publisher.topic, own.resolve_topic_name('x')), ('/out', 'out', '/x'))
        subscription = own.create_subscription(string, 'out', self.said.append, self.rclpy.qos.qos_profile_sensor_data)
        self.assertEqual((publisher.get_subscription_count(), subscription.get_publisher_count()), (1, 1))
        logger = own.get_logger()
        logger.set_level(self.rclpy.logging.LoggingSeverity.DEBUG)
        for level in ('debug', 'info', 'warn', 'warning', 'error', 'fatal'):
            getattr(logger, level)('said')
        for _ in range(2):
            logger.info('said', throttle_duration_sec=1.0, skip_first=True)
        own._logger.info('one of those that others should not call', once=True)
        self.assertEqual(logger.get_child('part').name, 'idioms.part')
        self.assertTrue(own.destroy_publisher(publisher) and own.destroy_subscription(subscription))
        self.assertIs(own.executor, self.executor)
        self.assertTrue(own.context.ok())

    def test_timers_and_clients_in_callbacks(self) -> None:
        own = self.own
        trigger = importlib.import_module('std_srvs.srv').Trigger
        ticks: list[int] = []

        def tick() -> None:
            ticks.append(len(ticks))
            if len(ticks) == 3:
                timer.cancel()
        timer = own.create_timer(timer_period_sec=0.001, callback=tick)
        self.spin_until(lambda: len(ticks) == 3)
        self.assertTrue(timer.is_canceled())
        timer.reset()
        self.spin_until(lambda: len(ticks) > 3)
        own.destroy_timer(timer)

        def answer(_: Any, response: Any) -> Any:
            response.success, response.message = True, 'done'
            return response
        own.create_service(srv_type=trigger, srv_name='trigger', callback=answer)
        client = own.create_client(trigger, 'trigger')
        while not client.wait_for_service(timeout_sec=1.0):
            own.get_logger().info('waiting')
        future = client.call_async(trigger.Request())
        future.add_done_callback(partial(lambda name, done: self.said.append((name, done.result().message)), 'bound'))
        self.rclpy.spin_until_future_complete(own, future, self.executor, timeout_sec=5.0)
        self.assertEqual((future.done(), future.exception()), (True, None))
        # Natively the callback is the executor's affair, too.
        self.spin_until(lambda: self.said == [('bound', 'done')])
        self.assertEqual((client.srv_name, client.service_name), ('trigger', '/trigger'))
        self.assertTrue(client.service_is_ready())

    def test_an_action_as_tutorials_write_it(self) -> None:
        action = importlib.import_module('rclpy.action')
        fibonacci = importlib.import_module('example_interfaces.action').Fibonacci
        status = importlib.import_module('action_msgs.msg').GoalStatus
        own = self.own

        def execute(goal_handle: Any) -> Any:
            feedback = fibonacci.Feedback()
            feedback.sequence = [0, 1]
            for i in range(1, goal_handle.request.order):
                if goal_handle.is_cancel_requested:
                    goal_handle.canceled()
                    return fibonacci.Result()
                feedback.sequence.append(feedback.sequence[i] + feedback.sequence[i - 1])
                goal_handle.publish_feedback(feedback)
            goal_handle.succeed()
            result = fibonacci.Result()
            result.sequence = feedback.sequence
            return result
        action.ActionServer(
            own, fibonacci, 'fibonacci', execute_callback=execute,
            goal_callback=lambda goal: action.GoalResponse.ACCEPT,
            cancel_callback=lambda handle: action.CancelResponse.ACCEPT,
            callback_group=self.rclpy.callback_groups.ReentrantCallbackGroup())
        client = action.ActionClient(own, fibonacci, 'fibonacci')
        self.assertTrue(client.wait_for_server(timeout_sec=1.0))
        goal = fibonacci.Goal()
        goal.order = 4
        handle = self.result(client.send_goal_async(
            goal, feedback_callback=lambda message: self.said.append(list(message.feedback.sequence))))
        self.assertTrue(handle.accepted)
        result = self.result(handle.get_result_async())
        self.assertEqual((result.status, list(result.result.sequence)), (status.STATUS_SUCCEEDED, [0, 1, 1, 2, 3]))
        self.assertEqual(self.said[-1], [0, 1, 1, 2, 3])

    def test_qualities_by_their_many_names(self) -> None:
        qos = importlib.import_module('rclpy.qos')
        made = qos.QoSProfile(
            reliability=qos.QoSReliabilityPolicy.BEST_EFFORT, history=qos.QoSHistoryPolicy.KEEP_LAST, depth=1,
            durability=qos.QoSDurabilityPolicy.TRANSIENT_LOCAL, liveliness=qos.QoSLivelinessPolicy.AUTOMATIC,
            deadline=self.rclpy.duration.Duration(seconds=1), lifespan=self.rclpy.duration.Duration(seconds=1))
        self.assertEqual((made.depth, made.reliability), (1, qos.ReliabilityPolicy.BEST_EFFORT))
        for name in ('sensor_data', 'system_default', 'services_default', 'parameters', 'parameter_events',
                     'best_available', 'action_status_default'):
            self.assertIsInstance(getattr(qos, f'qos_profile_{name}'), qos.QoSProfile)
        self.assertIs(qos.QoSPresetProfiles.SENSOR_DATA.value, qos.qos_profile_sensor_data)
        self.assertIs(qos.QoSPresetProfiles.get_from_short_key('sensor_data'), qos.qos_profile_sensor_data)
        changed = qos.qos_profile_system_default
        self.assertEqual(qos.QoSProfile(depth=10).reliability, qos.ReliabilityPolicy.RELIABLE)
        self.assertIsNotNone(changed.history)

    def test_locks_of_threads_beside_callbacks(self) -> None:
        lock, string = threading.Lock(), importlib.import_module('std_msgs.msg').String
        with lock:
            self.own.create_subscription(string, 'a', lambda message: self.said.append(message.data), 1)
        self.own.create_publisher(string, 'a', 1).publish(string(data='x'))
        self.spin_until(lambda: self.said == ['x'])


if __name__ == '__main__':
    unittest.main()
