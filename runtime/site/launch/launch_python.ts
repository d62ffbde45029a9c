// Runs the Python launch files of a site again, in a worker of their own: Pyodide and the evaluator beside each other, so
// that one can ask the other. Python has the same view as when the site was packed (templates/python/read_launch.mjs):
// the site's files, read-only, a date that stands still, and no JavaScript.

import type { PyCallable, PyProxy } from 'pyodide/ffi';
import { openEvaluator } from './launch_evaluator.ts';
import type { RunLaunch } from '../python/launch_run.ts';
import { openPyodide } from '../python/pyodide_loader.ts';
import { archivesOf, fetchedOf, install, prefix } from '../python/python_image.ts';
import { mountShare } from '../python/python_program.ts';
import { RunningSha256 } from '../contract/running_sha256.ts';
import { seededRandom } from '../contract/seeded_random.ts';
import type { SiteFile } from '../contract/session.ts';
import type { ReadNow } from '../program/site_files.ts';

const tools = '/tools';
const modules = `${prefix}/lib/python3.12/site-packages`;
const someDayNs = Date.UTC(2000, 0, 1) * 1e6;
const someSeed = 2000;
const doors = ['js', 'pyodide_js', 'pyodide'];
const prepare = `
import sys
for name in [one for one in sys.modules if one.partition('.')[0] in doors]:
    del sys.modules[name]
sys.path[:0] = places
sys.dont_write_bytecode = True
import launch
from ros2wasm_launch import reader
reader.prepare()
reader.answer`;

function sha256Of(bytes: Uint8Array): string {
  const sum = new RunningSha256();
  sum.add(bytes);
  return sum.hex();
}

/** A file that differs from the packed one is treated as missing. */
function verified(readNow: ReadNow, listed: readonly SiteFile[]): ReadNow {
  const hashes = new Map(listed.map(({ path, sha256 }) => [path, sha256]));
  return (place, path) => {
    const bytes = readNow(place, path);
    const expected = hashes.get(path) ?? '';
    return bytes === undefined || expected === '' || sha256Of(bytes) === expected ? bytes : undefined;
  };
}

interface FileSystem {
  readonly mkdirTree: (path: string) => void;
  readonly writeFile: (path: string, text: string) => void;
  readonly chmod: (path: string, mode: number) => void;
}

export const runLaunch: RunLaunch = async (module, start, files, readNow, begun) => {
  const home = start.base + start.home;
  const [recorders, ...others] = await archivesOf(start, start.archives, files);
  let looks = 0; // a time that is waited for comes: each look at it is a millisecond
  const steadyNs = (): number => {
    looks += 1;
    return looks * 1e6;
  };
  const { python } = await openPyodide({
    module,
    home,
    open: await files.pyodide(home),
    environment: { HOME: '/home', PYTHONHASHSEED: '0' },
    place: { clock: { steadyNs, systemNs: () => someDayNs }, random: seededRandom(someSeed, tools) },
    image: undefined,
    toBeKept: false,
    fetched: fetchedOf(start),
  });
  if (recorders === undefined) throw new TypeError('the site has nothing that records launch files');
  install(python, [recorders], tools);
  install(python, others);
  const read = verified(readNow, start.listed);
  mountShare(python, { files: start.files, readNow: read });
  const system = python['FS'] as unknown as FileSystem;
  const { texts = {} } = JSON.parse(start.data) as { readonly texts?: Readonly<Record<string, string>>; };
  for (const [path, text] of Object.entries(texts)) {
    system.mkdirTree(path.slice(0, path.lastIndexOf('/')));
    system.writeFile(path, text);
    system.chmod(path, 0o444);
  }
  let reply: (asked: string) => string = () => '{}';
  python.registerJsModule('ros2wasm_host', { ask: (text: string) => reply(text) });
  for (const name of doors.slice(0, 2)) python.unregisterJsModule(name);
  const globals = python.toPy({ places: [tools, modules], doors }) as PyProxy;
  const answer = python.runPython(prepare, { globals }) as PyCallable;
  const evaluate = await openEvaluator(start.evaluator, {
    python: (request, replying) => {
      reply = replying;
      return String(answer(request));
    },
    file: (path) => {
      const bytes = read(start.files.place, path);
      return bytes === undefined ? undefined : new TextDecoder().decode(bytes);
    },
  });
  begun();
  return evaluate(`{"launch":${start.data},"files":{},${start.rest}`);
};
