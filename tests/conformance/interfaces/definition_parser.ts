// A strict reader of .msg, .srv and .action files for tests: what it does not know, it refuses.
// Knows one line at a time; comments are dropped.

export type InterfaceKind = 'msg' | 'srv' | 'action';

export interface Constant {
  readonly type: string;
  readonly name: string;
  readonly value: string;
}

export interface Field {
  /** As written: "geometry_msgs/Pose[<=3]". */
  readonly type: string;
  readonly name: string;
  /** As written, when the field has a default. */
  readonly defaultValue: string | undefined;
}

/** One section of a file: a whole .msg, a request, a goal. */
export interface Section {
  readonly constants: readonly Constant[];
  readonly fields: readonly Field[];
}

/** A field's type in pieces. `size` is a length for "array" and a limit for "bounded". */
export interface TypeParts {
  readonly base: string;
  readonly stringBound: number | undefined;
  readonly container: 'none' | 'array' | 'bounded' | 'unbounded';
  readonly size: number;
}

const SECTION_NAMES: Readonly<Record<InterfaceKind, readonly string[]>> = {
  msg: [''],
  srv: ['request', 'response'],
  action: ['goal', 'result', 'feedback'],
};

const PRIMITIVES: ReadonlySet<string> = new Set([
  'bool',
  'byte',
  'char',
  'float32',
  'float64',
  'int8',
  'uint8',
  'int16',
  'uint16',
  'int32',
  'uint32',
  'int64',
  'uint64',
  'string',
  'wstring',
]);
const TYPE = /^(?<base>[a-z][a-z0-9_]*|(?:[a-z][a-z0-9_]*\/)?[A-Z][A-Za-z0-9]*)(?:<=(?<bound>[1-9]\d*))?(?<array>\[(?<limit><=)?(?<size>[1-9]\d*)?\])?$/;
const FIELD = /^(?<type>\S+) +(?<name>[a-z][a-z0-9_]*)(?: +(?<value>\S.*))?$/;
const CONSTANT = /^(?<type>\S+) +(?<name>[A-Z][A-Z0-9_]*)=(?<value>\S.*)$/;

export function isPrimitive(base: string): boolean {
  return PRIMITIVES.has(base);
}

export function typeParts(type: string): TypeParts {
  const groups = TYPE.exec(type)?.groups;
  const base = groups?.['base'];
  if (groups === undefined || base === undefined) throw new Error(`not a type: ${type}`);
  if (/^[a-z]/.test(base) && !base.includes('/') && !isPrimitive(base)) {
    throw new Error(`unknown primitive: ${type}`);
  }
  const bound = groups['bound'] === undefined ? undefined : Number(groups['bound']);
  if (bound !== undefined && base !== 'string' && base !== 'wstring') {
    throw new Error(`only strings have a bound: ${type}`);
  }
  if (groups['array'] === undefined) return { base, stringBound: bound, container: 'none', size: 0 };
  const size = Number(groups['size'] ?? 0);
  if (groups['limit'] !== undefined && size === 0) throw new Error(`a bound is missing: ${type}`);
  const container = groups['limit'] !== undefined ? 'bounded' : size > 0 ? 'array' : 'unbounded';
  return { base, stringBound: bound, container, size };
}

function parseSection(lines: readonly string[]): Section {
  const constants: Constant[] = [];
  const fields: Field[] = [];
  for (const raw of lines) {
    if (/^\s/.test(raw) && raw.trim() !== '') throw new Error(`a line begins with a blank: ${raw}`);
    const line = raw.replace(/#.*$/, '').trimEnd();
    if (line === '') continue;
    const constant = CONSTANT.exec(line)?.groups;
    const groups = constant ?? FIELD.exec(line)?.groups;
    const [type, name, value] = [groups?.['type'], groups?.['name'], groups?.['value']];
    if (type === undefined || name === undefined) throw new Error(`not a definition: ${raw}`);
    typeParts(type);
    if ([...constants, ...fields].some((other) => other.name === name)) {
      throw new Error(`twice: ${name}`);
    }
    if (constant !== undefined) constants.push({ type, name, value: value ?? '' });
    else fields.push({ type, name, defaultValue: value });
  }
  return { constants, fields };
}

/** Returns the sections by name; a .msg has one, named "". */
export function parseInterface(kind: InterfaceKind, text: string): ReadonlyMap<string, Section> {
  const names = SECTION_NAMES[kind];
  const sections: string[][] = [[]];
  for (const line of text.split('\n')) {
    if (line === '---') sections.push([]);
    else sections.at(-1)?.push(line);
  }
  if (sections.length !== names.length) {
    throw new Error(`.${kind} has ${names.length} sections, found ${sections.length}`);
  }
  return new Map(names.map((name, index) => [name, parseSection(sections[index] ?? [])]));
}
