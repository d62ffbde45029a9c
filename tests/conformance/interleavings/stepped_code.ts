// Makes code of runtime/site pause before every access to shared memory, so that a test decides who goes on.
// Nothing is written anew: each function that reaches shared memory becomes a generator, each access a point where it
// may yield to the explorer (stepper.ts). What a function does, and in which order, stays as it is in the source.

import { readFileSync } from 'node:fs';
import { stripTypeScriptTypes } from 'node:module';
import { basename } from 'node:path';
import { type AnyNode, parse } from 'acorn';
import { build } from 'esbuild';

/** Names under which the sources hold views of shared memory (and of programs' memory, told apart at run time). */
const viewNames = new Set(['i32', 'u8', 'words', 'from', 'to', 'fromWords', 'toWords']);
/** Parameters under which functions that reach shared memory are handed over. */
const calledBack = ['look', 'needed'];
const callbackMethods = new Set(['some', 'every', 'filter', 'map', 'forEach']);
/** Atomic accesses of runtime/site/bus/bus.ts, by the word's index. */
const busMethods = new Set(['load', 'store', 'add', 'sub', 'or', 'exchange', 'compareExchange']);
const rangeMethods = new Set(['fill', 'set', 'slice', 'copyWithin']);

interface Context {
  readonly text: string;
  /** Names of functions that reach shared memory. */
  readonly reaching: ReadonlySet<string>;
  /** A constructor cannot yield; what it does happens in one go. */
  readonly inConstructor: boolean;
}

function isNode(value: unknown): value is AnyNode {
  return typeof value === 'object' && value !== null && typeof (value as { type?: unknown; }).type === 'string';
}

function children(node: AnyNode): AnyNode[] {
  const found: AnyNode[] = [];
  for (const value of Object.values(node) as unknown[]) {
    if (Array.isArray(value)) found.push(...value.filter(isNode));
    else if (isNode(value)) found.push(value);
  }
  // A shorthand property names its key and value by the same text.
  return found.filter((child, i) => found.findIndex((other) => other.start === child.start && other.end === child.end) === i)
    .sort((a, b) => a.start - b.start);
}

/** The last name of an expression: `i32` of `this.bus.i32`. */
function lastName(node: AnyNode | null): string {
  if (node === null) return '';
  if (node.type === 'Identifier' || node.type === 'PrivateIdentifier') return node.name;
  if (node.type === 'MemberExpression' && !node.computed) return lastName(node.property);
  return '';
}

function isView(node: AnyNode): boolean {
  return viewNames.has(lastName(node));
}

function isAtomics(node: AnyNode): boolean {
  return node.type === 'CallExpression' && node.callee.type === 'MemberExpression' && lastName(node.callee.object) === 'Atomics';
}

/** `bus.load(word)` and its kin; inside the class Bus, `this.load(word)`. */
function isBusAccess(node: AnyNode): boolean {
  if (node.type !== 'CallExpression' || node.callee.type !== 'MemberExpression' || node.callee.computed) return false;
  const of = node.callee.object;
  return busMethods.has(lastName(node.callee)) && (of.type === 'ThisExpression' || lastName(of) === 'bus');
}

function isElement(node: AnyNode): boolean {
  return node.type === 'MemberExpression' && node.computed && isView(node.object);
}

function isRange(node: AnyNode): boolean {
  return node.type === 'CallExpression' && node.callee.type === 'MemberExpression' && !node.callee.computed
    && rangeMethods.has(lastName(node.callee)) && isView(node.callee.object);
}

function isFunction(node: AnyNode): boolean {
  return node.type === 'FunctionDeclaration' || node.type === 'FunctionExpression' || node.type === 'ArrowFunctionExpression';
}

/** `this.size()` of the class Bus, and `memory.grow(pages)`. */
function isSize(node: AnyNode): boolean {
  if (node.type !== 'CallExpression' || node.callee.type !== 'MemberExpression') return false;
  const { object } = node.callee;
  return lastName(node.callee) === 'grow' ? lastName(object) === 'memory' : lastName(node.callee) === 'size' && object.type === 'ThisExpression';
}

