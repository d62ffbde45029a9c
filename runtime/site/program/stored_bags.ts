// `--bags DIR` of a headless run: the bags and other files that nodes write lie there, below a folder for each node.

import { mkdir, readdir, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import type { Session, WrittenFile } from '../contract/session.ts';
import { SiteError } from '../contract/site_error.ts';
import { placeOf } from './written_files.ts';

/** Throws SiteError R2W0721: the folder has files, which might be overwritten. */
export async function checkBagsFolder(folder: string): Promise<void> {
  const files = await readdir(folder).catch((error: unknown) => {
    if (error instanceof Error && 'code' in error && error.code === 'ENOENT') return [];
    throw new SiteError('R2W0721', `bags cannot be written to ${folder}: ${error instanceof Error ? error.message : String(error)}`, {
      fix: 'name another folder with --bags',
    });
  });
  if (files.length === 0) return;
  throw new SiteError('R2W0721', `bags are not written to ${folder}: it is not empty`, {
    why: 'bags of an earlier run might be overwritten',
    fix: 'name another folder with --bags, or move its files away',
  });
}

export class KeptBags {
  private readonly session: Session;
  private readonly folder: string | undefined;
  /** One after the other: of a file that is written again, the last is what stays. */
  private writing = Promise.resolve();
  private lost: string | undefined;

  /** Without a folder they are dropped. `told`: of each that was written, where it lies. */
  constructor(session: Session, folder: string | undefined, told: (file: WrittenFile, path: string) => void) {
    this.session = session;
    this.folder = folder;
    session.written.onChange(() => {
      for (const file of session.written.take()) {
        if (folder !== undefined) this.writing = this.writing.then(() => this.keep(folder, file, told));
      }
    });
  }

  private async keep(folder: string, file: WrittenFile, told: (file: WrittenFile, path: string) => void): Promise<void> {
    try {
      const path = join(folder, ...placeOf(file));
      await mkdir(dirname(path), { recursive: true });
      await writeFile(path, new Uint8Array(await file.content.arrayBuffer()));
      told(file, path);
    } catch (error) {
      this.lost ??= error instanceof Error ? error.message : String(error);
    }
  }

  /** Stops what runs as Ctrl-C does, so that nodes close their bags. Gives why one could not be written. */
  async finish(): Promise<string | undefined> {
    if (this.folder === undefined) return undefined;
    await this.stopped();
    await this.writing;
    return this.lost;
  }

  private stopped(): Promise<void> {
    const { session } = this;
    return new Promise((resolve) => {
      const look = (): void => {
        if (session.nodes().some(({ state }) => state.kind === 'starting' || state.kind === 'running')) return;
        unwatch();
        resolve();
      };
      const unwatch = session.onNodes(look);
      session.stopAll();
      look();
    });
  }
}
