#!/usr/bin/env python3
"""Builds the fuzz targets and runs each for some seconds on its corpus, two at a time.

A finding is written to build-fuzz/findings; `build-fuzz/tests/fuzz/fuzz_NAME FILE` repeats it.
"""
from __future__ import annotations

import argparse
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

# Guarantee, hostile input: any text as a version, spec, manifest, lock, index, shard, archive, launch file, signature,
# key or file that a student hands in: fuzzed with a corpus under the address and undefined behaviour sanitizers
ROOT = Path(__file__).resolve().parents[2]
CORPUS = ROOT / "tests" / "fuzz" / "corpus"
BUILD = ROOT / "build-fuzz"
TARGETS = ["version", "match_spec", "repodata", "shards", "manifest", "lock", "archive", "launch",
           "signature", "progress"]


def build(targets: list[str]) -> bool:
    if not (BUILD / "build.ninja").exists():
        subprocess.run(["cmake", "--preset", "fuzz"], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    names = [f"fuzz_{target}" for target in targets]
    made = subprocess.run(["ninja", "-C", str(BUILD), *names], text=True, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if made.returncode != 0:
        print(made.stdout[-6000:])
    return made.returncode == 0


def fuzz(target: str, seconds: int, seed: int) -> tuple[str, bool, str]:
    """New inputs go to build-fuzz and are used again; the corpus of the repository is only read."""
    grown = BUILD / "corpus" / target
    findings = BUILD / "findings"
    for folder in (grown, findings):
        folder.mkdir(parents=True, exist_ok=True)
    command = [str(BUILD / "tests" / "fuzz" / f"fuzz_{target}"), f"-max_total_time={seconds}", f"-seed={seed}",
               "-timeout=20", "-rss_limit_mb=1500", "-max_len=16384", "-print_final_stats=1",
               f"-artifact_prefix={findings}/{target}-", str(grown), str(CORPUS / target)]
    done = subprocess.run(command, cwd=BUILD, text=True, errors="replace", check=False, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, env=dict(os.environ, UBSAN_OPTIONS="print_stacktrace=1"))
    (BUILD / f"fuzz-{target}.log").write_text(done.stdout)
    return target, done.returncode == 0, done.stdout


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=int, default=60, help="per target")
    parser.add_argument("--seed", type=int, default=0, help="0: another one each time")
    parser.add_argument("target", nargs="*", choices=[[], *TARGETS], help="all when none is given")
    options = parser.parse_args()
    targets = options.target or TARGETS
    if not build(targets):
        return 1
    with ThreadPoolExecutor(max_workers=2) as pool:
        results = list(pool.map(lambda target: fuzz(target, options.seconds, options.seed), targets))
    for target, fine, output in results:
        runs = [line.split(":")[-1].strip() for line in output.splitlines() if "number_of_executed_units" in line]
        print(f"{target:12} {'clean' if fine else 'FOUND'} after {runs[-1] if runs else '?'} inputs")
        if not fine:
            print(output[-4000:])
    failed = sum(not fine for _, fine, _ in results)
    print(f"{len(results) - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
