// The Python files of the workspace in a site, and what the visitor made of them: kept by the browser, bounded, each with
// the hash of the packed file that it was made of, so that nothing is applied to another one.

import type { KeptTexts } from '../contract/stored_texts.ts';
import { RunningSha256 } from '../contract/running_sha256.ts';
import { SiteError } from '../contract/site_error.ts';
import type { SiteSource, SiteSources, SourceKept, Sources, SourceStart, SourceView } from '../contract/site_sources.ts';
import { zipMember } from '../contract/zip_member.ts';

/** Characters of one file, and of all of a site. */
export const mostOfFile = 200_000;
export const mostOfSite = 1_000_000;

interface Kept {
  /** As the browser has it. */
  readonly raw: string;
  /** The hash of the packed file that the text was made from. */
  readonly of: string;
  readonly text: string;
  readonly sha256: string;
}

function hashOf(bytes: Uint8Array): string {
  const sum = new RunningSha256();
  sum.add(bytes);
  return sum.hex();
}

/** A text from the browser's storage may have been written by any page of the host. */
function readKept(raw: string): Kept | undefined {
  if (raw.length > 8 * mostOfFile) return undefined;
  try {
    const json = JSON.parse(raw) as { readonly of?: unknown; readonly text?: unknown; } | null;
    if (typeof json?.of !== 'string' || typeof json.text !== 'string' || json.text.length > mostOfFile) return undefined;
    return { raw, of: json.of, text: json.text, sha256: hashOf(new TextEncoder().encode(json.text)) };
  } catch {
    return undefined;
  }
}

export class SourceFiles implements Sources {
  private readonly site: SiteSources;
  private readonly texts: KeptTexts;
  private readonly archive: () => Promise<Blob>;
  private readonly listeners = new Set<() => void>();
  private readonly read = new Map<string, Kept>();
  private unwatch: (() => void) | undefined;

  /** `archive`: gives the zip file, which is the packed one. */
  constructor(site: SiteSources, texts: KeptTexts, archive: () => Promise<Blob>) {
    this.site = site;
    this.texts = texts;
    this.archive = archive;
  }

  list(): readonly SourceView[] {
    return this.site.files.map((source) => {
      const kept = this.kept(source.path);
      if (kept === undefined) return { ...source, state: 'packed' };
      return { ...source, state: kept.of === source.sha256 ? 'changed' : 'outdated', changedSha256: kept.sha256 };
    });
  }

  async packed(path: string): Promise<string> {
    const { file, sha256 } = this.source(path);
    const bytes = zipMember(new Uint8Array(await (await this.archive()).arrayBuffer()), path);
    if (bytes === undefined || hashOf(bytes) !== sha256) {
      throw new SiteError('R2W0724', `${file} is not the file that the site was packed with`, {
        why: `${this.site.archive} does not have it as site.json says`,
        fix: 'pack the workspace again',
      });
    }
    try {
      return new TextDecoder('utf-8', { fatal: true, ignoreBOM: true }).decode(bytes);
    } catch {
      throw new SiteError('R2W0726', `${file} cannot be shown`, { why: 'it is not in UTF-8', fix: 'save it in UTF-8 and pack the workspace again' });
    }
  }

  changed(path: string): string | undefined {
    return this.kept(path)?.text;
  }

  change(path: string, text: string | undefined): SourceKept {
    const { sha256 } = this.source(path);
    if (text !== undefined) {
      const others = this.site.files.filter((one) => one.path !== path);
      const sum = others.reduce((length, one) => length + (this.kept(one.path)?.text.length ?? 0), 0);
      if (text.length > mostOfFile || sum + text.length > mostOfSite) return 'too_long';
    }
    const isKept = this.texts.set(path, text === undefined ? undefined : JSON.stringify({ of: sha256, text }));
    this.tell();
    return isKept ? 'kept' : 'visit';
  }

  onChange(listener: () => void): () => void {
    this.listeners.add(listener);
    this.unwatch ??= this.texts.onChange(() => this.tell());
    return () => {
      this.listeners.delete(listener);
      if (this.listeners.size === 0) this.close();
    };
  }

  /** For a node that starts now. */
  forStart(): SourceStart {
    const changed = new Map<string, string>();
    for (const { path, sha256 } of this.site.files) {
      const kept = this.kept(path);
      if (kept?.of === sha256) changed.set(path, kept.text);
    }
    return { watched: this.site.files.map(({ path }) => path), changed };
  }

  close(): void {
    this.unwatch?.();
    this.unwatch = undefined;
  }

  private source(path: string): SiteSource {
    const found = this.site.files.find((one) => one.path === path);
    if (found === undefined) throw new RangeError(`the site has no source ${path}`);
    return found;
  }

  private kept(path: string): Kept | undefined {
    const raw = this.texts.get(path);
    const before = this.read.get(path);
    if (before !== undefined && before.raw === raw) return before;
    const now = raw === undefined ? undefined : readKept(raw);
    if (now === undefined) this.read.delete(path);
    else this.read.set(path, now);
    return now;
  }

  private tell(): void {
    for (const listener of [...this.listeners]) listener();
  }
}
