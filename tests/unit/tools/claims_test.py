"""The table of threats: a row without a test, with one that shows nothing, and a forgotten one are told."""
from __future__ import annotations

import unittest

from tests.tools.claims import KINDS, ROOT, THREATS, Rows, all_claims, threat_faults


class ThreatTable(unittest.TestCase):
    def setUp(self) -> None:
        self.rows: dict[str, Rows] = all_claims()
        self.text = (ROOT / THREATS).read_text(encoding="utf-8")

    def test_it_is_whole(self) -> None:
        self.assertEqual(threat_faults(self.text, self.rows), [])

    def test_a_row_without_a_test(self) -> None:
        line = next(line for line in self.text.splitlines() if line.startswith("| a visitor's link |"))
        without = " | ".join(line.split(" | ")[:3]) + " |  |"
        faults = threat_faults(self.text.replace(line, without), self.rows)
        self.assertEqual(faults, ["`a visitor's link` names no test"])

    def test_a_test_that_is_not_there_or_shows_nothing(self) -> None:
        for other in ("tests/unit/ui/no_such.test.ts", "tests/tools/layers.py"):
            text = self.text.replace("tests/unit/ui/layout.test.ts", other)
            self.assertEqual(threat_faults(text, self.rows), [f"`a visitor's link`: {other} shows no guarantee"])

    def test_somebody_forgotten(self) -> None:
        lines = [line for line in self.text.splitlines(True) if not line.startswith("| a visitor's link |")]
        self.assertEqual(threat_faults("".join(lines), self.rows), ["there is no row for a visitor's link"])
        self.assertEqual(len(threat_faults("", {kind: {} for kind in KINDS})), 7)


if __name__ == "__main__":
    unittest.main()
