"""Names of files in documents: those that do not exist are found."""
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from tests.tools import documents


class DocumentsTest(unittest.TestCase):
    def faults(self, name: str, text: str) -> list[str]:
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder).resolve()
            (root / "cli").mkdir()
            (root / "cli/main.cpp").touch()
            document = root / name
            document.write_text(text, encoding="utf-8")
            with mock.patch.object(documents, "ROOT", root):
                return documents.faults(document, {"main.cpp"})

    def test_an_absent_file_is_named_with_its_place(self) -> None:
        text = "See cli/main.cpp.\nAnd `cli/gone.cpp`, [here](runtime/old.ts).\n"
        self.assertEqual(self.faults("README.md", text), [
            "README.md:2: there is no cli/gone.cpp", "README.md:2: there is no runtime/old.ts"])

    def test_short_names_of_the_architecture(self) -> None:
        self.assertEqual(self.faults("ARCHITECTURE.md", "| x | cli/main.cpp, main.cpp, gone.cpp |\n"),
                         ["ARCHITECTURE.md:1: there is no gone.cpp"])
        self.assertEqual(self.faults("README.md", "| x | gone.cpp |\n"), [])

    def test_placeholders_folders_and_addresses_are_ignored(self) -> None:
        text = "cli/explain/CODE.md, cli/, https://host/cli/x.cpp, src/cli/x.cpp\n"
        self.assertEqual(self.faults("README.md", text), [])


if __name__ == "__main__":
    unittest.main()
