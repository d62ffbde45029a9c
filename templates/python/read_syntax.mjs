// Says which texts are not valid Python: each is compiled in Pyodide, and none of it runs.
// usage: node read_syntax.mjs PYODIDE
// a line {"texts": [TEXT]} comes in; a line [{"text": INDEX, "line": N, "column": N, "length": N, "why": WORDS}] goes out

import { receive, send } from './lines.mjs';
import { startPython } from './pyodide.mjs';

const python = await startPython(process.argv[2]);
const answer = python.runPython(`
import json
import warnings


def mistake(index: int, text: str) -> dict[str, object] | None:
    try:
        # Bytes, so that a line on the encoding counts as in a file.
        compile(text.encode('utf-8', 'surrogateescape'), 'file', 'exec', dont_inherit=True)
    except SyntaxError as error:
        line, column = error.lineno or 1, error.offset or 0
        same_line = error.end_lineno in (None, error.lineno)
        length = (error.end_offset or 0) - column if same_line else 1
        return {'text': index, 'line': line, 'column': max(column, 0), 'length': max(length, 1), 'why': error.msg}
    except (RecursionError, MemoryError, ValueError) as error:
        return {'text': index, 'line': 1, 'column': 0, 'length': 1, 'why': str(error) or type(error).__name__}
    return None


def answer(line: str) -> str:
    warnings.simplefilter('ignore')
    found = (mistake(index, text) for index, text in enumerate(json.loads(line)['texts']))
    return json.dumps([one for one in found if one is not None])


answer`);
for (let line = receive(); line !== undefined; line = receive()) send(answer(line));
