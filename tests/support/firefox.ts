// Debian's Firefox, driven by WebDriver BiDi: as much of it as a test needs that opens a page and looks at it.
// playwright-core's own client asks for commands that this Firefox has not.

import { type ChildProcess, spawn } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const program = 'firefox-esr';
const listening = /WebDriver BiDi listening on (ws:\/\/\S+)/;
const lookMs = 200;

type Answer = { readonly id?: number; readonly type: string; readonly result?: unknown; readonly error?: string; readonly message?: string; };
type Evaluated = { readonly type: string; readonly result?: { readonly value?: unknown; }; readonly exceptionDetails?: { readonly text: string; }; };

/** Where it waits for its driver. */
function addressOf(child: ChildProcess): Promise<string> {
  return new Promise((resolve, reject) => {
    let said = '';
    child.stderr?.on('data', (bytes: Buffer) => {
      said += bytes.toString();
      const [, address] = listening.exec(said) ?? [];
      if (address !== undefined) resolve(address);
    });
    child.on('error', reject);
    child.on('exit', (code) => reject(new Error(`${program} ends with ${code}: ${said}`)));
  });
}

function connected(address: string): Promise<WebSocket> {
  const socket = new WebSocket(address);
  return new Promise((resolve, reject) => {
    socket.onopen = () => resolve(socket);
    socket.onerror = () => reject(new Error(`${address} cannot be reached`));
  });
}

export class Firefox {
  private readonly child: ChildProcess;
  private readonly profile: string;
  private readonly socket: WebSocket;
  private readonly pending = new Map<number, (answer: Answer) => void>();
  private context = '';

  private constructor(child: ChildProcess, profile: string, socket: WebSocket) {
    this.child = child;
    this.profile = profile;
    this.socket = socket;
    socket.onmessage = ({ data }) => {
      const answer = JSON.parse(String(data)) as Answer;
      if (answer.id === undefined) return;
      this.pending.get(answer.id)?.(answer);
      this.pending.delete(answer.id);
    };
  }

  /** Without service workers a page has the headers that its host sends, and no others. */
  static async launch({ serviceWorkers }: { readonly serviceWorkers: boolean; }): Promise<Firefox> {
    const profile = mkdtempSync(join(tmpdir(), 'ros2wasm-firefox-'));
    writeFileSync(join(profile, 'user.js'), `user_pref("dom.serviceWorkers.enabled", ${serviceWorkers});\n`);
    const child = spawn(program, ['--headless', '--no-remote', '--profile', profile, '--remote-debugging-port', '0'], {
      stdio: ['ignore', 'ignore', 'pipe'],
      env: { ...process.env, HOME: profile },
    });
    const socket = await connected(`${await addressOf(child)}/session`);
    const firefox = new Firefox(child, profile, socket);
    await firefox.send('session.new', { capabilities: {} });
    firefox.context = (await firefox.send('browsingContext.create', { type: 'tab' }) as { readonly context: string; }).context;
    return firefox;
  }

  private async send(method: string, params: object): Promise<unknown> {
    const id = this.pending.size === 0 ? 1 : Math.max(...this.pending.keys()) + 1;
    const answer = await new Promise<Answer>((resolve) => {
      this.pending.set(id, resolve);
      this.socket.send(JSON.stringify({ id, method, params }));
    });
    if (answer.type !== 'success') throw new Error(`${method}: ${answer.error} ${answer.message}`);
    return answer.result;
  }

  async goto(url: string): Promise<void> {
    await this.send('browsingContext.navigate', { context: this.context, url, wait: 'complete' });
  }

  /** The value of an expression in the page: a text, a number or a boolean. */
  async evaluate(expression: string): Promise<unknown> {
    const target = { context: this.context };
    const found = await this.send('script.evaluate', { expression, target, awaitPromise: true }) as Evaluated;
    if (found.type !== 'success') throw new Error(found.exceptionDetails?.text ?? 'the page fails');
    return found.result?.value;
  }

  /** Waits until the page has a text that fits. Throws what the page has instead. */
  async seen(pattern: RegExp, timeoutMs: number): Promise<void> {
    const end = performance.now() + timeoutMs;
    for (;;) {
      const text = String(await this.evaluate("document.body?.innerText ?? ''"));
      if (pattern.test(text)) return;
      if (performance.now() > end) throw new Error(`nothing fits ${pattern} in: ${text}`);
      await new Promise((resolve) => setTimeout(resolve, lookMs));
    }
  }

  async close(): Promise<void> {
    const gone = new Promise((resolve) => this.child.once('exit', resolve));
    this.socket.close();
    this.child.kill('SIGKILL');
    await gone;
    rmSync(this.profile, { recursive: true, force: true });
  }
}
