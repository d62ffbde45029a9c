// The input of a worker that evaluates a launch file with Python.

import type { PythonParts } from './python_files.ts';
import type { WorkerFiles } from './worker_files.ts';
import type { SiteFile } from '../contract/session.ts';
import type { ReadNow, SiteFiles } from '../program/site_files.ts';

export interface LaunchStart {
  /** The folder of the site, and Pyodide's in it, as in PythonStart. */
  readonly base: string;
  readonly home: string;
  /** Archives of modules: those that record launch files, then those of the workspace. */
  readonly archives: readonly string[];
  readonly parts: PythonParts;
  readonly evaluator: WebAssembly.Module;
  /** launch.json. */
  readonly data: string;
  /** The rest of the question to the evaluator, a part of a JSON object. */
  readonly rest: string;
  readonly files: SiteFiles;
  /** The hashes of these. */
  readonly listed: readonly SiteFile[];
}

/** How python_worker.js is called in a browser to evaluate a launch file. `begun`: the interpreter is there. */
export type RunLaunch = (
  module: WebAssembly.Module,
  start: LaunchStart,
  files: WorkerFiles,
  readNow: ReadNow,
  begun: () => void,
) => Promise<unknown>;
