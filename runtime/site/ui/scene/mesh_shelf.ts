// The meshes of a scene: each file is read once, when an object that is shown names it. The parsers are loaded with the first.

import { Group, Mesh, DoubleSide } from 'three';
import type { Material, Object3D } from 'three';
import { meshKindOf, sitePathOf } from '../model/mesh_file.ts';
import type { MeshKind } from '../model/mesh_file.ts';
import { panelTexts } from '../texts_panels.ts';
import { MOST_MESH_BYTES, MOST_TRIANGLES, MeshFault } from './mesh_reading.ts';
import type { MeshFiles, ParsedMesh } from './mesh_reading.ts';
import { solid } from './shapes.ts';
import type { Rgba } from './shapes.ts';

export interface MeshWish {
  readonly file: string;
  readonly scale: readonly [number, number, number];
  readonly look: Rgba;
  /** When it has any. */
  readonly ownLook: boolean;
  /** In place of a file of the site: `file` tells its kind. */
  readonly bytes?: Uint8Array;
}

export interface PlacedMesh {
  /** Empty until the file is there. */
  readonly object: Group;
  /** Why it is not drawn, or not all of it; empty: it is, or is still read. */
  readonly problem: string;
  close(): void;
}

const NOT_DRAWN = 'R2W0743';

function meshProblem(words: string): string {
  return `${words} (${NOT_DRAWN})`;
}

export class MeshShelf {
  private readonly files: MeshFiles;
  private readonly changed: () => void;
  private readonly known = new Map<string, ParsedMesh | MeshFault | Promise<ParsedMesh | MeshFault>>();
  private drawn = 0;

  /** `changed`: a file has come, or not. */
  constructor(files: MeshFiles, changed: () => void) {
    this.files = files;
    this.changed = changed;
  }

  place(wish: MeshWish): PlacedMesh {
    const object = new Group();
    const placed = {
      object,
      problem: '',
      close: (): void => {
        closed = true;
        this.drawn -= triangles;
        triangles = 0;
      },
    };
    let closed = false;
    let triangles = 0;
    const take = (found: ParsedMesh | MeshFault): void => {
      if (closed) return;
      if (found instanceof MeshFault) placed.problem = meshProblem(found.message);
      else if (this.drawn + found.triangles > 2 * MOST_TRIANGLES)
        placed.problem = meshProblem(panelTexts.scene.mesh.tooMany(wish.file));
      else {
        triangles = found.triangles;
        this.drawn += triangles;
        object.add(copyOf(found, wish));
        placed.problem = found.note === '' ? '' : meshProblem(found.note);
      }
    };
    const found = this.find(wish);
    if (!(found instanceof Promise)) take(found);
    else {
      void found.then((each) => {
        take(each);
        this.changed();
      });
    }
    return placed;
  }

  private find({ file, bytes }: MeshWish): ParsedMesh | MeshFault | Promise<ParsedMesh | MeshFault> {
    const words = panelTexts.scene.mesh;
    const kind = meshKindOf(file);
    const path = sitePathOf(file);
    if (kind === null) return new MeshFault(words.kind(file));
    if (bytes !== undefined) {
      if (bytes.length > MOST_MESH_BYTES) return new MeshFault(words.tooLarge(file));
      return this.parse(kind, path ?? 'share/marker/mesh', file, Promise.resolve(Uint8Array.from(bytes).buffer));
    }
    if (path === null) return new MeshFault(words.outside(file));
    const size = this.files.size(path);
    if (size === undefined) return new MeshFault(words.missing(path));
    if (size > MOST_MESH_BYTES) return new MeshFault(words.tooLarge(file));
    const known = this.known.get(path);
    if (known !== undefined) return known;
    const coming = this.parse(kind, path, file, this.files.read(path));
    this.known.set(path, coming);
    void coming.then((found) => this.known.set(path, found));
    return coming;
  }

  private async parse(kind: MeshKind, path: string, file: string, bytes: Promise<ArrayBuffer>): Promise<ParsedMesh | MeshFault> {
    try {
      const [{ parseMesh }, data] = await Promise.all([import('./mesh_parsers.ts'), bytes]);
      return await parseMesh(kind, path, data, this.files);
    } catch (error) {
      if (error instanceof MeshFault) return error;
      return new MeshFault(panelTexts.scene.mesh.unreadable(file, error instanceof Error ? error.message : ''));
    }
  }
}

/** Geometries are shared by all copies. */
function copyOf({ object, hasLook }: ParsedMesh, { scale, look, ownLook }: MeshWish): Object3D {
  const copy = new Group().add(object.clone(true));
  copy.scale.set(...scale);
  if (hasLook && ownLook) return copy;
  copy.traverse((one) => {
    if (one instanceof Mesh) (one as Mesh).material = lookOf(look);
  });
  return copy;
}

function lookOf(look: Rgba): Material {
  const material = solid(look);
  material.side = DoubleSide;
  return material;
}
