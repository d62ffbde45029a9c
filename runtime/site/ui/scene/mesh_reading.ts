// The input and the result of reading the file of a mesh, and its limits.

import type { Object3D } from 'three';

/** The content of a file. */
export interface ParsedMesh {
  readonly object: Object3D;
  readonly triangles: number;
  /** Has it colours of its own? */
  readonly hasLook: boolean;
  /** Names the missing parts; empty: it is complete. */
  readonly note: string;
}

/** The files of the site. Rejects with an Error. */
export interface MeshFiles {
  /** Bytes; undefined: the site has no such file. */
  size(path: string): number | undefined;
  read(path: string): Promise<ArrayBuffer>;
}

/** The size limit of a file together with the files that it names. */
export const MOST_MESH_BYTES = 1 << 26;
/** The limit of a file; all files that are drawn may have twice as many. */
export const MOST_TRIANGLES = 2_000_000;

/** Its message is words for the visitor. */
export class MeshFault extends Error {}
