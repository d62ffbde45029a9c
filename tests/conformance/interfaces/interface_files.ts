// Finds the interface definitions of runtime/packages/interfaces.
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

const SHIPPED = join(REPOSITORY, 'runtime/packages/interfaces');

/** All definitions of the packages in a folder, sorted by type; of those we ship, unless told others. */
export function interfaceFiles(root: string = SHIPPED, packages: readonly string[] = entries(root)): InterfaceFile[] {
  const found: InterfaceFile[] = [];
  for (const pkg of packages) {
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
