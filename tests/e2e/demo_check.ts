// Runs a packed site once in Node.js and once in headless Chromium and prints the first messages
// that `listener` heard in each. `./dev demo --check` calls it; exit code 0 when both heard some.
import { spawn, spawnSync } from 'node:child_process';
import { chromium } from 'playwright-core';
import { chromiumOptions } from './chromium.ts';

const WANTED = 3; // messages to wait for in each place
const WATCHDOG_MS = 60_000;
const HEARD = /\[minimal_subscriber\]: I heard: '[^']*'/g;

const [cli, site] = process.argv.slice(2);
if (cli === undefined || site === undefined) {
  console.error('usage: demo_check.ts CLI SITE');
  process.exit(2);
}

function runInNode(command: string, folder: string): string[] {
  const run = spawnSync(command, ['run', folder, '--until', 'I heard: .*2', '--for', '30s'], {
    encoding: 'utf8',
    timeout: WATCHDOG_MS,
  });
  const heard = `${run.stdout}`.match(HEARD) ?? [];
  if (run.status !== 0) console.error(`${run.stdout}${run.stderr}`);
  return run.status === 0 ? heard.slice(0, WANTED) : [];
}

/** Starts `ros2wasm serve` on a free port; resolves to its address, printed on standard output. */
async function serve(command: string, folder: string): Promise<{ url: string; close: () => void }> {
  const server = spawn(command, ['serve', folder, '--port', '0'], { stdio: ['ignore', 'pipe', 'pipe'] });
  let output = '';
  const url = await new Promise<string>((resolve, reject) => {
    const read = (chunk: Buffer): void => {
      output += chunk.toString();
      const match = /https?:\/\/[^\s]+/.exec(output);
      if (match) resolve(match[0]);
    };
    server.stdout.on('data', read);
    server.stderr.on('data', read);
    server.on('exit', () => reject(new Error(`serve ended early:\n${output}`)));
  });
  return { url, close: () => server.kill('SIGTERM') };
}

async function runInChromium(command: string, folder: string): Promise<string[]> {
  const server = await serve(command, folder);
  const browser = await chromium.launch(chromiumOptions());
  try {
    const page = await browser.newPage();
    const problems: string[] = [];
    page.on('console', (message) => {
      if (message.type() === 'error') problems.push(message.text());
    });
    page.on('pageerror', (error) => problems.push(String(error)));
    await page.goto(server.url);
    const wanted = WANTED;
    await page
      .waitForFunction(
        (count) => ((document.body?.innerText ?? "").match(/I heard: '[^']*'/g) ?? []).length >= count,
        wanted,
        { timeout: WATCHDOG_MS },
      )
      .catch((error: unknown) => console.error([String(error), ...problems].join('\n')));
    const text = await page.evaluate(() => (document.body?.innerText ?? ""));
    return (text.match(HEARD) ?? text.match(/I heard: '[^']*'/g) ?? []).slice(0, WANTED);
  } finally {
    await browser.close();
    server.close();
  }
}

function report(place: string, lines: readonly string[]): boolean {
  console.log(`${place}: ${lines.length >= WANTED ? 'ok' : 'FAILED'}`);
  for (const line of lines) console.log(`  ${line}`);
  return lines.length >= WANTED;
}

const inNode = report('Node.js', runInNode(cli, site));
const inChromium = report('Chromium', await runInChromium(cli, site));
process.exit(inNode && inChromium ? 0 : 1);
