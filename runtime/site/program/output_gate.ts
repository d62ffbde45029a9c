// Decides which of the files that a program closes are handed to the host of the site, and when: those below its home, each at
// most once a second, as some programs open and close one for each line, and once more at the end. Bags are not handled here:
// their writer hands them over, wherever they are.

/** A larger one stays where it is. */
export const mostFileBytes = 2 ** 26;
/** One is handed over as often. */
const leastMs = 1000;

export interface OutputPlace {
  /** With "/" at the end. Names that begin with a dot are ignored, below it too. */
  readonly home: string;
  readonly now: () => number;
  /** A file is too large; said once. */
  readonly refused: (path: string) => void;
}

export class OutputGate {
  private readonly place: OutputPlace;
  private readonly given = new Map<string, number>();
  private readonly told = new Set<string>();
  private ends = false;

  constructor(place: OutputPlace) {
    this.place = place;
  }

  counts(path: string): boolean {
    const { home } = this.place;
    return path.startsWith(home) && !path.includes('/.', home.length - 1) && !path.endsWith('.mcap');
  }

  /** Whether one of that many bytes goes out now; later: it is to be asked about again. */
  passes(path: string, size: number): 'now' | 'later' | 'never' {
    if (!this.counts(path)) return 'never';
    const { now, refused } = this.place;
    if (size > mostFileBytes) {
      if (!this.told.has(path)) refused(path);
      this.told.add(path);
      return 'never';
    }
    const time = now();
    if (!this.ends && time - (this.given.get(path) ?? -Infinity) < leastMs) return 'later';
    this.given.set(path, time);
    return 'now';
  }

  /** The program is at its end: nothing waits any more. */
  end(): void {
    this.ends = true;
  }
}

/** The gate of a program; it uses the program's environment and console. */
export function outputGate({ environment, line }: {
  readonly environment: Readonly<Record<string, string>>;
  readonly line: (stream: 'stderr', text: string) => void;
}): OutputGate {
  return new OutputGate({
    home: `${environment['HOME'] ?? ''}/`,
    now: () => performance.now(),
    refused: (path) => line('stderr', `${path} is too large to be handed to the page`),
  });
}
