// Launch arguments as people write them: `name:=value` on the command line and in the page's address, and the list that
// `--show-args` prints.

import type { LaunchArgument } from './session.ts';
import { SiteError } from './site_error.ts';

const sign = ':=';

/** "robot:=one" each. Throws SiteError R2W0730. A later one of a name wins. */
export function readGiven(words: readonly string[]): ReadonlyMap<string, string> {
  return new Map(words.map((word): [string, string] => {
    const at = word.indexOf(sign);
    if (at > 0) return [word.slice(0, at), word.slice(at + sign.length)];
    throw new SiteError('R2W0730', `\`${word}\` is not a launch argument`, { why: 'one is written as name:=value' });
  }));
}

/** What `?robot:=one&graph=x` has of them. */
export function givenInAddress(search: string): ReadonlyMap<string, string> {
  const words = [...new URLSearchParams(search)].filter(([key]) => key.endsWith(':')).map(([key, value]) => `${key}=${value}`);
  return readGiven(words);
}

const quoted = (text: string): string => `'${text.replaceAll('\\', '\\\\').replaceAll("'", "\\'")}'`;

/** As `ros2 launch --show-args` prints them. */
export function shownArguments(all: readonly LaunchArgument[]): string {
  const lines = ["Arguments (pass arguments as '<name>:=<value>'):"];
  if (all.length === 0) lines.push('', '  No arguments.');
  for (const { name, description, choices, default: value } of all) {
    const about = description === '' ? 'no description given' : description;
    const valid = choices.length === 0 ? '' : `. Valid choices are: [${choices.map(quoted).join(', ')}]`;
    lines.push('', `    '${name}':`, `        ${about}${valid}`);
    if (value !== undefined) lines.push(`        (default: ${quoted(value)})`);
  }
  return lines.join('\n');
}
