// The Python files of the workspace in a site, as the page sees them: what was packed, and what the visitor made of it.
// Types only; source_files.ts has them.

/** A Python file of the workspace, as site.json has it. */
export interface SiteSource {
  /** In the installation that nodes see. */
  readonly path: string;
  /** In the workspace. */
  readonly file: string;
  /** As it was packed. */
  readonly sha256: string;
}

export interface SiteSources {
  /** Path of the zip file with the bytes, relative to site.json. */
  readonly archive: string;
  readonly files: readonly SiteSource[];
}

export interface SourceView extends SiteSource {
  /** "outdated": the visitor's text was made of another version of the file, and no node gets it. */
  readonly state: 'packed' | 'changed' | 'outdated';
  /** The hash of the visitor's text, when there is one. */
  readonly changedSha256?: string;
}

/** "visit": only until the page is closed, as the browser keeps nothing. "too_long": not at all. */
export type SourceKept = 'kept' | 'visit' | 'too_long';

/** The visitor's changes are for this browser and this site only. Nodes get them when they start. */
export interface Sources {
  /** As the workspace names them, sorted. */
  list(): readonly SourceView[];
  /** The text that was packed. Rejects with a SiteError. */
  packed(path: string): Promise<string>;
  /** The visitor's text, also an outdated one; undefined: there is none. */
  changed(path: string): string | undefined;
  /** undefined: as it was packed. */
  change(path: string, text: string | undefined): SourceKept;
  /** Called after each change, also by another tab. */
  onChange(listener: () => void): () => void;
}

/** The information about the sources that a worker gets. */
export interface SourceStart {
  /** Paths that the worker reports when the program reads them. */
  readonly watched: readonly string[];
  /** Texts that replace the packed ones, by path. */
  readonly changed: ReadonlyMap<string, string>;
}
