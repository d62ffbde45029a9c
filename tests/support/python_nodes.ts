// The files of Python nodes in a site, as `pack` will put them there: Pyodide, rclpy with the interfaces, the packages
// of a test.

import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { copyFileSync, existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../..', import.meta.url));
const sitePackages = 'lib/python3.12/site-packages';
const pyodide = join(root, 'node_modules/pyodide');
const pyodideFiles = ['pyodide.js', 'pyodide.asm.js', 'pyodide.asm.wasm'];

export interface PythonNode {
  /** `module:function`, or the path of a script in the installation. */
  readonly entry: string;
  readonly executable: string;
  readonly arguments?: readonly string[];
  readonly numpy?: boolean;
  readonly environment?: Readonly<Record<string, string>>;
}

const library = join(root, 'runtime/packages/vendor/pyodide');

/** The path of the output of `make`, made once for these sources. Tests that run at the same time write the same bytes. */
function madeOnce(name: string, sources: readonly string[], make: (place: string) => void): string {
  const hash = createHash('sha256');
  for (const file of [join(pyodide, 'package.json'), ...sources]) hash.update(file.slice(root.length)).update('\0').update(readFileSync(file));
  const made = join(tmpdir(), `ros2wasm-${name}-${hash.digest('hex')}`);
  if (!existsSync(made)) {
    const beside = `${made}.${process.pid}`;
    make(beside);
    try {
      renameSync(beside, made);
    } catch (error) {
      if (!existsSync(made)) throw error;
      rmSync(beside, { recursive: true });
    }
  }
  return made;
}

/** The standard library as the channel's package of Pyodide has it. */
export function compiledStdlib(): string {
  const script = join(library, 'make_stdlib.mjs');
  return madeOnce('stdlib', [script, join(library, 'compiler.mjs')], (place) => void execFileSync(process.execPath, [script, pyodide, place]));
}

/** The compiled modules that rclpy's package has beside its sources. */
function compiledModules(packages: readonly string[]): string {
  const script = join(library, 'compile_modules.mjs');
  const sources = packages.flatMap((folder) =>
    readdirSync(folder, { recursive: true, encoding: 'utf8' })
      .filter((name) => name.endsWith('.py')).sort().map((name) => join(folder, name))
  );
  return madeOnce('modules', [script, join(library, 'compiler.mjs'), ...sources],
    (place) => void execFileSync(process.execPath, [script, pyodide, `/ros/${sitePackages}`, place, ...packages]));
}

/** The interpreter, in a folder of that name. */
export function addPyodide(folder: string): void {
  mkdirSync(join(folder, 'pyodide'));
  for (const file of pyodideFiles) copyFileSync(join(pyodide, file), join(folder, 'pyodide', file));
  const lock = JSON.parse(readFileSync(join(pyodide, 'pyodide-lock.json'), 'utf8')) as object;
  writeFileSync(join(folder, 'pyodide/pyodide-lock.json'), JSON.stringify({ ...lock, packages: {} }));
  copyFileSync(compiledStdlib(), join(folder, 'pyodide/python_stdlib.zip'));
}

/** `packages`: folder -> place in the installation. */
export function addPythonFiles(folder: string, packages: Readonly<Record<string, string>>): void {
  addPyodide(folder);
  mkdirSync(join(folder, 'python'));
  const make = (out: string, pairs: readonly string[]): void => {
    execFileSync('python3', [join(root, 'tests/support/make_archive.py'), join(folder, 'python', out), ...pairs]);
  };
  const interfaces = join(root, 'runtime/packages/interfaces');
  const rclpy = join(root, 'runtime/packages/client/rclpy');
  const own = readdirSync(rclpy).filter((name) => !name.includes('.')).sort();
  const compiled = compiledModules(own.map((name) => join(rclpy, name)));
  make('rclpy.zip', [
    ...own.flatMap((name) => [join(rclpy, name), join(compiled, name)].map((folder) => `${folder}=${sitePackages}/${name}`)),
    ...['ament_index_python', 'sensor_msgs_py'].map((name) => `${join(root, 'runtime/packages/tools', name, name)}=${sitePackages}/${name}`),
    `${interfaces}=share`,
  ]);
  make('packages.zip', Object.entries(packages).map(([from, place]) => `${from}=${place}`));
}

/** An archive with numpy, for the nodes that say so. */
export function addNumpy(folder: string): void {
  const unpacked = mkdtempSync(join(tmpdir(), 'ros2wasm-numpy-'));
  const packed = join(root, 'node_modules/@emscripten-forge/numpy/pkg');
  for (const file of readdirSync(packed)) execFileSync('tar', ['xzf', join(packed, file), '-C', unpacked]);
  execFileSync('python3', [
    join(root, 'tests/support/make_archive.py'),
    join(folder, 'python/numpy.zip'),
    `${join(unpacked, sitePackages)}=${sitePackages}`,
  ]);
  rmSync(unpacked, { recursive: true });
}

/** A Python package among the tests' own: its modules, and its scripts as they are. */
export function ownPackage(name: string): Record<string, string> {
  const folder = join(root, 'tests/packages', name);
  return { [join(folder, name)]: `${sitePackages}/${name}`, [join(folder, 'scripts')]: `lib/${name}` };
}

/** The node as site.json has it. */
export function describePython(node: PythonNode, index: number): Record<string, unknown> {
  const { entry, executable } = node;
  const archives = ['python/rclpy.zip', 'python/packages.zip', ...(node.numpy === true ? ['python/numpy.zip'] : [])];
  return {
    id: `${executable}-${index}`,
    package: 'test',
    executable,
    label: `/${executable}`,
    kind: 'python',
    program: 'pyodide/pyodide.asm.wasm',
    python: { archives, entry },
    threads: false,
    respawn: false,
    arguments: node.arguments ?? [],
    environment: node.environment ?? {},
    output: 'screen',
    source: { file: 'workspace.yaml', line: 2 + index, column: 5 },
  };
}
