"""Messages to text and back, and interfaces by name; YAML is Debian's, the same that sites have."""
from __future__ import annotations

import importlib
import sys
import unittest
import unittest.mock
from collections import OrderedDict
from typing import Any

from tests.unit.rclpy.installation import install, install_host

# Compatibility, works: PyYAML (`yaml`, without its compiled module) and rosidl_runtime_py for Python nodes
DEBIAN = '/usr/lib/python3/dist-packages'


class RosidlRuntimePyTest(unittest.TestCase):
    module: Any

    @classmethod
    def setUpClass(cls) -> None:
        install(cls, 'rosidl_runtime_py')
        install_host(cls)
        cls.enterClassContext(unittest.mock.patch.object(sys, 'path', [*sys.path, DEBIAN]))
        cls.module = importlib.import_module('rosidl_runtime_py')

    def message(self, name: str, **fields: Any) -> Any:
        return importlib.import_module('rosidl_runtime_py.utilities').get_message(name)(**fields)

    def pose(self) -> Any:
        pose = self.message('geometry_msgs/msg/PoseStamped')
        pose.header.frame_id, pose.header.stamp.sec, pose.pose.position.x = 'map', 5, 1.5
        return pose

    def test_yaml(self) -> None:
        self.assertEqual(self.module.message_to_yaml(self.pose()), '''\
header:
  stamp:
    sec: 5
    nanosec: 0
  frame_id: map
pose:
  position:
    x: 1.5
    y: 0.0
    z: 0.0
  orientation:
    x: 0.0
    y: 0.0
    z: 0.0
    w: 1.0
''')
        string = self.message('std_msgs/String', data='grüße: y')
        self.assertEqual(self.module.message_to_yaml(string, flow_style=True), "{data: 'grüße: y'}\n")

    def test_dictionaries_and_what_is_left_out(self) -> None:
        scan = self.message('sensor_msgs/msg/LaserScan', ranges=[0.5, 1.0, 2.0])
        to_dict = self.module.message_to_ordereddict
        values = to_dict(scan)
        self.assertIsInstance(values, OrderedDict)
        self.assertEqual((list(values)[:2], values['ranges']), (['header', 'angle_min'], [0.5, 1.0, 2.0]))
        self.assertEqual(to_dict(scan, truncate_length=2)['ranges'], [0.5, 1.0, '...'])
        self.assertEqual(to_dict(scan, no_arr=True)['ranges'], '<sequence type: float, length: 3>')
        scan.header.frame_id = 'base_link'
        self.assertEqual(to_dict(scan, no_str=True)['header']['frame_id'], '<string length: <9>>')
        covariance = self.message('geometry_msgs/msg/PoseWithCovariance')
        self.assertEqual(to_dict(covariance, no_arr=True)['covariance'], '<array type: double[36]>')
        self.assertEqual(to_dict(covariance)['covariance'], [0.0] * 36)
        transforms = self.message('tf2_msgs/msg/TFMessage')
        self.assertEqual(to_dict(transforms, no_arr=True)['transforms'],
                         '<sequence type: geometry_msgs/msg/TransformStamped, length: 0>')

    def test_values(self) -> None:
        convert = importlib.import_module('rosidl_runtime_py.convert')._convert_value
        for value, length, wanted in (
                (5, 0, 5), (True, 1, True), ((1, 2, 3), 2, (1, 2, '...')), ((1, 2, 3), 0, ('...',)),
                (['123', '456', '789'], 2, ['12...', '45...', '...']), (b'hello world', 5, 'hello...'),
                ('hello', 5, 'hello'), ({1: 'abc', '234': 'bcd'}, 1, {1: 'a...', '234': 'b...'})):
            self.assertEqual(convert(value, truncate_length=length), wanted)

    def test_lines_of_commas(self) -> None:
        to_csv = self.module.message_to_csv
        self.assertEqual(to_csv(self.pose()), '5,0,map,1.5,0.0,0.0,0.0,0.0,0.0,1.0')
        scan = self.message('sensor_msgs/msg/LaserScan', ranges=[0.5, 1.0, 2.0])
        self.assertEqual(to_csv(scan, truncate_length=2), '0,0,,0.0,0.0,0.0,0.0,0.0,0.0,0.0,0.5,1.0,...,')
        self.assertIn(',<sequence type: float, length: 3>,', to_csv(scan, no_arr=True))

    def test_fields_are_set(self) -> None:
        pose = self.message('geometry_msgs/msg/PoseStamped')
        fill = self.module.set_message_fields
        self.assertEqual(fill(pose, {'header': {'frame_id': 'map', 'stamp': {'sec': 5}},
                                     'pose': {'position': {'x': 1.5}}}), [])
        self.assertEqual(pose, self.pose())
        later = fill(pose, {'header': 'auto'}, expand_header_auto=True)
        later[0](importlib.import_module('builtin_interfaces.msg').Time(sec=9))
        self.assertEqual(pose.header.stamp.sec, 9)
        later = fill(pose, {'header': {'stamp': 'now'}}, expand_time_now=True)
        later[0](importlib.import_module('builtin_interfaces.msg').Time(sec=11))
        self.assertEqual(pose.header.stamp.sec, 11)
        polygon = self.message('geometry_msgs/msg/Polygon')
        fill(polygon, {'points': [{'x': 1}, {'y': 2.0}]})
        self.assertEqual([(point.x, point.y) for point in polygon.points], [(1, 0), (0, 2)])
        many = self.message('std_msgs/msg/Float64MultiArray')
        fill(many, {'data': [1, 2], 'layout': {'dim': [{'label': 'a', 'size': 2}]}})
        self.assertEqual((list(many.data), many.layout.dim[0].label), ([1.0, 2.0], 'a'))
        with self.assertRaises(AttributeError):
            fill(pose, {'no_such_field': 1})
        with self.assertRaisesRegex(TypeError, "Value '5' is expected to be a dictionary but is a int"):
            fill(pose, {'pose': 5})

    def test_interfaces_by_name(self) -> None:
        utilities = importlib.import_module('rosidl_runtime_py.utilities')
        self.assertIs(utilities.get_service('example_interfaces/srv/AddTwoInts'),
                      importlib.import_module('example_interfaces.srv').AddTwoInts)
        self.assertIs(utilities.get_action('example_interfaces/Fibonacci'),
                      importlib.import_module('example_interfaces.action').Fibonacci)
        self.assertIs(utilities.get_interface('std_msgs/msg/String'), utilities.get_message('std_msgs/String'))
        with self.assertRaisesRegex(ValueError, "Expected the full name of a message, got 'std_srvs/srv/Empty'"):
            utilities.get_message('std_srvs/srv/Empty')
        with self.assertRaises(ModuleNotFoundError):
            utilities.get_message('no_such_package/msg/Thing')

    def test_which_interfaces_there_are(self) -> None:
        self.assertIn('std_msgs', self.module.get_interface_packages())
        self.assertIn('msg/String', self.module.get_message_interfaces(['std_msgs'])['std_msgs'])
        self.assertEqual(self.module.get_service_interfaces(['std_msgs']), {})
        self.assertIn('action/Fibonacci', self.module.get_action_interfaces()['example_interfaces'])
        self.assertIn('srv/Trigger', self.module.get_interfaces(['std_srvs'])['std_srvs'])
        with self.assertRaisesRegex(LookupError, "Unknown package 'nope'"):
            self.module.get_interfaces(['nope'])
        path = self.module.get_interface_path('std_msgs/msg/String')
        self.assertTrue(path.endswith('/share/std_msgs/msg/String.msg'))
        self.assertEqual(self.module.get_interface_path('std_msgs/msg/String.msg'), path)
        for wrong, error in (('String', ValueError), ('a//b', ValueError), ('std_msgs/../x', ValueError),
                             ('std_msgs/msg/Nope', LookupError)):
            with self.assertRaises(error):
                self.module.get_interface_path(wrong)


if __name__ == '__main__':
    unittest.main()
