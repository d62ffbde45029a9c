"""The phrases that lint counts: planted ones are found, good English is not."""
from __future__ import annotations

import unittest

from tests.tools.english import faults, phrases


class EnglishTest(unittest.TestCase):
    def test_planted_phrases_are_found(self) -> None:
        for text in ('"`x` is no match spec"', "// What a stop has to wait for.", "# Of all together.",
                     " * Whose must not be missed.", "/// Who types waits."):
            self.assertEqual(len(phrases(text)), 1, text)

    def test_good_english_is_not(self) -> None:
        for text in ("there is no such file", "it is no longer used", "// The sum of what was sent.",
                     "# What is a node? A program of ROS.", "const what = Of(1);"):
            self.assertEqual(phrases(text), [], text)

    def test_a_file_may_not_have_more_than_recorded(self) -> None:
        rows = phrases("it is no name\n// Of one.\n")
        self.assertEqual(faults({"a.md": rows}, {"a.md": 2}), [])
        self.assertEqual(faults({"a.md": rows}, {"a.md": 1})[-1], "a.md: 2 such phrases, at most 1 may stay")
        self.assertEqual(len(faults({"new.md": rows}, {})), 3)

    def test_one_that_has_fewer_is_recorded_anew(self) -> None:
        self.assertIn("--record", faults({}, {"a.md": 1})[0])


if __name__ == "__main__":
    unittest.main()
