// `ros2wasm build` and `pack`, for the packages of a board: a manifest beside nothing of theirs, and what the
// program said when it failed.
import { execFile } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { join, relative } from 'node:path';
import type { Expectation } from './expectation.ts';
import { closure, type Package } from './packages.ts';

export interface Failure {
  /** A code of ros2wasm, or a word of the board: `unmet`, `absent`. */
  readonly code: string;
  readonly reason: string;
}

/** `leftOut`: programs that the package has and that were not built. */
export type Built =
  | { readonly executables: readonly string[]; readonly leftOut: ReadonlyMap<string, Failure>; readonly launches: readonly string[]; }
  | { readonly failure: Failure; };

export type Packed = { readonly site: string; } | { readonly failure: Failure; };

/** As in a manifest, with further keys. */
interface LaunchedNode {
  readonly package: string;
  readonly executable: string;
}

export class Workshop {
  private readonly cli: string;
  private readonly folder: string;
  private readonly packages: ReadonlyMap<string, Package>;
  private readonly companions: ReadonlyMap<string, ReadonlySet<string>>;

  /** `folder`: for manifests, locks and sites; what stands there already may be overwritten. */
  constructor(cli: string, folder: string, packages: ReadonlyMap<string, Package>, expectations: Iterable<Expectation>) {
    this.cli = cli;
    this.folder = folder;
    this.packages = packages;
    this.companions = companionsOf(expectations);
  }

  async build(name: string): Promise<Built> {
    // `build` starts nothing, but a manifest must name something.
    const manifest = this.manifest(join(this.folder, name), [name], [{ package: name, executable: 'any' }]);
    const { failure, output, messages } = await this.run(['build', '--quick', manifest]);
    if (failure !== undefined) return { failure };
    const built = JSON.parse(output) as readonly { readonly package: string; readonly prefix: string; }[];
    const prefix = built.find((one) => one.package === name)?.prefix;
    if (prefix === undefined) return { failure: whyLeftOut(messages, name) };
    return {
      executables: programs(join(prefix, 'lib', name)),
      leftOut: leftOutPrograms(join(prefix, 'lib', name)),
      launches: launchFiles(join(prefix, 'share', name)),
    };
  }

  /** The folder of a site with the executable and what runs beside it, the executable first. */
  async pack(start: LaunchedNode, expected: Expectation | undefined): Promise<Packed> {
    const folder = join(this.folder, start.package, start.executable);
    const nodes = expected === undefined ? [{ ...start, options: {} }] : [{ ...expected, executable: expected.program }, ...expected.beside];
    const launch = nodes.map(({ package: of, executable, options }) => ({ package: of, executable, ...options }));
    return this.packSite(folder, this.manifest(folder, nodes.map((node) => node.package), launch));
  }

  /** The folder of a site with what the launch file of a package starts. */
  async packLaunch(name: string, file: string, given: Expectation['given']): Promise<Packed> {
    const folder = join(this.folder, name, file);
    mkdirSync(folder, { recursive: true });
    // A launch file of the manifest lies beside it; this one is where the package installs it.
    const place = `$(find-pkg-share ${name})/${file}`.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;');
    writeFileSync(join(folder, 'board.launch.xml'), `<launch><include file="${place}"/></launch>\n`);
    return this.packSite(folder, this.manifest(folder, [name], { file: 'board.launch.xml', arguments: given }));
  }

  private async packSite(folder: string, manifest: string): Promise<Packed> {
    const site = join(folder, 'site');
    rmSync(site, { recursive: true, force: true });
    const { failure } = await this.run(['pack', '--quick', manifest, '--output', site]);
    return failure === undefined ? { site } : { failure };
  }

  private manifest(folder: string, packages: readonly string[], launch: unknown): string {
    mkdirSync(folder, { recursive: true });
    // Always all that any site of the package needs: another set would be another environment, and all built anew.
    const [first = ''] = packages;
    const names = [...new Set([...packages, ...(this.companions.get(first) ?? [])])];
    const local = closure(names, this.packages);
    const file = join(folder, 'workspace.yaml');
    writeFileSync(file, JSON.stringify({
      schema: 1,
      name: 'scoreboard',
      distro: 'jazzy',
      packages: local.map((one) => relative(folder, one.folder)),
      dependencies: names.filter((name) => !this.packages.has(name)),
      launch,
    }));
    return file;
  }

