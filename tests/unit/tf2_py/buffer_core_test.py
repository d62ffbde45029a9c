"""The tree of frames for Python: the same values and texts that the one for C++ is tested for."""
from __future__ import annotations

import importlib
import math
import unittest
import unittest.mock
from typing import Any

from tests.unit.rclpy.installation import install, install_host
from tests.unit.tf2_py.frames import at, seconds_of, transform, yaw_of

# Compatibility, works: tf2 for Python (`tf2_py`, `tf2_ros`, `tf2_geometry_msgs`): the buffer as the one for C++,
# with its interpolation, static frames, new parents, errors with the texts of ROS 2; lookups that block and lookups
# that are awaited


class BufferCoreTest(unittest.TestCase):
    tf2: Any

    @classmethod
    def setUpClass(cls) -> None:
        install(cls, 'tf2_py')
        install_host(cls)
        cls.tf2 = importlib.import_module('tf2_py')

    def setUp(self) -> None:
        self.buffer = self.tf2.BufferCore()

    def put(self, *args: Any, static: bool = False) -> None:
        put = self.buffer.set_transform_static if static else self.buffer.set_transform
        self.assertIsNone(put(transform(*args), 'me'))

    def look_up(self, target: str, source: str, seconds: float = 0) -> Any:
        return self.buffer.lookup_transform_core(target, source, at(seconds))

    def fails(self, error: str, text: str, target: str, source: str, seconds: float = 0) -> None:
        with self.assertRaises(self.tf2.TransformException) as raised:
            self.look_up(target, source, seconds)
        self.assertEqual((type(raised.exception).__name__, str(raised.exception)), (error, text))

    def tree(self) -> None:
        """map <- odom <- base <- arm (static), and base <- leg."""
        for t in (1.0, 2.0):
            self.put('map', 'odom', t, 10 * t)
            self.put('odom', 'base', t, t, math.pi / 2)
            self.put('base', 'leg', t, -1.0)
        self.put('base', '/arm', 0, 1.0, static=True)

    def test_up_down_and_across_the_tree(self) -> None:
        self.tree()
        up = self.look_up('map', 'arm', 1.5)
        self.assertAlmostEqual(up.transform.translation.x, 16.5)
        self.assertAlmostEqual(up.transform.translation.y, 1)
        self.assertAlmostEqual(yaw_of(up.transform.rotation), math.pi / 2)
        self.assertEqual(seconds_of(up.header.stamp), 1.5)
        self.assertEqual((up.header.frame_id, up.child_frame_id), ('map', 'arm'))
        down = self.look_up('arm', 'map', 1.5)
        self.assertAlmostEqual(down.transform.translation.x, -1)
        self.assertAlmostEqual(down.transform.translation.y, 16.5)
        across = self.look_up('leg', 'arm')
        self.assertAlmostEqual(across.transform.translation.x, 2)
        self.assertEqual(seconds_of(across.header.stamp), 2)

    def test_the_latest_time_that_all_of_the_way_has(self) -> None:
        self.tree()
        self.put('map', 'odom', 3, 30.0)
        self.assertEqual(seconds_of(self.look_up('map', 'arm').header.stamp), 2)
        self.assertEqual(seconds_of(self.look_up('base', 'arm').header.stamp), 0)
        self.assertEqual(self.buffer.get_latest_common_time('map', 'arm'), at(2))
        with self.assertRaisesRegex(self.tf2.LookupException, '"x" passed to get_latest_common_time does not exist'):
            self.buffer.get_latest_common_time('map', 'x')

    def test_across_time(self) -> None:
        self.tree()
        moved = self.buffer.lookup_transform_full_core('base', at(2), 'base', at(1), 'odom')
        self.assertAlmostEqual(moved.transform.translation.y, 1)
        self.assertEqual(seconds_of(moved.header.stamp), 2)
        self.assertEqual(self.buffer.can_transform_full_core('base', at(2), 'base', at(1), 'odom'), (1, ''))
        self.assertEqual(self.buffer.can_transform_full_core('base', at(2), 'base', at(1), 'x'), (
            0, 'Invalid frame ID "x" passed to canTransform argument fixed_frame - frame does not exist'))
        self.assertEqual(self.buffer.can_transform_full_core('base', at(5), 'base', at(1), 'odom')[0], 0)

    def test_what_is_above_both_is_not_asked(self) -> None:
        self.tree()
        self.put('odom', 'base', 5, 5.0)
        self.put('base', 'leg', 5, -5.0)
        self.assertAlmostEqual(self.look_up('arm', 'leg', 5).transform.translation.x, -6)

    def test_a_frame_in_itself(self) -> None:
        self.tree()
        same = self.look_up('leg', 'leg')
        self.assertEqual((same.transform.rotation.w, seconds_of(same.header.stamp)), (1, 2))
        self.assertEqual(seconds_of(self.look_up('x', 'x', 4).header.stamp), 4)
        self.assertEqual(self.buffer.can_transform_core('x', 'x', at(0)), (1, ''))

    def test_a_new_parent(self) -> None:
        self.tree()
        self.put('map', 'leg', 6, 7.0)
        self.assertAlmostEqual(self.look_up('map', 'leg', 6).transform.translation.x, 7)
        self.assertAlmostEqual(self.look_up('base', 'leg', 2).transform.translation.x, -1)
        # Between two parents nothing can be interpolated: the older one still holds.
        self.assertAlmostEqual(self.look_up('base', 'leg', 2.5).transform.translation.x, -1)

    def test_interpolation_turns_on_the_shorter_way(self) -> None:
        for seconds, x in ((1, 0.0), (3, 1.0), (2, 0.5)):  # out of order
            self.put('a', 'b', seconds, x, x)
        between = self.look_up('a', 'b', 2.5).transform
        self.assertAlmostEqual(between.translation.x, 0.75)
        self.assertAlmostEqual(yaw_of(between.rotation), 0.75)
        self.put('a', 'c', 1, 0.0, 3.0)
        self.put('a', 'c', 2, 0.0, -3.0)
        self.assertAlmostEqual(abs(yaw_of(self.look_up('a', 'c', 1.5).transform.rotation)), math.pi)

    def test_what_is_too_old_is_forgotten(self) -> None:
        self.put('a', 'b', 1, 0.0)
        self.put('a', 'b', 20, 1.0)
        self.put('a', 'b', 9, 0.5)
        self.assertIn('oldest_transform: 20.000000', self.buffer.all_frames_as_yaml())
        self.put('a', 'b', 10, 0.5)
        self.put('a', 'b', 20, 1.0)  # the same again is kept once
        self.assertIn('rate: 0.200\n  most_recent_transform: 20.000000\n  oldest_transform: 10.000000\n'
                      '  buffer_length: 10.000', self.buffer.all_frames_as_yaml())
        self.buffer = self.tf2.BufferCore(importlib.import_module('rclpy.duration').Duration(seconds=1))
        self.put('a', 'b', 1, 0.0)
        self.put('a', 'b', 2.5, 0.0)
        self.put('a', 'b', 2.5, 0.1)
        self.assertEqual(self.buffer.can_transform_core('a', 'b', at(1))[0], 0)

    def test_errors(self) -> None:
        self.put('a', 'b', 1, 1.0)
        self.fails('ExtrapolationException', 'Lookup would require extrapolation at time 2.000000, but only time '
                   '1.000000 is in the buffer, when looking up transform from frame [b] to frame [a]', 'a', 'b', 2)
        self.put('a', 'b', 2, 1.0)
        self.put('c', 'd', 1, 1.0)
        self.fails('LookupException', '"x" passed to lookupTransform argument source_frame does not exist. ', 'a', 'x')
        self.fails('InvalidArgumentException', 'Invalid argument "" passed to lookupTransform argument target_frame - '
                   'in tf2 frame_ids cannot be empty', '', 'a')
        self.fails('InvalidArgumentException', 'Invalid argument "/b" passed to lookupTransform argument source_frame '
                   "- in tf2 frame_ids cannot start with a '/'", 'a', '/b')
        apart = ("Could not find a connection between 'a' and 'd' because they are not part of the same tree.Tf has "
                 'two or more unconnected trees.')
        self.fails('ConnectivityException', apart, 'a', 'd')
        self.fails('ConnectivityException', apart, 'a', 'd', 1)
        self.fails('ExtrapolationException', 'Lookup would require extrapolation into the future.  Requested time '
                   '3.000000 but the latest data is at time 2.000000, when looking up transform from frame [a] to '
                   'frame [b]', 'b', 'a', 3)
        self.fails('ExtrapolationException', 'Lookup would require extrapolation into the past.  Requested time '
                   '0.500000 but the earliest data is at time 1.000000, when looking up transform from frame [b] to '
                   'frame [a]', 'a', 'b', 0.5)
        self.assertEqual(self.buffer.can_transform_core('a', 'x', at(0)), (
            0, 'Invalid frame ID "x" passed to canTransform argument source_frame - frame does not exist'))
        self.assertEqual(self.buffer.can_transform_core('a', 'd', at(0)), (0, apart))
        with self.assertRaisesRegex(TypeError, 'must be str, not int'):
            self.look_up(1, 'a')  # type: ignore[arg-type]
        with self.assertRaisesRegex(TypeError, 'time must have sec and nanosec, or nanoseconds'):
            self.buffer.lookup_transform_core('a', 'b', 5)
        self.assertEqual(self.tf2.LookupException.__module__, 'tf2')

    def test_a_loop(self) -> None:
        self.put('x', 'y', 1, 1.0)
        self.put('y', 'x', 1, 1.0)
        self.put('z', 'w', 1, 1.0)
        for seconds in (0, 1):
            with self.assertRaisesRegex(
                    self.tf2.LookupException, '^The tf tree is invalid because it contains a loop.\nFrame '):
                self.look_up('w', 'x', seconds)

    def test_what_is_not_taken(self) -> None:
        no_rotation = transform('a', 'e', 1, 1.0)
        no_rotation.transform.rotation.w = 0.0
        for wrong, said in (
                (transform('a', 'a', 1, 1.0), 'TF_SELF_TRANSFORM'), (transform('', 'e', 1, 1.0), 'TF_NO_FRAME_ID'),
                (transform('a', '', 1, 1.0), 'TF_NO_CHILD_FRAME_ID'),
                (transform('a', 'e', 1, math.nan), 'TF_NAN_INPUT'), (no_rotation, 'TF_DENORMALIZED_QUATERNION')):
            with unittest.mock.patch('rclpy.logging._root_logger') as logger:
                self.buffer.set_transform(wrong, 'me')
                self.assertTrue(logger.error.call_args[0][0].startswith(f'{said}: Ignoring transform '))
        self.assertEqual(self.buffer._getFrameStrings(), [])
        self.put('a', 'b', 100, 1.0)
        with unittest.mock.patch('rclpy.logging._root_logger') as logger:
            self.put('a', 'b', 89, 1.0)
            self.assertRegex(logger.warning.call_args[0][0], '^TF_OLD_DATA ignoring data from the past for frame b at '
                             'time 89.000000 according to authority me\n')

    def test_a_quaternion_of_any_length_and_sign(self) -> None:
        message = transform('a', 'b', 1, 1.0)
        message.transform.rotation.w, message.transform.rotation.x = -2.0, 2.0
        self.buffer.set_transform(message, 'me')
        rotation = self.look_up('a', 'b').transform.rotation
        self.assertAlmostEqual(rotation.w, math.sqrt(0.5))
        self.assertAlmostEqual(rotation.x, -math.sqrt(0.5))

    def test_views(self) -> None:
        self.assertEqual(self.buffer.all_frames_as_yaml(), '[]')
        self.tree()
        self.assertIn('Frame arm exists with parent base.\n', self.buffer.all_frames_as_string())
        self.assertIn("arm: \n  parent: 'base'\n  broadcaster: 'me'\n  rate: 10000.000\n",
                      self.buffer.all_frames_as_yaml())
        self.assertEqual(self.buffer._chain('arm', at(1), 'map', at(1), 'odom'), ['map', 'odom', 'base', 'arm'])
        self.assertEqual(sorted(self.buffer._getFrameStrings()), ['arm', 'base', 'leg', 'map', 'odom'])
        self.assertTrue(self.buffer._frameExists('arm'))
        self.assertIn('"odom" -> "base"[label="Broadcaster: me\\nAverage rate: 2.000 Hz', self.buffer._allFramesAsDot())
        self.buffer.clear()
        self.assertEqual(self.buffer.can_transform_core('map', 'odom', at(0))[0], 0)
        self.assertEqual(self.buffer.can_transform_core('base', 'arm', at(0))[0], 1)

    def test_velocity(self) -> None:
        duration = importlib.import_module('rclpy.duration').Duration
        self.tree()
        linear, angular = self.buffer.lookupVelocityCore('odom', 'map', at(1.5), duration(seconds=1))
        self.assertAlmostEqual(linear[0], 10)
        self.assertEqual(angular, (0, 0, 0))
        for t in range(5):
            self.put('parent', 'wheel', t, 3.0 * t)
            self.put('parent', 'top', t, 0.0, 0.5 * t)
        first = self.buffer.lookupVelocityCore('wheel', 'parent', at(0), duration(seconds=4, nanoseconds=1000000))
        self.assertAlmostEqual(first[0][0], 3, 2)
        spin = self.buffer.lookupVelocityCore('top', 'parent', at(0), duration(seconds=2))
        self.assertEqual(spin[0], (0, 0, 0))
        self.assertAlmostEqual(spin[1][2], 0.5)
        self.assertEqual(first, self.buffer.lookupVelocityFullCore(
            'wheel', 'parent', 'parent', (0, 0, 0), 'wheel', at(0), duration(seconds=4, nanoseconds=1000000)))


if __name__ == '__main__':
    unittest.main()
