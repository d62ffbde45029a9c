"""Files of parameters that are refused: each error names the line, what is wrong, and a way out."""
from __future__ import annotations

import ast
import json
import re
import subprocess
import sys
import time
from types import CodeType

from tests.unit.generate_parameter_library_py.generator import PACKAGE, GeneratorTest

INJECTIONS = (
    '"; std::system("x"); //', '*/ int main(); /*', '\\', '\n#include "/etc/passwd"\n', '??/', 'R"(', '${x}', '\x00y',
    'é€',
    "'''", '"""', '\\N{BELL}', '{0}')


def constants_of(code: CodeType) -> list[object]:
    inner = [constants_of(one) for one in code.co_consts if isinstance(one, CodeType)]
    return [*code.co_consts, *(one for part in inner for one in part)]


class RefusalsTest(GeneratorTest):
    def test_what_is_not_a_file_of_parameters(self) -> None:
        root = 'The yaml definition must only have one root element'
        self.assertTrue(self.refusal('').startswith('F: error: the file is empty'))
        self.assertTrue(self.refusal('a: {}\nb: {}').startswith(f'F:1: error: {root}'))
        self.assertTrue(self.refusal('- a').startswith(f'F:1: error: {root}'))
        self.assertTrue(self.refusal('ns: 3').startswith('F:1: error: `ns` has no parameters below it'))
        self.assertTrue(self.refusal('ns: {type: int}').startswith('F:1: error: `ns` has no parameters below it'))
        self.assertTrue(self.refusal('ns:\n  x: {type: int\n').startswith('F:3: error: not YAML: '))
        self.assertTrue(self.refusal('ns:\n\tx: 1').startswith('F:2: error: not YAML: found character'))
        self.assertTrue(self.refusal(b'ns: \xff').startswith('F: error: byte 4 is not UTF-8'))
        self.assertTrue(self.refusal('ns:\n  x: !!python/object/apply:os.system [ls]').startswith('F:2: error: '))
        self.assertEqual(self.refusal('ns:\n  x: {type: int, description: 2024-13-45}'),
                         'F:2: error: `2024-13-45` cannot be read as timestamp\n  fix: put texts in quotes')

    def test_values_that_cannot_be_read(self) -> None:
        for text in ('!!bool maybe', '!!int ""', '!!timestamp foo', '!!float x'):
            self.assertIn(f'cannot be read as {text[2:].split()[0]}',
                          self.refused_parameter(f'type: int, default_value: {text}'))
        self.assertIn('half of a surrogate pair', self.refused_parameter(r'type: string, default_value: "\ud800"'))
        self.assertIn('half of a surrogate pair', self.refused_parameter(r'type: string, description: "\ud800"'))
        self.assertIn('more than 400 characters',
                      self.refused_parameter('type: int, default_value: ' + '1:' * 300 + '1'))
        self.assertIn('got: an integer of more than 64 bits',
                      self.refused_parameter('type: double, default_value: 1' + '0' * 350))
        self.assertIn('= 1e+50;', self.parameter('type: double, default_value: 1' + '0' * 50))

    def test_merges(self) -> None:
        code = self.generated('ns:\n  a: &a {type: int, default_value: 1}\n  b: &b {<<: *a, default_value: 2}\n'
                              '  c: {<<: [*b, *a]}\n  d: {<<: [*a, *b], description: d}\n')
        for line in ('a = 1', 'b = 2', 'c = 2', 'd = 1'):
            self.assertIn(f'int64_t {line};', code)
        self.assertEqual(self.warnings, '')
        self.parameter('type: int, default_value: 1, default_value: 2')
        self.assertIn('`default_value` is there twice, and this one counts', self.warnings)
        self.assertIn('something that is not a mapping', self.refusal('ns:\n  x: {<<: 3, type: int}'))

    def test_a_file_that_is_not_there(self) -> None:
        with self.assertRaises(self.module('errors').ParameterFileError) as caught:
            self.module('generate_cpp_header').run('out.hpp', '/nowhere/p.yaml')
        self.assertEqual(str(caught.exception), '/nowhere/p.yaml: error: cannot be read: No such file or directory')

    def test_names(self) -> None:
        self.assertEqual(self.refusal('ns:\n  a-b: {type: int}'),
                         'F:2: error: the group or parameter `a-b` cannot be a name in C++\n  fix: name it `a_b`')
        for name in ('class', '1a', 'a.b', 'a b', '"é"', '__stamp', 'x;y', '"x\\n"'):
            said = self.refusal(f'ns:\n  {name}: {{type: int}}')
            self.assertIn(' cannot be a name in C++', said, name)
            self.generated(f'ns:\n  {said.split("name it `")[1].rstrip("`")}: {{type: int}}')
        self.assertIn('the namespace `a::b` cannot be a name', self.refusal('a::b:\n  x: {type: int}'))
        self.assertIn('`on` is not a text, which a name must be', self.refusal('ns:\n  on: {type: int}'))
        self.assertIn('a key is not a text', self.refusal('ns:\n  ? [a]\n  : {type: int}'))
        self.assertIn('`lambda` cannot be a name in Python', self.refusal('ns:\n  lambda: {type: int}', 'python'))
        self.assertIn('lambda', self.generated('ns:\n  lambda: {type: int}'))
        self.assertIn('`get_entry` is a name that groups have', self.refusal('ns:\n  get_entry: {type: int}', 'python'))

    def test_parameters(self) -> None:
        self.assertEqual(self.refused_parameter('typ: int'),
                         "F:2: error: Invalid syntax in parameter x. 'typ' is not valid syntax\n  fix: write `type`")
        self.assertIn('No type defined for parameter x', self.refused_parameter('default_value: 3'))
        for type_ in ('float', 'int_fixed_3', 'string_fixed_0', 'bool_array_fixed_3', '[int]', 'string_fixed_9999999'):
            said = self.refused_parameter(f'type: {type_}')
            self.assertIn(' for parameter x. Allowed types are: none, bool', said, type_)
        self.assertIn('fix: write `type: double`', self.refused_parameter('type: doubl'))
        self.assertIn('`x` is empty', self.refusal('ns:\n  x: {}'))
        self.assertIn('`read_only` of x is yes please', self.refused_parameter('type: int, read_only: yes please'))
        self.assertIn('`description` must be a text', self.refused_parameter('type: int, description: [a]'))

    def test_defaults_of_another_type(self) -> None:
        for type_, value, got in (
                ('int', '1.5', 'double'), ('int', 'true', 'bool'), ('double', 'true', 'bool'), ('bool', '1', 'int'),
                ('string', '3', 'int'), ('double', '[1.0]', 'double_array'), ('double_array', '1.0', 'double'),
                ('string_array', '[a, 2]', 'an array with int'),
                ('int', '9223372036854775808', 'an integer of more than 64 bits'),
                ('int', '{a: 1}', 'a mapping')):
            self.assertIn(f'Parameter x has incorrect type. Expected: {type_}, got: {got}',
                          self.refused_parameter(f'type: {type_}, default_value: {value}'))
        self.assertIn('write `1.0e-5`', self.refused_parameter('type: double, default_value: 1e-5'))
        self.assertIn('the default of x has 4 bytes, and `string_fixed_3` holds 3',
                      self.refused_parameter('type: string_fixed_3, default_value: abcd'))
        self.assertIn('has 2 elements, and `int_array_fixed_1` holds 1',
                      self.refused_parameter('type: int_array_fixed_1, default_value: [1, 2]'))

    def validation(self, type_: str, text: str) -> str:
        return self.refused_parameter(f'type: {type_}, validation: {text}')

    def test_validation(self) -> None:
        self.assertIn('`boundz`, the validation of x, is not a known function\n  fix: write `bounds<>`',
                      self.validation('int', '{boundz<>: [1, 2]}'))
        self.assertIn('`bounds` of x has other arguments than it takes\n  fix: it takes two',
                      self.validation('int', '{bounds<>: [1]}'))
        self.assertIn('a list in the list', self.validation('string', '{one_of<>: [a, b]}'))
        self.assertIn('`gt` of x compares string with int', self.validation('int', '{gt<>: [a]}'))
        self.assertIn('`size_gt` of x compares double with int', self.validation('int_array', '{size_gt<>: 1.5}'))
        self.assertIn('`lt` of x compares inf with int', self.validation('int', '{lt<>: [.inf]}'))
        self.assertIn('`gt` of x compares nan with int', self.validation('int', '{gt<>: [.nan]}'))
        self.assertIn('compares a length with -1', self.validation('int_array', '{size_gt<>: [-1]}'))
        self.assertIn('`bounds` of x is not for the type int_array\n  fix: write `element_bounds<>`',
                      self.validation('int_array', '{bounds<>: [1, 2]}'))
        self.assertIn('`lower_element_bounds` of x is not for the type int\n  fix: write `lower_bounds<>`',
                      self.validation('int', '{lower_element_bounds<>: 1}'))
        self.assertIn('`validation` of x is not a mapping', self.validation('int', '[gt]'))
        self.assertIn("cannot combine 'bounds' with scalar", self.validation('int', '{bounds<>: [1, 2], gt<>: 1}'))
        self.assertIn("cannot combine 'element_bounds'", self.validation(
            'int_array', '{element_bounds<>: [1, 2], lower_element_bounds<>: 1}'))
        self.assertIn('is neither a text, a number', self.validation('int', '{"a::b": [[[1]]]}'))
        for name in ('f(); g', 'a::b<>;', 'a b', '', 'f<int>()', 'é', 'a::', 'f\\n'):
            self.assertIn('is not the name of a function', self.validation('int', json.dumps({name: [1]})), name)

    def test_functions_that_python_cannot_call(self) -> None:
        for name, way_out in (('is_even', 'custom_validators::is_even'), ('own::is_even', 'custom_validators::is_even'),
                              ('rsl::unique<>', 'unique<>'), ('custom_validators::class', 'custom_validators::class_')):
            said = self.refused_parameter(f'type: int, validation: {{"{name}": null}}', 'python', 'package.module')
            self.assertIn(f'cannot be called from Python\n  fix: write `{way_out}`', said)
        self.assertIn('cannot be called from Python', self.refused_parameter(
            'type: int, validation: {"custom_validators::is_even": null}', 'python'))

    def test_maps(self) -> None:
        self.assertIn('give `n_map` another name', self.refusal(
            'ns:\n  n: {type: string_array}\n  n_map: {type: int}\n  __map_n: {v: {type: int}}\n'))
        said = self.refusal('ns:\n  joints: {type: string_array}\n  g:\n    __map_joint: {v: {type: int}}\n')
        self.assertEqual(said, 'F:4: error: `__map_joint` needs an array of texts `joint`, and there is none here or '
                         'further out\n  fix: name the map `__map_joints`')
        self.assertIn('needs an array of texts `n`', self.refusal(
            'ns:\n  n: {type: int_array}\n  __map_n: {v: {type: int}}\n'))
        self.assertIn('`__map_n` is a parameter', self.refusal(
            'ns:\n  n: {type: string_array}\n  __map_n: {type: int}\n'))
        self.assertIn('`__map_a` and `__map_b` are maps in one group', self.refusal(
            'ns:\n  a: {type: string_array}\n  b: {type: string_array}\n  __map_a: {v: {type: int}}\n'
            '  __map_b: {v: {type: int}}\n', 'python'))

    def test_files_that_would_cost_time(self) -> None:
        start = time.monotonic()
        large = 'ns:\n  x: {type: int, description: "' + 'a' * 10_000_000
        self.assertIn('more than 1000000 bytes', self.refusal(large))
        self.assertIn('contains itself', self.refusal('ns: &a\n  x: *a\n'))
        self.assertIn('int64_t x{}', self.generated('ns: &a\n  <<: *a\n  x: {type: int}\n'))
        doubled = ''.join(f'  l{i}: &l{i} {{a: *l{i - 1}, b: *l{i - 1}}}\n' for i in range(1, 40))
        self.assertIn('more than 20000 values', self.refusal('ns:\n  l0: &l0 {v: {type: int}}\n' + doubled))
        nested = '{v: {type: int}}'
        for i in range(30):
            nested = f'&l{i} {{<<: [{nested}, *l{i - 1}]}}' if i else f'&l0 {nested}'
        self.assertIn('more than 20000 values', self.refusal(f'ns: {nested}'))
        wide = ', '.join(f'k{i}: {{}}' for i in range(4000))
        self.assertIn('more than 20000 values', self.refusal(
            f'ns:\n  a: &a {{{wide}}}\n  b: {{<<: [{", ".join(["*a"] * 4000)}]}}\n'))
        many = 'ns:\n  x: {type: int_array, default_value: [' + '1,' * 400_000
        self.assertIn('more than 20000 values', self.refusal(many))
        self.assertIn('nested too deeply', self.refusal('ns: ' + '{a: ' * 5000 + '1' + '}' * 5000))
        self.assertIn('nested more than 64 deep', self.refusal('ns: ' + '{a: ' * 100 + '1' + '}' * 100))
        self.assertLess(time.monotonic() - start, 30.0)

    def text_file(self, text: str) -> str:
        quoted = json.dumps(text)
        return (f'ns:\n  x: {{type: string, default_value: {quoted}, description: {quoted}, '
                f'additional_constraints: {quoted}, validation: {{one_of<>: [[{quoted}]]}}}}\n')

    def test_texts_stay_texts_in_python(self) -> None:
        for text in INJECTIONS:
            code = self.generated(self.text_file(text), 'python')
            tree = compile(code, 'code.py', 'exec')
            self.assertIn(text, constants_of(tree))

    def test_texts_stay_texts_in_cpp(self) -> None:
        plain = re.compile(r'"(?:[ !#-&(->@-\[\]-~\']|\\[0-7]{3})*"')
        for text in INJECTIONS:
            code = self.generated(self.text_file(text))
            literals = re.findall(
                r'(?:std::string\(|std::string x = |constraints\(|Field\(|\{)("[^\n]*?")[,;)}]', code)
            self.assertEqual(len(literals), 4, code)
            for one in literals:
                self.assertTrue(plain.fullmatch(one), one)
            # Octal escapes mean the same in bytes of Python.
            self.assertEqual([ast.literal_eval('b' + one).decode() for one in (literals[0], literals[-1])], [text] * 2)
            self.assertEqual(code.count('\n'), self.generated(self.text_file('plain')).count('\n'))

    def test_zero_bytes_do_not_end_a_text_in_cpp(self) -> None:
        code = self.parameter(r'type: string_array, default_value: ["a\0b"], validation: {subset_of<>: [["a\0b"]]}')
        self.assertEqual(code.count(r'{std::string("a\000b", 3)}'), 2)

    def test_the_program_says_it_without_a_traceback(self) -> None:
        self.yaml.write_text('ns: {x: {type: int, y: 1}}')
        done = subprocess.run(
            [sys.executable, '-B', '-c', 'import sys\n'
             'from generate_parameter_library_py.generate_cpp_header import main\nsys.exit(main())',
             str(self.folder / 'x.hpp'), str(self.yaml)],
            capture_output=True, text=True, env={'PYTHONPATH': str(PACKAGE)})
        self.assertEqual((done.returncode, done.stderr.splitlines()[0]), (
            1, f"{self.yaml}:1: error: Invalid syntax in parameter x. 'y' is not valid syntax"))
        self.assertFalse((self.folder / 'x.hpp').exists())
