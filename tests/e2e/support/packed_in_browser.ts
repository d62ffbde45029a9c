// A workspace for the tests of one file, packed, and a browser in which its site is opened.

import { after, before } from 'node:test';
import { type Browser, chromium } from 'playwright-core';
import { chromiumOptions } from './chromium.ts';
import { PackWorkspace } from './pack_workspace.ts';

export interface PackedInBrowser {
  readonly workspace: PackWorkspace;
  readonly browser: Browser;
  /** Its folder. */
  readonly site: string;
}

/** Packs what `fill` writes before the tests, and takes all away after them. */
export function packedInBrowser(fill: (workspace: PackWorkspace) => void): PackedInBrowser {
  let made: PackedInBrowser | undefined;
  const get = (): PackedInBrowser => {
    if (made === undefined) throw new Error('it is there while tests run');
    return made;
  };
  before(async () => {
    const workspace = new PackWorkspace('shared');
    fill(workspace);
    made = { workspace, site: await workspace.packed(), browser: await chromium.launch(chromiumOptions()) };
  }, { timeout: 500_000 });
  after(async () => {
    await made?.browser.close();
    made?.workspace.close();
  });
  return {
    get workspace() {
      return get().workspace;
    },
    get browser() {
      return get().browser;
    },
    get site() {
      return get().site;
    },
  };
}
