// One line of a node's console, made ready for showing: its ROS 2 log parts, its level, its colours.
// Pure; the text is kept exactly as the node printed it, apart from control characters.

import type { ConsoleLine } from '../../contract/session.ts';
import { texts } from '../texts.ts';
import { parseAnsi } from './ansi.ts';
import type { Span } from './ansi.ts';

export type Level = 'DEBUG' | 'INFO' | 'WARN' | 'ERROR' | 'FATAL';

export const LEVELS: readonly Level[] = ['DEBUG', 'INFO', 'WARN', 'ERROR', 'FATAL'];

/** The default format of rcutils: [LEVEL] [seconds.nanoseconds] [logger]: message */
export interface LogParts {
  readonly level: Level;
  /** With its brackets, as printed. */
  readonly stamp: string;
  readonly logger: string;
  readonly message: string;
}

export interface DisplayLine {
  /** Unique and growing within one list. */
  readonly key: number;
  /** Milliseconds since 1970. */
  readonly time: number;
  /** `[talker-1] ` in a merged console, as `ros2 launch` prints it; else empty. */
  readonly prefix: string;
  /** The line without escape sequences, at most MAX_SHOWN characters. */
  readonly plain: string;
  readonly level: Level | null;
  /** Set when the line is a ROS 2 log line without colours of its own. */
  readonly parts: LogParts | null;
  /** Set when the line brings its own colours. */
  readonly spans: readonly Span[] | null;
  /** Every character is one column wide. */
  readonly simple: boolean;
}

/** Longer lines are cut for showing; "copy" gives them whole. */
export const MAX_SHOWN = 8192;

const PATTERN = /^\[(DEBUG|INFO|WARN|ERROR|FATAL)\] (\[\d{1,20}\.\d{1,12}\]) (\[[^\]]{0,512}\]): (.*)$/s;

export function parseLogParts(plain: string): LogParts | null {
  const match = PATTERN.exec(plain);
  if (match === null) {
    return null;
  }
  const [, level, stamp, logger, message] = match;
  return {
    level: level as Level,
    stamp: stamp ?? '',
    logger: logger ?? '',
    message: message ?? '',
  };
}

export function displayLine(line: ConsoleLine, key: number, prefix: string): DisplayLine {
  const raw = expandTabs(lastOverwrite(line.text));
  const cut = raw.length > MAX_SHOWN
    ? `${raw.slice(0, MAX_SHOWN)}\u2026 ${texts.moreCharacters(raw.length - MAX_SHOWN)}`
    : raw;
  const spans = parseAnsi(cut);
  const plain = spans.length === 1 ? (spans[0]?.text ?? '') : spans.map((span) => span.text).join('');
  const coloured = spans.some(
    (span) => span.style.foreground !== null || span.style.background !== null || span.style.bold,
  );
  const parts = parseLogParts(plain);
  return {
    key,
    time: line.time,
    prefix,
    plain,
    level: parts?.level ?? line.level ?? null,
    parts: coloured ? null : parts,
    spans: coloured || parts === null ? spans : null,
    simple: /^[\x20-\x7e]*$/.test(plain) && /^[\x20-\x7e]*$/.test(prefix),
  };
}

/** Columns by which the second and later rows of a line are set in. */
export const HANG = 2;

/**
 * How many rows of `columns` characters the line takes, wrapped at spaces like the style sheet does it.
 * Wide characters count twice. Where a browser breaks elsewhere, the view corrects it after drawing.
 */
export function rowsOf(line: DisplayLine, columns: number): number {
  const text = line.prefix + line.plain;
  if (line.simple && text.length <= columns) return 1;
  const later = Math.max(1, columns - HANG);
  let rows = 1;
  let room = Math.max(1, columns);
  for (const word of text.split(/(?<= )(?=[^ ])/)) {
    // Spaces at the end of a row hang over and take no room.
    const solid = line.simple ? word.trimEnd().length : widthOf(word.trimEnd());
    if (solid > room) {
      const fresh = room === (rows === 1 ? columns : later);
      if (!fresh) {
        rows += 1;
        room = later;
      }
      const more = solid <= room ? 0 : Math.ceil((solid - room) / later);
      rows += more;
      room = more === 0 ? room - solid : more * later + room - solid;
    } else {
      room -= solid;
    }
    room -= Math.min(room, word.length - word.trimEnd().length);
  }
  return rows;
}

/** Whether its rows are only reckoned, not certain: it may not fit one row. */
export function mayWrap(line: DisplayLine, columns: number): boolean {
  return !line.simple || line.prefix.length + line.plain.length > columns;
}

/** A carriage return starts the line again, as progress bars use it. */
function lastOverwrite(text: string): string {
  const trimmed = text.endsWith('\r') ? text.slice(0, -1) : text;
  const at = trimmed.lastIndexOf('\r');
  return at < 0 ? trimmed : trimmed.slice(at + 1);
}

function expandTabs(text: string): string {
  if (!text.includes('\t')) {
    return text;
  }
  let out = '';
  for (const character of text.slice(0, MAX_SHOWN * 2)) {
    out += character === '\t' ? ' '.repeat(8 - (out.length % 8)) : character;
  }
  return out;
}

function widthOf(text: string): number {
  let width = 0;
  for (const character of text) {
    const code = character.codePointAt(0) ?? 0;
    const wide = (code >= 0x1100 && code <= 0x115f)
      || (code >= 0x2e80 && code <= 0xa4cf)
      || (code >= 0xac00 && code <= 0xd7a3)
      || (code >= 0xf900 && code <= 0xfaff)
      || (code >= 0xfe30 && code <= 0xfe6f)
      || (code >= 0xff00 && code <= 0xff60)
      || (code >= 0x1f300 && code <= 0x1faff)
      || (code >= 0x20000 && code <= 0x3fffd);
    width += wide ? 2 : 1;
  }
  return width;
}
