"""What ./dev coverage counts, on one real test: Node.js runs it and reports."""
from __future__ import annotations

import tempfile
import unittest
from pathlib import Path

from tests.tools import coverage


class Coverage(unittest.TestCase):
    # Guarantee, robust: which lines the tests reach is counted for each folder, by `./dev coverage`
    def test_lines_of_what_a_test_reaches(self) -> None:
        table: coverage.Table = {}
        with tempfile.TemporaryDirectory() as folder:
            coverage.scripts(Path(folder), table, [str(coverage.ROOT / "tests/unit/ui/console_lines.test.ts")])
        reached = table["runtime/site/ui"]
        self.assertGreater(reached.reached, 20)
        self.assertLess(reached.reached, reached.all)
        self.assertFalse([name for name in table if not name.startswith("runtime/")])

    def test_folders(self) -> None:
        self.assertEqual(coverage.folder_of("bundler/channel/x.cpp"), "bundler/channel")
        self.assertEqual(coverage.folder_of("runtime/site/ui/model/x.ts"), "runtime/site/ui")
        self.assertEqual(coverage.folder_of("cli/main.cpp"), "cli")
        self.assertEqual(coverage.Lines(1, 8).percent(), "12.5")
        self.assertEqual(coverage.Lines().percent(), "-")


if __name__ == "__main__":
    unittest.main()
