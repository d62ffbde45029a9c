"""Which tests `./dev quick` runs for a change, and that a planted fault is found."""
from __future__ import annotations

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from tests.tools.lint import ROOT
from tests.tools.quick import changed_files, native_targets, python_tests, script_tests


class QuickTest(unittest.TestCase):
    def test_a_script_brings_the_tests_that_reach_it(self) -> None:
        found = {Path(test).name for test in script_tests(["runtime/site/contract/qos.ts"])}
        self.assertTrue(found)
        every = {file.name for file in (ROOT / "tests/unit").rglob("*.test.ts")}
        self.assertLess(found, every)
        one = sorted((ROOT / "tests/unit/bag").glob("*.test.ts"))[0]
        self.assertEqual(script_tests([str(one.relative_to(ROOT))]), [str(one)])

    def test_a_native_file_brings_the_tests_of_its_folder(self) -> None:
        self.assertEqual(native_targets(["cli/pack_command.cpp"]), ["cli_test"])
        self.assertEqual(native_targets(["tests/unit/runtime_cpp/tf2_test.cpp"]), ["runtime_cpp_test"])
        self.assertIn("bundler_channel_test", native_targets(["bundler/io/files.hpp"]))
        self.assertEqual(native_targets(["docs/page.md", "tests/fuzz/lock_fuzz.cpp"]), [])

    def test_a_python_file_brings_the_test_of_its_name(self) -> None:
        self.assertEqual(python_tests(["tests/tools/quick.py"]), ["tests.unit.tools.quick_test"])

    def test_files_of_a_folder_are_named_from_the_root(self) -> None:
        self.assertIn("tests/tools/quick.py", changed_files([ROOT / "tests/tools"]))

    def test_a_planted_fault_is_found(self) -> None:
        with tempfile.NamedTemporaryFile("w", suffix=".cpp", dir=ROOT / "cli", prefix="planted_") as planted:
            planted.write("int  badly( ) {return 1 ;}\n")
            planted.flush()
            command = [sys.executable, "tests/tools/quick.py", "--build", "/nowhere", planted.name]
            done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertRegex(done.stdout, r"format +FAILED")


if __name__ == "__main__":
    unittest.main()
