"""A code without a page does not compile, and the tables name who reports one."""
import subprocess
import tempfile
import unittest
from pathlib import Path

from tests.tools import codes

ROOT = Path(__file__).resolve().parents[3]
PROGRAM = """#include "workspace_schema/base/diagnostic.hpp"
const ros2wasm::Diagnostic kOne{.code = "%s", .message = "m"};
"""


def compiles(code: str) -> bool:
    with tempfile.TemporaryDirectory() as folder:
        source = Path(folder) / "one.cpp"
        source.write_text(PROGRAM % code, encoding="utf-8")
        done = subprocess.run(["g++", "-std=c++20", "-fsyntax-only", f"-I{ROOT}", str(source)], check=False,
                              capture_output=True, text=True)
    if done.returncode != 0 and "DiagnosticCode" not in done.stderr:
        raise AssertionError(done.stderr)
    return done.returncode == 0


class CodesTest(unittest.TestCase):
    def test_only_codes_with_a_page_compile(self) -> None:
        self.assertTrue(compiles("R2W0402"))
        self.assertFalse(compiles("R2W9999"))

    def test_a_row_has_the_title_and_the_files(self) -> None:
        rows = codes.texts()[codes.TABLE].splitlines()
        row = next(row for row in rows if row.startswith("| [R2W0402]"))
        self.assertIn("bundler/launch/launch_graph.cpp", row)
        self.assertIn(codes.titles()["R2W0402"], row)

    def test_each_code_is_reported_somewhere(self) -> None:
        found = codes.reporters()
        self.assertEqual([code for code in codes.titles() if code not in found], [])


if __name__ == "__main__":
    unittest.main()
