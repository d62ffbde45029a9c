"""`inspect version|spec|match`: one line in, one JSON object out, whatever the line is."""
from __future__ import annotations

import json
import subprocess
import unittest

from tests.network.channel_fixture import CLI, WATCHDOG_SECONDS


def answers(what: str, text: str) -> list[dict[str, object]]:
    done = subprocess.run([CLI, "inspect", what], input=text, text=True, capture_output=True,
                          timeout=WATCHDOG_SECONDS, check=True)
    return [json.loads(line) for line in done.stdout.splitlines()]


class Inspect(unittest.TestCase):
    def test_versions_are_condas_nested_lists(self) -> None:
        self.assertEqual(answers("version", "1.0rc1\n1!2_3\n1.0.1_\n"), [
            {"input": "1.0rc1", "parsed": [[0], [1], [0, "rc", 1]]},
            {"input": "1!2_3", "parsed": [[1], [2], [3]]},
            {"input": "1.0.1_", "parsed": [[0], [1], [0], [1, "_"]]}])

    def test_a_local_version_stands_apart(self) -> None:
        self.assertEqual(answers("version", "2.0+a.1\n"),
                         [{"input": "2.0+a.1", "parsed": [[0], [2], [0]], "local": [[0, "a"], [1]]}])

    def test_every_line_has_its_answer(self) -> None:
        given = ["", "1.0", "bad version", "1.0\r", "a" * 5000, "\u00fc"]
        said = answers("version", "\n".join(given))
        self.assertEqual([one["input"] for one in said], [line.rstrip("\r") for line in given])
        self.assertEqual(["parsed" in one for one in said], [False, True, False, True, True, False])
        self.assertTrue(all(("parsed" in one) != ("error" in one) for one in said))

    def test_specs(self) -> None:
        good, bad = answers("spec", "conda-forge/noarch::NumPy >=1,<2 py*\nx[y=2]\n")
        self.assertEqual(good["parsed"], {"name": "numpy", "version": ">=1,<2", "build": "py*",
                                          "channel": "conda-forge", "subdir": "noarch"})
        self.assertIn("no field `y`", str(bad["error"]))

    def test_matches(self) -> None:
        rows = (("a >=3,<4|>=1,<2", "1.5", "0", True), ("a 1.7.*", "1.7.1", "0", True),
                ("a !=1.7", "1.7.1", "0", True), ("a 1.8.* *_cp311", "1.8.2", "h1_cp311", True),
                ("a ==1.8", "1.8.0", "0", True), ("a ~=0.5.3", "0.6", "0", False),
                ("a[build_number=>1]", "1", "h_2", True))
        said = answers("match", "".join(f"{spec}\t{version}\t{build}\n" for spec, version, build, _ in rows))
        self.assertEqual([(one["input"], one["matches"]) for one in said],
                         [(f"{spec}\t{version}\t{build}", matches) for spec, version, build, matches in rows])
        one, two = answers("match", "a\na >=1\tno version\t0\n")
        self.assertIn("spec<TAB>version<TAB>build", str(one["error"]))
        self.assertIn("no version", str(two["error"]))


if __name__ == "__main__":
    unittest.main()
