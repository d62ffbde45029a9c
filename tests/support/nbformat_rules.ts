// The rules of the schema of nbformat 4, written by hand: neither npm nor Debian's own packages have the schema.

type Rule = (value: unknown, minor: number) => readonly string[];
type Members = Readonly<Record<string, unknown>>;

const isObject = (value: unknown): value is Members => typeof value === 'object' && value !== null && !Array.isArray(value);
const fails = (holds: boolean, what: string): readonly string[] => holds ? [] : [what];
const text: Rule = (value) => fails(typeof value === 'string', 'is not text');
const object: Rule = (value) => fails(isObject(value), 'is not an object');
const lines: Rule = (value) =>
  fails(typeof value === 'string' || (Array.isArray(value) && value.every((line) => typeof line === 'string')), 'is neither a text nor a list of lines');
const texts: Rule = (value) => fails(Array.isArray(value) && value.every((line) => typeof line === 'string'), 'is not a list of texts');
const count: Rule = (value) => fails(value === null || (Number.isInteger(value) && (value as number) >= 0), 'is neither null nor a count');
const is = (...allowed: readonly unknown[]): Rule => (value) => fails(allowed.includes(value), `is not one of ${allowed.join(', ')}`);
const id: Rule = (value) => fails(typeof value === 'string' && /^[a-zA-Z0-9_-]{1,64}$/.test(value), 'is not an id');

/** Data by MIME type: JSON where the type says so, else text. */
const bundle: Rule = (value) =>
  isObject(value)
    ? Object.entries(value).flatMap(([mime, data]) => /^application\/(.*\+)?json$/.test(mime) ? [] : at(mime, lines(data, 0)))
    : ['is not an object'];
const attachments: Rule = (value, minor) =>
  isObject(value) ? Object.entries(value).flatMap(([name, data]) => at(name, bundle(data, minor))) : ['is not an object'];

function at(place: string, faults: readonly string[]): readonly string[] {
  return faults.map((fault) => `${place}${fault.startsWith('.') || fault.startsWith('[') ? '' : ' '}${fault}`);
}

/** All of `wanted` are there, `optional` may be, and nothing else is. */
function members(value: unknown, minor: number, wanted: Readonly<Record<string, Rule>>, optional: Readonly<Record<string, Rule>> = {}): readonly string[] {
  if (!isObject(value)) return ['is not an object'];
  const rules: Readonly<Record<string, Rule>> = { ...wanted, ...optional };
  return [
    ...Object.keys(wanted).filter((name) => !(name in value)).map((name) => `.${name} is missing`),
    ...Object.entries(value).flatMap(([name, part]) => at(`.${name}`, rules[name]?.(part, minor) ?? ['is unknown'])),
  ];
}

const outputs: Readonly<Record<string, Readonly<Record<string, Rule>>>> = {
  execute_result: { execution_count: count, data: bundle, metadata: object },
  display_data: { data: bundle, metadata: object },
  stream: { name: text, text: lines },
  error: { ename: text, evalue: text, traceback: texts },
};

const output: Rule = (value, minor) => {
  const kind = isObject(value) ? String(value['output_type']) : '';
  const wanted = outputs[kind];
  return wanted === undefined ? ['.output_type is unknown'] : members(value, minor, { output_type: is(kind), ...wanted });
};

const list = (rule: Rule): Rule => (value, minor) => Array.isArray(value) ? value.flatMap((each, i) => at(`[${i}]`, rule(each, minor))) : ['is not a list'];

const cell: Rule = (value, minor) => {
  const kind = isObject(value) ? value['cell_type'] : '';
  const wanted = { cell_type: is('code', 'markdown', 'raw'), metadata: object, source: lines, ...(minor >= 5 ? { id } : {}) };
  return kind === 'code'
    ? members(value, minor, { ...wanted, outputs: list(output), execution_count: count })
    : members(value, minor, wanted, minor >= 1 ? { attachments } : {});
};

/** The faults of a notebook, each with its place. */
export function nbformatFaults(notebook: unknown): readonly string[] {
  const minor = isObject(notebook) && Number.isInteger(notebook['nbformat_minor']) ? notebook['nbformat_minor'] as number : -1;
  if (minor < 0) return ['.nbformat_minor is not a count'];
  const faults = members(notebook, minor, { metadata: object, nbformat: is(4), nbformat_minor: count, cells: list(cell) });
  const ids = ((notebook as Members)['cells'] as readonly Members[] | undefined)?.map((each) => each['id']).filter((each) => each !== undefined) ?? [];
  return [...faults, ...fails(new Set(ids).size === ids.length, 'two cells have one id')];
}
