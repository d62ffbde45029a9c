// An expectation as text, for a page. Pure.
import type { Expectation } from './expectation.ts';

export function posted(expected: Expectation | undefined): string {
  return JSON.stringify({ expected }, (_, value: unknown) =>
    value instanceof RegExp ? { regex: value.source } : value instanceof Map ? { map: [...value] } : value);
}

export function received(text: string): Expectation | undefined {
  const { expected } = JSON.parse(text, (_, value: unknown) => {
    if (typeof value !== 'object' || value === null) return value;
    if ('regex' in value && typeof value.regex === 'string') return new RegExp(value.regex);
    if ('map' in value && Array.isArray(value.map)) return new Map(value.map);
    return value;
  }) as { readonly expected?: Expectation };
  return expected;
}
