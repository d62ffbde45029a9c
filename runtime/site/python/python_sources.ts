// The sources of the workspace in a running interpreter: those that the visitor changed are put over the packed ones,
// and of all of them is told when the program reads one.

import type { PyodideInterface } from 'pyodide';
import { prefix } from './python_image.ts';
import type { SourceStart } from '../contract/site_sources.ts';

/** A file of Emscripten's file system in memory. */
interface FileNode {
  contents: Uint8Array | null;
}

interface FileSystem {
  readonly mkdirTree: (path: string) => void;
  readonly writeFile: (path: string, bytes: Uint8Array) => void;
  readonly analyzePath: (path: string) => { readonly object: FileNode | null; };
}

/** `read`: called once for each, the first time. */
export function placeSources(python: PyodideInterface, { watched, changed }: SourceStart, read: (path: string) => void): void {
  const system = python['FS'] as unknown as FileSystem;
  for (const [path, text] of changed) {
    const whole = `${prefix}/${path}`;
    system.mkdirTree(whole.slice(0, whole.lastIndexOf('/')));
    system.writeFile(whole, new TextEncoder().encode(text));
  }
  for (const path of watched) {
    const node = system.analyzePath(`${prefix}/${path}`).object;
    if (node !== null) watch(node, () => read(path));
  }
}

/** Its bytes are a plain property again once they were read or written. */
function watch(node: FileNode, read: () => void): void {
  const bytes = node.contents;
  const settle = (value: Uint8Array | null): void => {
    Object.defineProperty(node, 'contents', { value, writable: true, enumerable: true, configurable: true });
  };
  Object.defineProperty(node, 'contents', {
    configurable: true,
    enumerable: true,
    get: () => {
      settle(bytes);
      read();
      return bytes;
    },
    set: settle,
  });
}
