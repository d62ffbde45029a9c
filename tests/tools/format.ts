// Formats TypeScript with dprint (dprint.json): `node tests/tools/format.ts check|fix [FILE...]`; without files, all of the
// repository. Files that were well formatted are known by their hash (build/.formatted.json) and skipped.
import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { createFromBuffer } from '@dprint/formatter';
import { getPath } from '@dprint/typescript';

interface Settings {
  readonly general: Record<string, unknown>;
  readonly typescript: Record<string, unknown>;
}

const ROOT = resolve(import.meta.dirname, '../..');
const KNOWN = join(ROOT, 'build/.formatted.json');

function allFiles(): string[] {
  const listed = execFileSync('git', ['ls-files', '-co', '--exclude-standard', '*.ts', '*.tsx', '*.mjs'], { cwd: ROOT, encoding: 'utf8' });
  return listed.split('\n').filter((file) => file !== '' && existsSync(join(ROOT, file)));
}

/** The hashes of texts that this configuration leaves as they are. */
function knownHashes(): Set<string> {
  try {
    return new Set(JSON.parse(readFileSync(KNOWN, 'utf8')) as string[]);
  } catch {
    return new Set();
  }
}

function main([mode, ...named]: readonly string[]): number {
  if (mode !== 'check' && mode !== 'fix') {
    console.error('usage: node tests/tools/format.ts check|fix [FILE...]');
    return 2;
  }
  const config = readFileSync(join(ROOT, 'dprint.json'), 'utf8');
  const plugin = readFileSync(getPath());
  const formatter = createFromBuffer(plugin);
  const { general, typescript } = JSON.parse(config) as Settings;
  formatter.setConfig(general, typescript);
  const problems = formatter.getConfigDiagnostics();
  if (problems.length > 0) throw new Error(`dprint.json: ${JSON.stringify(problems)}`);
  const before = knownHashes();
  const after = new Set<string>();
  const wrong: string[] = [];
  for (const file of named.length > 0 ? named : allFiles()) {
    const text = readFileSync(join(ROOT, file), 'utf8');
    const hash = createHash('sha256').update(config).update(plugin).update(text).digest('hex');
    if (before.has(hash)) {
      after.add(hash);
      continue;
    }
    const formatted = formatter.formatText({ filePath: file, fileText: text });
    if (formatted === text) after.add(hash);
    else if (mode === 'check') wrong.push(file);
    else writeFileSync(join(ROOT, file), formatted);
  }
  mkdirSync(join(ROOT, 'build'), { recursive: true });
  writeFileSync(KNOWN, JSON.stringify([...(named.length > 0 ? before : []), ...after]));
  for (const file of wrong) console.log(`${file}: not formatted (./dev fmt)`);
  return wrong.length > 0 ? 1 : 0;
}

process.exitCode = main(process.argv.slice(2));
