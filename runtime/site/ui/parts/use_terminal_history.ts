// The lines that were typed in terminals of this site: of this one, and for the ones that are opened later.

import { useRef } from 'preact/hooks';
import { readText, writePreference } from '../model/preferences.ts';
import type { Store } from '../model/preferences.ts';
import { readHistory } from '../model/terminal_input.ts';

const MOST_HISTORY = 200;

export interface TerminalHistory {
  lines(): readonly string[];
  add(typed: string): void;
  /** The line that many steps from the one that was recalled last; empty behind the newest. */
  recall(step: -1 | 1): string;
  forget(): void;
}

class History implements TerminalHistory {
  private readonly store: Store | null;
  // The name has the path of this site: other sites may be on the same host.
  private readonly name = `terminal.${new URL('.', document.baseURI).pathname}`;
  private known: string[];
  private at: number;

  constructor(store: Store | null) {
    this.store = store;
    this.known = this.stored();
    this.at = this.known.length;
  }

  private stored(): string[] {
    return readHistory(readText(this.store, this.name), MOST_HISTORY);
  }

  lines(): readonly string[] {
    return this.known;
  }

  add(typed: string): void {
    this.known = withLine(this.known, typed);
    this.at = this.known.length;
    // Other terminals may have typed meanwhile.
    writePreference(this.store, this.name, JSON.stringify(withLine(this.stored(), typed)));
  }

  recall(step: -1 | 1): string {
    this.at = Math.max(0, Math.min(this.known.length, this.at + step));
    return this.known[this.at] ?? '';
  }

  forget(): void {
    this.known = [];
    this.at = 0;
    writePreference(this.store, this.name, '[]');
  }
}

function withLine(lines: readonly string[], typed: string): string[] {
  return (lines.at(-1) === typed ? [...lines] : [...lines, typed]).slice(-MOST_HISTORY);
}

export function useTerminalHistory(store: Store | null): TerminalHistory {
  const history = useRef<TerminalHistory | null>(null);
  history.current ??= new History(store);
  return history.current;
}
