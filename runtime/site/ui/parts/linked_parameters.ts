// Parameters in a link: `{"/robot": {"speed": [3, "1.5"]}}`, each with its type as in rcl_interfaces/msg/ParameterType
// and its text. Loaded when a link has some, or some were set.

import type { Session } from '../../contract/session.ts';
import { readYaml } from '../../decode/read_yaml.ts';
import type { Caller } from '../../ros2cli/calls.ts';
import { setValue, valuesOf } from '../../ros2cli/parameter_calls.ts';
import { setParameters } from '../../ros2cli/set_parameters.ts';
import { isRecord } from '../model/json.ts';
import { parameterText, readParameter } from '../model/parameter_text.ts';
import { problemOf } from '../model/problem.ts';
import { codecOf } from './message_feed.ts';

const MOST_TEXT = 16_384;
const MOST_PARAMETERS = 256;
/** A node that does not answer keeps nobody from a link. */
const ANSWER_MS = 1500;
/** rcl_interfaces/msg/ParameterType: their text is cut. */
const BYTES = 5;

export interface LinkedParameter {
  readonly node: string;
  readonly name: string;
  readonly type: number;
  readonly text: string;
}

/** Invalid entries are skipped. */
export function readLinkedParameters(text: string): readonly LinkedParameter[] {
  let nodes: unknown;
  try {
    nodes = text.length > MOST_TEXT ? null : JSON.parse(text);
  } catch {
    return [];
  }
  if (!isRecord(nodes)) return [];
  const found: LinkedParameter[] = [];
  for (const [node, parameters] of Object.entries(nodes)) {
    if (!/^(\/[A-Za-z_]\w*)+$/.test(node) || !isRecord(parameters)) continue;
    for (const [name, pair] of Object.entries(parameters)) {
      const [type, value] = Array.isArray(pair) ? (pair as readonly unknown[]) : [];
      if (typeof type === 'number' && typeof value === 'string' && name !== '') found.push({ node, name, type, text: value });
    }
  }
  return found.slice(0, MOST_PARAMETERS);
}

/** The present values of all that was set, for a link; null when nothing was. */
export async function linkedParameters(session: Session): Promise<string | null> {
  const nodes = await Promise.all(
    [...setParameters(session)].map(async ([node, set]): Promise<readonly [string, unknown]> => {
      const names = [...set].sort();
      const caller: Caller = { session, codec: () => codecOf(session), signal: AbortSignal.timeout(ANSWER_MS) };
      // A node that has gone has no values.
      const values = await valuesOf(caller, node, names).catch(() => []);
      return [node, Object.fromEntries(names.flatMap((name, at) => {
        const value = values[at];
        const type = Number(value?.['type'] ?? 0);
        return value === undefined || type === 0 || type === BYTES ? [] : [[name, [type, parameterText(value)]]];
      }))];
    }),
  );
  const told = nodes.filter(([, parameters]) => Object.keys(parameters as object).length > 0);
  return told.length === 0 ? null : JSON.stringify(Object.fromEntries(told));
}

/** Sets them as their nodes come; `refused` is told what a node does not take. Returns what ends it. */
export function applyParameters(
  session: Session,
  all: readonly LinkedParameter[],
  refused: (parameter: LinkedParameter, reason: string) => void,
): () => void {
  const abort = new AbortController();
  const caller: Caller = { session, codec: () => codecOf(session), signal: abort.signal };
  const waiting = new Map(Map.groupBy(all, ({ node }) => node));
  const set = async (parameter: LinkedParameter): Promise<void> => {
    const read = readParameter(parameter.text, parameter.type, readYaml);
    if (read.kind === 'failed') throw new Error(read.reason);
    const result = await setValue(caller, parameter.node, parameter.name, read.value);
    if (!result.successful) refused(parameter, result.reason);
  };
  const look = (): void => {
    for (const { name, services } of session.graph().nodes) {
      const own = waiting.get(name);
      if (own === undefined || !services.some((service) => service.name === `${name}/set_parameters`)) continue;
      waiting.delete(name);
      void (async () => {
        for (const parameter of own)
          await set(parameter).catch((error: unknown) => {
            if (!abort.signal.aborted) refused(parameter, problemOf(error).what);
          });
      })();
    }
  };
  const stop = session.onGraph(look);
  look();
  return () => {
    stop();
    abort.abort();
  };
}
