// Which image the Python nodes of a site begin with, and who makes it: one for all of them, kept from an earlier visit, or
// made by a worker of its own: when more nodes start than the machine boots at once, or, to be kept, when those that booted
// by themselves have come to wait.

import { whenIdle } from '../contract/idle.ts';
import { kernelNode } from '../contract/notebook.ts';
import type { Platform } from './platform.ts';
import { type ImageStart, imageVersion } from '../python/python_image.ts';
import { promiseIntegration } from '../program/program.ts';
import { folderOf, homeOf } from '../python/python_files.ts';
import type { PythonStart } from '../python/python_program.ts';
import type { PythonWorkers } from './python_workers.ts';
import { RunningSha256 } from '../contract/running_sha256.ts';
import { carriedPrograms, type SiteDescription, type SiteNode, type SiteProgram } from '../contract/session.ts';

export type ImageOfStart = PythonStart['image'];

/** The longest common beginning of the lists. */
function commonBegin(lists: readonly (readonly string[])[]): string[] {
  const [first = [], ...others] = lists;
  const end = first.findIndex((one, i) => others.some((other) => other[i] !== one));
  return first.slice(0, end < 0 ? first.length : end);
}

/** Settings that the interpreter reads when it boots: nodes that have such ones boot by themselves. */
function bootsByItself(environment: Readonly<Record<string, string>>): boolean {
  return Object.keys(environment).some((name) => name.startsWith('PYTHON') || name === 'ROS_PYTHON_CHECK_FIELDS');
}

/**
 * The bytes of an image depend on these, and on the browser. undefined: not all that it is made of has a hash, so that
 * nobody could tell of what it was made.
 */
function keyOf(site: SiteDescription, program: string, archives: readonly string[]): string | undefined {
  const home = homeOf(program);
  const hashed = new Set(site.files.filter(({ sha256 }) => sha256 !== '').map(({ path }) => path));
  if (![program, ...archives].every((path) => hashed.has(path))) return undefined;
  const parts = site.files.filter(({ path }) => path.startsWith(home) || archives.includes(path) || path === 'python_worker.js');
  const told = [imageVersion, navigator.userAgent, ...parts.map(({ path, sha256 }) => `${path} ${sha256}`).sort()].join('\n');
  const hash = new RunningSha256();
  hash.add(new TextEncoder().encode(told));
  return hash.hex();
}

const longestMakingMs = 60_000;

/** As many boot beside each other as fast as one; each of them takes more memory than with an image. */
const mostByThemselves = 2;

interface Made {
  readonly bytes: Blob;
  /** It was cached in an earlier visit. */
  readonly kept: boolean;
}

export class PythonImages {
  private readonly site: SiteDescription;
  private readonly platform: Platform;
  private readonly workers: PythonWorkers;
  private readonly program: string | undefined;
  private readonly archives: readonly string[];
  private readonly share: string;
  private made: Promise<Made | undefined> | undefined;
  /** Whether one is kept. */
  private looked: Promise<Made | undefined> | undefined;
  /** Ids of the nodes that asked. */
  private readonly asked = new Set<string>();
  /** Ids of those that boot by themselves and do not wait yet: making an image first would take them longer. */
  private readonly booting = new Set<string>();
  /** A kept one that cannot be opened is gone when this resolves. */
  private dropped: Promise<void> | undefined;
  private end: (() => void) | undefined;
  private closed = false;

  /** `share`: as in ImageStart. */
  constructor(site: SiteDescription, platform: Platform, workers: PythonWorkers, share: string) {
    const all: readonly SiteProgram[] = [...carriedPrograms(site), ...(site.notebook === undefined ? [] : [kernelNode(site.notebook)])];
    const nodes = all.filter(({ python }) => python !== undefined);
    const programs = new Set(nodes.map(({ program }) => program));
    this.site = site;
    this.platform = platform;
    this.workers = workers;
    this.share = share;
    this.archives = commonBegin(nodes.map(({ python }) => python?.archives ?? []));
    // One that is kept pays off for one node too, at the next visit.
    const pays = platform.kept !== undefined || nodes.length > 1;
    const works = promiseIntegration() !== undefined && programs.size === 1 && this.archives.length > 0;
    this.program = pays && works ? nodes[0]?.program : undefined;
  }

