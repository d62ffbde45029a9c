// The door for another language: the page's texts are chosen when it is built. Each file of runtime/site/ui whose name begins
// with `texts` is taken from the folder of a translation instead, when that has one of the same name.

import { existsSync } from 'node:fs';
import { basename, join, resolve } from 'node:path';
import type { Plugin } from 'esbuild';

/** A plugin of esbuild. `folder`: named by its language, as `de`. */
export function otherTexts(folder: string): Plugin {
  return {
    name: 'other-texts',
    setup(esbuild) {
      esbuild.onResolve({ filter: /\/texts(_\w+)?\.ts$/ }, ({ path }) => {
        const file = join(resolve(folder), basename(path));
        return existsSync(file) ? { path: file } : undefined;
      });
    },
  };
}

export function languageOf(folder: string): string {
  return basename(resolve(folder));
}
