// The cost of cv2 in a Python node: VGA pictures, beside the OpenCV of the desktop's Python (python3-opencv) on one thread.
import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { inBrowser } from './browser_site.ts';
import { machineLoad } from './machine_load.ts';
import { packLaunch } from './packed_launch.ts';
import type { BenchContext } from './run.ts';

/** At most: how often the desktop's time the mask of a line follower takes. */
const MOST_OF_MASK = 4;
const MASK = 'HSV, inRange, findContours';
const SCRIPT = 'tests/bench/packages/python_bench/scripts/sees';

type Steps = ReadonlyMap<string, number>;

function stepsOf(text: string): Steps {
  const lines = [...text.matchAll(/\{"step".*?\}/g)].map(([json]) => JSON.parse(json) as { readonly step: string; readonly ms: number; });
  return new Map(lines.map(({ step, ms }) => [step, ms]));
}

/** undefined: this machine's Python has no OpenCV. */
function onDesktop(context: BenchContext): Steps | undefined {
  const run = spawnSync('/usr/bin/python3', ['-c', `import cv2; cv2.setNumThreads(1); exec(open('${SCRIPT}').read())`], {
    cwd: context.root,
    encoding: 'utf8',
  });
  return run.status === 0 ? stepsOf(run.stdout) : undefined;
}

export async function benchVision(context: BenchContext): Promise<void> {
  const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-bench-'));
  try {
    const site = packLaunch(context, folder, ['python_bench'], 'sees', ['{package: python_bench, executable: sees}']);
    const peer = onDesktop(context);
    if (peer === undefined) console.error('python3-opencv is not installed: the times have no peer');
    const headless = spawnSync(join(context.build, 'ros2wasm'), ['run', site, '--until', 'sees: done', '--for', '120s'], { encoding: 'utf8' });
    let inPage = '';
    await inBrowser(site, async (page, _pid, url) => {
      await page.goto(url);
      await page.waitForFunction(() => document.body.innerText.includes('sees: done'), undefined, { timeout: 120_000 });
      inPage = await page.evaluate(() => document.body.innerText);
    });
    const places = new Map([['Node.js', stepsOf(headless.stdout)], ['Chromium', stepsOf(inPage)]]);
    for (const [place, steps] of places) {
      if (steps.size === 0) context.fail(`vision: ${place}: nothing was measured`);
      for (const [what, ms] of steps) {
        // The desktop's is imported already when the script begins.
        const other = what === 'import' ? undefined : peer?.get(what);
        const ratio = other === undefined ? undefined : Math.round((ms / other) * 100) / 100;
        context.emit({
          bench: 'vision',
          what: `cv2: ${what}`,
          place,
          picture: '640 x 480',
          ms,
          ...(other === undefined ? {} : { peer: 'OpenCV of python3-opencv, one thread', peer_ms: other, ratio }),
          machine_load: machineLoad(),
        });
        if (what === MASK && ratio !== undefined && ratio > MOST_OF_MASK) context.fail(`vision: ${what} takes ${ratio} times the desktop's time in ${place}`);
      }
    }
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
