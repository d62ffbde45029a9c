// The script that a node worker in a browser loads when its node is a Python program, or to run launch files in Python.

import { runLaunch } from '../launch/launch_python.ts';
import { makeImage } from '../python/python_image.ts';
import { type PythonRuntime, runPython } from '../python/python_program.ts';

Object.assign(globalThis, { ros2wasmPython: { run: runPython, makeImage, runLaunch } satisfies PythonRuntime });
