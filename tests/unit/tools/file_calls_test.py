"""The check for throwing calls of std::filesystem: what it finds, and what is fine."""
from __future__ import annotations

import unittest

from tests.tools.file_calls import throwing_calls


class FileCallsTest(unittest.TestCase):
    def test_each_planted_call_is_found(self) -> None:
        for call in (
            "fs::current_path()", "fs::weakly_canonical(fs::absolute(output, error))", "std::filesystem::exists(path)",
            "fs::is_directory(folder / name)", "fs::directory_iterator it(folder)", "fs::rename(from, to)",
            "fs::copy_file(a, b, fs::copy_options::overwrite_existing)", "fs::temp_directory_path()",
            "entry.is_directory()", "it->file_size()", "for (const auto& one : fs::directory_iterator(folder, error))",
            "fs::is_regular_file(fs::status(path))",
        ):
            with self.subTest(call):
                found = throwing_calls(f"int main() {{\n  {call};\n}}\n")
                self.assertTrue(found)
                self.assertEqual(found[0][0], 2)

    def test_calls_that_report_their_error_are_fine(self) -> None:
        for call in (
            "fs::current_path(error)", "fs::canonical(path, error)", "fs::exists(path, ignored)",
            "fs::is_directory(status)", "fs::is_symlink(fs::symlink_status(path, error))",
            "for (fs::recursive_directory_iterator it(path, error), end; !error && it != end; it.increment(error))",
            "fs::recursive_directory_iterator()", "fs::path(x).is_absolute()", "it->symlink_status(error)",
        ):
            with self.subTest(call):
                self.assertEqual(throwing_calls(call), [])

    def test_a_call_over_several_lines_is_one(self) -> None:
        self.assertEqual(throwing_calls("fs::copy_file(a,\n  b,\n  error);"), [])
        self.assertEqual(throwing_calls("x;\nfs::copy_file(a,\n  b);"), [(2, "fs::copy_file(a, b")])


if __name__ == "__main__":
    unittest.main()
