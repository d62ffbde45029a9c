"""The reader of .msg files that builds use treats odd input as ROS 2 does.

msg_grammar_cases.txt has one case a line: the text as a Python string, an arrow, and fields and
constants, or the error, that ROS 2 gives.
"""
import ast
import contextlib
import io
import unittest
from pathlib import Path

from . import ROOT  # noqa: F401  (finds Debian's packages)
from rosidl_adapter.parser import parse_message_string

CASES = Path(__file__).with_name("msg_grammar_cases.txt")


def outcome(text: str) -> str:
    try:
        with contextlib.redirect_stderr(io.StringIO()):
            message = parse_message_string("p", "M", text)
    except Exception as error:  # noqa: BLE001  (which one is what is tested)
        return f"ERR {type(error).__name__} {error}"
    fields = [(str(field.type), field.name, field.default_value) for field in message.fields]
    constants = [(str(constant.type), constant.name, constant.value) for constant in message.constants]
    return f"{fields} {constants}"


class MsgGrammar(unittest.TestCase):

    def test_all_cases(self) -> None:
        lines = CASES.read_text(encoding="utf-8").splitlines()
        self.assertEqual(len(lines), 61)
        for line in lines:
            text, expected = line.split(" -> ")
            with self.subTest(text):
                found = outcome(ast.literal_eval(text)).replace("\n", " ")
                if expected.startswith("ERR"):  # long messages are cut in the file
                    found = found[:len(expected)]
                self.assertEqual(found, expected)


if __name__ == "__main__":
    unittest.main()
