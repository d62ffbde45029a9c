"""Buffers that wait, registrations, and messages in other frames, with the bus left out."""
from __future__ import annotations

import importlib
import math
import unittest
import unittest.mock
from types import SimpleNamespace
from typing import Any

from tests.unit.rclpy.installation import install, install_host
from tests.unit.tf2_py.frames import at, transform, yaw_of


class FakeNode:
    """Notes what is made and what is published."""

    def __init__(self) -> None:
        self.made: list[tuple[str, Any]] = []
        self.published: list[Any] = []

    def create_publisher(self, _type: Any, topic: str, qos: Any) -> Any:
        self.made.append((topic, qos))
        return SimpleNamespace(publish=lambda message: self.published.append(list(message.transforms)))

    def create_subscription(self, _type: Any, topic: str, callback: Any, qos: Any, **_: Any) -> Any:
        self.made.append((topic, qos))
        return callback

    def destroy_subscription(self, _: Any) -> None:
        del self.made[-1:]


class Tf2RosTest(unittest.TestCase):
    tf2_ros: Any
    msg: Any

    @classmethod
    def setUpClass(cls) -> None:
        install(cls, 'tf2_py', 'tf2_ros_py', 'tf2_geometry_msgs')
        install_host(cls)
        cls.tf2_ros = importlib.import_module('tf2_ros')
        cls.msg = importlib.import_module('geometry_msgs.msg')

    def setUp(self) -> None:
        self.buffer = self.tf2_ros.Buffer()

    def put(self, *args: Any) -> None:
        self.buffer.set_transform(transform(*args), 'me')

    def result_of(self, coroutine: Any) -> Any:
        with self.assertRaises(StopIteration) as end:
            coroutine.send(None)
        return end.exception.value

    def test_an_awaited_transform_that_is_there(self) -> None:
        self.put('a', 'b', 1, 2.0)
        found = self.result_of(self.buffer.lookup_transform_async('a', 'b', at(1)))
        self.assertEqual(found, transform('a', 'b', 1, 2.0))
        found = self.result_of(self.buffer.lookup_transform_full_async('a', at(1), 'b', at(1), 'a'))
        self.assertEqual(found.transform.translation.x, 2)

    def test_an_awaited_transform_that_comes(self) -> None:
        one = self.buffer.lookup_transform_async('a', 'c', at(1))
        full = self.buffer.lookup_transform_full_async('a', at(1), 'c', at(1), 'b')
        one.send(None), full.send(None)
        self.put('a', 'b', 1, 2.0)
        self.assertEqual(len(self.buffer._new_data_callbacks), 2)
        self.put('b', 'c', 1, 2.0)
        for waiting in (one, full):
            self.assertEqual(self.result_of(waiting).transform.translation.x, 4)
        self.assertEqual(self.buffer._new_data_callbacks, [])

    def test_a_wait_that_is_given_up_is_forgotten(self) -> None:
        self.buffer.wait_for_transform_async('a', 'b', at(1)).cancel()
        self.put('a', 'b', 1, 2.0)
        self.assertEqual(self.buffer._new_data_callbacks, [])

    def test_a_lookup_blocks_until_its_time_is_over_or_somebody_tells(self) -> None:
        module = importlib.import_module('tf2_ros.buffer')
        duration = importlib.import_module('rclpy.duration').Duration
        slept = [0.0]

        def sleep(seconds: float) -> None:
            slept[0] += seconds
            if slept[0] > 0.1:
                self.put('a', 'b', 1, 2.0)
        time = importlib.import_module('rclpy.time').Time
        clock = SimpleNamespace(now=lambda: time(nanoseconds=round(slept[0] * 1e9) + 10 ** 15))
        with unittest.mock.patch.object(module, 'Clock', lambda: clock), \
                unittest.mock.patch.object(module.python_time, 'sleep', sleep):
            with self.assertRaises(self.tf2_ros.LookupException):
                self.buffer.lookup_transform('a', 'b', at(0), duration(seconds=0.05))
            self.assertAlmostEqual(slept[0], 0.06)
            self.assertEqual(
                self.buffer.lookup_transform('a', 'b', at(0), timeout=duration(seconds=5)).child_frame_id, 'b')
            self.assertAlmostEqual(slept[0], 0.12)
        self.assertEqual(self.buffer.can_transform('a', 'x', at(0), return_debug_tuple=True), (
            0, 'Invalid frame ID "x" passed to canTransform argument source_frame - frame does not exist'))
        self.assertEqual(self.buffer.can_transform_full('a', at(1), 'b', at(1), 'a'), 1)

    def test_a_clock_that_goes_back_clears_the_buffer(self) -> None:
        node = SimpleNamespace(create_service=lambda *_: None,
                               get_clock=lambda: importlib.import_module('rclpy.clock').ROSClock())
        self.buffer = self.tf2_ros.Buffer(node=node)
        self.put('a', 'b', 1, 2.0)
        self.buffer.clock.set_ros_time_override(at(10))
        self.buffer.clock._set_ros_time_is_active(True)
        self.put('a', 'b', 1, 2.0)
        self.buffer.clock.set_ros_time_override(at(9.5))
        self.assertEqual(self.buffer.can_transform('a', 'b', at(0)), 1)
        self.buffer.clock.set_ros_time_override(at(5))
        self.assertEqual(self.buffer.can_transform('a', 'b', at(0)), 0)

    def test_broadcasters(self) -> None:
        node = FakeNode()
        moving = self.tf2_ros.TransformBroadcaster(node)
        a, b, c = transform('m', 'a', 1, 1.0), transform('m', 'b', 1, 1.0), transform('m', 'a', 2, 2.0)
        moving.sendTransform(a)
        moving.sendTransform((b, c))
        self.assertEqual(node.published, [[a], [b, c]])
        node.published.clear()
        still = self.tf2_ros.StaticTransformBroadcaster(node)
        still.sendTransform([a])
        still.sendTransform(b)
        still.sendTransform(c)
        self.assertEqual(node.published, [[a], [a, b], [a, b]])
        self.assertEqual([(topic, qos.depth, qos.durability.name) for topic, qos in node.made],
                         [('/tf', 100, 'VOLATILE'), ('/tf_static', 1, 'TRANSIENT_LOCAL')])

    def test_a_listener(self) -> None:
        node = FakeNode()
        listener = self.tf2_ros.TransformListener(self.buffer, node)
        self.assertEqual([(topic, qos.depth, qos.durability.name) for topic, qos in node.made],
                         [('/tf', 100, 'VOLATILE'), ('/tf_static', 100, 'TRANSIENT_LOCAL')])
        message = importlib.import_module('tf2_msgs.msg').TFMessage
        listener.tf_sub(message(transforms=[transform('a', 'b', 5, 1.0), transform('b', 'c', 5, 1.0)]))
        listener.tf_static_sub(message(transforms=[transform('c', 'd', 0, 1.0)]))
        self.assertEqual(self.buffer.lookup_transform('a', 'd', at(5)).transform.translation.x, 3)
        self.assertIn("broadcaster: 'default_authority'", self.buffer.all_frames_as_yaml())
        listener.unregister()
        self.assertEqual(node.made, [])

    def test_a_buffer_of_another_node(self) -> None:
        goals: list[Any] = []
        lookup = importlib.import_module('tf2_msgs.action').LookupTransform
        result, client = lookup.Result(), unittest.mock.Mock()

        def send(goal: Any) -> Any:
            goals.append(goal)
            sent = importlib.import_module('rclpy.task').Future()
            if goal.target_frame != 'nowhere':
                sent.set_result(SimpleNamespace(accepted=goal.target_frame != 'refused'))
            return sent
        client.send_goal_async = send
        client._get_result.return_value = SimpleNamespace(result=result)
        duration = importlib.import_module('rclpy.duration').Duration
        with unittest.mock.patch('tf2_ros.buffer_client.ActionClient', return_value=client):
            remote = self.tf2_ros.BufferClient(object(), 'tf2_buffer_server', timeout_padding=duration())
        result.transform = transform('a', 'b', 1, 2.0)
        self.assertIs(remote.lookup_transform('a', 'b', at(1.5), duration(seconds=2.25)), result.transform)
        goal, = goals
        self.assertEqual((goal.target_frame, goal.source_frame, goal.source_time.sec, goal.timeout.nanosec,
                          goal.advanced),
                         ('a', 'b', 1, 250000000, False))
        remote.lookup_transform_full('a', at(1), 'b', at(2), 'map')
        self.assertEqual((goals[1].target_time.sec, goals[1].source_time.sec, goals[1].fixed_frame, goals[1].advanced),
                         (1, 2, 'map', True))
        result.error.error, result.error.error_string = result.error.LOOKUP_ERROR, 'no such frame'
        with self.assertRaisesRegex(self.tf2_ros.LookupException, 'no such frame'):
            remote.lookup_transform('a', 'b', at(1))
        self.assertFalse(remote.can_transform('a', 'b', at(1)))
        for target, said in (('nowhere', 'did not answer in time'), ('refused', 'did not accept')):
            with self.assertRaisesRegex(self.tf2_ros.TimeoutException, said):
                remote.lookup_transform(target, 'b', at(1))
        with self.assertRaises(TypeError):
            remote.lookup_transform('a', 'b', 1.0)

    def test_conversions(self) -> None:
        known = self.tf2_ros.ConvertRegistration()

        class Mine:
            def __init__(self, x: float) -> None:
                self.x = x
        known.add_to_msg(Mine, lambda mine: self.msg.Point(x=mine.x))
        known.add_from_msg(Mine, lambda point: Mine(point.x))
        known.add_from_msg(self.msg.Point, lambda point: point)
        self.assertEqual(self.tf2_ros.convert(Mine(2.0), self.msg.Point).x, 2)
        mine = Mine(3.0)
        copy = self.tf2_ros.convert(mine, Mine)
        self.assertTrue(copy is not mine and copy.x == 3)
        known.add_convert((Mine, str), lambda mine: str(mine.x))
        self.assertEqual(self.tf2_ros.convert(mine, str), '3.0')
        with self.assertRaisesRegex(self.tf2_ros.TypeException, "Type <class 'int'> is not loaded or supported"):
            self.tf2_ros.convert(1, str)
        with self.assertRaises(self.tf2_ros.NotImplementedException):
            self.tf2_ros.BufferInterface().lookup_transform('a', 'b', at(0))
        stamped = self.tf2_ros.Stamped(self.msg.PointStamped(), at(1).to_msg(), 'map')
        self.assertEqual((stamped.header.frame_id, stamped.header.stamp.sec), ('map', 1))

    def test_messages_in_other_frames(self) -> None:
        importlib.import_module('tf2_geometry_msgs')
        self.put('map', 'base', 3, 1.0, math.pi / 2)
        header = importlib.import_module('std_msgs.msg').Header(frame_id='base', stamp=at(3).to_msg())
        point = self.buffer.transform(self.msg.PointStamped(header=header, point=self.msg.Point(x=2.0)), 'map')
        self.assertAlmostEqual(point.point.x, 1)
        self.assertAlmostEqual(point.point.y, 2)
        self.assertEqual((point.header.frame_id, point.header.stamp.sec), ('map', 3))
        vector = self.buffer.transform(self.msg.Vector3Stamped(header=header, vector=self.msg.Vector3(x=2.0)), 'map')
        self.assertAlmostEqual(vector.vector.x, 0)
        self.assertAlmostEqual(vector.vector.y, 2)
        pose = self.msg.PoseStamped(header=header)
        pose.pose.position.x = 2.0
        moved = self.buffer.transform(pose, 'map', new_type=self.msg.PoseStamped)
        self.assertAlmostEqual(moved.pose.position.y, 2)
        self.assertAlmostEqual(yaw_of(moved.pose.orientation), math.pi / 2)
        polygon = self.msg.PolygonStamped(header=header)
        polygon.polygon.points = [self.msg.Point32(x=1.0), self.msg.Point32(x=2.0)]
        self.assertAlmostEqual(self.buffer.transform(polygon, 'map').polygon.points[1].y, 2)
        full = self.buffer.transform_full(pose, 'map', at(3), 'map')
        self.assertEqual(full, moved)
        with self.assertRaisesRegex(self.tf2_ros.TypeException, 'is not loaded or supported'):
            self.buffer.transform(header, 'map')

    # Compatibility, differs: `tf2_geometry_msgs.do_transform_vector3` of Python -> leaves the transform that it is
    # given as it is; that of ROS 2 sets its translation to zero
    def test_a_vector_is_turned_alone(self) -> None:
        module = importlib.import_module('tf2_geometry_msgs')
        quarter = transform('map', 'base', 3, 7.0, math.pi / 2)
        turned = module.do_transform_vector3(
            self.msg.Vector3Stamped(vector=self.msg.Vector3(x=1.0)), quarter)
        self.assertAlmostEqual(turned.vector.x, 0)
        self.assertAlmostEqual(turned.vector.y, 1)
        self.assertEqual(quarter, transform('map', 'base', 3, 7.0, math.pi / 2))
        # Four zeros are no turn.
        pose = self.msg.Pose(position=self.msg.Point(x=2.0), orientation=self.msg.Quaternion(w=0.0))
        moved = module.do_transform_pose(pose, transform('map', 'base', 3, 7.0))
        self.assertEqual((moved.position.x, moved.orientation.w), (9, 1))

    def test_covariances_turn_quarter_by_quarter(self) -> None:
        module = importlib.import_module('tf2_geometry_msgs')
        half = transform('map', 'base', 3, 1.0)
        half.transform.rotation.w, half.transform.rotation.x = 0.0, 1.0
        pose = self.msg.PoseWithCovarianceStamped()
        pose.pose.covariance = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0] * 6
        pose.pose.pose.orientation.w, pose.pose.pose.orientation.x = 0.0, 1.0
        pose.pose.pose.position.x, pose.pose.pose.position.y = 1.0, 2.0
        out = module.do_transform_pose_with_covariance_stamped(pose, half)
        first, other = [1.0, -2.0, -3.0, 4.0, -5.0, -6.0], [-1.0, 2.0, 3.0, -4.0, 5.0, 6.0]
        self.assertEqual(list(out.pose.covariance), [*first, *other, *other, *first, *other, *other])
        at_ = out.pose.pose
        self.assertEqual((at_.position.x, at_.position.y, at_.position.z), (2, -2, 0))
        self.assertEqual((at_.orientation.x, at_.orientation.w), (0, 1))


if __name__ == '__main__':
    unittest.main()
