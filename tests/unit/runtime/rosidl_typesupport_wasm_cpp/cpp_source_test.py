"""The generated C++ calls for each shape of a field, and what the generator refuses."""
import unittest
from pathlib import Path

from cpp_source import literal, source
from generate import load_dependencies, nested_types, source_places
from layout import LayoutTable
import type_description as td

from .definitions import described


def generated(text: str) -> str:
    interface = described("p", "msg/M.msg", text)
    types = td.TypeTable()
    types.add(interface.descriptions)
    return source([], interface.messages, [], [], {}, types, LayoutTable(types))


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


class Descriptions(unittest.TestCase):

    def test_text_survives_as_a_literal(self) -> None:
        cases = {
            "": '""',
            'say "no"\n': '"say \\042no\\042\\n"',
            "a\nb": '"a\\n"\n    "b"',
            "\u00e9\\?": '"\\303\\251\\134\\077"',
            "one\r\ntab\t1": '"one\\015\\n"\n    "tab\\0111"',
        }
        for text, expected in cases.items():
            with self.subTest(text):
                self.assertEqual(literal(text), expected)

    def test_parts_of_a_service_have_no_text_of_their_own(self) -> None:
        interface = described("p", "srv/S.srv", "int32 a\n---\nstring<=5[<=3] b")
        sources = interface.sources("p", {"srv/S": Path(__file__)})
        self.assertEqual(sources["p/srv/S"][0], "py")
        self.assertEqual({sources[f"p/srv/S_{part}"] for part in ("Request", "Response", "Event")},
                         {("implicit", "")})
        types = td.TypeTable()
        types.add(interface.descriptions)
        text = source([], interface.messages, interface.services, [], sources, types, LayoutTable(types))
        self.assertIn('{"b", nullptr, "", 3u, 5u, 117},', text)
        self.assertIn('{"info", &kType_service_msgs__msg__ServiceEventInfo, "", 0u, 0u, 1},', text)
        self.assertIn('{"request", &kType_p__srv__S_Request, "", 1u, 0u, 97},', text)

    def test_the_event_of_a_service_is_a_message(self) -> None:
        interface = described("p", "srv/S.srv", "int32 a\n---\nstring b")
        self.assertEqual(interface.messages, [f"p/srv/S_{part}" for part in ("Request", "Response", "Event")])
        types = td.TypeTable()
        types.add(interface.descriptions)
        text = source([], interface.messages, interface.services, [], {}, types, LayoutTable(types))
        self.assertIn("read_sequence(reader, message.request, 1, 0);", text)
        self.assertIn("get_message_type_support_handle<::p::srv::S_Event>()", text)
        self.assertEqual(nested_types(interface),
                         {"service_msgs/msg/ServiceEventInfo", "p/srv/S_Request", "p/srv/S_Response"})

    def test_what_people_wrote_goes_before_what_was_made_of_it(self) -> None:
        places = source_places({
            "idl_tuples": ["/made:msg/A.idl", "/own:msg/B.idl"], "non_idl_tuples": ["/own:msg/A.msg"]})
        self.assertEqual(places, {"msg/A": Path("/own/msg/A.msg"), "msg/B": Path("/own/msg/B.idl")})


class Dependencies(unittest.TestCase):

    def test_a_package_that_is_not_named_is_asked_for(self) -> None:
        interface = described("p", "msg/M.msg", "std_msgs/Header header")
        with self.assertRaisesRegex(ValueError, "'std_msgs/msg/Header' is not known.*DEPENDENCIES"):
            load_dependencies([], nested_types(interface), td.TypeTable())


if __name__ == "__main__":
    unittest.main()
