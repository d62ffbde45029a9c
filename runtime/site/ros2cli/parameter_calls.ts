// The parameter services of a node, asked by values: for the commands and for the page. A CommandError says why there is
// no answer.

import { callService, type Caller } from './calls.ts';
import { parameterValue, type ParameterValue } from './parameters.ts';
import { noteSet } from './set_parameters.ts';
import { yamlReader } from './yaml_reader.ts';

/** A node that is busy is not waited for without end. */
const timeoutMs = 10_000;

export interface SetResult {
  readonly successful: boolean;
  readonly reason: string;
}

export interface NumberRange<T> {
  readonly from_value: T;
  readonly to_value: T;
  /** 0: any. */
  readonly step: T;
}

/** As rcl_interfaces/msg/ParameterDescriptor. */
export interface Descriptor {
  readonly name: string;
  readonly type: number;
  readonly description: string;
  readonly additional_constraints: string;
  readonly read_only: boolean;
  readonly dynamic_typing: boolean;
  readonly floating_point_range: readonly NumberRange<number>[];
  readonly integer_range: readonly NumberRange<bigint>[];
}

async function ask(caller: Caller, of: string, service: string, type: string, request: unknown): Promise<Readonly<Record<string, unknown>>> {
  return await callService(caller, `${of}/${service}`, `rcl_interfaces/srv/${type}`, request, timeoutMs);
}

/** `of`: the node's full name. Sorted. */
export async function namesOf(caller: Caller, of: string): Promise<string[]> {
  const { result } = await ask(caller, of, 'list_parameters', 'ListParameters', {});
  return [...(result as { readonly names: readonly string[]; }).names].sort();
}

export async function valuesOf(caller: Caller, of: string, names: readonly string[]): Promise<readonly ParameterValue[]> {
  const { values } = await ask(caller, of, 'get_parameters', 'GetParameters', { names });
  return values as readonly ParameterValue[];
}

export async function descriptorsOf(caller: Caller, of: string, names: readonly string[]): Promise<readonly Descriptor[]> {
  const { descriptors } = await ask(caller, of, 'describe_parameters', 'DescribeParameters', { names });
  return descriptors as readonly Descriptor[];
}

/** One after the other; a result each. */
export async function setValues(
  caller: Caller,
  of: string,
  parameters: readonly { readonly name: string; readonly value: ParameterValue; }[],
): Promise<readonly SetResult[]> {
  const { results } = await ask(caller, of, 'set_parameters', 'SetParameters', { parameters });
  const told = results as readonly SetResult[];
  noteSet(caller.session, of, parameters.filter((_, at) => told[at]?.successful === true).map(({ name }) => name));
  return told;
}

export async function setValue(caller: Caller, of: string, name: string, value: ParameterValue): Promise<SetResult> {
  return (await setValues(caller, of, [{ name, value }]))[0] ?? { successful: false, reason: '' };
}

/** The parameter value that a typed text means. */
export async function textValue(text: string): Promise<ParameterValue> {
  const { readYaml } = await yamlReader();
  const read = readYaml(text);
  return parameterValue(text, read.kind === 'value' ? read.value : text);
}

/** Sets what a text means, as `ros2 param set`. */
export async function setText(caller: Caller, of: string, name: string, text: string): Promise<SetResult> {
  return await setValue(caller, of, name, await textValue(text));
}
