// The conditions for a green executable or launch file: one entry of a YAML file (README.md has the form). An unknown key in an
// entry is an error, since a key that silently does nothing would make a row green too easily.
import { readFileSync } from 'node:fs';
import { parse } from 'yaml';

/** One node of the site that is played, in the words of workspace.yaml. */
export interface Start {
  readonly package: string;
  readonly executable: string;
  readonly options: Readonly<Record<string, unknown>>;
  /** Texts for its standard input, each sent when a line of its output fits `after`. */
  readonly input: readonly { readonly after: RegExp; readonly text: string; }[];
  /** It is asked to stop, as by Ctrl-C, when a line of its output fits and its endpoints are there; undefined: it is left running. */
  readonly stop: RegExp | undefined;
  /** Each fits a line of its output, in this order. */
  readonly log: readonly RegExp[];
  /** Each fits a line of its output, wherever. */
  readonly anywhere: readonly RegExp[];
  /** None fits a line of its output. */
  readonly never: readonly RegExp[];
}

export interface Expectation extends Start {
  readonly kind: 'executable' | 'launch';
  /** Launch arguments, of a launch file. */
  readonly given: Readonly<Record<string, string | number | boolean>>;
  /** The executable that is started, when the row is one of what it holds: a component in a container. */
  readonly program: string;
  /** Started beside it. */
  readonly beside: readonly Start[];
  /** `publisher /topic std_msgs/msg/String`: endpoints that it must make. */
  readonly endpoints: readonly string[];
  /** Topic -> path in a message -> what its value reads like. */
  readonly values: ReadonlyMap<string, ReadonlyMap<string, RegExp>>;
  /** Code that it must end with; it need not end when undefined. */
  readonly exit: number | undefined;
  readonly seconds: number;
}

export const NODE_KEYS = ['name', 'namespace', 'arguments', 'parameters', 'remappings'] as const;
const START_KEYS = ['package', 'executable', 'input', 'stop', 'log', 'anywhere', 'never', ...NODE_KEYS];
const SEEN_KEYS = ['endpoints', 'values', 'exit', 'seconds'];
const KEYS = [...START_KEYS, ...SEEN_KEYS, 'program', 'beside'];
const LAUNCH_KEYS = ['package', 'launch', 'arguments', 'log', 'anywhere', 'never', ...SEEN_KEYS];
/** On a busy machine a program's first line takes some seconds. */
const SECONDS = 20;

export class BadExpectation extends Error {}

/** Key of a row: `package/executable`; of a launch file its place in share/package/, as `package/launch/all.launch.py`. */
export function keyOf({ package: name, executable }: { readonly package: string; readonly executable: string; }): string {
  return `${name}/${executable}`;
}

/** Later files win. */
export function readExpectations(files: readonly string[]): ReadonlyMap<string, Expectation> {
  const found = new Map<string, Expectation>();
  for (const file of files) {
    for (const one of parseExpectations(readFileSync(file, 'utf8'), file)) found.set(keyOf(one), one);
  }
  return found;
}

export function parseExpectations(text: string, file: string): Expectation[] {
  const entries: unknown = parse(text);
  if (!Array.isArray(entries)) throw new BadExpectation(`${file}: a list of executables is wanted`);
  const seen = new Set<string>();
  return entries.map((entry: unknown, index) => {
    const at = `${file}, entry ${index + 1}`;
    const one = expectation(entry, at);
    if (seen.has(keyOf(one))) throw new BadExpectation(`${at}: ${keyOf(one)} stands there twice`);
    seen.add(keyOf(one));
    return one;
  });
}

function expectation(value: unknown, at: string): Expectation {
  const isLaunch = typeof value === 'object' && value !== null && 'launch' in value;
  const entry = mapping(value, isLaunch ? LAUNCH_KEYS : KEYS, at);
  const started = start(isLaunch ? { ...entry, executable: entry['launch'], arguments: undefined } : entry, at);
  const read: Expectation = {
    ...started,
    kind: isLaunch ? 'launch' : 'executable',
    given: isLaunch ? given(entry['arguments'], at) : {},
    program: entry['program'] === undefined ? started.executable : text(entry['program'], at),
    beside: list(entry['beside'], at).map((one) => start(mapping(one, START_KEYS, at), at)),
    endpoints: list(entry['endpoints'], at).map((one) => text(one, at)),
    values: new Map(
      Object.entries(mapping(entry['values'] ?? {}, undefined, at)).map((
        [topic, fields],
      ) => [topic, new Map(Object.entries(mapping(fields, undefined, at)).map(([path, value]) => [path, regex(value, at)]))]),
    ),
    exit: number(entry['exit'], at),
    seconds: number(entry['seconds'], at) ?? SECONDS,
  };
  const says = read.log.length + read.anywhere.length + read.endpoints.length + read.values.size + read.beside.reduce((n, s) => n + s.log.length, 0);
  if (says === 0) throw new BadExpectation(`${at}: it says nothing that must be seen`);
  return read;
}

function given(value: unknown, at: string): Expectation['given'] {
  return Object.fromEntries(Object.entries(mapping(value ?? {}, undefined, at)).map(([name, one]) => {
    if (typeof one === 'string' || typeof one === 'number' || typeof one === 'boolean') return [name, one];
    throw new BadExpectation(`${at}: ${name} has no value that a launch argument can have`);
  }));
}

function start(entry: Readonly<Record<string, unknown>>, at: string): Start {
  const options = Object.fromEntries(NODE_KEYS.filter((key) => entry[key] !== undefined).map((key) => [key, entry[key]]));
  const regexes = (key: string): RegExp[] => list(entry[key], at).map((one) => regex(one, at));
  return {
    package: text(entry['package'], at),
    executable: text(entry['executable'], at),
    options,
    input: list(entry['input'], at).map((one) => {
      const { after, text: words } = mapping(one, ['after', 'text'], at);
      return { after: regex(after, at), text: text(words, at) };
    }),
    stop: entry['stop'] === undefined ? undefined : regex(entry['stop'], at),
    log: regexes('log'),
    anywhere: regexes('anywhere'),
    never: regexes('never'),
  };
}

function mapping(value: unknown, keys: readonly string[] | undefined, at: string): Readonly<Record<string, unknown>> {
  if (typeof value !== 'object' || value === null || Array.isArray(value)) throw new BadExpectation(`${at}: a mapping is wanted`);
  const unknownKey = keys === undefined ? undefined : Object.keys(value).find((key) => !keys.includes(key));
  if (unknownKey !== undefined) throw new BadExpectation(`${at}: no such key: ${unknownKey}`);
  return value as Readonly<Record<string, unknown>>;
}

function list(value: unknown, at: string): readonly unknown[] {
  if (value === undefined) return [];
  if (!Array.isArray(value)) throw new BadExpectation(`${at}: a list is wanted`);
  return value;
}

function text(value: unknown, at: string): string {
  if (typeof value !== 'string') throw new BadExpectation(`${at}: a text is wanted, not ${JSON.stringify(value)}`);
  return value;
}

function number(value: unknown, at: string): number | undefined {
  if (value === undefined || typeof value === 'number') return value;
  throw new BadExpectation(`${at}: a number is wanted, not ${JSON.stringify(value)}`);
}

function regex(value: unknown, at: string): RegExp {
  try {
    return new RegExp(text(value, at));
  } catch (error) {
    throw error instanceof SyntaxError ? new BadExpectation(`${at}: ${error.message}`) : error;
  }
}
