#!/usr/bin/env python3
"""Runs every test suite of the project and ends with the counts.

A suite is one row: a name, a command and how its result is counted. Suites that leave a core idle run three at
a time, then the others one by one, then the files of e2e and browser. A suite that runs no test counts as a
failure, and so does a skipped test: neither may pass for tested. Tests that wait for browsers and clocks share
a machine with others, so the few that fail are run once more by themselves, and named: a test that fails twice
has failed. On a machine that is too slow for all files of e2e and browser in the time that a run may take,
those that were not begun are listed: they count for nothing. Which ones these are changes from commit to
commit. A nightly run (ROS2WASM_NIGHTLY=1) also fuzzes, and plays scenes on every link and in every host: the
tests that import tests/support/nightly.ts.
"""
from __future__ import annotations

import argparse
import contextlib
import hashlib
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as ElementTree
from collections import deque
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

# A suite with more failures than this is not run again: these are not accidents.
SECOND_TRIES = 8
# Suites at a time of those that leave a core idle: one of them waits for a network most of the time.
TOGETHER = 3
# Tests that are listed at the end of a run.
SLOWEST = 20
# Files of e2e and browser that take a minute or more.
LONGEST = ("rclcpp", "scoreboard", "libraries", "simulator_control", "launch_components", "same_bytes", "store",
           "cross_language", "python_image", "pack_python", "launch_arguments", "clean_root", "pack_trouble", "rebuild",
           "native_rules", "launch_container_of_several", "turtlesim", "hostile_neighbour", "ros2_control",
           "navigation_maps", "sources")
# A suite that takes longer than this hangs: it is asked what it waits for, and ended.
MOST_SECONDS = 1200
# Where files live in memory, and what tests may need there.
IN_MEMORY = Path("/dev/shm")
SCRATCH_BYTES = 8 << 30
# How long it may take to answer before it is killed.
LAST_WORDS_SECONDS = 20
NIGHTLY = os.environ.get("ROS2WASM_NIGHTLY") == "1"
# An ordinary run begins no further file of e2e and browser after so many minutes, counted from the start of ./dev
# (seconds since 1970).
MOST_MINUTES = 70
BEGAN = float(os.environ.get("ROS2WASM_TEST_BEGAN") or time.time())
# Files of e2e and browser at a time: more than there are cores, for tests also wait, for browsers and for time to pass.
FILES_TOGETHER = 3


@dataclass(frozen=True)
class Suite:
    name: str
    command: list[str]
    counting: str  # "ctest", "node", "gtest" (these write JUnit XML) or "lines" ("N passed, N failed")
    alone: bool = False  # uses both cores by itself, or is about time
    nightly: bool = False  # runs in a nightly run, and when it is asked for
    most_seconds: float = MOST_SECONDS
    not_run: str = ""  # why it cannot run on this machine: said in a line; a failure when it was asked for
    files: tuple[str, ...] = ()  # test files behind the command, each run by itself, while there is time


@dataclass(frozen=True)
class Counts:
    passed: int
    failed: int
    skipped: int = 0
    again: tuple[str, ...] = ()  # failed, and passed when they were run once more
    seconds: float = 0
    not_begun: tuple[str, ...] = ()  # files for which there was no time


@dataclass(frozen=True)
class Case:
    name: str
    file: str  # empty when the report has none


def junit_cases(report: Path) -> Iterator[ElementTree.Element]:
    """The leaf test cases of a JUnit file, which may have been cut off. Colours of a terminal are not XML."""
    text = re.sub(r"[\x00-\x08\x0b\x0c\x0e-\x1f]", "?", report.read_text(encoding="utf-8", errors="replace"))
    parser = ElementTree.XMLPullParser(["end"])
    parser.feed(text)
    return (element for _, element in parser.read_events() if element.tag == "testcase")


def failed_cases(report: Path) -> list[Case]:
    """Those of a JUnit file."""
    return [
        Case(case.get("name", ""), case.get("file", ""))
        for case in junit_cases(report)
        if case.find("failure") is not None or case.find("error") is not None
    ]


def failed_methods(output: str) -> list[Case]:
    """Those that unittest prints: "FAIL: test_name (package.module.Class.test_name)"."""
    names = re.findall(r"^(?:FAIL|ERROR): \w+ \(([\w.]+)\)", output, re.MULTILINE)
    return [Case(name, "") for name in dict.fromkeys(names)]