  /** The image with which a node begins; undefined: it begins without one. Never rejects. */
  async take(node: SiteNode, environment: Readonly<Record<string, string>>): Promise<ImageOfStart> {
    const { program } = this;
    if (node.kind === 'command' || program === undefined || program !== node.program || node.python === undefined) return undefined;
    this.asked.add(node.id);
    if (bootsByItself(environment)) return undefined;
    if (this.made === undefined) {
      this.looked ??= this.keptOne(program).catch(() => undefined);
      const kept = await this.looked;
      if (kept !== undefined) this.made ??= Promise.resolve(kept);
      // Those that are started at once have all asked by now.
      else if (this.asked.size <= Math.min(mostByThemselves, navigator.hardwareConcurrency)) {
        this.booting.add(node.id);
        return undefined;
      }
    }
    const made = await this.begun(program);
    return made === undefined ? undefined : { bytes: made.bytes, archives: this.archives.length };
  }

  /** The node waits for the first time, or is over. */
  settled(node: SiteNode): void {
    const { program, booting, platform: { kept } } = this;
    if (!booting.delete(node.id) || booting.size > 0) return;
    if (kept === undefined || program === undefined || keyOf(this.site, program, this.archives) === undefined) return;
    whenIdle(() => {
      if (!this.closed) void this.begun(program);
    });
  }

  /** The image could not be opened: a cached one is made again; after one that was just made, no further try follows. */
  broken(image: ImageOfStart): void {
    const { made } = this;
    if (made === undefined) return;
    void made.then((found) => {
      if (found === undefined || found.bytes !== image?.bytes || this.made !== made) return;
      this.made = found.kept ? undefined : Promise.resolve(undefined);
      this.looked = undefined;
      this.dropped = this.drop();
    });
  }

  close(): void {
    this.closed = true;
    this.end?.();
  }

  private async drop(): Promise<void> {
    const { program, platform: { kept } } = this;
    const key = program === undefined ? undefined : keyOf(this.site, program, this.archives);
    if (key !== undefined) await kept?.drop(key);
  }

  private async keptOne(program: string): Promise<Made | undefined> {
    const { kept } = this.platform;
    const key = keyOf(this.site, program, this.archives);
    if (kept === undefined || key === undefined) return undefined;
    await this.dropped;
    const found = await kept.get(key);
    return found === undefined ? undefined : { bytes: found, kept: true };
  }

  private begun(program: string): Promise<Made | undefined> {
    this.made ??= this.makeAndKeep(program).catch(() => undefined);
    return this.made;
  }

  private async makeAndKeep(program: string): Promise<Made | undefined> {
    const made = await this.make(program);
    const key = keyOf(this.site, program, this.archives);
    if (made !== undefined && key !== undefined) void this.platform.kept?.put(key, made.bytes);
    return made;
  }

  private async make(program: string): Promise<Made | undefined> {
    const { archives, share, platform, workers } = this;
    const { promise, resolve } = Promise.withResolvers<Blob | undefined>();
    // At once: it loads its script while the rest comes.
    const worker = workers.start(program, 'python image', {
      report: (report) => {
        if (report.t === 'image') over(report.image);
      },
      failed: () => over(undefined),
    });
    // A worker that ends without a word must not keep the nodes waiting: they boot then.
    const watchdog = setTimeout(() => over(undefined), longestMakingMs);
    const over = (image: Blob | undefined): void => {
      clearTimeout(watchdog);
      this.end = undefined;
      void worker.terminate();
      resolve(image);
    };
    this.end = () => over(undefined);
    try {
      const [module, parts] = await Promise.all([platform.compile(program), workers.files.parts(program, archives)]);
      const start: ImageStart = { base: folderOf(platform.place), home: homeOf(program), archives, share, parts };
      if (this.closed) over(undefined);
      else worker.post({ t: 'image', module, start }, []);
    } catch {
      over(undefined);
    }
    const bytes = await promise;
    return bytes === undefined ? undefined : { bytes, kept: false };
  }
}
