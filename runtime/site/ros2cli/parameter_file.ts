// A file of parameters as `ros2 param load` takes it: of one node, by its full name, and of `/**` when asked for.

import { readYaml } from '../decode/read_yaml.ts';
import { formatScalar, isMessage } from '../decode/yaml.ts';
import { CommandError } from './command.ts';
import { parameterValue, type ParameterValue } from './parameters.ts';

const everyNode = '/**';
const deepest = 32;

export interface FileParameter {
  /** With dots between its parts. */
  readonly name: string;
  readonly value: ParameterValue;
}

/** In the order of the file, each name once: the node's own are the ones that count. Throws a CommandError. */
export function parametersOfFile(text: string, node: string, wildcard: boolean): FileParameter[] {
  const read = readYaml(text);
  if (read.kind === 'failed') throw new CommandError(read.reason);
  const nodes = read.value;
  if (!isMessage(nodes)) throw new CommandError('The file has no parameters: node names with `ros__parameters` below them are wanted');
  // A name without its slash is one of the root namespace.
  const own = Object.keys(nodes).filter((key) => key === node || `/${key}` === node);
  const keys = [...(wildcard && everyNode in nodes ? [everyNode] : []), ...own];
  if (keys.length === 0) {
    throw new CommandError(`Param file does not contain parameters for ${node}, only for nodes: ${Object.keys(nodes).join(', ')}`);
  }
  const found = new Map<string, ParameterValue>();
  for (const key of keys) {
    const parameters = isMessage(nodes[key]) ? nodes[key]['ros__parameters'] : undefined;
    if (!isMessage(parameters)) {
      throw new CommandError(`Invalid structure of parameter file for node ${key}, expected same format as provided by ros2 param dump`);
    }
    collect(parameters, '', found, 0);
  }
  return [...found].map(([name, value]) => ({ name, value }));
}

function collect(tree: Readonly<Record<string, unknown>>, before: string, found: Map<string, ParameterValue>, depth: number): void {
  if (depth > deepest) throw new CommandError(`Parameters are nested deeper than ${deepest} times`);
  for (const [key, value] of Object.entries(tree)) {
    if (isMessage(value)) collect(value, `${before}${key}.`, found, depth + 1);
    else found.set(`${before}${key}`, parameterValue(typeof value === 'string' ? value : formatScalar(value, null, ''), value));
  }
}
