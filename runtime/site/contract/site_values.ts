// Values of site.json by their kinds: what is another one is told with its place in the file.

import type { SourcePlace } from './site_nodes.ts';
import { SiteError } from './site_error.ts';

export type Json = Readonly<Record<string, unknown>>;

export function fail(what: string): never {
  throw new SiteError('R2W0700', `site.json: ${what}`, {
    why: 'the file is not what `ros2wasm pack` writes',
    fix: 'pack the workspace again and put the whole folder in place',
  });
}

export function object(value: unknown, what: string): Json {
  if (typeof value !== 'object' || value === null || Array.isArray(value)) fail(`${what} is not an object`);
  return value as Json;
}

export function text(json: Json, key: string, what: string, otherwise?: string): string {
  const value = json[key];
  if (value === undefined && otherwise !== undefined) return otherwise;
  return typeof value === 'string' ? value : fail(`${what}.${key} is not a text`);
}

export function number(json: Json, key: string, what: string, otherwise?: number): number {
  const value = json[key];
  if (value === undefined && otherwise !== undefined) return otherwise;
  return typeof value === 'number' && Number.isFinite(value) ? value : fail(`${what}.${key} is not a number`);
}

export function flag(json: Json, key: string): boolean {
  return json[key] === true;
}

export function list<T>(json: Json, key: string, what: string, read: (value: unknown, what: string) => T): T[] {
  const value = json[key];
  if (value === undefined) return [];
  if (!Array.isArray(value)) return fail(`${what}.${key} is not a list`);
  return value.map((item, i) => read(item, `${what}.${key}[${i}]`));
}

/** A path inside the site: never absolute, never upwards. */
export function path(value: string, what: string): string {
  const ok = value !== '' && !value.startsWith('/') && !value.includes('\\') && !/^[a-z]+:/i.test(value)
    && !value.split('/').some((part) => part === '..' || part === '');
  return ok ? value : fail(`${what} is not a path inside the site: ${value}`);
}

export function readSource(json: Json): SourcePlace | undefined {
  if (json['source'] === undefined || json['source'] === null) return undefined;
  const source = object(json['source'], 'source');
  return { file: text(source, 'file', 'source'), line: number(source, 'line', 'source'), column: number(source, 'column', 'source', 1) };
}
