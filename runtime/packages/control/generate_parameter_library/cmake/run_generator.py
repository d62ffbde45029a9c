"""
Runs the generator: run_generator.py MODULES LANGUAGE OUTPUT YAML [VALIDATORS].

MODULES is where generate_parameter_library_py is installed. What this Python has itself comes before it.
"""
import importlib
import sys

MODULES_OF_LANGUAGES = {'cpp': 'generate_cpp_header', 'python': 'generate_python_module'}

modules, language, *arguments = sys.argv[1:]
sys.path.append(modules)
sys.argv[1:] = arguments
sys.exit(importlib.import_module(f'generate_parameter_library_py.{MODULES_OF_LANGUAGES[language]}').main())
