// The place of a site, in a browser page or in Node.js: its files, and the cache of what was made of them.

import type { KeptBytes } from './cached_bytes.ts';
import type { KeptTexts } from '../contract/stored_texts.ts';
import type { SiteFile } from '../contract/session.ts';

export interface SiteHost {
  /** Where the site lies: its address, or its folder. */
  readonly place: string;
  /** Throws SiteError R2W0706. */
  readonly json: (path: string) => Promise<unknown>;
  /** From now on files must be as site.json lists them. */
  readonly expect: (files: readonly SiteFile[]) => void;
  /** Fetches and compiles; the same path gives the same module. Throws SiteError R2W0703, R2W0706 or R2W0724. */
  readonly compile: (path: string) => Promise<WebAssembly.Module>;
  /** The whole file. Throws SiteError R2W0706 or R2W0724. */
  readonly bytes: (path: string) => Promise<ArrayBuffer>;
  /** The cache for later visits; undefined: nothing is cached. */
  readonly kept?: KeptBytes | undefined;
  /** The visitor's changes of sources, by their paths; undefined: sources cannot be changed. */
  readonly texts?: KeptTexts;
}
