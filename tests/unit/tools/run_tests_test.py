"""The runner of the suites: what a second try may forgive, and what it may not."""
from __future__ import annotations

import contextlib
import io
import os
import subprocess
import tempfile
import time
import unittest
from dataclasses import replace
from pathlib import Path
from unittest import mock

from tests.tools import run_tests
from tests.tools.run_tests import (LONGEST, ROOT, SECOND_TRIES, Counts, Suite, chosen_of, in_order, opens_browser, run,
                                   run_files, suites)

# Fails as long as there are fewer than `needed` lines in the file beside it, and adds one.
FAILS_AT_FIRST = """
import test from 'node:test';
import assert from 'node:assert/strict';
import { appendFileSync, existsSync, readFileSync } from 'node:fs';
const file = new URL('./%(name)s.tries', import.meta.url);
test('steady', () => undefined);
test('%(name)s', () => {
  const tries = existsSync(file) ? readFileSync(file, 'utf8').length : 0;
  appendFileSync(file, '.');
  assert.ok(tries >= %(needed)d, '\\u001b[2mwith a colour of a terminal');
});
"""


class SecondTryTest(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def outcome(self, needed: dict[str, int]) -> tuple[Counts, str]:
        files = []
        for name, tries in needed.items():
            file = self.folder / f"{name}.test.mjs"
            file.write_text(FAILS_AT_FIRST % {"name": name, "needed": tries})
            files.append(str(file))
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            counts = run(Suite("sample", ["node", "--test", *files], "node"), self.folder, environment())
        return counts, printed.getvalue()

    def test_one_that_failed_by_chance_is_named(self) -> None:
        counts, printed = self.outcome({"shaky": 1, "calm": 0})
        self.assertEqual((counts.passed, counts.failed, counts.again), (4, 0, ("shaky",)))
        self.assertIn("once more, by themselves: shaky", printed)
        self.assertIn("1 at the second try", printed)

    def test_one_that_fails_twice_has_failed(self) -> None:
        counts, printed = self.outcome({"broken": 2, "shaky": 1})
        self.assertEqual((counts.passed, counts.failed, counts.again), (2, 2, ()))
        self.assertIn("2 failed", printed)

    def test_many_failures_are_no_accident(self) -> None:
        many = SECOND_TRIES + 1
        counts, printed = self.outcome({f"shaky_{n}": 1 for n in range(many)})
        self.assertEqual((counts.passed, counts.failed), (many, many))
        self.assertNotIn("once more", printed)

    def test_a_suite_that_hangs_is_ended_and_says_where(self) -> None:
        file = self.folder / "endless.test.mjs"
        file.write_text("import test from 'node:test';\n"
                        "test('waits for ever', () => new Promise((done) => setTimeout(done, 1e8)));\n")
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            counts = run(Suite("sample", ["node", "--test", str(file)], "node", most_seconds=8), self.folder,
                         environment())
        self.assertGreaterEqual(counts.failed, 1)
        self.assertIn("the suite was ended: it ran for more than 8 s", printed.getvalue())
        self.assertIn("endless.test.mjs", printed.getvalue())


def end_to_end(name: str) -> Path:
    """The file of this name; their folders are its subjects."""
    found, = (ROOT / "tests" / "e2e").rglob(f"{name}.test.ts")
    return found


class SuitesTest(unittest.TestCase):
    def test_a_test_that_opens_a_browser_is_known_by_what_it_imports(self) -> None:
        for name, expected in {"page": True, "firefox": True, "scoreboard": True, "page_turtlesim": True,
                               "pack": False, "rclcpp": False}.items():
            self.assertEqual(opens_browser(end_to_end(name)), expected, name)

    def test_the_longest_files_exist(self) -> None:
        for name in LONGEST:
            self.assertTrue(end_to_end(name).is_file(), name)

    def test_every_test_file_is_in_one_suite(self) -> None:
        words = [word for suite in suites(ROOT / "build", bless=False) for word in (*suite.command, *suite.files)]
        named = [word for word in words if word.endswith(".test.ts")]
        self.assertEqual(sorted(named), sorted(str(file) for file in (ROOT / "tests").rglob("*.test.ts")))


def environment() -> dict[str, str]:
    # A test of Node.js that runs within another one's would report to that one.
    return {key: value for key, value in os.environ.items() if key != "NODE_TEST_CONTEXT"}


NIGHTLY_TESTS = """
import { nightlyTest, played } from %(file)r;
nightlyTest('large', { timeout: 1000 }, async () => undefined);
console.log(played('shared', 'port').join());
"""


class NightlyTest(unittest.TestCase):
    def test_fuzzing_is_for_a_nightly_run_and_for_who_names_it(self) -> None:
        rows = suites(Path("build"), False)

        def names(wanted: list[str], nightly: bool) -> list[str]:
            return [suite.name for suite in chosen_of(rows, wanted, nightly)]

        self.assertNotIn("fuzz", names([], False))
        self.assertEqual(names([], True), [suite.name for suite in rows])
        self.assertEqual(names(["fuzz"], False), ["fuzz"])

    def test_an_ordinary_run_has_the_first_variant_and_no_nightly_test(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "one.test.mjs"
            file.write_text(NIGHTLY_TESTS % {"file": str(ROOT / "tests/support/nightly.ts")})
            for nightly, variants, has_test in (("0", "shared", False), ("1", "shared,port", True)):
                variables = {**environment(), "ROS2WASM_NIGHTLY": nightly}
                command = ["node", str(file)]
                said = subprocess.run(command, env=variables, text=True, capture_output=True, check=True).stdout
                self.assertIn(variants + "\n", said)
                self.assertEqual("large" in said, has_test, said)


def sample(name: str, numbers: range) -> Suite:
    files = tuple(str(ROOT / "tests" / "e2e" / f"{number:02}.test.ts") for number in numbers)
    return Suite(name, ["node", "--test"], "node", alone=True, files=files)


E2E = sample("e2e", range(40))
BROWSER = sample("browser", range(40, 60))


class FilesTest(unittest.TestCase):
    def test_the_files_of_two_suites_are_mixed_and_the_long_ones_begin(self) -> None:
        long = replace(BROWSER, files=(*BROWSER.files, str(ROOT / "tests/e2e/nodes/scoreboard.test.ts")))
        order = in_order([E2E, long])
        self.assertEqual(sorted(file for _, file in order), sorted([*E2E.files, *long.files]))
        self.assertEqual(Path(order[0][1]).name, "scoreboard.test.ts")
        self.assertEqual({suite.name for suite, _ in order[1:12]}, {"e2e", "browser"})

    def counts(self, minutes: float, outcome: Counts) -> tuple[list[Counts], str]:
        """Runs both suites when so many minutes have passed; each file takes one, and one runs at a time."""
        began = [time.time() - 60 * minutes]

        def one(*_: object) -> tuple[Counts, str]:
            began[0] -= 60
            run_tests.BEGAN = began[0]
            return outcome, ""

        said = io.StringIO()
        with tempfile.TemporaryDirectory() as folder, mock.patch.object(run_tests, "BEGAN", began[0]), \
                mock.patch.object(run_tests, "NIGHTLY", False), mock.patch.object(run_tests, "first_try", one), \
                mock.patch.object(run_tests, "FILES_TOGETHER", 1), contextlib.redirect_stdout(said):
            return run_files([E2E, BROWSER], Path(folder), {}), said.getvalue()

    def test_all_files_run_while_there_is_time(self) -> None:
        counts, said = self.counts(10, Counts(5, 0))
        self.assertEqual([(each.passed, each.failed, each.not_begun) for each in counts], [(200, 0, ()), (100, 0, ())])
        self.assertNotIn("not begun", said)

    def test_files_without_time_are_listed_and_count_for_nothing(self) -> None:
        counts, said = self.counts(run_tests.MOST_MINUTES - 29.5, Counts(5, 0))
        self.assertEqual(sum(each.passed for each in counts), 150)
        self.assertEqual(sum(len(each.not_begun) for each in counts), 30)
        self.assertTrue(all(each.passed and each.not_begun for each in counts))
        self.assertRegex(said, r"browser: not begun, for there was no time: \d+ of 20 files")

    def test_a_suite_of_which_nothing_ran_has_failed(self) -> None:
        counts, _ = self.counts(run_tests.MOST_MINUTES + 1, Counts(5, 0))
        self.assertEqual([(each.passed, each.failed, len(each.not_begun)) for each in counts], [(0, 1, 40), (0, 1, 20)])

    def test_files_that_failed_are_run_once_more_after_all_others(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            files = []
            for name, tries in {"shaky": 1, "calm": 0, "broken": 2}.items():
                file = Path(folder) / f"{name}.test.mjs"
                file.write_text(FAILS_AT_FIRST % {"name": name, "needed": tries})
                files.append(str(file))
            suite = Suite("sample", ["node", "--test"], "node", files=tuple(files))
            said = io.StringIO()
            with contextlib.redirect_stdout(said):
                counts, = run_files([suite], Path(folder), environment())
        self.assertEqual((counts.passed, counts.failed, counts.again), (5, 1, ("shaky",)))


if __name__ == "__main__":
    unittest.main()
