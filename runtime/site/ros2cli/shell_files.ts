// Files of a shell, relative to where it is: bags, and texts.

import { closeSync, constants, fstatSync, openSync, readFileSync, readSync, readdirSync, statSync, writeSync } from 'node:fs';
import { join } from 'node:path';
import { type BagPlace, CommandError } from './command.ts';

export const bagFiles: BagPlace = {
  open: (given) =>
    Promise.resolve().then(() => {
      const name = bagFileOf(given);
      // Opening a pipe would wait for who writes into it.
      const file = opened(name, constants.O_RDONLY | (constants.O_NONBLOCK ?? 0), 'ENOENT');
      if (file === undefined) return undefined;
      if (!fstatSync(file).isFile()) {
        closeSync(file);
        return undefined;
      }
      return {
        name,
        size: fstatSync(file).size,
        read: (from: number, length: number) =>
          Promise.resolve().then(() => {
            const bytes = new Uint8Array(Math.max(0, Math.min(length, fstatSync(file).size - from)));
            let at = 0;
            for (let got = 1; at < bytes.length && got > 0; at += got) got = readSync(file, bytes, at, bytes.length - at, from + at);
            return bytes.subarray(0, at);
          }),
      };
    }),
  create: (name) =>
    Promise.resolve().then(() => {
      const file = opened(name, 'wx', 'EEXIST');
      if (file === undefined) return undefined;
      return {
        write: (bytes: Uint8Array) => {
          for (let at = 0; at < bytes.length;) at += writeSync(file, bytes, at);
        },
        end: () => closeSync(file),
      };
    }),
};

/** The file that is meant: of a folder as rosbag2 makes it, the one that lies beside its metadata. */
function bagFileOf(name: string): string {
  if (statSync(name, { throwIfNoEntry: false })?.isDirectory() !== true) return name;
  const names = readdirSync(name).sort();
  const bags = names.filter((one) => one.endsWith('.mcap'));
  const hint = bags.length === 0 ? '' : `: name a file of it, '${join(name, bags[0]!)}'`;
  if (!names.includes('metadata.yaml')) throw new CommandError(`Could not find metadata in bag directory '${name}'${hint}`);
  if (bags.length !== 1) throw new CommandError(`Bag directory '${name}' has ${bags.length} MCAP files${hint}`);
  return join(name, bags[0]!);
}

function opened(name: string, flags: string | number, expected: string): number | undefined {
  try {
    return openSync(name, flags);
  } catch (error) {
    if ((error as NodeJS.ErrnoException).code === expected) return undefined;
    throw error;
  }
}

/** undefined: there is no such file. Rejects when it cannot be read. */
export function textOfFile(name: string): Promise<string | undefined> {
  return Promise.resolve().then(() => {
    const file = opened(name, 'r', 'ENOENT');
    if (file === undefined) return undefined;
    try {
      return readFileSync(file, 'utf8');
    } finally {
      closeSync(file);
    }
  });
}
