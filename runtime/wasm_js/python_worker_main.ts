// The script that a node worker in a browser loads when its node is a Python program.

import { makeImage } from './python_image.ts';
import { type PythonRuntime, runPython } from './python_program.ts';

Object.assign(globalThis, { ros2wasmPython: { run: runPython, makeImage } satisfies PythonRuntime });
