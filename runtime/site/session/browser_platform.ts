// A browser page as the place where a site runs.

import { fetchOfSite, setPlaces, type WorkerFile, workerFiles } from '../program/carried_files.ts';
import { ExpectedFiles } from '../program/expected_files.ts';
import { keptBytes } from '../program/cached_bytes.ts';
import { keptTexts } from '../contract/stored_texts.ts';
import type { HoldOrder } from '../workers/worker_messages.ts';
import { answerForList } from '../program/own_list.ts';
import type { Platform, WorkerEvents, WorkerHandle } from '../workers/platform.ts';
import { SiteError } from '../contract/site_error.ts';
import { lifeOver, newLife } from '../workers/worker_life.ts';
import { strangeReport, takeReport } from '../workers/worker_reports.ts';

async function get(path: string, base: URL, cache: RequestCache = 'default'): Promise<Response> {
  const url = new URL(path, base);
  let response: Response;
  try {
    response = await fetchOfSite(path, base, cache);
  } catch (error) {
    // The loader of a page that carries its files throws its own.
    const carried = error as Partial<SiteError>;
    if (carried.name === 'SiteError')
      throw new SiteError(carried.code ?? 'R2W0706', String(carried.message), { why: carried.why ?? [], fix: carried.fix ?? [] });
    throw new SiteError('R2W0706', `${url.pathname} cannot be fetched: ${error instanceof Error ? error.message : String(error)}`, {
      why: 'the host is not reachable, and the page has no copy of the file yet',
      fix: 'reload the page when the connection is back',
    });
  }
  if (!response.ok) {
    throw new SiteError('R2W0706', `${url.pathname} cannot be fetched: the host answers ${response.status}`, {
      why: 'the folder on the host is not complete',
      fix: 'put all files that `ros2wasm pack` wrote in place',
    });
  }
  return response;
}

async function compileModule(path: string, bytes: ArrayBuffer): Promise<WebAssembly.Module> {
  try {
    return await WebAssembly.compile(bytes);
  } catch (error) {
    throw new SiteError('R2W0703', `${path}: ${error instanceof Error ? error.message : String(error)}`);
  }
}

export interface BrowserPlatform extends Platform {
  /** After expect(): workers can start at once from then on. Never rejects: the caller that starts a worker gets the error. */
  readonly ready: Promise<void>;
  close(): void;
}

/**
 * Workers start from a blob: URL of the script. Such a worker has the page's Content-Security-Policy, whatever headers
 * the host sends; a worker from a plain URL would have only the host's. `early`: where the script lies, if not at its path.
 */
export function browserPlatform(base: URL, script: string, early?: string): BrowserPlatform {
  const modules = new Map<string, Promise<WebAssembly.Module>>();
  const expected = new ExpectedFiles();
  let known: () => void = () => undefined;
  const list = new Promise<void>((resolve) => {
    known = resolve;
  });
  let paths: readonly string[] = [];
  /** Where a host lets browsers keep files, an old one may come with a new site.json: then it is asked for once more. */
  const checked = async (path: string, bytes: ArrayBuffer): Promise<ArrayBuffer> => {
    if (await expected.matches(path, bytes)) return bytes;
    return expected.checked(path, await (await get(path, base, 'reload')).arrayBuffer());
  };
  const bytes = async (path: string): Promise<ArrayBuffer> => checked(path, await (await get(path, base)).arrayBuffer());
  const scriptUrl = Promise.all([get(early ?? script, base).then((response) => response.arrayBuffer()), list])
    .then(([text]) => checked(script, text))
    .then(async (text): Promise<WorkerScript> => ({
      url: URL.createObjectURL(new Blob([text], { type: 'text/javascript' })),
      files: await workerFiles(base, paths),
    }));
  return {
    ready: scriptUrl.then(
      () => undefined,
      () => undefined,
    ),
    place: base.href,
    json: async (path) => {
      const response = await get(path, base);
      const text = await response.text();
      if (path === 'site.json') answerForList(text);
      try {
        return JSON.parse(text) as unknown;
      } catch (error) {
        throw new SiteError('R2W0700', `${path}: ${error instanceof Error ? error.message : String(error)}`);
      }
    },
    expect: (files) => {
      expected.set(files);
      setPlaces(files);
      paths = files.map(({ path }) => path);
      known();
    },
    compile: (path) => {
      let module = modules.get(path);
      if (module === undefined) {
        module = get(path, base).then((response) => response.arrayBuffer()).then(async (program) => {
          // Beside the look at its hash; what is another one's is never run.
          const made = compileModule(path, program);
          made.catch(() => undefined);
          const right = await checked(path, program);
          return right === program ? made : compileModule(path, right);
        });
        modules.set(path, module);
        // A failed fetch may be tried again.
        module.catch(() => modules.delete(path));
      }
      return module;
    },
    bytes,
    kept: keptBytes(base, keptTexts('ros2wasm.kept ')),
    texts: keptTexts(`ros2wasm.source ${base.pathname} `),
    startWorker: (name, events) => new BrowserWorker(scriptUrl, name, events),
    frame: (task) => {
      // Frames do not come while the page is hidden.
      if (document.visibilityState === 'hidden') setTimeout(task, 100);
      else requestAnimationFrame(task);
    },
    close: () => {
      scriptUrl.then(({ url }) => URL.revokeObjectURL(url), () => undefined);
    },
  };
}

interface WorkerScript {
  readonly url: string;
  readonly files: ReadonlyMap<string, WorkerFile> | undefined;
}

/** Keeps orders until the script is there. */
class BrowserWorker implements WorkerHandle {
  private worker: Worker | undefined;
  private ended = false;
  private readonly life = newLife();
  private readonly early: (() => void)[] = [];

  constructor(script: Promise<WorkerScript>, name: string, events: WorkerEvents) {
    script.then(({ url, files }) => {
      if (this.ended) return;
      const worker = new Worker(url, { name });
      worker.onmessage = (event: MessageEvent<unknown>) => takeReport(event.data, events);
      worker.onerror = (event) => events.failed(event.message === undefined || event.message === '' ? 'the worker did not start' : event.message);
      worker.onmessageerror = () => events.failed(strangeReport.message, strangeReport.code);
      this.worker = worker;
      worker.postMessage({ t: 'hold', life: this.life, files } satisfies HoldOrder);
      for (const order of this.early) order();
    }).catch((error: unknown) => {
      if (!this.ended) events.failed(error instanceof Error ? error.message : String(error));
    });
  }

  post(order: Parameters<WorkerHandle['post']>[0], transfer: Parameters<WorkerHandle['post']>[1]): void {
    if (this.worker === undefined) this.early.push(() => this.post(order, transfer));
    else this.worker.postMessage(order, [...transfer]);
  }

  async terminate(): Promise<void> {
    this.ended = true;
    if (this.worker === undefined) return;
    this.worker.onmessage = null;
    this.worker.onerror = null;
    this.worker.terminate();
    await lifeOver(this.life);
  }
}
