// The visible part of a plot, and the moment whose values are shown. Pure.

import type { Extent } from './plot_svg.ts';
import type { NamedSamples, Samples } from './samples.ts';

/** Shares of their size that numbers can still tell apart. */
const FINEST = 1e-12;

/** Smaller for factors above one; `around` stays where it is. */
export function zoomedExtent({ least, most }: Extent, factor: number, around = (least + most) / 2): Extent {
  const next = { least: around - (around - least) / factor, most: around + (most - around) / factor };
  const finest = FINEST * Math.max(Math.abs(next.least), Math.abs(next.most), FINEST);
  return next.most - next.least > finest ? next : { least, most };
}

/** By so much of its size. */
export function movedExtent({ least, most }: Extent, share: number): Extent {
  const by = share * (most - least);
  return { least: least + by, most: most + by };
}

/** The next moment at which any of the series has a sample, or the one before; null: there is none. */
export function momentBeside(series: readonly NamedSamples[], time: number, direction: 1 | -1): number | null {
  let found: number | null = null;
  for (const { samples } of series) {
    let at = samples.from(time);
    if (direction === 1) { while (at < samples.length && samples.time(at) === time) at += 1; }
    else at -= 1;
    if (at < 0 || at >= samples.length) continue;
    const here = samples.time(at);
    if (found === null || direction * (here - found) < 0) found = here;
  }
  return found;
}

/** The sample of any series that is nearest to that moment; null: there are none. */
export function momentNear(series: readonly NamedSamples[], time: number): number | null {
  let found: number | null = null;
  for (const { samples } of series) {
    const at = samples.from(time);
    for (const index of [at - 1, at]) {
      if (index < 0 || index >= samples.length) continue;
      const here = samples.time(index);
      if (found === null || Math.abs(here - time) < Math.abs(found - time)) found = here;
    }
  }
  return found;
}

/** Points of a series against the first one, whose value holds until its next. Of several at one moment each has its own. */
export function pairsWith(first: Samples, other: Samples, { least, most }: Extent): (readonly [x: number, y: number])[] {
  const points: [number, number][] = [];
  let again = 0;
  for (let i = other.from(least); i < other.length; i += 1) {
    const time = other.time(i);
    if (time > most) break;
    again = points.length > 0 && time === other.time(i - 1) ? again + 1 : 0;
    const at = first.from(time) + again;
    const own = at < first.length && first.time(at) === time;
    points.push([own ? first.value(at) : first.valueAt(time), other.value(i)]);
  }
  return points;
}