def junit_counts(report: Path) -> Counts:
    """Counts the leaf test cases of a JUnit file."""
    passed = failed = skipped = 0
    for case in junit_cases(report):
        if case.find("failure") is not None or case.find("error") is not None:
            failed += 1
        elif case.find("skipped") is not None or case.get("status") in ("notrun", "disabled"):
            skipped += 1
        else:
            passed += 1
    return Counts(passed, failed, skipped)


def slowest(reports: list[Path]) -> list[tuple[float, str]]:
    """Seconds and name of the tests that took longest. Suites that write no report of single tests are absent."""
    timed = []
    for report in filter(Path.exists, reports):
        for case in junit_cases(report):
            file = Path(case.get("file", "")).name or case.get("classname", "")
            timed.append((float(case.get("time") or 0), f"{report.stem}: {file}: {case.get('name', '')}"))
    return sorted(timed, reverse=True)[:SLOWEST]


def line_counts(output: str) -> Counts:
    """Reads the last "N passed, N failed" or unittest's "Ran N tests" of an output."""
    rows = re.findall(r"(\d+) passed, (\d+) failed(?:, (\d+) skipped)?", output)
    if rows:
        passed, failed, skipped = rows[-1]
        return Counts(int(passed), int(failed), int(skipped or 0))
    ran = re.findall(r"^Ran (\d+) tests?", output, re.MULTILINE)
    if ran:
        broken = sum(int(n) for n in re.findall(r"(?:failures|errors)=(\d+)", output))
        skipped = sum(int(n) for n in re.findall(r"skipped=(\d+)", output))
        return Counts(int(ran[-1]) - broken - skipped, broken, skipped)
    return Counts(0, 0)


def conda_data() -> Path:
    """Public data of conda, which is not part of the repository."""
    return Path(os.environ.get("ROS2WASM_CONDA_DATA", ROOT.parent / "shared" / "data" / "conda")).resolve()


def opens_browser(test: Path) -> bool:
    """Whether a test, or what it imports of the repository's tests, starts one."""
    waiting, seen = [test], {test}
    while waiting:
        file = waiting.pop()
        text = file.read_text(encoding="utf-8")
        if "from 'playwright-core'" in text or "'--chromium'" in text or file.name == "firefox.ts":
            return True
        near = {(file.parent / name).resolve() for name in re.findall(r"from '(\.[^']+\.tsx?)'", text)}
        fresh = {one for one in near if ROOT / "tests" in one.parents} - seen
        seen |= fresh
        waiting += fresh
    return False


def suites(build: Path, bless: bool) -> list[Suite]:
    cli = str(build / "ros2wasm")
    data = conda_data()

    def tests_of(folder: str) -> list[Path]:
        return sorted((ROOT / "tests" / folder).rglob("*.test.ts"))

    def node(files: list[Path]) -> list[str]:
        return ["node", "--test", f"--test-concurrency={FILES_TOGETHER}", *map(str, files)]

    ends = tests_of("e2e")
    browser = [file for file in ends if opens_browser(file)]
    rows = [
        Suite("fuzz", [sys.executable, "tests/fuzz/run.py"], "lines", alone=True, nightly=True,
              most_seconds=3600),
        Suite("unit-js", node(tests_of("unit")), "node"),
        Suite(
            "unit-python",
            [sys.executable, "-m", "unittest", "discover", "-s", "tests", "-t", ".", "-p", "*_test.py"],
            "lines",
        ),
        # With Debian's Python, for which its matplotlib is installed.
        Suite("figures", ["/usr/bin/python3", "-m", "unittest", "discover", "-s", "tests/figures", "-t", ".",
                          "-p", "*_checks.py"], "lines"),
        Suite("lint", [sys.executable, "tests/tools/lint.py", "--build", str(build)], "lines"),
        Suite("native", ["ctest", "--test-dir", str(build), "--output-on-failure"], "ctest"),
        Suite(
            "conda-data", [str(build / "tests" / "conda_data" / "conda_data_test")], "gtest",
            not_run="" if data.is_dir() else f"its data is not part of the repository, and not at {data}; "
                                             "ROS2WASM_CONDA_DATA may say where it is",
        ),
        Suite(
            "golden",
            [sys.executable, "tests/golden/run.py", "--cli", cli] + (["--bless"] if bless else []),
            "lines",
        ),
        Suite("conformance", node(tests_of("conformance")), "node", alone=True),
        Suite("e2e", node([]), "node", alone=True,
              files=tuple(str(file) for file in ends if file not in browser)),
        Suite("browser", node([]), "node", alone=True, files=tuple(map(str, browser))),
    ]
    return rows


