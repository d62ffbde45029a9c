// Name rules of ROS 2 for the page and its commands: full names, hidden names, names of types. Pure.
// The same rules and words as wasm_cpp's names.cpp.

/** `place` counts from 0. */
export interface NameProblem {
  readonly what: string;
  readonly place: number;
}

const longestTopic = 247;

/** The problem of a fully qualified name of a topic, service or action; undefined: the name is valid. */
export function checkFullName(name: string): NameProblem | undefined {
  const found = (what: string, place: number): NameProblem => ({ what: `topic name ${what}`, place });
  if (name === '') return found('must not be empty string', 0);
  if (!name.startsWith('/')) return found("must be absolute, it must lead with a '/'", 0);
  if (name.endsWith('/')) return found("must not end with a '/'", name.length - 1);
  const strange = name.search(/[^A-Za-z0-9_/]/);
  if (strange >= 0) return found("must not contain characters other than alphanumerics, '_', or '/'", strange);
  const repeated = name.indexOf('//');
  if (repeated >= 0) return found("must not contain repeated '/'", repeated + 1);
  const numeric = name.search(/\/[0-9]/);
  if (numeric >= 0) return found('must not have a token that starts with a number', numeric + 1);
  if (name.length > longestTopic) return { what: `topic length should not exceed '${longestTopic}'`, place: longestTopic };
  return undefined;
}

/** The full name that a participant called `node` of namespace `namespace` means by `name`: `~` and relative names too. */
export function expandName(name: string, node: string, namespace = '/'): string {
  if (name.startsWith('~')) return `${joinName(namespace, node)}${name.slice(1)}`;
  return name.startsWith('/') ? name : joinName(namespace, name);
}

export function joinName(namespace: string, name: string): string {
  return namespace.endsWith('/') ? `${namespace}${name}` : `${namespace}/${name}`;
}

/** ROS 2 hides names with a token that starts with `_`. */
export function isHiddenName(name: string): boolean {
  return name.split('/').some((token) => token.startsWith('_'));
}

/** `std_msgs/String` and `std_msgs/msg/String` mean the same; undefined: that is not a name of a type. */
export function fullTypeName(name: string, kind: 'msg' | 'srv' | 'action' = 'msg'): string | undefined {
  const tokens = name.split('/');
  if (!tokens.every((token) => /^[A-Za-z][A-Za-z0-9_]*$/.test(token))) return undefined;
  if (tokens.length === 2) return `${tokens[0]}/${kind}/${tokens[1]}`;
  return tokens.length === 3 && ['msg', 'srv', 'action'].includes(tokens[1]!) ? name : undefined;
}

export interface NodeName {
  readonly namespace: string;
  readonly name: string;
}

/** `/a/b/node` -> `/a/b` and `node`. */
export function splitNodeName(full: string): NodeName {
  const cut = full.lastIndexOf('/');
  return { namespace: cut <= 0 ? '/' : full.slice(0, cut), name: full.slice(cut + 1) };
}
