"""Messages as Python nodes see them, made of the definitions that we ship: classes, bytes on the wire, hashes."""
from __future__ import annotations

import importlib
import unittest
from array import array
from typing import Any
from unittest import mock

from tests.unit.rclpy.installation import PAYLOAD_AT, ROOT, install


class Messages(unittest.TestCase):
    types: Any

    @classmethod
    def setUpClass(cls) -> None:
        install(cls)
        cls.types = importlib.import_module('ros2wasm.types')

    def encode(self, message: Any) -> bytes:
        view = memoryview(bytearray(1 << 12))
        return bytes(view[PAYLOAD_AT:message._codec.write(message, view, PAYLOAD_AT)])

    def decode(self, cls: Any, data: bytes) -> Any:
        return cls._codec.read(array('B', bytes(PAYLOAD_AT) + data), PAYLOAD_AT)[0]


class WithoutNumpyTest(Messages):
    # Compatibility, differs: arrays of fixed length (`covariance`) of a node whose site has no numpy -> `array.array`;
    # where a node imports numpy they are numpy's, as natively
    def test_fixed_arrays_without_numpy_are_arrays(self) -> None:
        find = self.types.find_message
        with mock.patch.object(importlib.import_module('ros2wasm.codec'), 'find_numpy', lambda: None), \
                mock.patch.object(importlib.import_module('ros2wasm.message_class'), 'find_numpy', lambda: None):
            message = find('geometry_msgs/msg/AccelWithCovariance')()
            message.covariance[35] = 2.5
            self.assertIsInstance(message.covariance, array)
            back = self.decode(type(message), self.encode(message))
            self.assertEqual((type(back.covariance), list(back.covariance)), (array, [0.0] * 35 + [2.5]))


class MessagesTest(Messages):
    def test_a_message_is_as_upstreams(self) -> None:
        message = self.types.find_message('std_msgs/msg/String')
        self.assertEqual(message.get_fields_and_field_types(), {'data': 'string'})
        self.assertEqual(message.__slots__, ['_data', '_check_fields'])
        self.assertEqual(repr(message(data='x')), "std_msgs.msg.String(data='x')")
        self.assertEqual(message(data='x'), message(data='x'))
        self.assertNotEqual(message(data='x'), message())
        with self.assertRaisesRegex(AssertionError, "The 'data' field must be of type 'str'"):
            message(data=5, check_fields=True)
        with self.assertRaisesRegex(AssertionError, 'Invalid arguments passed to constructor: dta'):
            message(dta='', check_fields=True)

    def test_import(self) -> None:
        module = importlib.import_module('sensor_msgs.msg')
        scan = module.LaserScan(ranges=[1, 2])
        self.assertEqual(scan.ranges, array('f', [1, 2]))
        ranges = array('f', [3])
        scan.ranges = ranges
        self.assertIs(scan.ranges, ranges)
        self.assertIs(importlib.import_module('sensor_msgs.msg._laser_scan').LaserScan, module.LaserScan)
        self.assertEqual(module.BatteryState.POWER_SUPPLY_STATUS_FULL, 4)
        with self.assertRaises(AttributeError):
            module.NoSuchMessage
        service = importlib.import_module('example_interfaces.srv').AddTwoInts
        self.assertEqual(service.Request(a=1).b, 0)
        action = importlib.import_module('example_interfaces.action').Fibonacci
        self.assertEqual(list(action.Result().sequence), [])

    def test_what_nobody_defines_cannot_be_imported(self) -> None:
        for line in ('from std_msgs.msg import Nope', 'from example_interfaces.srv import Nope',
                     'from example_interfaces.action import Nope'):
            with self.assertRaises(ImportError, msg=line):
                exec(line)

    def test_assignments_are_checked_when_the_environment_says_so(self) -> None:
        classes = importlib.import_module('ros2wasm.message_class')
        structure = self.types.find_structure('std_msgs/msg/String')
        make = classes.make_class
        arguments = (structure, 'std_msgs.msg._string', 'String', self.types.find_message)
        make(*arguments)().data = 5
        with mock.patch.object(classes, 'CHECKED', True):
            cls = make(*arguments)
            message = cls()
            with self.assertRaisesRegex(AssertionError, "The 'data' field must be of type 'str'"):
                message.data = 5
            message.data = 'x'
        self.assertEqual(message, cls(data='x'))
        self.assertEqual(repr(message), "std_msgs.msg.String(data='x')")

    def test_bytes_are_those_of_the_wire(self) -> None:
        vectors: list[tuple[str, str, dict[str, Any]]] = [
            ('std_msgs/msg/String', '0f00000048656c6c6f20576f726c643a203100', {'data': 'Hello World: 1'}),
            ('std_msgs/msg/String', '0100000000', {'data': ''}),
            ('std_msgs/msg/Int32', 'feffffff', {'data': -2}),
            ('std_msgs/msg/Empty', '00', {}),
            # A sequence of eight-byte numbers behind a count: padding, but none when it is empty.
            ('std_msgs/msg/Float64MultiArray', '00000000' '00000000' '01000000' '00000000' '000000000000f03f',
             {'data': [1.0]}),
            ('std_msgs/msg/Float64MultiArray', '00000000' '00000000' '00000000', {}),
        ]
        for name, wire, values in vectors:
            cls = self.types.find_message(name)
            self.assertEqual(self.encode(cls(**values)).hex(), wire, name)
            self.assertEqual(self.decode(cls, bytes.fromhex(wire)), cls(**values), name)

    def test_every_type_comes_back_from_its_bytes(self) -> None:
        count = 0
        for file in sorted((ROOT / 'runtime/packages/interfaces').glob('*/*/*.*')):
            kind = file.parent.name
            if file.suffix != f'.{kind}':
                continue
            for name in self.types.names_of(f'{file.parts[-3]}/{kind}/{file.stem}'):
                whole = self.types.definition_of(name) == name and kind != 'msg'
                if whole or name.endswith(('_SendGoal', '_GetResult')):
                    continue
                cls = self.types.find_message(name)
                came = self.decode(cls, self.encode(cls()))
                # A default that float32 does not have comes back as the nearest that it has.
                self.assertEqual(self.encode(came), self.encode(cls()), name)
                if not name.startswith('irobot_create_msgs/'):
                    self.assertEqual(came, cls(), name)
                count += 1
        self.assertGreater(count, 300)

    def test_what_is_cut_or_too_long_is_refused(self) -> None:
        cls = self.types.find_message('rcl_interfaces/msg/ParameterDescriptor')
        ranges = [self.types.find_message('rcl_interfaces/msg/IntegerRange')() for _ in range(2)]
        with self.assertRaises(ValueError):
            self.encode(cls(integer_range=ranges))
        field = self.types.find_message('type_description_interfaces/msg/FieldType')
        self.encode(field(nested_type_name='x' * 255))
        with self.assertRaises(ValueError):
            self.encode(field(nested_type_name='x' * 256))
        pose = self.types.find_message('geometry_msgs/msg/Pose')
        with self.assertRaises(Exception):
            self.decode(pose, self.encode(pose())[:-1])

    def test_a_text_that_is_no_utf_8_is_read_all_the_same(self) -> None:
        cls = self.types.find_message('std_msgs/msg/String')
        self.assertEqual(self.decode(cls, b'\x03\0\0\0a\xff\0').data, 'a\ufffd')

    def test_hashes_are_those_of_ros(self) -> None:
        self.assertEqual(
            self.types.type_hash('std_msgs/msg/String'),
            'RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18')


if __name__ == '__main__':
    unittest.main()
