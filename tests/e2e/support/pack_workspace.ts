// A colcon workspace for one test, and a way to run the program on it.
import { spawn, type ChildProcess } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';

const WATCHDOG_MS = 600_000;
export const CLI = resolve(process.env['ROS2WASM_CLI'] ?? 'build/ros2wasm');

export interface Finished {
  readonly code: number | null;
  readonly stdout: string;
  readonly stderr: string;
}

/** The cache of a run of all tests, empty at first: the compiler's headers and the channel's packages are prepared there once. */
const SHARED_CACHE = process.env['ROS2WASM_TEST_CACHE'];

export class PackWorkspace {
  readonly root = mkdtempSync(join(tmpdir(), 'ros2wasm-pack-'));
  readonly cache: string;

  /** Tests of what is built, or is not, want a cache of their own; those of what runs share one. */
  constructor(cache: 'own' | 'shared' = 'own') {
    this.cache = (cache === 'shared' ? SHARED_CACHE : undefined) ?? join(this.root, 'cache');
  }

  write(path: string, text: string | Uint8Array): string {
    const file = join(this.root, path);
    mkdirSync(dirname(file), { recursive: true });
    writeFileSync(file, text);
    return file;
  }

  /** An ament_cmake package with one program per entry of `programs` (name -> C++ text). */
  addPackage(name: string, programs: Readonly<Record<string, string>>, options: { cmake?: string; depends?: readonly string[]; } = {}): void {
    const depends = (options.depends ?? []).map((d) => `  <depend>${d}</depend>\n`).join('');
    this.write(`src/${name}/package.xml`, `<?xml version="1.0"?>
<package format="3">
  <name>${name}</name>
  <version>1.2.3</version>
  <description>A package of a test</description>
  <maintainer email="someone@example.org">Someone</maintainer>
  <license>Apache-2.0</license>
  <buildtool_depend>ament_cmake</buildtool_depend>
${depends}  <test_depend>ament_lint_auto</test_depend>
  <export><build_type>ament_cmake</build_type></export>
</package>
`);
    const names = Object.keys(programs);
    for (const program of names) this.write(`src/${name}/src/${program}.cpp`, programs[program] ?? '');
    const targets = names.map((p) => `add_executable(${p} src/${p}.cpp)\n`).join('');
    const install = names.length === 0 ? '' : `install(TARGETS ${names.join(' ')} DESTINATION lib/\${PROJECT_NAME})\n`;
    this.write(`src/${name}/CMakeLists.txt`, `cmake_minimum_required(VERSION 3.8)
project(${name})
find_package(ament_cmake REQUIRED)
${targets}${options.cmake ?? ''}
${install}if(BUILD_TESTING)
  find_package(ament_lint_auto REQUIRED)
  ament_lint_auto_find_test_dependencies()
endif()
ament_package()
`);
  }

  /** An ament_python package with one executable per entry of `programs` (name -> the module's text, which has a `main`). */
  addPythonPackage(name: string, programs: Readonly<Record<string, string>>, depends: readonly string[] = ['rclpy']): void {
    this.write(`src/${name}/package.xml`, `<?xml version="1.0"?>
<package format="3">
  <name>${name}</name>
  <version>1.2.3</version>
  <description>A package of a test</description>
  <maintainer email="someone@example.org">Someone</maintainer>
  <license>Apache-2.0</license>
${depends.map((d) => `  <exec_depend>${d}</exec_depend>\n`).join('')}  <export><build_type>ament_python</build_type></export>
</package>
`);
    const scripts = Object.keys(programs).map((program) => `'${program} = ${name}.${program}:main'`).join(', ');
    this.write(`src/${name}/setup.cfg`, `[develop]\nscript_dir=$base/lib/${name}\n[install]\ninstall_scripts=$base/lib/${name}\n`);
    this.write(`src/${name}/setup.py`, `from setuptools import setup
setup(name='${name}', version='1.2.3', packages=['${name}'],
      data_files=[('share/${name}', ['package.xml']), ('share/ament_index/resource_index/packages', ['resource/${name}'])],
      entry_points={'console_scripts': [${scripts}]})
`);
    this.write(`src/${name}/resource/${name}`, '');
    this.write(`src/${name}/${name}/__init__.py`, '');
    for (const [program, text] of Object.entries(programs)) this.write(`src/${name}/${name}/${program}.py`, text);
  }

