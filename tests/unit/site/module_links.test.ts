// The imports of modules, found by regular expressions, compared with a parser: in every module of the built page.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { type Node, parse } from 'acorn';
import { linkedModule, neededModules } from '../../../runtime/site/program/module_links.ts';

const BUILT = process.env['ROS2WASM_BUILD'] ?? new URL('../../../build', import.meta.url).pathname;

interface Source extends Node {
  readonly source?: { readonly value?: unknown; } | null;
}

/** The imports of the module, by the parser: static ones in `now`, dynamic ones in `later`. */
function imports(text: string): { readonly now: string[]; readonly later: string[]; } {
  const now: string[] = [];
  const later: string[] = [];
  const visit = (value: unknown): void => {
    if (Array.isArray(value)) value.forEach(visit);
    if (typeof value !== 'object' || value === null || Array.isArray(value)) return;
    const node = value as Source;
    const from = node.source?.value;
    if (typeof from === 'string') (node.type === 'ImportExpression' ? later : now).push(from);
    Object.values(node).forEach(visit);
  };
  visit(parse(text, { ecmaVersion: 'latest', sourceType: 'module' }));
  return { now, later };
}

test('each import of the built page is named anew, and nothing else is changed', () => {
  const folder = join(BUILT, 'runtime');
  const { assets } = JSON.parse(readFileSync(join(folder, 'runtime_assets.json'), 'utf8')) as { assets: { file: string; role: string; }[]; };
  const modules = assets.filter(({ file, role }) => file.endsWith('.js') && ['script', 'launch_script'].includes(role) && file !== 'boot.js');
  assert.ok(modules.length > 60, 'modules');
  const names = new Set(readdirSync(folder));
  let seen = 0;
  for (const { file } of modules) {
    const text = readFileSync(join(folder, file), 'utf8');
    const before = imports(text);
    const needed = neededModules(text);
    assert.deepEqual(new Set(needed.map((name) => `./${name}`)), new Set(before.now), file);
    for (const name of needed) assert.ok(names.has(name), `${file} needs ${name}`);
    const linked = linkedModule(text, new Map(needed.map((name) => [name, `blob:null/${name}`])), 'importOfPage');
    const after = imports(linked);
    assert.deepEqual(after, { now: before.now.map((name) => name.replace('./', 'blob:null/')), later: [] }, file);
    const asked = Array.from(linked.matchAll(/\bimportOfPage\("([^"]+)"\)/g), ([, name]) => `./${name}`);
    assert.deepEqual(asked.sort(), before.later.sort(), file);
    seen += before.now.length + before.later.length;
  }
  assert.ok(seen > 200, `${seen} imports`);
});

test('forms of imports', () => {
  const addresses = new Map([['a.js', 'blob:1'], ['b-C.js', 'blob:2']]);
  const text = 'import"./a.js";import{x as y}from"./b-C.js";export{z}from\'./a.js\';const s="./a.js";import("./later.js");import(s)';
  assert.deepEqual(neededModules(text), ['a.js', 'b-C.js']);
  assert.equal(
    linkedModule(text, addresses, 'load'),
    'import"blob:1";import{x as y}from"blob:2";export{z}from"blob:1";const s="./a.js";load("later.js");import(s)',
  );
});
