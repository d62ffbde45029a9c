// The aim and the observations of a check in words; and the comparison of a value with its conditions. Pure.

import { unreachable } from '../contract/session.ts';
import type { CheckAim, Comparison } from '../contract/site_checks.ts';
import type { TaskCheck } from '../contract/site_tasks.ts';

/** No text that comes from a node is shown or searched longer than this. */
const longestShown = 200;
export const longestSearched = 4096;

/** Colours and what else a terminal would take as a command. */
const escapes = /\u001b\[[0-9;?]*[ -/]*[@-~]/g;

export function plainLine(text: string): string {
  return text.slice(0, 2 * longestSearched).replace(escapes, '').slice(0, longestSearched);
}

export function shown(value: unknown): string {
  const text = typeof value === 'string' ? `\u2018${value}\u2019` : String(value);
  return text.length > longestShown ? `${text.slice(0, longestShown)}\u2026` : text;
}

export function hertz(rate: number): string {
  return `${rate < 100 ? Number(rate.toPrecision(3)) : Math.round(rate)} Hz`;
}

function bounds(unit: string, { above, below }: { readonly above?: number; readonly below?: number; }): string[] {
  return [
    ...(above === undefined ? [] : [`above ${above}${unit}`]),
    ...(below === undefined ? [] : [`below ${below}${unit}`]),
  ];
}

function comparison(value: Comparison): string {
  const parts = bounds('', value);
  if (value.equals !== undefined) parts.push(shown(value.equals));
  if (value.matches !== undefined) parts.push(`like /${value.matches}/`);
  return parts.join(' and ');
}

function aimWords(aim: CheckAim): string {
  switch (aim.kind) {
    case 'rate':
      return aim.above === undefined && aim.below === undefined
        ? `a message on ${aim.topic}`
        : `${aim.topic} ${bounds(' Hz', aim).join(' and ')}`;
    case 'message':
      return `${aim.topic}: ${aim.field} is ${comparison(aim.value)}`;
    case 'log':
      return `${aim.node ?? 'a node'} prints /${aim.log}/`;
    case 'parameter':
      return `${aim.node}: parameter ${aim.parameter} is ${comparison(aim.value)}`;
    case 'state':
      return aim.state === 'running' ? `${aim.node} runs` : aim.state === 'exited' ? `${aim.node} ends` : `${aim.node} crashes`;
    case 'exit_code':
      return `${aim.node} ends with code ${aim.exitCode}`;
    default:
      return unreachable(aim);
  }
}

export function checkTitle({ title, aim }: TaskCheck): string {
  return title === '' ? aimWords(aim) : title;
}

/** Is a value of a message or a parameter what it must be? */
export function meets(value: unknown, { above, below, equals, matches }: Comparison): boolean {
  const isNumber = typeof value === 'number' || typeof value === 'bigint';
  if (above !== undefined && !(isNumber && value > above)) return false;
  if (below !== undefined && !(isNumber && value < below)) return false;
  if (equals !== undefined && !same(value, equals)) return false;
  return matches === undefined || new RegExp(matches, 'u').test(String(value).slice(0, longestSearched));
}

/** A float32 that was written as a decimal number comes back as its nearest one. */
function same(value: unknown, wanted: boolean | number | string): boolean {
  if (typeof value === 'bigint') return typeof wanted === 'number' && Number.isInteger(wanted) && value === BigInt(wanted);
  return value === wanted || (typeof value === 'number' && typeof wanted === 'number' && value === Math.fround(wanted));
}

/** The value at `pose.position.x` or `ranges[3]`; undefined: there is none. */
export function valueAt(message: unknown, path: string): unknown {
  let value = message;
  for (const part of path.match(/[^.[\]]+/g) ?? []) {
    if (typeof value !== 'object' || value === null || !Object.hasOwn(value, part)) return undefined;
    value = (value as Readonly<Record<string, unknown>>)[part];
  }
  return value;
}
