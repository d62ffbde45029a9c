// An ordinary run of the tests leaves some to a nightly one (`ROS2WASM_NIGHTLY=1`): further links and hosts of a scene that is
// already played on one, and sizes that take minutes.

import { test } from 'node:test';

export const nightly = process.env['ROS2WASM_NIGHTLY'] === '1';

/** The variants in which a scene is played: the first one in each run, all in a nightly run. */
export function played<const T extends readonly [unknown, ...unknown[]]>(...variants: T): readonly T[number][] {
  return nightly ? variants : variants.slice(0, 1);
}

/** A test of nightly runs. An ordinary run does not have it: it is neither skipped nor passed there. */
export function nightlyTest(name: string, options: { readonly timeout: number; }, body: () => Promise<void>): void {
  if (nightly) void test(name, options, body);
}
