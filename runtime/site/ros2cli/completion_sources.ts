// The requests of completion: a node's parameters, a type's message to begin with.

import { draftOf, TooLarge } from '../decode/draft.ts';
import { inFlow } from '../decode/flow_yaml.ts';
import type { Session } from '../contract/session.ts';
import type { Wanted } from './complete.ts';
import { namesOf } from './parameter_calls.ts';
import { codecOf } from './run.ts';

/** Upper bound in ms on how long completion waits for a node. */
const timeoutMs = 2000;

/** Empty when nobody answers, or there is no such type. */
export async function tellWanted(session: Session, wanted: Wanted): Promise<readonly string[]> {
  try {
    if (wanted.kind === 'parameters') {
      return await namesOf({ session, codec: () => codecOf(session), signal: AbortSignal.timeout(timeoutMs) }, wanted.node);
    }
    const parsed = (await codecOf(session)).types.get(wanted.type);
    if (typeof parsed === 'string') return [];
    const fields = Object.entries(draftOf(parsed.shape)).map(([name, value]) =>
      `${name}: ${inFlow(value, parsed.shape.find((field) => field.name === name), null)}`
    );
    const text = `{${fields.join(', ')}}`;
    // For a shell: where double quotes would mean something, a quote in the text is closed, said and opened again.
    return [/["$`\\]/.test(text) ? `'${text.replaceAll("'", "'\\''")}'` : `"${text}"`];
  } catch (error) {
    if (error instanceof TooLarge || error instanceof Error) return [];
    throw error;
  }
}
