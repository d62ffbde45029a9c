// A Debian of its own, for tests: a folder that has what every Debian has, and some packages with all that they depend on, each
// as it is installed on this machine. Nothing else of this machine is in it.
import { execFileSync, spawn } from 'node:child_process';
import { cpSync, existsSync, lstatSync, mkdirSync, readFileSync, readdirSync, readlinkSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { type Finished, finished } from './pack_workspace.ts';

interface Installed {
  /** With its architecture where dpkg wants that. */
  readonly full: string;
  readonly depends: string;
  readonly essential: boolean;
}

const field = /^\s*([a-z0-9][a-z0-9+.-]*)/;

export class CleanRoot {
  readonly folder: string;
  private readonly installed = new Map<string, Installed>();
  private readonly providers = new Map<string, string>();
  private readonly taken = new Set<string>();

  constructor(folder: string) {
    this.folder = folder;
    const format = ['Package', 'binary:Package', 'Essential', 'Pre-Depends', 'Depends', 'Provides', 'db:Status-Status'].map((name) => `\${${name}}`).join('\t');
    for (const line of execFileSync('dpkg-query', ['-W', '-f', `${format}\n`], { encoding: 'utf8', maxBuffer: 1 << 26 }).split('\n')) {
      const [name = '', full = '', essential = '', before = '', depends = '', provides = '', status = ''] = line.split('\t');
      if (status !== 'installed') continue;
      this.installed.set(name, { full, depends: `${before},${depends}`, essential: essential === 'yes' });
      for (const one of provides.split(',')) {
        const provided = field.exec(one)?.[1];
        if (provided !== undefined) this.providers.set(provided, name);
      }
    }
    for (const [name, { essential }] of this.installed) if (essential) this.take(name);
  }

  /** Packages in the form of a field such as Depends, and what they depend on. Those that are not installed here are given back. */
  takeAll(wanted: string): string[] {
    const missing: string[] = [];
    for (const clause of wanted.split(',')) {
      if (clause.trim() === '') continue;
      const names = clause.split('|').map((one) => field.exec(one)?.[1] ?? '');
      const found = names.find((name) => this.installed.has(name)) ?? names.map((name) => this.providers.get(name)).find((name) => name !== undefined);
      if (found === undefined) missing.push(clause.trim());
      else this.take(found);
    }
    return missing;
  }

  private take(name: string): void {
    if (this.taken.has(name)) return;
    this.taken.add(name);
    this.takeAll(this.installed.get(name)?.depends ?? '');
  }

  /** Copies the files of all packages that were taken, and tells dpkg that it has them. */
  make(): void {
    for (const name of ['bin', 'sbin', 'lib', 'lib64']) {
      if (!existsSync(`/${name}`) || !lstatSync(`/${name}`).isSymbolicLink()) continue;
      const target = readlinkSync(`/${name}`).replace(/^\//, '');
      mkdirSync(join(this.folder, target), { recursive: true });
      symlinkSync(target, join(this.folder, name));
    }
    for (const name of ['proc', 'dev', 'tmp', 'root', 'etc', 'usr/local/bin', 'opt']) mkdirSync(join(this.folder, name), { recursive: true });
    const dpkg = join(this.folder, 'var/lib/dpkg');
    for (const name of ['info', 'updates', 'triggers']) mkdirSync(join(dpkg, name), { recursive: true });
    const packages = [...this.taken].map((name) => this.installed.get(name)?.full ?? name);
    const paths = new Set(execFileSync('dpkg-query', ['-L', ...packages], { encoding: 'utf8', maxBuffer: 1 << 28 }).split('\n')
      .filter((path) => path.startsWith('/') && path !== '/.' && !/^\/(?:bin|sbin|lib|lib64)$/.test(path) && existsSync(path)));
    // Links in place of files that several packages offer.
    for (const link of readdirSync('/etc/alternatives')) {
      const choice = join('/etc/alternatives', link);
      if (!lstatSync(choice).isSymbolicLink() || !paths.has(readlinkSync(choice))) continue;
      paths.add(choice);
      const place = join('/usr/bin', link);
      if (existsSync(place) && lstatSync(place).isSymbolicLink()) paths.add(place);
    }
    const list = join(this.folder, 'tmp/files');
    writeFileSync(list, [...paths].map((path) => path.slice(1)).join('\0'));
    execFileSync('bash', ['-c', 'set -o pipefail; tar -C / --null --no-recursion -T "$1" -cf - | tar -C "$2" -xpf -', 'copy', list, this.folder]);
    for (const name of packages) {
      for (const file of [`${name}.list`, `${name.split(':')[0] ?? ''}.list`]) {
        if (existsSync(join('/var/lib/dpkg/info', file))) cpSync(join('/var/lib/dpkg/info', file), join(dpkg, 'info', file));
      }
    }
    const paragraphs = readFileSync('/var/lib/dpkg/status', 'utf8').split('\n\n').filter((paragraph) =>
      this.taken.has(/^Package: (\S+)$/m.exec(paragraph)?.[1] ?? '')
    );
    writeFileSync(join(dpkg, 'status'), `${paragraphs.join('\n\n')}\n`);
    for (const [name, minor] of [['null', '3'], ['urandom', '9']] as const)
      execFileSync('mknod', ['-m', '666', join(this.folder, 'dev', name), 'c', '1', minor]);
  }

  /** In the root, as its only user, with nothing of this process's environment. /proc is there where this machine allows it. */
  run(command: readonly string[], cwd = '/root'): Promise<Finished> {
    const inside =
      `cd "$0" && exec chroot . /usr/bin/env -i PATH=/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 sh -c 'cd "$0" && exec "$@"' "$@"`;
    const script = `if [ "$1" = mounted ]; then shift; mount -t proc proc "$0/proc"; ${inside}
      elif unshare --mount true 2>/dev/null; then exec unshare --mount sh -c "$SCRIPT" "$0" mounted "$@"
      else ${inside}; fi`;
    return finished(spawn('sh', ['-c', script, this.folder, cwd, ...command], { env: { ...process.env, SCRIPT: script }, stdio: ['ignore', 'pipe', 'pipe'] }));
  }
}
