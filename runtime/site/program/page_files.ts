// The files of a site that its page carries, in that page: unpacks them when they are asked for, looks whether they are those
// that site.json lists, and gives its modules addresses.

import type { CarriedFiles } from './carried_files.ts';
import { ExpectedFiles } from './expected_files.ts';
import { mimeTypeOf } from '../contract/mime_types.ts';
import { linkedModule, neededModules } from './module_links.ts';
import { readSite } from '../contract/site_reader.ts';

/** Function of the page that its modules call to import others later: with the name of the file. */
export const importer = 'ros2wasmImport';

async function unpacked(text: string): Promise<ArrayBuffer> {
  const packed = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  return new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate-raw'))).arrayBuffer();
}

export class PageFiles implements CarriedFiles {
  private readonly packed: ReadonlyMap<string, string>;
  private readonly expected = new ExpectedFiles();
  private readonly addresses = new Map<string, Promise<string>>();
  private readonly modules = new Map<string, Promise<string>>();

  constructor(packed: ReadonlyMap<string, string>) {
    this.packed = packed;
  }

  /** Before anything but site.json is asked for. */
  async readList(): Promise<void> {
    const list = await (await this.whole('site.json')).text();
    this.expected.set(readSite(JSON.parse(list)).files);
  }

  has(path: string): boolean {
    return this.packed.has(path);
  }

  async file(path: string): Promise<Blob | undefined> {
    const text = this.packed.get(path);
    if (text === undefined) return undefined;
    return new Blob([await this.expected.checked(path, await unpacked(text))], { type: kindOf(path) });
  }

  async address(path: string): Promise<string> {
    return once(this.addresses, path, async () => URL.createObjectURL(await this.whole(path)));
  }

  /** The address to import for a module; the modules that it needs are linked to it. */
  async moduleAddress(path: string): Promise<string> {
    return once(this.modules, path, async () => {
      const text = await (await this.whole(path)).text();
      const needed = await Promise.all(neededModules(text).map(async (name) => [name, await this.moduleAddress(name)] as const));
      return URL.createObjectURL(new Blob([linkedModule(text, new Map(needed), importer)], { type: kindOf(path) }));
    });
  }

  private async whole(path: string): Promise<Blob> {
    const file = await this.file(path);
    if (file === undefined) throw new Error(`the page does not carry ${path}`);
    return file;
  }
}

function once(made: Map<string, Promise<string>>, path: string, make: () => Promise<string>): Promise<string> {
  const known = made.get(path) ?? make();
  made.set(path, known);
  return known;
}

/** Never a page: it would have the rights of this one. */
function kindOf(path: string): string {
  return mimeTypeOf(path);
}
