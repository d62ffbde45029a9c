"""Generated modules for Python, with nodes that have their parameters."""
from __future__ import annotations

import importlib
import importlib.util
import math
import sys
from typing import Any
from unittest import mock

from tests.unit.generate_parameter_library_py.generator import GeneratorTest
from tests.unit.rclpy.fake_bus import BusTest

ARM = """arm:
  rate: {type: double, default_value: 2.5, description: "Hz", validation: {gt<>: [0.0], lt_eq<>: [100.0]}}
  name: {type: string, default_value: 'it''s "x"', validation: {not_empty<>: null}}
  frame: {type: string, read_only: true, default_value: base}
  offset: {type: double, default_value: .nan}
  joints: {type: string_array, default_value: [a, b], validation: {unique<>: null, size_gt<>: 0}}
  tags: {type: string_array, default_value: [], read_only: true, validation: {subset_of<>: [[p, q]]}}
  mode: {type: string_fixed_6, default_value: fast, validation: {one_of<>: [[fast, slow, fastest]]}}
  pid:
    period: {type: int, default_value: 10, validation: {bounds<>: [1, 50]}}
    __map_joints:
      p: {type: double, default_value: 1.0, validation: {gt_eq<>: 0.0}}
      limits: {type: double_array, default_value: [0.0, 1.0], validation: {element_bounds<>: [-1.0, 1.0]}}
"""


