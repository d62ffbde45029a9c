// Where the files of a site lie. Most sites have them beside site.json, under their paths. Sites that share a store have
// there, under its sha256, what does not belong to them alone; and a file that is too large for a host lies in parts.
// bundler/site/site_place.cpp is the same in C++.

export interface SiteStore {
  /** Relative to site.json, with "/" at the end. */
  readonly objects: string;
  /** Folder there of the page's modules, which find each other by their names. */
  readonly scripts: string;
}

export interface FilePart {
  readonly size: number;
  readonly sha256: string;
}

/** A file as site.json lists it. */
export interface ListedPlace {
  readonly path: string;
  readonly sha256: string;
  /** In the store: by its hash, or with the scripts. */
  readonly kept?: string;
  readonly parts?: readonly FilePart[];
}

/** With its bytes' sha256. */
export interface Place {
  readonly at: string;
  readonly sha256: string;
}

const hash = /^[0-9a-f]{64}$/;

/** undefined: it is not a store that `ros2wasm pack` writes. */
export function readStore(value: unknown): SiteStore | undefined {
  if (typeof value !== 'object' || value === null) return undefined;
  const { objects, scripts } = value as { readonly objects?: unknown; readonly scripts?: unknown; };
  if (typeof objects !== 'string' || !/^(?:\.\.\/){1,8}(?:[\w-][\w.-]*\/){1,8}$/.test(objects)) return undefined;
  return typeof scripts === 'string' && hash.test(scripts) ? { objects, scripts } : undefined;
}

function ending(path: string): string {
  return /[^/]\.[a-z0-9]{1,8}$/.exec(path)?.[0].slice(1) ?? '';
}

/** Relative to site.json; of a file in parts more than one, in their order. */
export function placesOf({ path, sha256, kept, parts }: ListedPlace, store: SiteStore | undefined): readonly Place[] {
  if (parts !== undefined) {
    return parts.map((part, i) => ({
      at: store === undefined ? `${path}.part${i + 1}` : `${store.objects}${part.sha256}.part`,
      sha256: part.sha256,
    }));
  }
  if (store === undefined || kept === undefined) return [{ at: path, sha256 }];
  return [{ at: kept === 'script' ? `${store.objects}${store.scripts}/${path}` : `${store.objects}${sha256}${ending(path)}`, sha256 }];
}
