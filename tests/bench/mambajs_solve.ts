// Solves once or more with mambajs, the solver of today's wasm line, and prints what it took as JSON.
// Its requests are answered from a folder, so that no network and no server is in the figures.
//   node mambajs_solve.ts CHANNEL_DIR RUNS SPEC...
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

const ORIGIN = 'http://channel.invalid';
const [folder = '.', runs = '1', ...specs] = process.argv.slice(2);

/** A response that bears the address it came from, as the solver wants to see it. */
function respond(body: Uint8Array<ArrayBuffer> | null, url: string): Response {
  const response = new Response(body, { status: body === null ? 404 : 200 });
  Object.defineProperty(response, 'url', { value: url });
  return response;
}

globalThis.fetch = (input): Promise<Response> => {
  const url = input instanceof Request ? input.url : input.toString();
  const path = join(folder, new URL(url).pathname.replace(/^\/channel\//, ''));
  const here = url.startsWith(`${ORIGIN}/channel/`) && existsSync(path);
  return Promise.resolve(respond(here ? Uint8Array.from(readFileSync(path)) : null, url));
};

const { solve } = await import('@emscripten-forge/mambajs');
const lines = ['channels:', `  - ${ORIGIN}/channel`, 'dependencies:', ...specs.map((spec) => `  - "${spec}"`)];
const solves: { wallMs: number; cpuMs: number; }[] = [];
let packages: string[] = [];
for (let i = 0; i < Number(runs); i += 1) {
  const began = performance.now();
  const used = process.cpuUsage();
  const lock = await solve({ ymlOrSpecs: lines.join('\n'), platform: 'emscripten-wasm32' });
  const { user, system } = process.cpuUsage(used);
  solves.push({ wallMs: performance.now() - began, cpuMs: (user + system) / 1000 });
  packages = Object.values(lock.packages).map((one) => `${one.name} ${one.version}`).sort();
}
console.log(JSON.stringify({ solves, packages }));