def part_of(suite: Suite, file: str) -> Suite:
    """One file of a long suite, as a suite."""
    name = Path(file).name.removesuffix(".test.ts")
    return replace(suite, name=f"{suite.name}-{name}", command=[*suite.command, file], files=(file,))


def in_order(long_suites: list[Suite]) -> list[tuple[Suite, str]]:
    """The files of these suites: the long ones, then the others in an order that changes with the commit."""
    said = subprocess.run(["git", "rev-parse", "HEAD"], cwd=ROOT, capture_output=True, text=True, check=False)
    commit = said.stdout

    def place(pair: tuple[Suite, str]) -> tuple[int, str]:
        name = Path(pair[1]).name.removesuffix(".test.ts")
        rank = LONGEST.index(name) if name in LONGEST else len(LONGEST)
        return rank, hashlib.sha256((commit + pair[1]).encode()).hexdigest()

    return sorted(((suite, file) for suite in long_suites for file in suite.files), key=place)


def is_late() -> bool:
    return not NIGHTLY and time.time() - BEGAN > 60 * MOST_MINUTES


def chosen_of(rows: list[Suite], names: list[str], nightly: bool) -> list[Suite]:
    """The suites of these names; without names, those of the run."""
    return [suite for suite in rows if suite.name in names or (not names and (nightly or not suite.nightly))]


def with_report(suite: Suite, command: list[str], report: Path) -> list[str]:
    """The command that also writes how each test ended; the same one for suites that only print it."""
    if suite.counting == "ctest":
        return [*command, "--output-junit", str(report)]
    if suite.counting == "gtest":
        return [*command, f"--gtest_output=xml:{report}"]
    if suite.counting == "node":
        return [
            *command[:2], "--test-reporter=junit", f"--test-reporter-destination={report}",
            "--test-reporter=spec", "--test-reporter-destination=stdout",
            # A watchdog for tests that have none, and for files in which one left a server open: --test-force-exit
            # would end them at once, now and then before their last results are told.
            "--test-timeout=600000", *command[2:],
        ]
    return command


def second_try(suite: Suite, failed: list[Case]) -> list[str] | None:
    """The command for those tests alone; None where that cannot be, or would be no second try but a second run."""
    if not 0 < len(failed) <= SECOND_TRIES:
        return None
    if suite.counting == "ctest":
        return [*suite.command, "--rerun-failed"]
    if suite.name == "unit-python":
        return [sys.executable, "-m", "unittest", *(case.name for case in failed)]
    if suite.counting == "node" and all(case.file for case in failed):
        return ["node", "--test", "--test-concurrency=1", *sorted({case.file for case in failed})]
    return None


def started(command: list[str], environment: dict[str, str], log: Path,
            most_seconds: float) -> tuple[int, str]:
    """The exit code and the output of a command, which is in the log while it runs. One that hangs is ended."""
    with log.open("w") as stream:
        process = subprocess.Popen(command, cwd=ROOT, env=environment, stdin=subprocess.DEVNULL, stdout=stream,
                                   stderr=subprocess.STDOUT, start_new_session=True)
        try:
            process.wait(most_seconds)
        except subprocess.TimeoutExpired:
            # Node.js and unittest answer it with what was running.
            process.send_signal(signal.SIGINT)
            try:
                process.wait(LAST_WORDS_SECONDS)
            except subprocess.TimeoutExpired:
                pass
            stream.write(f"\nthe suite was ended: it ran for more than {most_seconds:.0f} s\n")
        finally:
            # Browsers and servers of tests that were ended stay in the session.
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
            process.wait()
    return process.returncode, log.read_text(errors="replace")


def counts_of(suite: Suite, report: Path, output: str) -> Counts:
    if suite.counting == "lines":
        return line_counts(output)
    return junit_counts(report) if report.exists() else Counts(0, 0)


def tried_again(suite: Suite, report: Path, output: str, environment: dict[str, str], first: Counts) -> Counts:
    """The counts after the failed tests have been run once more."""
    failed = failed_cases(report) if report.exists() else failed_methods(output)
    command = second_try(suite, failed)
    if command is None:
        return first
    print(f"{suite.name}: once more, by themselves: {', '.join(case.name for case in failed)}", flush=True)
    second = report.with_name(f"{suite.name}-again.xml")
    second.unlink(missing_ok=True)
    code, said = started(with_report(suite, command, second), environment, second.with_suffix(".log"),
                         suite.most_seconds)
    again = counts_of(suite, second, said)
    if again.passed == 0 or again.failed or again.skipped or code != 0:
        print(said[-12000:], flush=True)
        return first
    return Counts(first.passed + len(failed), 0, first.skipped, tuple(case.name for case in failed))


