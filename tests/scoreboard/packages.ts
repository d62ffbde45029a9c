// The ROS 2 packages below a folder, as colcon finds them: names, kinds, and who needs whom.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

export interface Package {
  readonly name: string;
  readonly folder: string;
  readonly language: 'cpp' | 'python';
  /** Names from package.xml, those of tests left out; of `findPackages`, also those that only sources know. */
  readonly needs: readonly string[];
}

const IGNORED = ['COLCON_IGNORE', 'AMENT_IGNORE'];
const NEEDS = /<(?:build_|build_export_|buildtool_|exec_)?depend(?:\s[^>]*)?>\s*([^<\s]+)\s*</g;

/** Sorted by name. The first of two packages with one name counts. */
export function findPackages(roots: readonly string[]): ReadonlyMap<string, Package> {
  const found = new Map<string, Package>();
  for (const root of roots) visit(root, found);
  const named = [...found.values()].map((one): [string, Package] => {
    const needs = [...new Set([...one.needs, ...mentioned(one.folder, found)])].sort();
    return [one.name, { ...one, needs: needs.filter((name) => name !== one.name) }];
  });
  return new Map(named.sort(([a], [b]) => (a < b ? -1 : 1)));
}

/** The packages in `all` that Python sources and launch files of a package name: a workspace that is built as a whole has them. */
function mentioned(folder: string, all: ReadonlyMap<string, Package>): string[] {
  const files = readdirSync(folder, { recursive: true, encoding: 'utf8' }).filter((path) => /(?:\.py|[._]launch\.(?:xml|ya?ml)|\.launch)$/.test(path));
  const words = files.flatMap((path) => readFileSync(join(folder, path), 'utf8').match(/[a-z][a-z0-9_]*/g) ?? []);
  return [...new Set(words)].filter((word) => all.has(word));
}

function visit(folder: string, found: Map<string, Package>): void {
  if (IGNORED.some((mark) => existsSync(join(folder, mark)))) return;
  const xml = join(folder, 'package.xml');
  if (existsSync(xml)) {
    const read = readPackage(folder, readFileSync(xml, 'utf8'));
    if (read !== undefined && !found.has(read.name)) found.set(read.name, read);
    return;
  }
  for (const entry of readdirSync(folder, { withFileTypes: true })) {
    if (entry.isDirectory() && !entry.name.startsWith('.')) visit(join(folder, entry.name), found);
  }
}

export function readPackage(folder: string, xml: string): Package | undefined {
  const text = xml.replaceAll(/<!--[^]*?-->/g, '');
  const name = /<name>\s*(\S+?)\s*<\/name>/.exec(text)?.[1];
  if (name === undefined) return undefined;
  const kind = /<build_type>\s*(\S+?)\s*<\/build_type>/.exec(text)?.[1] ?? 'ament_cmake';
  const needs = new Set([...text.matchAll(NEEDS)].map((match) => match[1] ?? ''));
  return { name, folder, language: kind === 'ament_python' ? 'python' : 'cpp', needs: [...needs].sort() };
}

/** The packages and all that they need, as far as `all` has them; sorted. */
export function closure(names: Iterable<string>, all: ReadonlyMap<string, Package>): Package[] {
  const chosen = new Map<string, Package>();
  const add = (name: string): void => {
    const one = all.get(name);
    if (one === undefined || chosen.has(name)) return;
    chosen.set(name, one);
    one.needs.forEach(add);
  };
  for (const name of names) add(name);
  return [...chosen.values()].sort((a, b) => (a.name < b.name ? -1 : 1));
}
