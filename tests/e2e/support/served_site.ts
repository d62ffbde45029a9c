// Starts `ros2wasm serve` for a test and ends it; makes small sites to serve.
import { type ChildProcess, spawn } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';

export const CLI: string = process.env['ROS2WASM_CLI'] ?? new URL('../../../build/ros2wasm', import.meta.url).pathname;
const WATCHDOG_MS = 240_000; // with --watch the start is a whole pack

/** A folder that goes away with the test. */
export class Scratch {
  readonly path: string = mkdtempSync(join(tmpdir(), 'ros2wasm-e2e-'));

  file(path: string, content: string | Uint8Array): string {
    const full = join(this.path, path);
    mkdirSync(dirname(full), { recursive: true });
    writeFileSync(full, content);
    return full;
  }

  [Symbol.dispose](): void {
    rmSync(this.path, { recursive: true, force: true });
  }
}

export interface Ended {
  readonly code: number | null;
  readonly output: string;
  readonly errors: string;
}

/** A running `ros2wasm serve`. */
export class ServedSite {
  readonly #child: ChildProcess;
  readonly #ended: Promise<Ended>;
  #output = '';
  #errors = '';
  #url = '';
  #changed: () => void = () => {};

  private constructor(args: readonly string[], environment: NodeJS.ProcessEnv) {
    this.#child = spawn(CLI, ['serve', ...args], {
      stdio: ['ignore', 'pipe', 'pipe'],
      env: environment,
    });
    this.#child.stdout?.on('data', (chunk: Buffer) => {
      this.#output += chunk.toString();
      this.#changed();
    });
    this.#child.stderr?.on('data', (chunk: Buffer) => {
      this.#errors += chunk.toString();
      this.#changed();
    });
    this.#ended = new Promise((resolve) => {
      this.#child.on('close', (code) => {
        this.#changed();
        resolve({ code, output: this.#output, errors: this.#errors });
      });
    });
  }

  /** Resolves when the link is printed. */
  static async start(
    args: readonly string[],
    environment: NodeJS.ProcessEnv = process.env,
  ): Promise<ServedSite> {
    const site = new ServedSite(args, environment);
    await site.until(() => site.#output.includes('\n'), 'the link');
    site.#url = site.#output.split('\n')[0] ?? '';
    return site;
  }

  get url(): string {
    return this.#url;
  }

  get errors(): string {
    return this.#errors;
  }

  /** Waits for a condition on what the server printed. */
  async until(condition: () => boolean, what: string): Promise<void> {
    const deadline = Date.now() + WATCHDOG_MS;
    while (!condition()) {
      const report = (): Error => new Error(`waiting for ${what}:\n${this.#output}${this.#errors}`);
      if (this.#child.exitCode !== null) throw report();
      await new Promise<void>((resolve, reject) => {
        const watchdog = setTimeout(() => reject(report()), deadline - Date.now());
        this.#changed = () => {
          clearTimeout(watchdog);
          resolve();
        };
      });
    }
  }

  signal(name: NodeJS.Signals): Promise<Ended> {
    this.#child.kill(name);
    return this.#ended;
  }

  async [Symbol.asyncDispose](): Promise<void> {
    await this.signal('SIGKILL');
  }
}

/** The least that counts as a site, with some more files to ask for. */
export function makeSite(scratch: Scratch): string {
  scratch.file('site/index.html', '<!doctype html><html><head><title>t</title></head></html>');
  scratch.file('site/site.json', '{"schema":1}');
  return join(scratch.path, 'site');
}

/** Runs the command line to its end. */
export function runCli(args: readonly string[], signal?: AbortSignal): Promise<Ended> {
  return new Promise((resolve, reject) => {
    const child = spawn(CLI, args, { stdio: ['ignore', 'pipe', 'pipe'], ...(signal && { signal }) });
    let output = '';
    let errors = '';
    child.stdout.on('data', (chunk: Buffer) => (output += chunk.toString()));
    child.stderr.on('data', (chunk: Buffer) => (errors += chunk.toString()));
    child.on('error', reject);
    child.on('close', (code) => resolve({ code, output, errors }));
  });
}