def first_try(suite: Suite, build: Path, environment: dict[str, str]) -> tuple[Counts, str]:
    """Runs the suite once; what it printed is shown when it failed."""
    report = report_of(suite, build)
    report.parent.mkdir(parents=True, exist_ok=True)
    report.unlink(missing_ok=True)
    code, said = started(with_report(suite, suite.command, report), environment, report.with_suffix(".log"),
                         suite.most_seconds)
    counts = counts_of(suite, report, said)
    if code != 0 and counts.failed == 0:
        counts = Counts(counts.passed, 1, counts.skipped)
    if counts.passed + counts.failed == 0:
        print(f"{suite.name}: no test ran", flush=True)
        counts = Counts(0, 1)
    if counts.failed:
        print(said[-12000:], flush=True)
    return counts, said


def report_of(suite: Suite, build: Path) -> Path:
    return build / "test-reports" / f"{suite.name}.xml"


def say_counts(suite: Suite, counts: Counts) -> None:
    skipped = f", {counts.skipped} skipped" if counts.skipped else ""
    again = f", {len(counts.again)} at the second try" if counts.again else ""
    print(f"{suite.name:12} {counts.passed:5} passed, {counts.failed} failed{skipped}{again} ({counts.seconds:.1f} s)",
          flush=True)


def run(suite: Suite, build: Path, environment: dict[str, str]) -> Counts:
    began = time.monotonic()
    counts, said = first_try(suite, build, environment)
    if counts.failed:
        counts = tried_again(suite, report_of(suite, build), said, environment, counts)
    counts = replace(counts, seconds=time.monotonic() - began)
    say_counts(suite, counts)
    return counts


def sum_of(all_counts: list[Counts]) -> Counts:
    return Counts(
        sum(counts.passed for counts in all_counts), sum(counts.failed for counts in all_counts),
        sum(counts.skipped for counts in all_counts), tuple(name for counts in all_counts for name in counts.again),
        sum(counts.seconds for counts in all_counts), tuple(file for counts in all_counts for file in counts.not_begun))


def run_files(long_suites: list[Suite], build: Path, environment: dict[str, str]) -> list[Counts]:
    """Runs the files of these suites beside each other, each by a process of its own, while there is time."""

    def one(pair: tuple[Suite, str]) -> Counts:
        suite, file = pair
        if is_late():
            return Counts(0, 0, not_begun=(file,))
        began = time.monotonic()
        counts, _ = first_try(part_of(suite, file), build, environment)
        return replace(counts, seconds=time.monotonic() - began)

    pairs = in_order(long_suites)
    waiting = deque(enumerate(pairs))
    results: dict[int, Counts] = {}

    def work(worker: int) -> None:
        # The first takes the long files, the others the short ones: no core is idle at the end, and a run that has
        # not the time for all has begun most of them.
        while waiting:
            try:
                place, pair = waiting.popleft() if worker == 0 else waiting.pop()
            except IndexError:
                return
            results[place] = one(pair)

    with ThreadPoolExecutor(max_workers=FILES_TOGETHER) as pool:
        list(pool.map(work, range(FILES_TOGETHER)))
    ran = [(pair, results[place]) for place, pair in enumerate(pairs)]
    return [counts_of_files(suite, [(file, counts) for (owner, file), counts in ran if owner is suite], build,
                            environment) for suite in long_suites]


def counts_of_files(suite: Suite, ran: list[tuple[str, Counts]], build: Path, environment: dict[str, str]) -> Counts:
    """The counts of a suite whose files have run, after those that failed have been run once more by themselves."""
    failed = [file for file, counts in ran if counts.failed]
    after = []
    for file, counts in ran:
        part = part_of(suite, file)
        if counts.failed and len(failed) <= SECOND_TRIES:
            counts = replace(tried_again(part, report_of(part, build), "", environment, counts), seconds=counts.seconds)
        after.append(counts)
    counts = sum_of(after)
    if counts.not_begun:
        print(f"{suite.name}: not begun, for there was no time: {len(counts.not_begun)} of {len(suite.files)} files",
              flush=True)
        if counts.passed == 0:
            counts = replace(counts, failed=counts.failed + 1)
    say_counts(suite, counts)
    return counts


