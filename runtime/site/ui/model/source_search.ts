// A text that is looked for in all sources: which lines have it. Pure.

export interface SearchedFile {
  readonly file: string;
  readonly text: string;
}

export interface SourceHit {
  readonly file: string;
  /** From 1. */
  readonly line: number;
  /** The line in three parts, cut to what can be read: what is found is the middle one. */
  readonly before: string;
  readonly found: string;
  readonly after: string;
}

export interface SourceHits {
  readonly hits: readonly SourceHit[];
  /** There are more, which are not in the list. */
  readonly more: boolean;
}

const MOST_HITS = 200;
const MOST_BEFORE = 40;
const MOST_AFTER = 120;

/** One hit a line, in the order of the files. Capital letters count when there are some in `wanted`. */
export function searchSources(files: readonly SearchedFile[], wanted: string): SourceHits {
  const hits: SourceHit[] = [];
  if (wanted.trim() === '') return { hits, more: false };
  const exact = wanted !== wanted.toLowerCase();
  for (const { file, text } of files) {
    let line = 0;
    for (const words of text.split(/\r?\n/)) {
      line += 1;
      const lower = exact ? words : words.toLowerCase();
      const at = lower.indexOf(wanted);
      // Few letters have another length when they are small: then the place is told of the whole line.
      if (at === -1) continue;
      if (hits.length >= MOST_HITS) return { hits, more: true };
      const same = lower.length === words.length;
      const begin = same ? at : 0;
      const end = same ? at + wanted.length : 0;
      const lead = words.slice(0, begin).trimStart();
      hits.push({
        file,
        line,
        before: lead.length > MOST_BEFORE ? `\u2026${lead.slice(-MOST_BEFORE)}` : lead,
        found: words.slice(begin, end),
        after: words.length - end > MOST_AFTER ? `${words.slice(end, end + MOST_AFTER)}\u2026` : words.slice(end),
      });
    }
  }
  return { hits, more: false };
}