  /** Takes packages of tests/packages. */
  copyPackages(...names: readonly string[]): void {
    for (const name of names) cpSync(resolve(import.meta.dirname, '../../packages', name), join(this.root, 'src', name), { recursive: true });
  }

  start(args: readonly string[], environment: Readonly<Record<string, string>> = {}): ChildProcess {
    return spawn(CLI, args, {
      cwd: this.root,
      env: { ...process.env, XDG_CACHE_HOME: this.cache, ...environment },
      stdio: ['ignore', 'pipe', 'pipe'],
    });
  }

  run(args: readonly string[], environment: Readonly<Record<string, string>> = {}): Promise<Finished> {
    return finished(this.start(args, environment));
  }

  /** Packs it into the folder `site`, and gives that. */
  async packed(): Promise<string> {
    const { code, stderr } = await this.run(['pack', 'workspace.yaml', '--output', 'site']);
    if (code !== 0) throw new Error(stderr);
    return join(this.root, 'site');
  }

  read(path: string): Buffer<ArrayBuffer> {
    return readFileSync(join(this.root, path));
  }

  /** Path -> contents of every file below a folder. */
  files(folder: string): Map<string, string> {
    const found = new Map<string, string>();
    for (const entry of readdirSync(join(this.root, folder), { recursive: true, withFileTypes: true })) {
      if (!entry.isFile()) continue;
      const file = join(entry.parentPath, entry.name);
      found.set(file.slice(join(this.root, folder).length + 1), readFileSync(file).toString('latin1'));
    }
    return new Map([...found].sort(([a], [b]) => (a < b ? -1 : 1)));
  }

  close(): void {
    rmSync(this.root, { recursive: true, force: true });
  }
}

export function finished(child: ChildProcess): Promise<Finished> {
  let stdout = '';
  let stderr = '';
  child.stdout?.setEncoding('utf8').on('data', (text: string) => {
    stdout += text;
  });
  child.stderr?.setEncoding('utf8').on('data', (text: string) => {
    stderr += text;
  });
  const watchdog = setTimeout(() => child.kill('SIGKILL'), WATCHDOG_MS);
  return new Promise((done, fail) => {
    child.on('error', fail);
    child.on('close', (code) => {
      clearTimeout(watchdog);
      done({ code, stdout, stderr });
    });
  });
}

/** Runs a singly linked program with the least of WASI, returns what it printed and its exit code. */
export function runProgram(bytes: Uint8Array): { output: string; code: number; } {
  const module = new WebAssembly.Module(bytes as Uint8Array<ArrayBuffer>);
  const decoder = new TextDecoder();
  let output = '';
  let memory: WebAssembly.Memory | undefined;
  const view = (): DataView => new DataView((memory as WebAssembly.Memory).buffer);
  class Exit extends Error {
    readonly code: number;
    constructor(code: number) {
      super('exit');
      this.code = code;
    }
  }
  const zero = (): number => 0;
  const wasi: Record<string, (...args: number[]) => number> = {
    fd_write(_fd = 0, vectors = 0, count = 0, written = 0) {
      let total = 0;
      for (let i = 0; i < count; ++i) {
        const at = view().getUint32(vectors + 8 * i, true);
        const length = view().getUint32(vectors + 8 * i + 4, true);
        output += decoder.decode(new Uint8Array(view().buffer, at, length));
        total += length;
      }
      view().setUint32(written, total, true);
      return 0;
    },
    environ_sizes_get(count = 0, size = 0) {
      view().setUint32(count, 0, true);
      view().setUint32(size, 0, true);
      return 0;
    },
    args_sizes_get(count = 0, size = 0) {
      view().setUint32(count, 0, true);
      view().setUint32(size, 0, true);
      return 0;
    },
    proc_exit(code = 0): number {
      throw new Exit(code);
    },
  };
  const imports: Record<string, Record<string, (...args: number[]) => number>> = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module)) {
    (imports[from] ??= {})[name] = (from === 'wasi_snapshot_preview1' ? wasi[name] : undefined) ?? zero;
  }
  const instance = new WebAssembly.Instance(module, imports);
  memory = instance.exports['memory'] as WebAssembly.Memory;
  try {
    (instance.exports['_start'] as () => void)();
    return { output, code: 0 };
  } catch (thrown) {
    if (thrown instanceof Exit) return { output, code: thrown.code };
    throw thrown;
  }
}
