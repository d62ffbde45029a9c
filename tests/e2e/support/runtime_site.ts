// A site made of the loader's small test programs and the real runtime files.

import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { copyFileSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { buildProgram } from '../../unit/site/programs.ts';
import type { SiteSources } from '../../../runtime/site/contract/site_sources.ts';
import { addNumpy, addPythonFiles, describePython, type PythonNode } from '../../support/python_nodes.ts';
import { splitNames } from '../../unit/site/site_fixture.ts';

const root = fileURLToPath(new URL('../../..', import.meta.url));

export interface TestNode {
  /** File in tests/unit/site/programs. */
  readonly program: string;
  readonly threads?: boolean;
  readonly respawn?: boolean;
}

export interface PythonPart {
  readonly nodes: readonly PythonNode[];
  /** Folder -> place in the installation. */
  readonly packages: Readonly<Record<string, string>>;
  /** Those of them that the page shows. */
  readonly sources?: SiteSources['files'];
}

/** A temporary folder with a whole site. `more`: further files; `ui`: as in the manifest; `texts`: of another language. */
export function makeSite(
  nodes: readonly TestNode[],
  more: Readonly<Record<string, string>> = {},
  ui: Readonly<Record<string, unknown>> = {},
  python?: PythonPart,
  texts?: string,
): string {
  const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-site-'));
  const assets = join(folder, 'assets');
  execFileSync(process.execPath, [join(root, 'runtime/build.mjs'), '--out', assets, ...(texts === undefined ? [] : ['--texts', texts])]);
  for (const file of readdirSync(assets)) {
    if (file !== 'headless.js' && file !== 'runtime_assets.json') copyFileSync(join(assets, file), join(folder, file));
  }
  rmSync(assets, { recursive: true });
  mkdirSync(join(folder, 'programs'));
  const described: Record<string, unknown>[] = nodes.map(({ program, threads = false, respawn = false }, i) => {
    const name = program.replace(/\..*/, '');
    const split = splitNames(readFileSync(buildProgram(program, { threads })));
    writeFileSync(join(folder, 'programs', `${name}.wasm`), split.program);
    writeFileSync(join(folder, 'programs', `${name}.names`), split.names);
    return {
      id: `${name}-${i + 1}`,
      package: 'test',
      executable: name,
      label: `/${name}`,
      kind: 'cpp',
      threads,
      respawn,
      program: `programs/${name}.wasm`,
      names: `programs/${name}.names`,
      arguments: ['--ros-args'],
      environment: { COLOUR: 'red' },
      output: 'screen',
      source: { file: 'workspace.yaml', line: 3 + i, column: 5 },
    };
  });
  if (python !== undefined) {
    addPythonFiles(folder, python.packages);
    if (python.nodes.some(({ numpy }) => numpy)) addNumpy(folder);
    described.push(...python.nodes.map((node, i) => describePython(node, nodes.length + i + 1)));
  }
  for (const [file, text] of Object.entries(more)) {
    mkdirSync(dirname(join(folder, file)), { recursive: true });
    writeFileSync(join(folder, file), text);
  }
  const files = readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath, entry.name).slice(folder.length + 1))
    .sort()
    .map((path) => {
      const bytes = readFileSync(join(folder, path));
      return { path, size: bytes.length, sha256: createHash('sha256').update(bytes).digest('hex'), reason: 'test' };
    });
  writeFileSync(join(folder, 'site.json'), JSON.stringify({
    schema: 1,
    protocol: 1,
    generator: 'test',
    name: 'test',
    title: 'A test',
    version: '1',
    distro: 'jazzy',
    license: 'Apache-2.0',
    authors: [],
    nodes: described,
    ui,
    files,
    ...(more['interfaces.json'] === undefined ? {} : { interfaces: 'interfaces.json' }),
    ...(python?.sources === undefined ? {} : { sources: { archive: 'python/packages.zip', files: python.sources } }),
  }));
  return folder;
}
