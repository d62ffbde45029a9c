"""Which types may be copied as they lie, and how few bytes a value can take."""
import unittest

import type_description as td
from layout import Layout, LayoutTable

from .definitions import described


def layout(text: str, **others: str) -> Layout:
    types = td.TypeTable()
    for name, definition in {**others, "Subject": text}.items():
        types.add(described("p", f"msg/{name}.msg", definition).descriptions)
    return LayoutTable(types).of("p/msg/Subject")


class PlainTypes(unittest.TestCase):

    def plain(self, expected: tuple[int, int], text: str, **others: str) -> None:
        found = layout(text, **others)
        self.assertEqual((found.plain_size, found.plain_alignment), expected, text)

    def test_members_without_gaps_are_plain(self) -> None:
        self.plain((8, 4), "int32 sec\nuint32 nanosec")
        self.plain((24, 8), "float64 x\nfloat64 y\nfloat64 z")
        self.plain((16, 8), "float64 a\nint32 b\nint16 c\nuint8 d\nbyte e")
        self.plain((16, 1), "uint8[16] uuid")
        self.plain((1, 1), "")

    def test_nested_plain_types_are_plain(self) -> None:
        self.plain((32, 8), "Point[2] points", Point="float64 x\nfloat64 y")
        self.plain((24, 8), "Point p\nint32 a\nint32 b", Point="float64 x\nfloat64 y")

    def test_gaps_and_smaller_first_members_are_not(self) -> None:
        self.plain((0, 0), "uint8 a\nfloat64 b")   # its place decides the gap
        self.plain((0, 0), "float64 a\nuint8 b")   # a gap at the end
        self.plain((0, 0), "float64 a\nuint8 b\nint32 c\nuint8[3] d")
        self.plain((0, 0), "uint8[8] a\nfloat64 b")

    def test_bool_text_and_sequences_are_not(self) -> None:
        self.plain((0, 0), "bool a")  # a wire byte of 2 must not become a bool
        self.plain((0, 0), "string a")
        self.plain((0, 0), "float64[] a")
        self.plain((0, 0), "float64[<=2] a")
        self.plain((0, 0), "Inner a", Inner="bool b")


class MinimumSize(unittest.TestCase):

    def test_counts_what_must_be_there(self) -> None:
        self.assertEqual(layout("string a\nfloat64[] b\nuint8 c").minimum_size, 9)
        self.assertEqual(layout("string[3] a").minimum_size, 12)
        self.assertEqual(layout("Inner[2] a", Inner="bool b\nint16 c").minimum_size, 6)
        self.assertEqual(layout("").minimum_size, 1)


if __name__ == "__main__":
    unittest.main()
