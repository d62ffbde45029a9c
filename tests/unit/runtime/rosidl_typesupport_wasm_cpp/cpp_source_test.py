"""The generated C++ calls for each shape of a field, and what the generator refuses."""
import unittest

from cpp_source import source
from generate import load_dependencies, nested_types
from layout import LayoutTable
import type_description as td

from .definitions import described


def generated(text: str) -> str:
    interface = described("p", "msg/M.msg", text)
    types = td.TypeTable()
    types.add(interface.descriptions)
    return source([], interface.messages, [], [], types, LayoutTable(types))


class Calls(unittest.TestCase):

    def test_each_shape_of_a_field(self) -> None:
        cases = {
            "string s": "write_string(writer, message.s, 0);",
            "string<=5 s": "write_string(writer, message.s, 5);",
            "wstring<=2 s": "write_string(writer, message.s, 2);",
            "string<=5[<=3] s": "write_sequence(writer, message.s, 3, 5);",
            "string[2] s": "write_elements(writer, message.s.data(), message.s.size(), 0);",
            "bool[] b": "write_sequence(writer, message.b, 0, 0);",
            "bool b": "write_value(writer, message.b);",
        }
        for definition, call in cases.items():
            with self.subTest(definition):
                text = generated(definition)
                self.assertIn(call, text)
                self.assertIn(call.replace("writer", "reader").replace("write_", "read_"), text)

    def test_a_plain_type_is_checked_and_copied(self) -> None:
        text = generated("float64 x\nfloat64 y")
        self.assertIn("static_assert(sizeof(::p::msg::M) == 16);", text)
        self.assertNotIn("::write(CdrWriter", text)

    def test_members_keep_their_order(self) -> None:
        text = generated("string b\nstring a")
        self.assertLess(text.index("message.b"), text.index("message.a"))


class Dependencies(unittest.TestCase):

    def test_a_package_that_is_not_named_is_asked_for(self) -> None:
        interface = described("p", "msg/M.msg", "std_msgs/Header header")
        with self.assertRaisesRegex(ValueError, "'std_msgs/msg/Header' is not known.*DEPENDENCIES"):
            load_dependencies([], nested_types(interface), td.TypeTable())


if __name__ == "__main__":
    unittest.main()