  private run(args: readonly string[]): Promise<{ readonly failure: Failure | undefined; readonly output: string; readonly messages: string; }> {
    return new Promise((resolve) => {
      execFile(this.cli, [...args, '--json'], { maxBuffer: 1 << 28 }, (error, output, messages) => {
        resolve({ output, messages, failure: error === null ? undefined : firstError(messages) ?? { code: 'failed', reason: error.message } });
      });
    });
  }
}

/** Package -> packages of what runs beside its executables. */
function companionsOf(expectations: Iterable<Expectation>): ReadonlyMap<string, ReadonlySet<string>> {
  const found = new Map<string, Set<string>>();
  for (const one of expectations) {
    const names = found.get(one.package) ?? new Set();
    for (const beside of one.beside) names.add(beside.package);
    found.set(one.package, names);
  }
  return found;
}

/** Names of the programs in a folder of the installed tree: compiled ones, and scripts that Python runs. */
function programs(folder: string): string[] {
  try {
    const names = readdirSync(folder).map((name) => name.endsWith('.wasm') ? name.slice(0, -'.wasm'.length) : isScript(join(folder, name)) ? name : '');
    return names.filter((name) => name !== '').sort();
  } catch {
    return [];
  }
}

/** The toolchain's note says a header, what of a browser with the source that refers to it, or a library. */
function codeOfNeed(need: string): string {
  if (need.startsWith('the header ')) return 'R2W0522';
  return need.includes(' refers to `') ? 'R2W0523' : 'R2W0405';
}

/** Name -> why it was not built. */
function leftOutPrograms(folder: string): ReadonlyMap<string, Failure> {
  if (!existsSync(folder)) return new Map();
  const notes = readdirSync(folder).filter((name) => name.endsWith('.left_out')).sort();
  return new Map(notes.map((note) => {
    const need = readFileSync(join(folder, note), 'utf8');
    return [note.slice(0, -'.left_out'.length), { code: codeOfNeed(need), reason: `skipped: it needs ${need}` }];
  }));
}

/** Below a folder, as `ros2 launch` offers them; sorted. */
export function launchFiles(folder: string): string[] {
  if (!existsSync(folder)) return [];
  return readdirSync(folder, { recursive: true, encoding: 'utf8' })
    .filter((path) => /(?:[._]launch\.(?:py|xml|ya?ml)|\.launch)$/.test(path) && statSync(join(folder, path)).isFile())
    .sort();
}

function isScript(file: string): boolean {
  const stat = statSync(file);
  return stat.isFile() && (stat.mode & 0o111) !== 0 && /^#!.*python/.test(readFileSync(file, 'utf8'));
}

/** The first error among the events that `--json` writes to stderr. */
export function firstError(messages: string): Failure | undefined {
  for (const event of findings(messages)) {
    if (event.severity === 'warning') continue;
    // The last line of CMake's output does not contain the reason.
    const detail = event.code === 'R2W0503' ? undefined : event.detail?.split('\n').find((text) => text.includes('error'));
    return { code: event.code, reason: [(event.message ?? '') + placeOf(event), ...(detail === undefined ? [] : [detail])].join(': ') };
  }
  return undefined;
}

/** The warnings about a package that was not built. */
export function whyLeftOut(messages: string, name: string): Failure {
  const said = findings(messages).find((event) => event.message?.startsWith(`package \`${name}\` is skipped: `) === true);
  if (said === undefined) return { code: 'R2W0514', reason: 'the package is skipped' };
  // The last cause is the first one of all.
  const root = said.message?.includes(' is skipped: it needs `') === true ? said.why?.at(-1) : undefined;
  return { code: said.code, reason: [(said.message ?? '') + placeOf(said), ...(root === undefined ? [] : [root])].join(': ') };
}

interface Finding {
  readonly code: string;
  readonly severity?: string;
  readonly message?: string;
  readonly detail?: string;
  readonly why?: readonly string[];
  readonly span?: { readonly file: string; readonly line: number; } | null;
}

function findings(messages: string): readonly Finding[] {
  return messages.split('\n').filter((line) => line.startsWith('{')).map((line) => JSON.parse(line) as Partial<Finding>)
    .filter((event): event is Finding => event.code !== undefined);
}

function placeOf({ span }: Finding): string {
  return span === undefined || span === null ? '' : ` (${span.file}:${String(span.line)})`;
}