/** Does what lies directly in the node (functions inside it apart) reach shared memory? */
function reaches(node: AnyNode, names: ReadonlySet<string>): boolean {
  if (isAtomics(node) || isBusAccess(node) || isElement(node) || isRange(node) || isSize(node)) return true;
  if (node.type === 'CallExpression') {
    if (names.has(lastName(node.callee))) return true;
    if (callbackMethods.has(lastName(node.callee)) && node.arguments.some((each) => isFunction(each) && reachesInside(each, names))) return true;
  }
  return children(node).some((child) => !isFunction(child) && reaches(child, names));
}

/** Waiting without blocking is the page's affair and in no scene. */
function isAsync(node: AnyNode): boolean {
  return isFunction(node) && 'async' in node && node.async;
}

function reachesInside(node: AnyNode, names: ReadonlySet<string>): boolean {
  return !isAsync(node) && children(node).some((child) => !isFunction(child) && reaches(child, names));
}

/** Adds the names under which functions that reach shared memory can be called. */
function collect(node: AnyNode, names: Set<string>): void {
  const add = (name: string, value: AnyNode | null | undefined): void => {
    if (name !== '' && name !== 'constructor' && value != null && isFunction(value) && reachesInside(value, names)) names.add(name);
  };
  if (node.type === 'FunctionDeclaration') add(lastName(node.id), node);
  if (node.type === 'MethodDefinition' || node.type === 'PropertyDefinition' || node.type === 'Property') add(lastName(node.key), node.value);
  if (node.type === 'VariableDeclarator') add(lastName(node.id), node.init);
  if (node.type === 'AssignmentExpression') add(lastName(node.left), node.right);
  for (const child of children(node)) collect(child, names);
}

function emit(node: AnyNode, context: Context): string {
  const { text, reaching, inConstructor } = context;
  const inner = (child: AnyNode): string => emit(child, context);
  const point = (operation: string, ...args: readonly string[]): string => `(S.enter(S.${operation}, ${args.join(', ')}) && (yield), S.perform())`;
  if (isAsync(node)) return text.slice(node.start, node.end);
  if (isFunction(node) && reachesInside(node, reaching)) return emitFunction(node, context);
  if (node.type === 'MethodDefinition') {
    if (node.kind === 'constructor') {
      return text.slice(node.start, node.value.start) + splice(node.value, { ...context, inConstructor: true });
    }
    const star = reachesInside(node.value, reaching) ? '*' : '';
    const at = node.key.start;
    return text.slice(node.start, at) + star + splice(node, context).slice(at - node.start);
  }
  if (inConstructor) {
    if (node.type === 'CallExpression' && reaching.has(lastName(node.callee))) return `S.drive(${splice(node, context)})`;
    return splice(node, context);
  }
  if (node.type === 'CallExpression') {
    if (isAtomics(node)) {
      const operation = lastName(node.callee);
      const args = node.arguments.map(inner);
      if (operation === 'wait') return `(yield* S.wait(${args.join(', ')}))`;
      return point(operation, ...args);
    }
    if (isRange(node) && node.callee.type === 'MemberExpression') {
      return `(yield* S.${lastName(node.callee)}(${[node.callee.object, ...node.arguments].map(inner).join(', ')}))`;
    }
    if (isBusAccess(node) && node.callee.type === 'MemberExpression') {
      return point(lastName(node.callee), `${inner(node.callee.object)}.i32`, ...node.arguments.map(inner));
    }
    if (isSize(node) && node.callee.type === 'MemberExpression') {
      const of = inner(node.callee.object);
      return lastName(node.callee) === 'grow' ? point('resize', of, '0', ...node.arguments.map(inner)) : point('size', `${of}.memory`, '0');
    }
    const name = lastName(node.callee);
    const callback = node.arguments.some((each) => isFunction(each) && reachesInside(each, reaching));
    if (callback && callbackMethods.has(name) && node.callee.type === 'MemberExpression') {
      return `(yield* S.each.${name}(${[node.callee.object, ...node.arguments].map(inner).join(', ')}))`;
    }
    if (reaching.has(name) || callback) return `(S.follows(S.called = ${splice(node, context)}) ? yield* S.called : S.called)`;
  }
  if (node.type === 'AssignmentExpression' && isElement(node.left) && node.left.type === 'MemberExpression') {
    if (node.operator !== '=') throw new Error(`no rule for ${text.slice(node.start, node.end)}`);
    return point('put', inner(node.left.object), inner(node.left.property), inner(node.right));
  }
  if (isElement(node) && node.type === 'MemberExpression') return point('get', inner(node.object), inner(node.property));
  return splice(node, context);
}

