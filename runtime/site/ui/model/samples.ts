// Numbers over time, the newest so many of them; what a plot draws and writes to files. Times are seconds. Pure.

/** Seconds. Messages of several publishers come a little out of order; a clock that restarts goes back further. */
export const APART = 1;

export class Samples {
  private times: Float64Array;
  private values: Float64Array;
  private start = 0;
  private count = 0;
  private readonly capacity: number;

  constructor(capacity: number) {
    this.capacity = capacity;
    this.times = new Float64Array(Math.min(1024, capacity));
    this.values = new Float64Array(this.times.length);
  }

  get length(): number {
    return this.count;
  }

  /** When time goes back by more than APART (a restart of the site's clock), all earlier samples are dropped. */
  add(published: number, value: number): void {
    const last = this.count > 0 ? this.time(this.count - 1) : published;
    if (last - published > APART) this.clear();
    const time = last - published > APART ? published : Math.max(published, last);
    if (this.count === this.times.length && this.count < this.capacity) this.grow();
    const size = this.times.length;
    if (this.count === size) {
      this.start = (this.start + 1) % size;
      this.count -= 1;
    }
    const at = (this.start + this.count) % size;
    this.times[at] = time;
    this.values[at] = value;
    this.count += 1;
  }

  clear(): void {
    this.start = 0;
    this.count = 0;
  }

  time(index: number): number {
    return this.times[(this.start + index) % this.times.length] ?? Number.NaN;
  }

  value(index: number): number {
    return this.values[(this.start + index) % this.values.length] ?? Number.NaN;
  }

  /** Index of the first sample at or after that time. */
  from(time: number): number {
    let low = 0;
    let high = this.count;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.time(middle) < time) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  /** The value that holds at that time: of the last sample at or before it. */
  valueAt(time: number): number {
    return this.valuesAt(time).at(-1) ?? Number.NaN;
  }

  /** The values of that very moment, of which there may be several; else the one that holds from before. */
  valuesAt(time: number): readonly number[] {
    const first = this.from(time);
    let end = first;
    while (end < this.count && this.time(end) === time) end += 1;
    const begin = end > first ? first : Math.max(0, first - 1);
    return Array.from({ length: end - begin }, (_, index) => this.value(begin + index));
  }

  private grow(): void {
    const size = Math.min(this.capacity, 2 * this.times.length);
    const [times, values] = [new Float64Array(size), new Float64Array(size)];
    for (let i = 0; i < this.count; i += 1) {
      times[i] = this.time(i);
      values[i] = this.value(i);
    }
    this.times = times;
    this.values = values;
    this.start = 0;
  }
}

export interface NamedSamples {
  readonly name: string;
  readonly samples: Samples;
}

/** The times of all series from `since` on, in order and once each, and each series' value there (null: none). */
export function aligned(
  series: readonly NamedSamples[],
  since: number,
): { readonly times: Float64Array; readonly columns: readonly (readonly (number | null)[])[]; } {
  const at = series.map(({ samples }) => samples.from(since));
  const times: number[] = [];
  const columns: (number | null)[][] = series.map(() => []);
  for (;;) {
    let next = Number.POSITIVE_INFINITY;
    series.forEach(({ samples }, index) => {
      const place = at[index] ?? 0;
      if (place < samples.length) next = Math.min(next, samples.time(place));
    });
    if (next === Number.POSITIVE_INFINITY) break;
    times.push(next);
    series.forEach(({ samples }, index) => {
      const place = at[index] ?? 0;
      const here = place < samples.length && samples.time(place) === next;
      columns[index]?.push(here ? finite(samples.value(place)) : null);
      if (here) at[index] = place + 1;
    });
  }
  return { times: Float64Array.from(times), columns };
}

/** One row per time, as a spreadsheet reads it. */
export function toCsv(series: readonly NamedSamples[]): string {
  const { times, columns } = aligned(series, Number.NEGATIVE_INFINITY);
  const quoted = (text: string): string => `"${text.replaceAll('"', '""')}"`;
  const lines = [['time', ...series.map(({ name }) => quoted(name))].join(',')];
  times.forEach((time, row) => {
    lines.push([time.toFixed(9), ...columns.map((column) => column[row] ?? '')].join(','));
  });
  return `${lines.join('\n')}\n`;
}

function finite(value: number): number | null {
  return Number.isFinite(value) ? value : null;
}
