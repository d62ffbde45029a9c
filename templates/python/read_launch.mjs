// Holds the launch files in Python of one evaluation, in Pyodide, and answers the evaluator: a line of JSON comes in, a
// line goes out. In between it may ask back the same way (`ask`). The workspace's own code runs here: it sees the
// folders that the first line names, for reading, and nothing else of this machine.
// usage: node read_launch.mjs PYODIDE
// first line: {"folders": [{"at": PATH, "from": PATH}], "modules": [PATH]}; then requests, see ros2wasm_launch/reader.py,
// or "seen": what was looked at in the folders so far, path -> what was there

import { fileURLToPath } from 'node:url';

import { receive, send } from './lines.mjs';
import { mountedFiles } from './mounted_files.mjs';
import { startPython } from './pyodide.mjs';

const tools = '/tools';

const { folders, modules } = JSON.parse(receive());
const python = await startPython(process.argv[2]);
const seen = new Map();
const files = mountedFiles(python.FS, seen);
for (const { at, from } of [{ at: tools, from: fileURLToPath(new URL('launch_modules', import.meta.url)) }, ...folders]) {
  python.FS.mkdirTree(at);
  python.FS.mount(files, { from, at }, at);
}
python.registerJsModule('ros2wasm_host', {
  ask: (text) => {
    send(text);
    return receive();
  },
});
python.globals.set('places', [tools, ...modules].join(':'));
const answer = python.runPython(`
import sys
sys.path[:0] = places.split(':')
sys.dont_write_bytecode = True
import launch
from ros2wasm_launch import reader
reader.prepare()
reader.answer`);
send('{"ready": true}');
// Its own files are no part of what it saw.
const seenSoFar = () => JSON.stringify(Object.fromEntries([...seen].filter(([path]) => !path.startsWith(`${tools}/`)).sort(([a], [b]) => (a < b ? -1 : 1))));
for (let line = receive(); line !== undefined; line = receive()) send(line === '"seen"' ? seenSoFar() : answer(line));
