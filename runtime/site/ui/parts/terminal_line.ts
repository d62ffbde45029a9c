// A line that another panel asks a terminal to run. The first terminal that is free takes it; one that is just opened
// takes what waits.

type Taker = (line: string) => boolean;

const takers = new Set<Taker>();
let waiting: string | null = null;

/** False: all terminals are busy. With none open it waits for the next one. */
export function runInTerminal(line: string): boolean {
  for (const take of takers) if (take(line)) return true;
  if (takers.size > 0) return false;
  waiting = line;
  return true;
}

/** `take` says whether it could. Returns what ends it. */
export function takeLines(take: Taker): () => void {
  takers.add(take);
  const line = waiting;
  waiting = null;
  if (line !== null) take(line);
  return () => takers.delete(take);
}
