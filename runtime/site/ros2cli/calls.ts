// Calls of services by values, for the commands: what is asked and answered, made and read.

import type { SiteError } from '../contract/site_error.ts';
import { CommandError, type Context } from './command.ts';
import { decoded } from './filled_message.ts';

/** The caller of a service: a command, or a panel of the page. */
export type Caller = Pick<Context, 'session' | 'codec' | 'signal'>;

/** Calls once; a CommandError says why there is no answer. `request`: fields; bytes are taken as they are. */
export async function callService(
  context: Caller,
  name: string,
  type: string,
  request: unknown,
  timeoutMs = Infinity,
): Promise<Readonly<Record<string, unknown>>> {
  const codec = await context.codec();
  let bytes: Uint8Array;
  if (request instanceof Uint8Array) {
    bytes = request;
  } else {
    const encoded = codec.encode(`${type}_Request`, request);
    if (encoded.kind === 'failed') throw new CommandError(`${encoded.path}: ${encoded.reason}`);
    ({ bytes } = encoded);
  }
  const client = context.session.node().client(name, type);
  try {
    const reply = await client.call(bytes, { timeoutMs, signal: context.signal });
    return (await decoded(context, `${type}_Response`, reply)).value;
  } catch (error) {
    throw error instanceof CommandError ? error : new CommandError(reason(error));
  } finally {
    client.close();
  }
}

export function reason(error: unknown): string {
  const { message, code } = error as Partial<SiteError>;
  return code === undefined ? (message ?? String(error)) : `${message ?? ''} (${code})`;
}
