// Finds the interface definitions of runtime/interfaces.
import { readFileSync, readdirSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

import type { InterfaceKind } from './definition_parser.ts';

export const REPOSITORY = join(dirname(fileURLToPath(import.meta.url)), '..', '..', '..');

export interface InterfaceFile {
  /** "std_msgs/msg/String" */
  readonly type: string;
  readonly package: string;
  readonly kind: InterfaceKind;
  readonly name: string;
  readonly text: string;
}

const KINDS: readonly InterfaceKind[] = ['msg', 'srv', 'action'];

function entries(folder: string): string[] {
  try {
    return readdirSync(folder).sort();
  } catch {
    return [];
  }
}

/** All definitions, sorted by type. */
export function interfaceFiles(): InterfaceFile[] {
  const root = join(REPOSITORY, 'runtime', 'interfaces');
  const found: InterfaceFile[] = [];
  for (const pkg of entries(root)) {
    for (const kind of KINDS) {
      for (const file of entries(join(root, pkg, kind))) {
        if (!file.endsWith(`.${kind}`)) throw new Error(`${pkg}/${kind}/${file} does not belong there`);
        const name = file.slice(0, -kind.length - 1);
        const text = readFileSync(join(root, pkg, kind, file), 'utf8');
        found.push({ type: `${pkg}/${kind}/${name}`, package: pkg, kind, name, text });
      }
    }
  }
  return found.sort((a, b) => (a.type < b.type ? -1 : 1));
}
