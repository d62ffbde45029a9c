// Gathers the definition of a message type and of every type inside it into one text, in the form that
// @foxglove/rosmsg reads. Field types are written out in full, so that two packages may use one name.

export type Definitions = ReadonlyMap<string, string>;

const SEPARATOR = `\n${'='.repeat(80)}\n`;

const PRIMITIVE: ReadonlySet<string> = new Set([
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

/** Types whose two fields the decoder knows by itself. */
const TIMES: ReadonlySet<string> = new Set([
  'builtin_interfaces/msg/Time',
  'builtin_interfaces/msg/Duration',
]);

const TIME_TEXT: ReadonlyMap<string, string> = new Map([...TIMES].map((time) => [time, 'int32 sec\nuint32 nanosec']));

/** The text for one message type, or the name of the type that is missing. */
export function gatherDefinition(
  type: string,
  interfaces: Definitions,
): { text: string; } | { missing: string; } {
  const found = gatherParts(type, interfaces);
  return 'missing' in found ? found : { text: found.parts.map(({ text }) => text).join(SEPARATOR) };
}

/**
 * The same as bags have it (`ros2msg` of MCAP's registry): definitions as they were written, each but the first behind a
 * line `MSG: package/Name`.
 */
export function gatherSchema(type: string, interfaces: Definitions): string | undefined {
  const found = gatherParts(type, interfaces);
  if ('missing' in found) return undefined;
  const times = [...TIMES].filter((time) => time !== type && found.parts.some(({ uses }) => uses.has(time)));
  const all = [...found.parts, ...times.map((time) => ({ type: time, source: interfaces.get(time) ?? TIME_TEXT.get(time) ?? '' }))];
  return all.map(({ type: name, source }, index) => {
    const [package_name = '', , own = ''] = name.split('/');
    return index === 0 ? source.trimEnd() : `MSG: ${package_name}/${own}\n${source.trimEnd()}`;
  }).join(SEPARATOR);
}

/** The types in a schema of a bag, by their full names; `type` is that of the first. Parts without a valid form are skipped. */
export function splitSchema(type: string, schema: string): Map<string, string> {
  const found = new Map<string, string>();
  for (const [index, part] of schema.replaceAll('\r\n', '\n').split(/^={3,}$\n?/m).entries()) {
    if (index === 0) {
      found.set(type, part);
      continue;
    }
    const match = /^MSG:[ \t]*([A-Za-z]\w*)\/(?:(msg|srv|action)\/)?([A-Za-z]\w*)[ \t]*(?:\n|$)/.exec(part);
    if (match === null) continue;
    const [head, package_name = '', kind = 'msg', name = ''] = match;
    found.set(`${package_name}/${kind}/${name}`, part.slice(head.length));
  }
  return found;
}

interface Part {
  readonly type: string;
  /** As it was written. */
  readonly source: string;
  /** With full names. */
  readonly text: string;
  /** Those of TIMES that it names. */
  readonly uses: ReadonlySet<string>;
}

/** A type and all types inside it. */
function gatherParts(type: string, interfaces: Definitions): { parts: Part[]; } | { missing: string; } {
  const done = new Set<string>([type]);
  const queue: string[] = [type];
  const parts: Part[] = [];
  for (let next = queue.shift(); next !== undefined; next = queue.shift()) {
    const source = interfaces.get(next) ?? derivedDefinition(next, interfaces);
    if (source === undefined) {
      return { missing: next };
    }
    const uses = new Set<string>();
    const lines: string[] = next === type ? [] : [`MSG: ${next}`];
    for (const line of source.split('\n')) {
      const field = readField(line);
      if (field === null) continue;
      const full = qualify(field.type, next);
      if (full !== null && TIMES.has(full)) uses.add(full);
      if (full !== null && !done.has(full) && !TIMES.has(full)) {
        done.add(full);
        queue.push(full);
      }
      lines.push(`${full ?? field.type}${field.rest}`);
    }
    parts.push({ type: next, source, text: lines.join('\n'), uses });
  }
  return { parts };
}

/** `geometry_msgs/msg/Point` for `Point` in `geometry_msgs/msg/Pose`; null for a primitive type. */
export function qualify(type: string, within: string): string | null {
  if (PRIMITIVE.has(type)) return null;
  const tokens = type.split('/');
  if (tokens.length === 3) return type;
  if (tokens.length === 2) return `${tokens[0] ?? ''}/msg/${tokens[1] ?? ''}`;
  const [package_name, kind] = within.split('/');
  // Inside a service or action, a bare name still means a message of the package.
  return kind === 'action' && /_(Goal|Result|Feedback)$/.test(type)
    ? `${package_name ?? ''}/action/${type}`
    : `${package_name ?? ''}/msg/${type}`;
}

/** Messages that ROS 2 makes out of `.srv` and `.action` files, as they appear on topics. */
function derivedDefinition(type: string, interfaces: Definitions): string | undefined {
  const match = /^(.+?)_(FeedbackMessage|(?:SendGoal|GetResult)_(?:Request|Response)|Goal|Result|Feedback|Request|Response|Event)$/.exec(type);
  if (match === null) return undefined;
  const [, base, kind] = match;
  const parts = interfaces.get(base ?? '')?.split(/^---[^\n]*$/m);
  if (parts === undefined) return undefined;
  const name = base?.split('/').at(-1) ?? '';
  switch (kind) {
    case 'FeedbackMessage':
      return `unique_identifier_msgs/UUID goal_id\n${name}_Feedback feedback`;
    case 'SendGoal_Request':
      return `unique_identifier_msgs/UUID goal_id\n${name}_Goal goal`;
    case 'SendGoal_Response':
      return 'bool accepted\nbuiltin_interfaces/Time stamp';
    case 'GetResult_Request':
      return 'unique_identifier_msgs/UUID goal_id';
    case 'GetResult_Response':
      return `int8 status\n${name}_Result result`;
    case 'Event':
      return `service_msgs/ServiceEventInfo info\n${base ?? ''}_Request[<=1] request\n${base ?? ''}_Response[<=1] response`;
    case 'Feedback':
      return parts[2];
    case 'Result':
    case 'Response':
      return parts[1];
    default:
      return parts[0];
  }
}

/** Splits a line into its type name and what follows (bounds, name, value); null when it declares nothing. */
function readField(line: string): { type: string; rest: string; } | null {
  const match = /^([A-Za-z][A-Za-z0-9_/]*)(.*)$/.exec(line.trim());
  return match === null ? null : { type: match[1] ?? '', rest: match[2] ?? '' };
}