class PythonModuleTest(GeneratorTest, BusTest):
    def setUp(self) -> None:
        GeneratorTest.setUp(self)
        BusTest.setUp(self)
        self.made = importlib.import_module('rclpy.parameter').Parameter
        for name in [one for one in sys.modules if one.startswith('generate_parameter_library_py')]:
            del sys.modules[name]  # rclpy is another one in each class of tests

    def listener(self, text: str, prefix: str = '', validators: str = '', **overrides: Any) -> Any:
        """A listener of a new node; of the namespace `arm`."""
        self.generated(text, 'python', validators)
        spec = importlib.util.spec_from_file_location('arm_parameters', self.folder / 'out/code.py')
        assert spec is not None and spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        values = [self.made(name.replace('__', '.'), value=value) for name, value in overrides.items()]
        self.own = self.node('arm', parameter_overrides=values)
        return module.arm.ParamListener(self.own, prefix) if prefix else module.arm.ParamListener(self.own)

    def set(self, name: str, value: Any) -> str:
        """Empty when the node takes the value, else its reason."""
        result = self.own.set_parameters([self.made(name, value=value)])[0]
        return '' if result.successful else str(result.reason)

    def test_values_are_the_defaults_and_what_the_node_was_given(self) -> None:
        params = self.listener(ARM, rate=5.0, tags=['q'], joints=['b'], pid__b__p=2.0).get_params()
        self.assertEqual((params.rate, params.name, params.tags, params.mode), (5.0, 'it\'s "x"', ['q'], 'fast'))
        self.assertTrue(math.isnan(params.offset))
        self.assertEqual((params.pid.period, params.pid.get_entry('b').p, params.pid.b.limits), (10, 2.0, [0.0, 1.0]))
        with self.assertRaises(KeyError):
            params.pid.get_entry('a')

    def test_an_empty_array_has_its_type(self) -> None:
        listener = self.listener('arm:\n  a: {type: double_array, default_value: []}\n'
                                 '  b: {type: string_array, default_value: [], read_only: true}\n')
        self.assertEqual([self.own.get_parameter(one).type_.name for one in 'ab'], ['DOUBLE_ARRAY', 'STRING_ARRAY'])
        self.assertEqual(self.set('a', [1.5]), '')
        self.assertEqual((listener.get_params().a, listener.get_params().b), ([1.5], []))
        self.assertIn('read-only', self.set('b', ['x']))

    def test_changes_are_checked_and_followed(self) -> None:
        listener = self.listener(ARM)
        params = listener.get_params()
        self.assertFalse(listener.is_old(params))
        self.assertEqual(self.set('rate', 20.0), '')
        self.assertTrue(listener.is_old(params))
        self.assertEqual((params.rate, listener.get_params().rate), (2.5, 20.0))
        for name, value, reason in (
                ('name', '', "Parameter 'name' cannot be empty"),
                ('joints', ['a', 'a'], "Parameter 'joints' must only contain unique values"),
                ('mode', 'slowest', "Parameter 'mode' with the value 'slowest' is not in the set "
                 "['fast', 'slow', 'fastest']"),
                ('mode', 'fastest', "Length of parameter 'mode' is '7' but must be less than 7"),
                ('pid.a.p', -0.5, 'out of range'), ('pid.period', 51, 'out of range'), ('rate', 0.0, 'out of range'),
                ('pid.a.limits', [2.0], "Value [2.0] in parameter 'pid.a.limits' must be within bounds [-1.0, 1.0]")):
            self.assertIn(reason, self.set(name, value) or 'taken', name)
        self.assertEqual(self.set('pid.b.p', 3.0), '')
        self.assertEqual((listener.get_params().pid.b.p, listener.get_params().pid.a.p), (3.0, 1.0))

    def test_the_descriptions_are_those_of_the_file(self) -> None:
        self.listener(ARM)
        rate, period, frame = (self.own.describe_parameter(one) for one in ('rate', 'pid.period', 'frame'))
        self.assertEqual((rate.description, frame.read_only), ('Hz', True))
        for of, ends in ((rate.floating_point_range[0], (5e-324, 100.0)), (period.integer_range[0], (1, 50))):
            self.assertEqual((of.from_value, of.to_value), ends)

    def test_a_required_parameter_must_be_given(self) -> None:
        exceptions = importlib.import_module('rclpy.exceptions')
        with self.assertRaises(exceptions.ParameterUninitializedException):
            self.listener('arm:\n  a: {type: int}\n')
        self.assertEqual(self.listener('arm:\n  a: {type: int}\n', a=3).get_params().a, 3)

    def test_a_refused_value_at_the_start(self) -> None:
        exceptions = importlib.import_module('rclpy.exceptions')
        with self.assertRaises(exceptions.InvalidParameterValueException) as caught:
            self.listener(ARM, joints=['a', 'a'])
        self.assertIn('Invalid value set during initialization for parameter joints: '
                      "Parameter 'joints' must only contain unique values", str(caught.exception))

    def test_keys_that_come_later(self) -> None:
        listener = self.listener(ARM)
        seen: list[Any] = []
        listener.set_user_callback(lambda params: seen.append(params.joints))
        self.assertEqual(self.set('joints', ['a', 'c']), '')
        self.assertEqual(seen, [['a', 'c']])
        self.assertFalse(self.own.has_parameter('pid.c.p'))
        listener.clear_user_callback()
        listener.refresh_dynamic_parameters()
        self.assertEqual(self.set('pid.c.p', 7.0), '')
        self.assertEqual(listener.get_params().pid.get_entry('c').p, 7.0)
        self.assertEqual(len(seen), 1)

    def test_a_prefix_is_part_of_the_names(self) -> None:
        listener = self.listener(ARM, 'left.')
        self.assertEqual(self.set('left.pid.a.p', 4.0), '')
        self.assertEqual(listener.get_params().pid.a.p, 4.0)
        self.assertFalse(self.own.has_parameter('rate'))

    def test_values_of_a_dictionary(self) -> None:
        listener = self.listener(ARM)
        listener.set_params_from_dict({'rate': 9.0, 'pid': {'period': 3, 'a': {'p': 8.0}}})
        params = listener.get_params()
        self.assertEqual((params.rate, params.pid.period, params.pid.a.p), (9.0, 3, 8.0))
        self.assertEqual(self.own.get_parameter('rate').value, 2.5)

    def test_functions_of_the_users(self) -> None:
        (self.folder / 'own_checks.py').write_text(
            'def even(param):\n    return "" if param.value % 2 == 0 else f"{param.name} is odd"\n')
        with mock.patch.object(sys, 'path', [str(self.folder), *sys.path]):
            listener = self.listener(
                'arm:\n  a: {type: int, default_value: 2, validation: {"custom_validators::even": null}}\n',
                validators='own_checks')
        self.assertEqual((self.set('a', 3), self.set('a', 4), listener.get_params().a), ('a is odd', '', 4))
