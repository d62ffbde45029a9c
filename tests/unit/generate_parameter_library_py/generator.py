"""The generator of code from files of parameters, for its tests."""
from __future__ import annotations

import contextlib
import importlib
import io
import sys
import tempfile
import unittest
from pathlib import Path
from typing import Any
from unittest import mock

PACKAGE = Path(__file__).resolve().parents[3] / 'runtime/packages/control/generate_parameter_library_py'


class GeneratorTest(unittest.TestCase):
    modules: Any

    @classmethod
    def setUpClass(cls) -> None:
        super().setUpClass()
        cls.enterClassContext(mock.patch.object(sys, 'path', [str(PACKAGE), *sys.path]))

    def setUp(self) -> None:
        super().setUp()
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.yaml = self.folder / 'parameters.yaml'
        self.warnings = ''

    def module(self, name: str) -> Any:
        return importlib.import_module(f'generate_parameter_library_py.{name}')

    def generated(self, text: str | bytes, language: str = 'cpp', validators: str = '') -> str:
        """The code for a file."""
        self.yaml.write_bytes(text if isinstance(text, bytes) else text.encode())
        output = self.folder / 'out' / ('code.hpp' if language == 'cpp' else 'code.py')
        run = self.module('generate_cpp_header' if language == 'cpp' else 'generate_python_module').run
        said = io.StringIO()
        with contextlib.redirect_stderr(said):
            run(str(output), str(self.yaml), validators)
        self.warnings = said.getvalue()
        return output.read_text()

    def refusal(self, text: str | bytes, language: str = 'cpp', validators: str = '') -> str:
        """What is said of a file, which is named `F` here."""
        with self.assertRaises(self.module('errors').ParameterFileError) as caught:
            self.generated(text, language, validators)
        return str(caught.exception).replace(str(self.yaml), 'F')

    def parameter(self, lines: str, language: str = 'cpp', validators: str = '') -> str:
        """The code for one parameter `x`, from what stands below its name."""
        return self.generated(f'ns:\n  x: {{{lines}}}\n', language, validators)

    def refused_parameter(self, lines: str, language: str = 'cpp', validators: str = '') -> str:
        """What is said of it; it stands in line 2."""
        return self.refusal(f'ns:\n  x: {{{lines}}}\n', language, validators)