def has_room(folder: Path) -> bool:
    """Whether tests can write there and run what they write."""
    try:
        if shutil.disk_usage(folder).free < SCRATCH_BYTES:
            return False
        with tempfile.TemporaryDirectory(dir=folder) as probe:
            script = Path(probe) / "probe"
            script.write_text("#!/bin/sh\n")
            script.chmod(0o755)
            return subprocess.run([script], check=False).returncode == 0
    except OSError:
        return False


@contextlib.contextmanager
def scratch(build: Path) -> Iterator[Path]:
    """A folder for what tests write: they make and remove hundreds of thousands of files, for which a disk may take
    longer than for the tests. In memory where this machine has room, else below the build's folder."""
    parent = IN_MEMORY if has_room(IN_MEMORY) else build
    with tempfile.TemporaryDirectory(prefix="ros2wasm-tests-", dir=parent, ignore_cleanup_errors=True) as folder:
        yield Path(folder)


def run_suites(chosen: list[Suite], build: Path, environment: dict[str, str],
               is_named: bool) -> list[tuple[Suite, Counts]]:
    """Each suite with its counts. One that cannot run here is a failure where it was asked for by its name."""

    def result(suite: Suite) -> Counts:
        if suite.not_run:
            print(f"{suite.name:12} not run: {suite.not_run}", flush=True)
            return Counts(0, 1 if is_named else 0)
        return run(suite, build, environment)

    pairs = [suite for suite in chosen if not suite.alone]
    alone = [suite for suite in chosen if suite.alone and not suite.files]
    by_file = [suite for suite in chosen if suite.files]
    with ThreadPoolExecutor(max_workers=TOGETHER) as pool:
        results = [*pool.map(result, pairs), *map(result, alone)]
    results += run_files(by_file, build, environment)
    return list(zip(pairs + alone + by_file, results, strict=True))


def say_times(ran: list[tuple[Suite, Counts]], build: Path) -> None:
    print("\nslowest tests (s):")
    reports = [report for suite, _ in ran for report in sorted((build / "test-reports").glob(f"{suite.name}*.xml"))]
    for seconds, name in slowest(reports):
        print(f"{seconds:7.1f}  {name}")
    print("\nminutes by suite:")
    for suite, counts in sorted(ran, key=lambda row: -row[1].seconds):
        print(f"{counts.seconds / 60:7.1f}  {suite.name}")


def say_gaps(ran: list[tuple[Suite, Counts]], build: Path) -> None:
    """What was not begun, and what passed at the second try only; the latter is written to a file, too."""
    for suite, counts in ran:
        for file in counts.not_begun:
            print(f"not begun: {Path(file).relative_to(ROOT)}")
    again = [f"{suite.name}: {name}" for suite, counts in ran for name in counts.again]
    (build / "test-reports" / "second-tries.txt").write_text("".join(f"{line}\n" for line in again))
    for line in again:
        print(f"passed at the second try only: {line}")


def main() -> int:
    # Shells have what they start in the background ignore it, and tests are about it.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=Path, required=True)
    parser.add_argument("--bless", action="store_true")
    parser.add_argument("filter", nargs="*", help="names of suites; all when none is given")
    options = parser.parse_args()
    build = options.build.resolve()
    shutil.rmtree(build / "test-reports", ignore_errors=True)
    rows = suites(build, options.bless)
    unknown = set(options.filter) - {suite.name for suite in rows}
    if unknown:
        parser.error(f"no such suite: {', '.join(sorted(unknown))}; there are {', '.join(s.name for s in rows)}")
    chosen = chosen_of(rows, options.filter, NIGHTLY)
    with scratch(build) as folder:
        environment = dict(os.environ, ROS2WASM_BUILD=str(build), ROS2WASM_CLI=str(build / "ros2wasm"),
                           ROS2WASM_CONDA_DATA=str(conda_data()), ROS2WASM_TEST_CACHE=str(folder / "cache"),
                           TMPDIR=str(folder))
        ran = run_suites(chosen, build, environment, bool(options.filter))
    say_times(ran, build)
    say_gaps(ran, build)
    passed = sum(counts.passed for _, counts in ran)
    failed = sum(counts.failed + counts.skipped for _, counts in ran)
    if not NIGHTLY and not options.filter:
        print("an ordinary run; ROS2WASM_NIGHTLY=1 also fuzzes, and plays scenes on every link and in every host")
    print(f"{passed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
