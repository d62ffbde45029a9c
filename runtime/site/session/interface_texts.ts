// The definitions of the interfaces of a site, loaded when they are asked for.

import type { Platform } from '../workers/platform.ts';

export class InterfaceTexts {
  private readonly platform: Platform;
  private readonly path: string;
  private loaded: Promise<Map<string, string>> | undefined;

  /** `path`: the site's file of them; empty when it has none. */
  constructor(platform: Platform, path: string) {
    this.platform = platform;
    this.path = path;
  }

  /** The text of each, by its name. */
  all(): Promise<Map<string, string>> {
    if (this.loaded === undefined) {
      const loading = this.load();
      this.loaded = loading;
      // The next call tries again.
      loading.catch(() => {
        this.loaded = undefined;
      });
    }
    return this.loaded;
  }

  /** Adds those that the site does not have. */
  async learn(definitions: ReadonlyMap<string, string>): Promise<void> {
    const known = await this.all();
    for (const [type, text] of definitions) if (!known.has(type)) known.set(type, text);
  }

  private async load(): Promise<Map<string, string>> {
    if (this.path === '') return new Map();
    const json = await this.platform.json(this.path);
    if (typeof json !== 'object' || json === null) return new Map();
    return new Map(Object.entries(json).filter((entry): entry is [string, string] => typeof entry[1] === 'string'));
  }
}
