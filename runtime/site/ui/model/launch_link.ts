// The page's address with launch arguments, as `?name:=value`. Pure.

import type { LaunchArgument } from '../../contract/session.ts';

/** A value stands in the address when it is not the one that the site has without it. */
export function launchLink(
  address: string,
  all: readonly LaunchArgument[],
  values: ReadonlyMap<string, string>,
): string {
  const url = new URL(address);
  // Which nodes are asked for has no meaning among others.
  const kept = [...url.searchParams].filter(([key]) => !key.endsWith(':') && key !== 'nodes');
  const words = [new URLSearchParams(kept.map(([key, value]) => [key, value])).toString()];
  for (const { name, packed } of all) {
    const value = values.get(name);
    if (value !== undefined && value !== packed)
      words.push(`${encodeURIComponent(name)}:=${encodeURIComponent(value)}`);
  }
  url.search = words.filter((word) => word !== '').join('&');
  return url.href;
}

/** Those that stand in the address. */
export function isGiven(address: string): boolean {
  return [...new URL(address).searchParams.keys()].some((key) => key.endsWith(':'));
}

const truths: readonly (readonly string[])[] = [
  ['true', 'false'],
  ['True', 'False'],
];

/** The values from which an argument can be chosen; undefined: any text. */
export function valuesOf(argument: LaunchArgument): readonly string[] | undefined {
  const { choices, default: usual, value } = argument;
  if (choices.length > 0) return choices;
  return truths.find((pair) => usual !== undefined && pair.includes(usual) && pair.includes(value));
}
