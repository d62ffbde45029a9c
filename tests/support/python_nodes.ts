// The files of Python nodes in a site, as `pack` will put them there: Pyodide, rclpy with the interfaces, the packages
// of a test.

import { execFileSync } from 'node:child_process';
import { copyFileSync, mkdirSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../..', import.meta.url));
const sitePackages = 'lib/python3.12/site-packages';
const pyodideFiles = ['pyodide.js', 'pyodide.asm.js', 'pyodide.asm.wasm', 'pyodide-lock.json', 'python_stdlib.zip'];

export interface PythonNode {
  /** `module:function`, or the path of a script in the installation. */
  readonly entry: string;
  readonly executable: string;
  readonly arguments?: readonly string[];
  readonly environment?: Readonly<Record<string, string>>;
}

/** `packages`: folder -> place in the installation. */
export function addPythonFiles(folder: string, packages: Readonly<Record<string, string>>): void {
  mkdirSync(join(folder, 'pyodide'));
  for (const file of pyodideFiles) copyFileSync(join(root, 'node_modules/pyodide', file), join(folder, 'pyodide', file));
  mkdirSync(join(folder, 'python'));
  const make = (out: string, pairs: readonly string[]): void => {
    execFileSync('python3', [join(root, 'tests/support/make_archive.py'), join(folder, 'python', out), ...pairs]);
  };
  const interfaces = join(root, 'runtime/interfaces');
  const rclpy = join(root, 'runtime/rclpy');
  make('rclpy.zip', [
    ...readdirSync(rclpy).filter((name) => !name.includes('.')).sort().map((name) => `${join(rclpy, name)}=${sitePackages}/${name}`),
    `${interfaces}=share`,
  ]);
  make('packages.zip', Object.entries(packages).map(([from, place]) => `${from}=${place}`));
}

/** A Python package among the tests' own: its modules, and its scripts as they are. */
export function ownPackage(name: string): Record<string, string> {
  const folder = join(root, 'tests/packages', name);
  return { [join(folder, name)]: `${sitePackages}/${name}`, [join(folder, 'scripts')]: `lib/${name}` };
}

/** The node as site.json has it. */
export function describePython(node: PythonNode, index: number): Record<string, unknown> {
  const { entry, executable } = node;
  return {
    id: `${executable}-${index}`, package: 'test', executable, label: `/${executable}`, kind: 'python',
    program: 'pyodide/pyodide.asm.wasm', python: { archives: ['python/rclpy.zip', 'python/packages.zip'], entry },
    threads: false, respawn: false, arguments: node.arguments ?? [], environment: node.environment ?? {}, output: 'screen',
    source: { file: 'workspace.yaml', line: 2 + index, column: 5 },
  };
}
