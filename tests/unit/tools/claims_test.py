"""The table of threats: a row without a test, with one that shows nothing, and a forgotten one are told. And of the
other tables: files that no suite runs, and what cannot be had without a code that says so."""
from __future__ import annotations

import unittest

from tests.tools.claims import (
    KINDS, ROOT, THREATS, Rows, all_claims, claims_of, table, threat_faults, unread_claims, unused_files,
)


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

    def test_files_that_no_suite_runs(self) -> None:
        self.assertEqual(unused_files(self.rows), [])
        files = ["tests/support/rviz/nothing_of_this.ts", "tests/tools/lint.py"]
        self.assertEqual(unused_files({"works": {"something": files}}), files)

    def test_comments_that_only_look_like_claims(self) -> None:
        for line in ("// Works: notebooks: `await`", "# Differs: magics -> do nothing", "  // Compatibility: works: a",
                     "# compatibility, works: a", "// Compatibility, work: a", " * Compatibility, works: a",
                     "// Guarantee, safe: a", "# Cannot: a -> R2W0523"):
            with self.subTest(line):
                self.assertEqual(len(unread_claims("tests/a.test.ts", f"x\n{line}\n")), 1)
        for line in ("// Compatibility, works: a", "# Guarantee, same bytes: a", "// It works: a", "print('Works: a')",
                     "# What works, and what does not"):
            with self.subTest(line):
                self.assertEqual(unread_claims("tests/a.test.ts", line), [])
        # A claim in a kind of file that is not read would be lost, so it is reported.
        self.assertEqual(unread_claims("tests/scripts/fresh", "# Compatibility, works: a"), [])
        self.assertEqual(unread_claims("tests/a.xml", "<!-- Compatibility, works: a"), [
            "tests/a.xml:1: `<!-- Compatibility, works: a` looks like a claim, and is none that is read"])
        self.assertEqual(len(unread_claims("tests/a.hpp", "// Compatibility, works: a")), 1)

    def test_a_claim_ends_with_its_comment(self) -> None:
        self.assertEqual(claims_of("# Compatibility, works: a\n# b\n# Compatibility, differs: c -> d\nx = 1\n# e\n"),
                         [("works", "a b"), ("differs", "c -> d")])

    def test_what_cannot_be_had_names_its_code(self) -> None:
        def row(reason: str) -> str:
            return table("cannot", {f"sockets -> {reason}": ["tests/a.golden"]})

        self.assertIn("| sockets | R2W0523; topics | tests/a.golden |", row("R2W0523; topics"))
        self.assertIn("no code: ", row("no code: nothing can tell"))
        for reason in ("because", "R2W9999 says so"):
            with self.assertRaises(SystemExit):
                row(reason)


if __name__ == "__main__":
    unittest.main()
