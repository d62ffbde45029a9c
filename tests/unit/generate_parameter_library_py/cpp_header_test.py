"""Headers for C++ from files of parameters."""
from __future__ import annotations

import re

from tests.unit.generate_parameter_library_py.generator import GeneratorTest

ALL_TYPES = """ns:
  a: {type: bool, default_value: true}
  b: {type: int, default_value: -3}
  c: {type: double, default_value: 1}
  d: {type: string, default_value: text}
  e: {type: bool_array, default_value: [true, false]}
  f: {type: int_array, default_value: [1, 5000000000]}
  g: {type: double_array, default_value: [.nan, -.inf, 1.0e-11]}
  h: {type: string_array, default_value: []}
  i: {type: string_fixed_5, default_value: abc}
  j: {type: double_array_fixed_3, default_value: [1.0]}
  k: {type: int_array_fixed_2}
  l: {type: string_array_fixed_2, default_value: [a, b]}
  m: {type: none, description: made by others}
"""
MAPS = """ns:
  joints: {type: string_array, default_value: [a]}
  pid:
    rate: {type: double, default_value: 0.5}
    __map_joints:
      p: {type: double, default_value: 1.0}
      inner:
        __map_axes:
          gain: {type: double}
    axes: {type: string_array, default_value: [x]}
"""


