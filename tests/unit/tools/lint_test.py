"""The house rules find what is planted in a file."""
from __future__ import annotations

import subprocess
import tempfile
import unittest
from pathlib import Path

from tests.tools.lint import FUNCTION_LIMIT, LIMIT, ROOT, house_rules


def problems(suffix: str, text: str) -> str:
    """Of a file with this text in the folder of the bus."""
    with tempfile.NamedTemporaryFile("w", suffix=suffix, dir=ROOT / "runtime/site/bus", prefix="planted_") as file:
        file.write(text)
        file.flush()
        return house_rules([Path(file.name).relative_to(ROOT).as_posix()]) or ""


def function(lines: int) -> str:
    return "export function grow(): void {\n" + "  grow();\n" * lines + "}\n"


class FormatTest(unittest.TestCase):
    def test_a_planted_fault_is_found_and_mended(self) -> None:
        with tempfile.NamedTemporaryFile("w+", suffix=".ts", dir=ROOT / "runtime/site/bus", prefix="planted_") as file:
            file.write('export const one="1" ;\n')
            file.flush()
            name = Path(file.name).relative_to(ROOT).as_posix()

            def run(mode: str) -> subprocess.CompletedProcess[str]:
                command = ["node", "tests/tools/format.ts", mode, name]
                return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)

            found = run("check")
            self.assertEqual((found.returncode, found.stdout), (1, f"{name}: not formatted (./dev fmt)\n"))
            self.assertEqual(run("fix").returncode, 0)
            self.assertEqual(Path(file.name).read_text(encoding="utf-8"), "export const one = '1';\n")
            self.assertEqual(run("check").returncode, 0)


class HouseRulesTest(unittest.TestCase):
    def test_names_of_typescript(self) -> None:
        for text, said in {
            "const kLimit = 3;\n": "kLimit: a constant has no prefix",
            "  const kLimit: number = 3;\n": "kLimit: a constant has no prefix",
            "export interface reader {\n}\n": "reader: a type begins with a capital letter",
            "type reader_ref = string;\n": "reader_ref: a type begins with a capital letter",
            "export async function read_all(): Promise<void> {\n}\n": "read_all: a function is in camelCase",
            "let next_one = 1;\n": "next_one: a variable is in camelCase",
        }.items():
            self.assertIn(said, problems(".ts", text), text)

    def test_other_names_are_left_alone(self) -> None:
        text = """const LIMIT = 3;
const kind = 1;
const { map_load_time: time } = { map_load_time: 1 };
export class Reader {}
function read(): number {
  const text = `
const size_t count = 3;
`;
  return time + kind + LIMIT + text.length;
}
"""
        self.assertEqual(problems(".ts", text), "")

    def test_a_function_has_a_limit(self) -> None:
        self.assertEqual(problems(".ts", function(FUNCTION_LIMIT - 1)), "")
        self.assertIn(f"a function of {FUNCTION_LIMIT + 21} lines", problems(".ts", function(FUNCTION_LIMIT + 20)))
        native = "int grow(int by) {\n" + "  by += 1;\n" * (FUNCTION_LIMIT + 5) + "  return by;\n}\n"
        self.assertIn(f"a function of {FUNCTION_LIMIT + 7} lines", problems(".cpp", native))
        method = "class A {\n  grow(): void {\n" + "    grow();\n" * (FUNCTION_LIMIT + 5) + "  }\n}\n"
        self.assertIn("a function of", problems(".ts", method))

    def test_a_file_has_a_limit(self) -> None:
        self.assertIn(f"{LIMIT + 1} lines; a file has one subject", problems(".ts", "export {};\n" * (LIMIT + 1)))

    def test_words_of_a_slot_have_names(self) -> None:
        self.assertIn("has a name in BusSlot", problems(".ts", "const a = i32[slot + 2];\n"))


if __name__ == "__main__":
    unittest.main()
