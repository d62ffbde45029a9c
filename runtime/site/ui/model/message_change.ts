// The differences between two messages of a topic. Pure.

import { isList, isMessage } from '../../decode/yaml.ts';

/** All values within are the same; NaN is NaN. */
export function sameValue(a: unknown, b: unknown): boolean {
  if (Object.is(a, b)) return true;
  if (isList(a)) {
    if (!isList(b) || a.length !== b.length) return false;
    for (let i = 0; i < a.length; i += 1) if (!sameValue(a[i], b[i])) return false;
    return true;
  }
  if (!isMessage(a) || !isMessage(b)) return false;
  const names = Object.keys(a);
  return names.length === Object.keys(b).length && names.every((name) => Object.hasOwn(b, name) && sameValue(a[name], b[name]));
}

/** The value at that place of the earlier message; undefined: there was none. */
export function partOf(before: unknown, step: string | number): unknown {
  if (typeof step === 'number') return isList(before) ? before[step] : undefined;
  return isMessage(before) && Object.hasOwn(before, step) ? before[step] : undefined;
}
