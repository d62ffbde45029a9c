// The files that a Python program writes: what it closes, and what it puts in another's place, is handed to the page.
import type { OutputGate } from '../program/output_gate.ts';

/** The part of Emscripten's file system that is used here. */
export interface WatchedSystem {
  readonly trackingDelegate: {
    onWriteToFile?: (path: string) => void;
    onCloseFile?: (path: string) => void;
    onMovePath?: (from: string, to: string) => void;
    willDeletePath?: (path: string) => void;
  };
  readonly readFile: (path: string) => Uint8Array;
  readonly stat: (path: string) => { readonly size: number; };
}

/** `rest` hands over what is left, at the program's end. */
export function watchOutput(
  system: WatchedSystem,
  gate: OutputGate,
  give: (path: string, bytes: Uint8Array<ArrayBuffer>) => void,
): { readonly rest: () => void; } {
  const changed = new Set<string>();
  const offer = (path: string): void => {
    try {
      const passes = gate.passes(path, system.stat(path).size);
      if (passes === 'later') return;
      changed.delete(path);
      if (passes === 'now') give(path, system.readFile(path).slice());
    } catch {
      // It is gone, or a folder.
      changed.delete(path);
    }
  };
  Object.assign(system.trackingDelegate, {
    onWriteToFile: (path: string): void => {
      if (gate.counts(path)) changed.add(path);
    },
    onCloseFile: (path: string): void => {
      if (changed.has(path)) offer(path);
    },
    onMovePath: (from: string, to: string): void => {
      changed.delete(from);
      if (!gate.counts(to)) return;
      changed.add(to);
      offer(to);
    },
    willDeletePath: (path: string): void => {
      changed.delete(path);
    },
  } satisfies WatchedSystem['trackingDelegate']);
  return {
    rest: () => {
      gate.end();
      for (const path of [...changed]) offer(path);
    },
  };
}