/** The node's own text with that of its children replaced. */
function splice(node: AnyNode, context: Context): string {
  let out = '';
  let at = node.start;
  for (const child of children(node)) {
    out += context.text.slice(at, child.start) + emit(child, context);
    at = child.end;
  }
  return out + context.text.slice(at, node.end);
}

function emitFunction(node: AnyNode, context: Context): string {
  const inside = { ...context, inConstructor: false };
  const { text } = context;
  if (node.type === 'ArrowFunctionExpression') {
    const parameters = node.params.map((each) => text.slice(each.start, each.end)).join(', ');
    const body = node.body.type === 'BlockStatement' ? emit(node.body, inside) : `{ return ${emit(node.body, inside)}; }`;
    return `(function* (${parameters}) ${body}).bind(this)`;
  }
  if (node.type === 'FunctionDeclaration') {
    if (node.generator) throw new Error(`a generator cannot reach shared memory: ${lastName(node.id)}`);
    return splice(node, inside).replace('function', 'function*');
  }
  return splice(node, inside);
}

function withConstants(text: string, constants: Readonly<Record<string, number>>): string {
  let out = text;
  for (const [name, value] of Object.entries(constants)) {
    const line = new RegExp(`export const ${name} = \\d+;`);
    if (!line.test(out)) throw new Error(`no constant ${name}`);
    out = out.replace(line, `export const ${name} = ${value};`);
  }
  return out;
}

/** `files` are stepped; the others they import are taken as they are, but for `constants` that are given anew. */
export async function steppedBundle(
  entry: string,
  files: readonly string[],
  constants: Readonly<Record<string, number>>,
): Promise<string> {
  const names = new Set(calledBack);
  const parsed = new Map<string, { text: string; tree: AnyNode; }>();
  for (const file of files) {
    const text = stripTypeScriptTypes(readFileSync(file, 'utf8'));
    parsed.set(file, { text, tree: parse(text, { ecmaVersion: 'latest', sourceType: 'module' }) });
  }
  for (let known = -1; known !== names.size;) {
    known = names.size;
    for (const { tree } of parsed.values()) collect(tree, names);
  }
  const result = await build({
    entryPoints: [entry],
    bundle: true,
    write: false,
    format: 'iife',
    globalName: 'stepped',
    target: 'es2024',
    logLevel: 'error',
    plugins: [{
      name: 'stepped',
      setup: (plugin) => {
        plugin.onLoad({ filter: /\.ts$/ }, ({ path }) => {
          const file = parsed.get(path);
          if (path.endsWith('/generated/constants.ts')) return { contents: withConstants(readFileSync(path, 'utf8'), constants), loader: 'ts' };
          if (file === undefined) return undefined;
          return { contents: emit(file.tree, { text: file.text, reaching: names, inConstructor: false }), loader: 'js' };
        });
      },
    }],
  });
  const text = result.outputFiles[0]?.text;
  if (text === undefined) throw new Error(`nothing came of ${basename(entry)}`);
  return text;
}
