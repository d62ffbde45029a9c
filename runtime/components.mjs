// The components of the files that go into every site: ros2wasm's own code and npm packages, with versions and licenses. For
// the list of components and the license texts of a site.

import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

const bundled = new Set();

/** Notes the packages whose files are in what esbuild has written. */
export function takeInputs(metafile) {
  for (const output of Object.values(metafile.outputs)) {
    for (const [path, { bytesInOutput }] of Object.entries(output.inputs)) {
      const name = /(?:^|\/)node_modules\/((?:@[^/]+\/)?[^/]+)\/(?!.*\/node_modules\/)/.exec(path)?.[1];
      if (name !== undefined && bytesInOutput > 0) bundled.add(name);
    }
  }
}

/** Those, sorted, behind ros2wasm itself: `name`, `version`, `license` (SPDX), `texts` of license files. */
export function components(root) {
  const own = {
    name: 'ros2wasm',
    type: 'generic',
    version: readFileSync(join(root, 'VERSION'), 'utf8').trim(),
    license: JSON.parse(readFileSync(join(root, 'package.json'), 'utf8')).license,
    texts: [readFileSync(join(root, 'LICENSE'), 'utf8')],
  };
  const others = [...bundled].sort().map((name) => {
    const folder = join(root, 'node_modules', name);
    const { version, license } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
    const files = readdirSync(folder).filter((file) => /^(licen[cs]e|copying|notice)(\.|$)/i.test(file)).sort();
    if (typeof license !== 'string') throw new Error(`${name} does not say its license`);
    return { name, type: 'npm', version, license, texts: files.map((file) => readFileSync(join(folder, file), 'utf8')) };
  });
  return [own, ...others];
}
