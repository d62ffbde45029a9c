// Has the launch files in Python of a site run in a worker, when the site has Pyodide; no longer than a minute.

import { folderOf, homeOf, PythonFiles } from '../python/python_files.ts';
import type { Platform } from './platform.ts';
import type { LaunchView, SiteDescription } from '../contract/session.ts';
import { SiteError } from '../contract/site_error.ts';
import { siteFiles } from '../program/site_files.ts';

/** Until Python is there, and what it is given then. */
const longestLoadingMs = 180_000;
const longestRunMs = 60_000;

/** The answer of the evaluator when it runs together with Python. `rest`: the question, a part of a JSON object. */
export async function askWithPython(
  site: SiteDescription,
  launch: LaunchView,
  data: string,
  rest: string,
  platform: Platform,
): Promise<unknown> {
  const { program, archives } = launch.python ?? { archives: [] };
  if (program === undefined) throw new TypeError('the site has no Python');
  const [module, evaluator, parts] = await Promise.all([
    platform.compile(program),
    platform.compile(launch.evaluator),
    new PythonFiles(site, platform).parts(program, archives),
  ]);
  const files = siteFiles(site, folderOf(platform.place));
  const shared = new Set(files.files.map(([path]) => path));
  return new Promise((resolve, reject) => {
    let timer: ReturnType<typeof setTimeout> | undefined;
    const worker = platform.startWorker('launch file', {
      report: (report) => {
        if (report.t === 'running') limit(longestRunMs);
        if (report.t !== 'launch') return;
        if (report.failed === undefined) over(() => resolve(report.answer));
        else fail(report.failed);
      },
      failed: (message) => fail(message),
    });
    const over = (end: () => void): void => {
      clearTimeout(timer);
      void worker.terminate();
      end();
    };
    const fail = (message: string): void =>
      over(() =>
        reject(new SiteError('R2W0733', `the launch file cannot be evaluated: ${message}`, {
          why: 'these launch arguments lead to what only Python decides',
          fix: 'leave them out to start the site as it was made',
        }))
      );
    const limit = (ms: number): void => {
      clearTimeout(timer);
      timer = setTimeout(() =>
        over(() =>
          reject(new SiteError('R2W0416', 'a launch file does not end', {
            why: `it was given ${ms / 1000} seconds; its clock does not advance`,
            fix: 'leave the launch arguments out to start the site as it was made',
          }))
        ), ms);
    };
    limit(longestLoadingMs);
    worker.post({
      t: 'launch',
      module,
      start: {
        base: folderOf(platform.place),
        home: homeOf(program),
        archives,
        parts,
        evaluator,
        data,
        rest,
        files,
        listed: site.files.filter(({ path }) => shared.has(path)),
      },
    }, []);
  });
}
