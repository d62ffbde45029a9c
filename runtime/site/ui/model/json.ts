// Plain JSON values from outside (links, stored layouts, the author's options), converted within bounds.

export type Json =
  | null
  | boolean
  | number
  | string
  | readonly Json[]
  | { readonly [key: string]: Json; };

const DEPTH = 8;

/** A copy of a plain value with at most `budget` characters of JSON; undefined for anything else. */
export function readJson(value: unknown, budget: number): Json | undefined {
  if (!isJson(value, DEPTH, { left: budget })) return undefined;
  const text = JSON.stringify(value);
  if (text.length > budget) return undefined;
  // A copy of its own: nobody can change it later, and odd prototypes are gone.
  return JSON.parse(text) as Json;
}

export function isRecord(value: unknown): value is Readonly<Record<string, unknown>> {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}

/** A member that the value itself has, never one of its prototype. */
export function member(value: unknown, name: string): unknown {
  return isRecord(value) && Object.hasOwn(value, name) ? value[name] : undefined;
}

export function textMember(value: unknown, name: string, fallback = ''): string {
  const found = member(value, name);
  return typeof found === 'string' ? found : fallback;
}

export function flagMember(value: unknown, name: string, fallback: boolean): boolean {
  const found = member(value, name);
  return typeof found === 'boolean' ? found : fallback;
}

export function numberMember(
  value: unknown,
  name: string,
  minimum: number,
  maximum: number,
  fallback: number,
): number {
  const found = member(value, name);
  return typeof found === 'number' && found >= minimum && found <= maximum ? found : fallback;
}

/** The texts of a list; a single text is a list of one. At most `limit` of them. */
export function textsMember(value: unknown, name: string, limit: number): readonly string[] {
  const found = member(value, name);
  if (typeof found === 'string') return [found];
  if (!Array.isArray(found)) return [];
  return found.filter((item): item is string => typeof item === 'string').slice(0, limit);
}

/**
 * Each value takes at least one character. Counted, because what another page sends may have the same list a hundred times
 * in a list, and that one again, or a list of a billion holes.
 */
function isJson(value: unknown, depth: number, budget: { left: number; }): value is Json {
  budget.left -= typeof value === 'string' ? value.length + 1 : 1;
  if (budget.left < 0) return false;
  if (value === null) return true;
  switch (typeof value) {
    case 'boolean':
    case 'string':
      return true;
    case 'number':
      return Number.isFinite(value);
    case 'object':
      if (depth === 0) return false;
      if (Array.isArray(value))
        return value.length <= budget.left && value.every((item: unknown) => isJson(item, depth - 1, budget));
      return isPlain(value) && Object.entries(value).every(
        ([name, item]: [string, unknown]) => isJson(name, depth, budget) && isJson(item, depth - 1, budget),
      );
    default:
      return false;
  }
}

/** Dates, maps and the like have no members to see. */
function isPlain(value: object): boolean {
  const prototype: unknown = Object.getPrototypeOf(value);
  return prototype === null || prototype === Object.prototype;
}
