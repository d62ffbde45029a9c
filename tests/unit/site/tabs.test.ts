// Tabs that cannot join say so.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { PortBroker } from '../../../runtime/site/bus/broker.ts';
import type { Platform } from '../../../runtime/site/workers/platform.ts';
import { SiteError } from '../../../runtime/site/contract/site_error.ts';
import { Tabs } from '../../../runtime/site/session/tabs.ts';

test('R2W0712: without locks there is no joining', async () => {
  const broker = new PortBroker();
  const before = Object.getOwnPropertyDescriptor(globalThis, 'navigator')!;
  Object.defineProperty(globalThis, 'navigator', { configurable: true, value: {} });
  try {
    const platform = {} as Platform;
    await assert.rejects(
      Tabs.join({ graph: 'g', site: 's', broker, platform, changed: () => undefined }),
      (error) => error instanceof SiteError && error.code === 'R2W0712' && error.message.includes('`g`'),
    );
  } finally {
    Object.defineProperty(globalThis, 'navigator', before);
    broker.close();
  }
});
