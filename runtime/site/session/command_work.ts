// Runs a command of `ros2` that the launch file starts, to its end. Loaded by sites that have some.

import type { Broker } from '../bus/broker.ts';
import type { ComingUp } from './coming_up.ts';
import type { CommandLoader, NodeState, RunningCommand, Session } from '../contract/session.ts';

/** On message ports the graph comes in bit by bit. */
const discoveryMs = 200;
/** Exit code of one that Ctrl-C keeps from its work. */
const interruptedCode = 130;

/** The place in which commands run. */
export interface CommandPlace extends Pick<RunningCommand, 'file'> {
  readonly session: Session;
  readonly load: CommandLoader;
  readonly comingUp: ComingUp;
}

interface CommandWork extends CommandPlace {
  readonly run: Awaited<ReturnType<CommandLoader>>;
  readonly words: readonly string[];
  readonly broker: Broker;
  readonly signal: AbortSignal;
  readonly say: (stream: 1 | 2, text: string) => void;
}

/** How it ends. */
export async function workOf({ session, file, comingUp, run, words, broker, signal, say }: CommandWork): Promise<NodeState> {
  // In a stepped run no time passes while a file comes.
  const holding = async (path: string): Promise<ArrayBuffer> => {
    const goOn = broker.conductor?.hold();
    try {
      return await file(path);
    } finally {
      goOn?.();
    }
  };
  try {
    if (broker.conductor === undefined) await comingUp.none(signal);
    if (broker.kind === 'port') await pause(discoveryMs);
    const code = signal.aborted
      ? interruptedCode
      : await run({ session, words, print: (text) => say(1, text), warn: (text) => say(2, text), file: holding, signal });
    return { kind: 'exited', code };
  } catch (error) {
    return { kind: 'crashed', code: 'R2W0708', message: error instanceof Error ? error.message : String(error) };
  }
}

function pause(ms: number): Promise<void> {
  return new Promise((resolve) => {
    setTimeout(resolve, ms);
  });
}
