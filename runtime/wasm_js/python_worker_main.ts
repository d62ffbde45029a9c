// The script that a node worker in a browser loads when its node is a Python program.

import { runPython } from './python_program.ts';

Object.assign(globalThis, { ros2wasmRunPython: runPython });
