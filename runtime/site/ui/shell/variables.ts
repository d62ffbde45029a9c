// The variables of one terminal.

import type { Session } from '../../contract/session.ts';
import { HOME } from './paths.ts';

export function isName(text: string): boolean {
  return /^[A-Za-z_]\w*$/.test(text);
}

/** `NAME=value` */
export function assignment(word: string): boolean {
  return /^[A-Za-z_]\w*=/.test(word);
}

export class Variables {
  private readonly values: Map<string, string>;

  /** They begin as a node's do. */
  constructor({ site, prefix }: Session) {
    this.values = new Map([
      ['AMENT_PREFIX_PATH', prefix],
      ['HOME', HOME],
      ['OLDPWD', HOME],
      ['PWD', HOME],
      ['ROS_DISTRO', site.distro],
      ['ROS_PYTHON_VERSION', '3'],
      ['ROS_VERSION', '2'],
      ['SHELL', '/bin/bash'],
      ['USER', 'user'],
    ]);
  }

  /** Empty where there is none of that name. */
  value(name: string): string {
    return this.values.get(name) ?? '';
  }

  moved(to: string, from: string): void {
    this.values.set('PWD', to).set('OLDPWD', from);
  }

  unset(name: string): void {
    this.values.delete(name);
  }

  /** Sets what begins a line of words; gives the rest. */
  take(words: readonly string[]): readonly string[] {
    const end = words.findIndex((word) => !assignment(word));
    for (const word of words.slice(0, end < 0 ? words.length : end)) {
      const cut = word.indexOf('=');
      this.values.set(word.slice(0, cut), word.slice(cut + 1));
    }
    return end < 0 ? [] : words.slice(end);
  }

  /** All with their names, or the values of some; the exit code. */
  print(names: readonly string[], out: (text: string) => void): number {
    if (names.length === 0) { for (const [name, value] of [...this.values].sort(([a], [b]) => (a < b ? -1 : 1))) out(`${name}=${value}`); }
    const known = names.filter((name) => this.values.has(name));
    for (const name of known) out(this.value(name));
    return known.length === names.length ? 0 : 1;
  }
}
