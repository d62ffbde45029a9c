// Runs a packed site once in Node.js and once in headless Chromium and prints the first messages
// that `listener` heard in each. `./dev demo --check` calls it; exit code 0 when both heard some.
import { chromium } from 'playwright-core';
import { wholeChromium } from './chromium.ts';
import { ServedSite, runCli } from './served_site.ts';

const WANTED = 3; // messages to wait for in each place
const WATCHDOG_MS = 60_000;
const HEARD = /\[minimal_subscriber\]: I heard: '[^']*'/g;

const [site] = process.argv.slice(2);
if (site === undefined) {
  console.error('usage: demo_check.ts SITE');
  process.exit(2);
}

async function runInNode(folder: string): Promise<string[]> {
  const limit = AbortSignal.timeout(WATCHDOG_MS);
  const run = await runCli(['run', folder, '--until', 'I heard: .*2', '--for', '30s'], limit);
  const heard = run.output.match(HEARD) ?? [];
  if (run.code !== 0) console.error(`${run.output}${run.errors}`);
  return run.code === 0 ? heard.slice(0, WANTED) : [];
}

async function runInChromium(folder: string): Promise<string[]> {
  await using server = await ServedSite.start([folder, '--port', '0']);
  const browser = await chromium.launch(wholeChromium());
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
        (count) => ((document.body?.innerText ?? '').match(/I heard: '[^']*'/g) ?? []).length >= count,
        wanted,
        { timeout: WATCHDOG_MS },
      )
      .catch((error: unknown) => console.error([String(error), ...problems].join('\n')));
    const text = await page.evaluate(() => (document.body?.innerText ?? ''));
    return (text.match(HEARD) ?? text.match(/I heard: '[^']*'/g) ?? []).slice(0, WANTED);
  } finally {
    await browser.close();
  }
}

function report(place: string, lines: readonly string[]): boolean {
  console.log(`${place}: ${lines.length >= WANTED ? 'ok' : 'FAILED'}`);
  for (const line of lines) console.log(`  ${line}`);
  return lines.length >= WANTED;
}

const inNode = report('Node.js', await runInNode(site));
const inChromium = report('Chromium', await runInChromium(site));
process.exit(inNode && inChromium ? 0 : 1);
