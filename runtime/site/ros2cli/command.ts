// The type of a command of `ros2`, and the things that it may use: a Session, a place to print, a signal for Ctrl-C.

import type { BagSource } from '../bag/bag_file.ts';
import type { BagSink } from '../bag/bag_writer.ts';
import type { Codec } from '../decode/codec.ts';
import type { KeyMode, Session } from '../contract/session.ts';

/** Where bags are, by name: the files of a shell, or what a page keeps. */
export interface BagPlace {
  /** undefined: there is none of that name. */
  open(name: string): Promise<BagSource | undefined>;
  /** undefined: there is one already. */
  create(name: string): Promise<BagOutput | undefined>;
}

export interface BagOutput extends BagSink {
  /** All is written. */
  end(): void;
}

/** Where a command makes files. Names are as they were typed. */
export interface NewFiles {
  /** The absolute path. */
  whole(name: string): string;
  exists(name: string): boolean;
  /** Makes the folders above it too. False: there is not enough room, or the place cannot be written to. */
  write(name: string, text: string): boolean;
}

export interface Terminal {
  readonly bags: BagPlace;
  /** undefined: commands make no files but bags here. */
  readonly newFiles?: NewFiles;
  /** The text of a file; undefined: there is none of that name. */
  readText(name: string): Promise<string | undefined>;
  /** Sends typed input to `taker` from now on, line by line with the newlines, or key by key; undefined: to nobody. */
  takeInput(taker: ((text: string) => void) | undefined, keys?: KeyMode): void;
  /** One line or several, without the newline at the end. */
  print(text: string): void;
  /** The same, for what is not a result. */
  warn(text: string): void;
  /** Ctrl-C. */
  readonly signal: AbortSignal;
}

/** The kind of thing that a word of the command line names; completion offers these. */
export type Meaning =
  | 'topic'
  | 'node'
  | 'service'
  | 'action'
  | 'message_type'
  | 'service_type'
  | 'action_type'
  | 'interface'
  | 'package'
  | 'parameter'
  | 'transition'
  | 'program_package'
  | 'executable'
  | 'container'
  | 'launch_package'
  | 'launch_file'
  | 'launch_argument'
  | 'message_values'
  | 'service_values'
  | 'goal_values'
  | 'text';

export interface Positional {
  /** As the usage shows it. */
  readonly name: string;
  readonly meaning: Meaning;
  /** May be omitted. */
  readonly optional?: boolean;
  /** The last one, any number of times. */
  readonly many?: boolean;
  /** The last one, all words behind the others, as they are. */
  readonly rest?: boolean;
}

export interface Option {
  /** `--once`, `-1`: the long one first. */
  readonly names: readonly string[];
  /** The name of its value in the usage; undefined: it takes none. */
  readonly value?: string;
  /** Takes all words up to the next option; Given has them with spaces between. */
  readonly many?: boolean;
  /** May be given several times; Given has the values with line breaks between. */
  readonly repeated?: boolean;
  /** The value when it is given without one. */
  readonly alone?: string;
  /** The values that it may have. */
  readonly choices?: readonly string[];
  /** Is the value a number? */
  readonly number?: boolean;
  readonly help: string;
}

/** The parsed arguments; options by their first name without dashes. */
export interface Given {
  readonly positionals: readonly string[];
  readonly options: ReadonlyMap<string, string>;
}

export interface Context extends Terminal {
  readonly session: Session;
  /** Loaded when first asked for. */
  codec(): Promise<Codec>;
}

export interface Command {
  /** `topic`, `echo`. */
  readonly words: readonly [string, string] | readonly [string];
  readonly help: string;
  readonly positionals: readonly Positional[];
  readonly options: readonly Option[];
  /** From a shell it runs without the site's own nodes: it starts them. */
  readonly startsNodes?: boolean;
  /** The exit code. A CommandError is printed, and makes it 1. */
  run(context: Context, given: Given): Promise<number>;
}

/** An error message that the user gets instead of a result. */
export class CommandError extends Error {}

export function has(given: Given, option: string): boolean {
  return given.options.has(option);
}

/** The values of an option that may be given several times. */
export function allOf(given: Given, option: string): readonly string[] {
  return given.options.get(option)?.split('\n') ?? [];
}

/** The value of an option that takes a number; the parser has checked it. */
export function numberOf(given: Given, option: string, otherwise: number): number {
  const text = given.options.get(option);
  return text === undefined ? otherwise : Number(text);
}

/** Resolves at Ctrl-C, or when `done` is called; `begin` returns what is to be closed then. */
export function untilDone(signal: AbortSignal, begin: (done: () => void) => readonly { close(): void; }[]): Promise<void> {
  return new Promise((resolve) => {
    let ended = false;
    let open: readonly { close(): void; }[] = [];
    const done = (): void => {
      ended = true;
      signal.removeEventListener('abort', done);
      for (const each of open) each.close();
      resolve();
    };
    open = begin(done);
    if (ended || signal.aborted) {
      for (const each of open) each.close();
      resolve();
    } else {
      signal.addEventListener('abort', done, { once: true });
    }
  });
}
