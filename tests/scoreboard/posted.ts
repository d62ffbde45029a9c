// Writes the request to play a site as text, for a page. Pure.
import type { Asked } from './play.ts';

export function posted(asked: Asked): string {
  return JSON.stringify(asked, (_, value: unknown) => value instanceof RegExp ? { regex: value.source } : value instanceof Map ? { map: [...value] } : value);
}

export function received(text: string): Asked {
  return JSON.parse(text, (_, value: unknown) => {
    if (typeof value !== 'object' || value === null) return value;
    if ('regex' in value && typeof value.regex === 'string') return new RegExp(value.regex);
    if ('map' in value && Array.isArray(value.map)) return new Map(value.map);
    return value;
  }) as Asked;
}
