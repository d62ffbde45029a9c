// The expected hashes of the site's files, as site.json has them. A program that is damaged, or from another
// version of the site, is refused before it runs.

import { RunningSha256 } from '../contract/running_sha256.ts';
import type { SiteFile } from '../contract/session.ts';
import { SiteError } from '../contract/site_error.ts';

type Bytes = ArrayBuffer | Uint8Array<ArrayBuffer>;

export class ExpectedFiles {
  private hashes: ReadonlyMap<string, string> = new Map();

  set(files: readonly SiteFile[]): void {
    this.hashes = new Map(files.map(({ path, sha256 }) => [path, sha256]));
  }

  async matches(path: string, bytes: Bytes): Promise<boolean> {
    const expected = this.expected(path);
    return expected === undefined || await sha256Of(bytes) === expected;
  }

  /** The bytes, when they are those of this path. Throws SiteError R2W0724. A file that site.json does not list is as it is. */
  async checked<T extends Bytes>(path: string, bytes: T): Promise<T> {
    const expected = this.expected(path);
    const found = expected === undefined ? undefined : await sha256Of(bytes);
    if (found === expected) return bytes;
    throw new SiteError('R2W0724', `${path} is not the file that the site was packed with`, {
      why: `its sha256 is ${found}, site.json says ${expected}`,
      fix: 'reload the page; if that does not help, put all files that `ros2wasm pack` wrote in place',
    });
  }

  private expected(path: string): string | undefined {
    const hash = this.hashes.get(path);
    return hash === '' ? undefined : hash;
  }
}

export async function sha256Of(bytes: Bytes): Promise<string> {
  // The browser has its own hash on https:// and localhost only.
  if (globalThis.crypto?.subtle === undefined) {
    const sum = new RunningSha256();
    sum.add(bytes instanceof Uint8Array ? bytes : new Uint8Array(bytes));
    return sum.hex();
  }
  const hash = new Uint8Array(await crypto.subtle.digest('SHA-256', bytes));
  return Array.from(hash, (byte) => byte.toString(16).padStart(2, '0')).join('');
}
