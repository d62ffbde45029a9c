// What the samples of a soak say: did memory, delivery and latency stay flat, and did every stream go on at its rate? Pure.

/** Flat: over the second half a straight line through the samples rises by at most this share of their mean. */
const MEMORY_RISE = 0.05;
/** Flat: the median of the last quarter is at most this many times that of the quarter before, and this much more. */
const LATENCY_RATIO = 1.5;
const LATENCY_SLACK_US = 200;
/** Flat: of what was sent in the second half this share came. */
const DELIVERED = 0.999;
/** Flat: in each sample of the second half as much was sent, and came, as this share of the stream's rate; a busy machine delays timers. */
const RATE = 0.8;

export const RULE = `flat: memory rises by at most ${MEMORY_RISE * 100} % of its mean in the second half (straight line), at least ${DELIVERED * 100} % came, `
  + `in each sample at least ${RATE * 100} % of each stream's rate was sent and came, `
  + `the last quarter's median latency is at most ${LATENCY_RATIO} times that of the quarter before + ${LATENCY_SLACK_US} us`;

/** A line of a node: the one that sends says what it published in a period, the one that takes says the rest. */
export type SoakReport =
  | { readonly soak: string; readonly published: number; }
  | { readonly soak: string; readonly sent: number; readonly came: number; readonly p50_us: number; readonly p99_us: number; };

/** A stream in one sample. */
export interface StreamSample {
  readonly soak: string;
  /** By its sender, for each period that it reported. */
  readonly published: number;
  /** By its taker: what was sent, by the numbers of what came. For each period that it reported. */
  readonly sent: number;
  readonly came: number;
  readonly p50_us: number;
  readonly p99_us: number;
}

export interface SoakSample {
  readonly minute: number;
  readonly heap_kb: number;
  readonly processes_kb: number;
  readonly bus_used_kb: number;
  readonly streams: readonly StreamSample[];
}

export interface SoakStream {
  readonly soak: string;
  /** Messages that are due in one period. */
  readonly due: number;
}

export interface SoakVerdict {
  readonly flat: boolean;
  readonly rise_in_second_half: Readonly<Record<string, number>>;
  readonly streams_in_second_half: Readonly<Record<string, {
    readonly delivered: number;
    /** Least of what was published or came in a sample, by what was due. */
    readonly least_rate: number;
    readonly p50_us: readonly [number, number];
  }>>;
}

export const rounded = (value: number): number => Math.round(value * 1000) / 1000;

function mean(values: readonly number[]): number {
  return values.length === 0 ? 0 : values.reduce((a, b) => a + b, 0) / values.length;
}

function median(values: readonly number[]): number {
  return values.toSorted((a, b) => a - b)[Math.floor(values.length / 2)] ?? Number.NaN;
}

/** By how much of their mean a straight line through values at equal distances rises from the first to the last. */
function rise(values: readonly number[]): number {
  const middle = (values.length - 1) / 2;
  let [up, over] = [0, 0];
  for (const [i, value] of values.entries()) {
    up += (i - middle) * (value - mean(values));
    over += (i - middle) ** 2;
  }
  return (up / over) * (values.length - 1) / mean(values);
}

/** Combines the lines of one sample for each stream; a node's periods may end twice in one sample. */
export function gather(reports: readonly SoakReport[], streams: readonly SoakStream[]): StreamSample[] {
  return streams.map(({ soak }) => {
    const mine = reports.filter((report) => report.soak === soak);
    const taken = mine.filter((report) => 'came' in report);
    return {
      soak,
      published: mean(mine.filter((report) => 'published' in report).map(({ published }) => published)),
      sent: mean(taken.map(({ sent }) => sent)),
      came: mean(taken.map(({ came }) => came)),
      p50_us: median(taken.map(({ p50_us }) => p50_us)),
      p99_us: Math.max(...taken.map(({ p99_us }) => p99_us)),
    };
  });
}

export function judge(samples: readonly SoakSample[], streams: readonly SoakStream[]): SoakVerdict {
  const half = samples.slice(Math.floor(samples.length / 2));
  const memory = Object.fromEntries((['heap_kb', 'processes_kb', 'bus_used_kb'] as const).map(
    (what) => [what, rounded(rise(half.map((sample) => sample[what])))],
  ));
  const judged = Object.fromEntries(streams.map(({ soak, due }) => {
    const of = half.map((sample) => sample.streams.find((stream) => stream.soak === soak)).filter((stream) => stream !== undefined);
    const quarter = Math.floor(of.length / 2);
    const sum = (what: 'sent' | 'came'): number => of.reduce((all, stream) => all + stream[what], 0);
    const rates = half.map((_, i) => Math.min(of[i]?.published ?? 0, of[i]?.came ?? 0) / due);
    const p50 = of.map(({ p50_us }) => p50_us);
    return [soak, {
      delivered: rounded(sum('came') / sum('sent')),
      least_rate: rounded(Math.min(...rates)),
      p50_us: [median(p50.slice(0, quarter)), median(p50.slice(quarter))] as const,
    }];
  }));
  const flat = Object.values(memory).every((share) => share <= MEMORY_RISE)
    && Object.values(judged).every(({ delivered, least_rate: rate, p50_us: [before, after] }) =>
      delivered >= DELIVERED && rate >= RATE && after <= before * LATENCY_RATIO + LATENCY_SLACK_US
    );
  return { flat, rise_in_second_half: memory, streams_in_second_half: judged };
}
