// A page on another origin and another site than the one that it shows in a frame: it is not cross-origin isolated, and talks
// with the frame by messages.

import assert from 'node:assert/strict';
import { type Server, createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import type { Browser, Frame, Page } from 'playwright-core';

const SCRIPT = `
globalThis.heard = [];
globalThis.told = new Map();
addEventListener('message', ({ data, source }) => {
  if (source !== document.querySelector('iframe').contentWindow) return;
  if (data.id === undefined) heard.push(data);
  else { told.get(data.id)?.(data); told.delete(data.id); }
});
let next = 0;
globalThis.ask = (order) => new Promise((resolve) => {
  const id = next++;
  told.set(id, resolve);
  document.querySelector('iframe').contentWindow.postMessage({ ros2wasm: 1, id, ...order }, '*');
});
`;

const escaped = (text: string): string => text.replaceAll('&', '&amp;').replaceAll('"', '&quot;');

export interface FrameOptions {
  /** The frame's attribute; undefined: none. */
  readonly sandbox?: string;
  readonly width?: number;
  readonly height?: number;
}

/** The answer of the page in the frame. */
export interface Reply {
  readonly ok: boolean;
  readonly result?: unknown;
  readonly error?: { readonly code: string; readonly message: string; };
}

export class EmbeddingPage {
  readonly origin: string;
  private readonly server: Server;

  private constructor(server: Server) {
    this.server = server;
    this.origin = `http://localhost:${(server.address() as AddressInfo).port}`;
  }

  static async serve(): Promise<EmbeddingPage> {
    const server = createServer((request, response) => {
      const { searchParams } = new URL(request.url ?? '/', 'http://localhost');
      response.writeHead(200, { 'content-type': 'text/html; charset=utf-8' }).end(searchParams.get('html') ?? '');
    });
    await new Promise<void>((resolve) => server.listen(0, 'localhost', () => resolve()));
    return new EmbeddingPage(server);
  }

  close(): Promise<void> {
    return new Promise((resolve) => {
      this.server.close(() => resolve());
      this.server.closeAllConnections();
    });
  }

  /** Shows `address` in a frame of this page, and gives both. */
  async open(browser: Browser, address: string, options: FrameOptions = {}): Promise<{ page: Page; frame: Frame; }> {
    const { sandbox, width = 640, height = 360 } = options;
    const html = `<!doctype html><html lang="en"><title>Course</title><style>body { font: 16px/1.5 sans-serif; max-width: 50rem; `
      + `margin: 2rem auto; } iframe { border: 1px solid #999; }</style><h1>Week 4: a course page</h1><p>Below runs a ROS 2 workspace.</p>`
      + `<script>${SCRIPT}</script><iframe title="ROS 2" width="${width}" height="${height}" `
      + `${sandbox === undefined ? '' : `sandbox="${escaped(sandbox)}" `}src="${escaped(address)}"></iframe>`;
    const page = await browser.newPage({ viewport: { width: 900, height: 640 } });
    page.setDefaultTimeout(120_000);
    await page.goto(`${this.origin}/?html=${encodeURIComponent(html)}`);
    const frame = page.frames()[1] ?? assert.fail('no frame');
    return { page, frame };
  }
}

/** Asks the page in the frame. */
export function ask(page: Page, order: Readonly<Record<string, unknown>>): Promise<Reply> {
  return page.evaluate((what) => (globalThis as unknown as { ask: (order: unknown) => Promise<Reply>; }).ask(what), order);
}
