// The files that a Python program writes below its home: each is handed to the page when it is closed, as bags are. Whoever
// opens and closes one for each line has it handed over now and then, and at the end.

/** The part of Emscripten's file system that is used here. */
export interface WatchedSystem {
  readonly trackingDelegate: {
    onWriteToFile?: (path: string) => void;
    onCloseFile?: (path: string) => void;
    onMovePath?: (from: string, to: string) => void;
    willDeletePath?: (path: string) => void;
  };
  readonly readFile: (path: string) => Uint8Array;
  readonly stat: (path: string) => { readonly size: number };
}

/** A larger one stays where it is. */
export const mostFileBytes = 2 ** 26;
/** One is handed over as often. */
const leastMs = 1000;

export interface OutputPlace {
  /** With "/" at the end. Names that begin with a dot are nobody's affair, below it too. */
  readonly home: string;
  readonly give: (path: string, bytes: Uint8Array<ArrayBuffer>) => void;
  readonly now: () => number;
  /** A file is too large. */
  readonly refused: (path: string) => void;
}

/** `rest` hands over what is left, at the program's end. */
export function watchOutput(system: WatchedSystem, { home, give, now, refused }: OutputPlace): { readonly rest: () => void } {
  const changed = new Set<string>();
  const given = new Map<string, number>();
  const told = new Set<string>();
  // Bags are handed over by those that write them, wherever they lie.
  const counts = (path: string): boolean => path.startsWith(home) && !path.includes('/.', home.length - 1) && !path.endsWith('.mcap');
  const handOver = (path: string): void => {
    changed.delete(path);
    try {
      if (system.stat(path).size > mostFileBytes) {
        if (!told.has(path)) refused(path);
        told.add(path);
        return;
      }
      give(path, system.readFile(path).slice());
      given.set(path, now());
    } catch {
      // It is gone, or a folder.
    }
  };
  Object.assign(system.trackingDelegate, {
    onWriteToFile: (path: string): void => {
      if (counts(path)) changed.add(path);
    },
    onCloseFile: (path: string): void => {
      if (changed.has(path) && now() - (given.get(path) ?? -Infinity) >= leastMs) handOver(path);
    },
    // As one is put in place of another.
    onMovePath: (from: string, to: string): void => {
      changed.delete(from);
      if (counts(to)) handOver(to);
    },
    willDeletePath: (path: string): void => {
      changed.delete(path);
    },
  } satisfies WatchedSystem['trackingDelegate']);
  return {
    rest: () => {
      for (const path of [...changed]) handOver(path);
    },
  };
}
