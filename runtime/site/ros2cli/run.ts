// Runs one command of `ros2` over a Session. Errors are printed; the result is the exit code.

import type { Codec } from '../decode/codec.ts';
import type { KeyMode, Session } from '../contract/session.ts';
import { reason } from './calls.ts';
import { CommandError, type Terminal } from './command.ts';
import { parseCommand } from './parse.ts';
import { commands } from './table.ts';

const wrongLine = 2;
const interrupted = 130;

/** Types are parsed once per session. */
const codecs = new WeakMap<Session, Promise<Codec>>();

async function loadCodec(session: Session): Promise<Codec> {
  const [{ createCodec }, interfaces] = await Promise.all([import('../decode/codec.ts'), session.interfaces()]);
  return createCodec(interfaces);
}

/** The session's, loaded at the first call. */
export async function codecOf(session: Session): Promise<Codec> {
  let codec = codecs.get(session);
  if (codec === undefined) {
    codec = loadCodec(session);
    codecs.set(session, codec);
    codec.catch(() => codecs.delete(session));
  }
  return await codec;
}

/** `words` begin after `ros2`. Rejects never. */
export async function runCommand(session: Session, words: readonly string[], terminal: Terminal): Promise<number> {
  const parsed = parseCommand(commands, words);
  switch (parsed.kind) {
    case 'help':
      terminal.print(parsed.text);
      return 0;
    case 'wrong':
      terminal.warn(parsed.text);
      return wrongLine;
    case 'run':
      break;
  }
  const { command, given } = parsed;
  const context = {
    session,
    signal: terminal.signal,
    bags: terminal.bags,
    ...(terminal.newFiles === undefined ? {} : { newFiles: terminal.newFiles }),
    readText: (name: string) => terminal.readText(name),
    takeInput: (taker: ((text: string) => void) | undefined, keys?: KeyMode) => terminal.takeInput(taker, keys),
    print: (text: string) => terminal.print(text),
    warn: (text: string) => terminal.warn(text),
    codec: () => codecOf(session),
  };
  try {
    const code = await command.run(context, given);
    return terminal.signal.aborted && code === 0 && command.words[1] === 'pub' ? interrupted : code;
  } catch (error) {
    if (terminal.signal.aborted) return interrupted;
    terminal.warn(error instanceof CommandError ? error.message : reason(error));
    return 1;
  }
}