class CppHeaderTest(GeneratorTest):
    def fields(self, code: str, structure: str = 'Params') -> list[str]:
        """The lines of a structure, without indentation."""
        body = code.partition(f'struct {structure} {{\n')[2].partition('\n};')[0]
        return [line.strip() for line in body.splitlines()]

    def test_each_type_becomes_a_field(self) -> None:
        fields = self.fields(self.generated(ALL_TYPES))
        self.assertEqual(fields[:-1], [
            'bool a = true;', 'int64_t b = -3;', 'double c = 1.0;', 'std::string d = "text";',
            'std::vector<bool> e = {true, false};', 'std::vector<int64_t> f = {1, 5000000000LL};',
            'std::vector<double> g = {std::numeric_limits<double>::quiet_NaN(), '
            '-std::numeric_limits<double>::infinity(), 1e-11};',
            'std::vector<std::string> h = {};', 'rsl::StaticString<5> i{std::string("abc", 3)};',
            'rsl::StaticVector<double, 3> j = {1.0};', 'rsl::StaticVector<int64_t, 2> k{};',
            'rsl::StaticVector<std::string, 2> l = {"a", "b"};'])
        self.assertIn('rclcpp::Time __stamp;', fields[-1])

    def test_the_stack_has_what_needs_no_memory(self) -> None:
        names = [re.findall(r'(\w+)(?: = .*|\{.*)?;$', line)[0] for line in
                 self.fields(self.generated(ALL_TYPES), 'StackParams')]
        self.assertEqual(names, ['a', 'b', 'c', 'i', 'j', 'k', 'l'])

    def test_a_map_has_an_entry_for_each_key(self) -> None:
        code = self.generated(MAPS)
        self.assertEqual(self.fields(code)[:-1], [
            'std::vector<std::string> joints = {"a"};', 'struct Pid {', 'double rate = 0.5;',
            'std::vector<std::string> axes = {"x"};', 'struct MapJoints {', 'double p = 1.0;', 'struct Inner {',
            'struct MapAxes {', 'double gain{};', '};', 'std::map<std::string, MapAxes> axes_map;', '} inner;', '};',
            'std::map<std::string, MapJoints> joints_map;', '} pid;'])
        loops = [line.strip() for line in code.splitlines() if 'key_' in line or 'prefix_' in line]
        self.assertEqual(loops, [
            'for (const std::string& key_1 : params.joints) {',
            '[[maybe_unused]] auto& entry_1 = params.pid.joints_map[key_1];',
            'const std::string prefix_1 = std::string("pid.") + key_1 + ".";',
            'fields.add(prefix_1 + "p", entry_1.p, Field(""));',
            'for (const std::string& key_2 : params.pid.axes) {',
            '[[maybe_unused]] auto& entry_2 = entry_1.inner.axes_map[key_2];',
            'const std::string prefix_2 = std::string(prefix_1 + "inner.") + key_2 + ".";',
            'fields.add(prefix_2 + "gain", entry_2.gain, Field("").required());'])

    def test_groups_of_what_others_declare_make_no_code(self) -> None:
        for language in ('cpp', 'python'):
            code = self.generated('ns:\n  keys: {type: string_array, default_value: []}\n'
                                  '  __map_keys: {chain: {type: none, description: by others}}\n', language)
            self.assertNotIn('MapKeys', code)
            self.assertNotIn('entry_', code)

    def test_a_key_is_looked_for_from_the_map_outwards(self) -> None:
        text = """ns:
  keys: {type: string_array, default_value: []}
  near:
    keys: {type: string_array, default_value: []}
    __map_keys: {v: {type: int, default_value: 0}}
  far: {__map_keys: {v: {type: int, default_value: 0}}}
"""
        code = self.generated(text)
        self.assertEqual(re.findall(r': params\.([\w.]+)\) \{', code), ['near.keys', 'keys'])

    def test_functions_of_validation_get_the_type_and_their_arguments(self) -> None:
        code = self.parameter('type: double_array, validation: {fixed_size<>: 3, element_bounds: [0.5, 2], '
                              'unique<>: null, "mine::check<>": [[1.0, 2.0], text, true, 7]}', validators='mine.hpp')
        self.assertEqual(re.findall(r'result = (.*); !', code), [
            'fixed_size<double>(param, 3)', 'element_bounds(param, 0.5, 2)', 'unique<double>(param)',
            'mine::check<double>(param, {1.0, 2.0}, "text", true, 7)'])
        self.assertIn('#include "mine.hpp"\n', code)
        code = self.parameter('type: string_fixed_4, validation: {"one_of<>": [[ab, cd]]}')
        self.assertEqual(re.findall(r'result = (.*); !', code), [
            'one_of<std::string>(param, {"ab", "cd"})', 'size_lt<std::string>(param, 5)'])

    def ranges(self, lines: str) -> list[str]:
        return re.findall(r'\.((?:integer_)?range\(.*\)),', self.parameter(f'{lines}'))

    def test_limits_of_numbers_are_part_of_the_description(self) -> None:
        lowest, most = 'std::numeric_limits<double>::lowest()', '9223372036854775807LL'
        self.assertEqual(self.ranges('type: int, validation: {bounds<>: [0, 255]}'), ['integer_range(0, 255)'])
        self.assertEqual(self.ranges('type: int, validation: {gt<>: 15}'), [f'integer_range(16, {most})'])
        self.assertEqual(self.ranges('type: double, validation: {gt<>: 0, lt_eq<>: [2.5]}'), ['range(5e-324, 2.5)'])
        self.assertEqual(self.ranges('type: double, validation: {lt<>: 2.0}'), [f'range({lowest}, 1.9999999999999998)'])
        self.assertEqual(self.ranges('type: double_array, validation: {lower_element_bounds<>: -1.0}'),
                         ['range(-1.0, std::numeric_limits<double>::max())'])
        self.assertEqual(self.ranges('type: int, validation: {gt<>: 9223372036854775807}'),
                         [f'integer_range({most}, {most})'])
        self.assertEqual(self.ranges('type: string, validation: {not_empty<>: null}'), [])

    def test_a_field_is_described(self) -> None:
        code = self.parameter('type: int, read_only: true, additional_constraints: "a {schema}", '
                              'description: "first\\n`second`"')
        self.assertIn('fields.add("x", params.x, Field("first\\012    second").required().read_only()'
                      '.constraints("a {schema}"));', code)

    def test_structures_do_not_share_names(self) -> None:
        code = self.generated("""ns:
  params: {params: {a: {type: int}}}
  a_b: {v: {type: int}}
  a__b: {v: {type: int}}
""")
        self.assertEqual(re.findall(r'struct (\w+) \{', code)[:5], ['Params', 'Params_', 'Params', 'AB', 'AB_'])

    def test_a_value_that_comes_twice_is_named_and_the_last_counts(self) -> None:
        code = self.generated('ns:\n  x: {type: int, default_value: 1}\n  x: {type: int, default_value: 2}')
        self.assertIn('int64_t x = 2;', code)
        self.assertIn('parameters.yaml:3: warning: `x` is there twice, and this one counts', self.warnings)

    def test_aliases_and_merges_are_followed(self) -> None:
        code = self.generated(
            'ns:\n  a: &a {type: int, default_value: 4}\n  b: {<<: *a, description: other}\n  c: *a\n')
        self.assertEqual(re.findall(r'int64_t (\w = \d);', code)[:3], ['a = 4', 'b = 4', 'c = 4'])

    def test_the_same_file_gives_the_same_code(self) -> None:
        self.assertEqual(self.generated(ALL_TYPES), self.generated(ALL_TYPES))
