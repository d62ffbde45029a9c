// The place in a line of a Python traceback: `  File "/ros/lib/.../talker.py", line 12, in main`. Nodes have the
// installation in /ros. Pure.

const MOST_LENGTH = 1_000;

export interface TracebackPlace {
  /** In the installation. */
  readonly path: string;
  /** From 1. */
  readonly line: number;
  /** Where `File "...", line N` stands in the text. */
  readonly start: number;
  readonly end: number;
}

/** null for a line that names none. */
export function tracebackPlace(text: string): TracebackPlace | null {
  if (text.length > MOST_LENGTH || !text.includes('File "/ros/')) return null;
  const found = /File "\/ros\/([^"]+)", line (\d{1,7})/.exec(text);
  const [whole, path, line] = found ?? [];
  if (found === null || whole === undefined || path === undefined || line === undefined) return null;
  return { path, line: Number(line), start: found.index, end: found.index + whole.length };
}
