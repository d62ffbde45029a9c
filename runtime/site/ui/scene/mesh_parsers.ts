// Reads the files of meshes by three's own loaders, without a request of theirs: what a file names is read before, from
// the site, and nothing else is. The files may be anything.

import { FileLoader, LoadingManager, Mesh, Texture, TextureLoader } from 'three';
import type { BufferAttribute, BufferGeometry, Material, Object3D } from 'three';
import { ColladaLoader } from 'three/addons/loaders/ColladaLoader.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import type { GLTFParser } from 'three/addons/loaders/GLTFLoader.js';
import { MTLLoader } from 'three/addons/loaders/MTLLoader.js';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { STLLoader } from 'three/addons/loaders/STLLoader.js';
import { member } from '../model/json.ts';
import { besidePath } from '../model/mesh_file.ts';
import type { MeshKind } from '../model/mesh_file.ts';
import { readXml } from '../model/xml.ts';
import type { XmlElement } from '../model/xml.ts';
import { unreachable } from '../../contract/session.ts';
import { panelTexts } from '../texts_panels.ts';
import { FARTHEST } from './places.ts';
import { MOST_MESH_BYTES, MOST_TRIANGLES, MeshFault } from './mesh_reading.ts';
import type { MeshFiles, ParsedMesh } from './mesh_reading.ts';

const MOST_NAMED = 64;
const MOST_NODES = 20_000;
const MOST_NUMBERS = 20_000_000;
const DEEPEST = 200;
/** One white pixel, for pictures that are not there. */
const WHITE = 'data:image/gif;base64,R0lGODlhAQABAIAAAP///wAAACH5BAAAAAAALAAAAAABAAEAAAICRAEAOw==';

interface Look {
  readonly object: Object3D;
  readonly hasLook: boolean;
}

/** Throws MeshFault, or an Error of the loader. */
export async function parseMesh(kind: MeshKind, path: string, bytes: ArrayBuffer, files: MeshFiles): Promise<ParsedMesh> {
  const named = new NamedFiles(path, bytes.byteLength, files);
  const { object, hasLook } = await named.during(() => lookOf(kind, bytes, named));
  bared(object);
  const triangles = countTriangles(object, path);
  if (triangles === 0) throw new MeshFault(panelTexts.scene.mesh.unreadable(path, panelTexts.scene.mesh.empty));
  if (triangles > MOST_TRIANGLES) throw new MeshFault(panelTexts.scene.mesh.triangles(path));
  return { object, hasLook, triangles, note: named.note };
}

async function lookOf(kind: MeshKind, bytes: ArrayBuffer, named: NamedFiles): Promise<Look> {
  switch (kind) {
    case 'stl':
      return { object: new Mesh(readStl(bytes, named.path)), hasLook: false };
    case 'dae':
      return { object: await readCollada(new TextDecoder().decode(bytes), named), hasLook: true };
    case 'obj':
      return readObj(new TextDecoder().decode(bytes), named);
    case 'gltf':
    case 'glb':
      return { object: await readGltf(bytes, named), hasLook: true };
    default:
      return unreachable(kind);
  }
}

function readStl(bytes: ArrayBuffer, path: string): BufferGeometry {
  // A binary file says how many triangles of 50 bytes follow.
  const isBinary = bytes.byteLength >= 84 && 84 + 50 * new DataView(bytes).getUint32(80, true) === bytes.byteLength;
  if (isBinary && new DataView(bytes).getUint32(80, true) > MOST_TRIANGLES) throw new MeshFault(panelTexts.scene.mesh.triangles(path));
  if (!isBinary && !/^\s*solid/.test(new TextDecoder().decode(bytes.slice(0, 200))))
    throw new MeshFault(panelTexts.scene.mesh.unreadable(path, panelTexts.scene.mesh.cut));
  const geometry = new STLLoader().parse(bytes);
  geometry.computeVertexNormals(); // many files have none, and say zeros
  return geometry;
}

/** As RViz: coordinates as they are, in metres by the file's unit, whichever axis it calls up. */
async function readCollada(text: string, named: NamedFiles): Promise<Object3D> {
  const root = readXml(text);
  if (root?.name !== 'COLLADA') throw new MeshFault(panelTexts.scene.mesh.unreadable(named.path, panelTexts.scene.mesh.noCollada));
  if (nodesOf(root) > MOST_NODES) throw new MeshFault(panelTexts.scene.mesh.triangles(named.path));
  for (const [, name = ''] of text.matchAll(/<init_from>\s*([^<>]{1,500}?)\s*<\/init_from>/g)) await named.fetch(name);
  const plain = text
    .replace(/<up_axis>[^<]*<\/up_axis>/g, '<up_axis>Y_UP</up_axis>')
    .replace(/\.tga(?=\s*<)/gi, '.tga-image'); // those it would ask the host for
  const { scene } = new ColladaLoader(named.manager).parse(plain, '') ?? {};
  if (scene === undefined) throw new MeshFault(panelTexts.scene.mesh.unreadable(named.path, panelTexts.scene.mesh.noCollada));
  return scene;
}

/** How many there are when each is put wherever the file wants it; Infinity: one within itself. */
function nodesOf(root: XmlElement): number {
  const byId = new Map<string, XmlElement>();
  const all: XmlElement[] = [root];
  for (let each = all.pop(); each !== undefined; each = all.pop()) {
    if (each.name === 'node') byId.set(each.attributes.get('id') ?? '', each);
    for (const child of each.children) all.push(child);
  }
  const counts = new Map<XmlElement, number>();
  const count = (node: XmlElement, depth: number): number => {
    const known = counts.get(node);
    if (known !== undefined) return known;
    if (depth > DEEPEST) return Infinity;
    counts.set(node, Infinity);
    let sum = 1;
    for (const child of node.children) {
      const other = child.name === 'instance_node' ? byId.get((child.attributes.get('url') ?? '').replace(/^#/, '')) : child;
      if (other !== undefined && (child.name === 'instance_node' || child.name === 'node')) sum += count(other, depth + 1);
    }
    counts.set(node, sum);
    return sum;
  };
  return [...byId.values()].reduce((sum, node) => Math.max(sum, count(node, 0)), 0);
}

async function readObj(text: string, named: NamedFiles): Promise<Look> {
  const loader = new OBJLoader();
  let hasLook = false;
  for (const [, library = ''] of text.matchAll(/^[ \t]*mtllib[ \t]+([^\r\n]{1,500}?)[ \t]*$/gm)) {
    const bytes = await named.fetch(library);
    if (bytes === undefined) {
      named.missing(library);
      continue;
    }
    const materials = new TextDecoder().decode(bytes);
    for (const [, rest = ''] of materials.matchAll(/^[ \t]*(?:map_\w+|bump|norm|disp)[ \t]+([^\r\n]{1,500}?)[ \t]*$/gim))
      for (const name of new Set([rest, rest.split(/\s+/).at(-1) ?? ''])) await named.fetch(name);
    loader.setMaterials(new MTLLoader(named.manager).parse(materials, ''));
    hasLook = true;
    break;
  }
  return { object: loader.parse(text), hasLook };
}

async function readGltf(bytes: ArrayBuffer, named: NamedFiles): Promise<Object3D> {
  const json = gltfJson(bytes);
  if (!isSoundGltf(json)) throw new MeshFault(panelTexts.scene.mesh.unreadable(named.path, panelTexts.scene.mesh.noGltf));
  for (const part of ['images', 'buffers'])
    for (const each of listOf(member(json, part))) {
      const uri = member(each, 'uri');
      if (typeof uri !== 'string' || uri.startsWith('data:')) continue;
      if ((await named.fetch(uri)) === undefined && part === 'buffers')
        throw new MeshFault(panelTexts.scene.mesh.part(named.path, uri.slice(0, 80)));
    }
  const loader = new GLTFLoader(named.manager);
  loader.register((parser: GLTFParser) => {
    const inner = parser as { textureLoader: unknown; fileLoader: unknown; };
    // Its own would ask for pictures in a way that the page's policy forbids.
    inner.textureLoader = new TextureLoader(named.manager);
    inner.fileLoader = new NamedLoader(named);
    return { name: 'files_of_the_site' };
  });
  const { scene } = await loader.parseAsync(bytes, '');
  return scene;
}

function gltfJson(bytes: ArrayBuffer): unknown {
  const view = new DataView(bytes);
  const isBinary = bytes.byteLength > 20 && view.getUint32(0, true) === 0x46546c67;
  const json = isBinary ? bytes.slice(20, 20 + view.getUint32(12, true)) : bytes;
  try {
    return JSON.parse(new TextDecoder().decode(json));
  } catch {
    return null;
  }
}

function listOf(value: unknown): readonly unknown[] {
  return Array.isArray(value) ? (value as readonly unknown[]) : [];
}

/** Nodes are a tree, and there is an end to the numbers that it wants room for. */
function isSoundGltf(json: unknown): boolean {
  if (member(json, 'asset') === undefined) return false;
  const nodes = listOf(member(json, 'nodes'));
  const children = nodes.flatMap((node) => listOf(member(node, 'children')));
  const roots = listOf(member(json, 'scenes')).flatMap((scene) => listOf(member(scene, 'nodes')));
  const isTree = new Set(children).size === children.length && !roots.some((root) => children.includes(root));
  const numbers = listOf(member(json, 'accessors')).reduce<number>((sum, each) => sum + Math.abs(Number(member(each, 'count'))), 0);
  return isTree && nodes.length <= MOST_NODES && children.length <= MOST_NODES && numbers <= MOST_NUMBERS;
}

/** The files that a mesh file refers to: read from the site before its loader asks. */
class NamedFiles {
  readonly manager = new LoadingManager();
  readonly path: string;
  note = '';
  private readonly files: MeshFiles;
  private readonly known = new Map<string, ArrayBuffer>();
  private readonly addresses = new Map<string, string>();
  private left: number;
  private open = 0;
  private done: () => void = () => undefined;

  constructor(path: string, size: number, files: MeshFiles) {
    this.path = path;
    this.files = files;
    this.left = MOST_MESH_BYTES - size;
    this.manager.setURLModifier((name) => this.addressOf(name));
    const { itemStart, itemEnd } = this.manager;
    this.manager.itemStart = (url) => {
      this.open += 1;
      itemStart(url);
    };
    this.manager.itemEnd = (url) => {
      this.open -= 1;
      itemEnd(url);
      if (this.open === 0) this.done();
    };
  }

  /** undefined: it cannot be had. */
  async fetch(name: string): Promise<ArrayBuffer | undefined> {
    const path = besidePath(this.path, name);
    const size = path === null ? undefined : this.files.size(path);
    if (path === null || size === undefined || this.known.size >= MOST_NAMED || size > this.left) return undefined;
    const bytes = this.known.get(name) ?? await this.files.read(path);
    if (!this.known.has(name)) this.left -= bytes.byteLength;
    this.known.set(name, bytes);
    return bytes;
  }

  bytesOf(name: string): ArrayBuffer | undefined {
    return this.known.get(name);
  }

  missing(name: string): void {
    this.note = panelTexts.scene.mesh.part(this.path, name.slice(0, 80));
  }

  /** Until all pictures are there, or never will be. */
  async during(read: () => Promise<Look>): Promise<Look> {
    try {
      const look = await read();
      if (this.open > 0)
        await new Promise<void>((resolve) => {
          this.done = resolve;
        });
      return look;
    } finally {
      for (const address of this.addresses.values()) URL.revokeObjectURL(address);
    }
  }

  private addressOf(name: string): string {
    if (/^(?:blob|data):/.test(name)) return name;
    const known = this.addresses.get(name);
    if (known !== undefined) return known;
    const bytes = this.known.get(name);
    if (bytes === undefined) {
      this.missing(name);
      return WHITE;
    }
    const address = URL.createObjectURL(new Blob([bytes], /\.svg$/i.test(name) ? { type: 'image/svg+xml' } : {}));
    this.addresses.set(name, address);
    return address;
  }
}

/** Loads the binary data of a glTF file. */
class NamedLoader extends FileLoader {
  private readonly named: NamedFiles;

  constructor(named: NamedFiles) {
    super(named.manager);
    this.named = named;
  }

  override load(
    url: string,
    onLoad?: (data: string | ArrayBuffer) => void,
    _?: unknown,
    onError?: (error: unknown) => void,
  ): undefined {
    const inline = /^data:[^,]{0,200};base64,/.exec(url)?.[0];
    try {
      const bytes = inline === undefined ? this.named.bytesOf(url) : bytesOfBase64(url.slice(inline.length));
      if (bytes === undefined) throw new MeshFault(panelTexts.scene.mesh.part(this.named.path, url.slice(0, 80)));
      onLoad?.(bytes);
    } catch (error) {
      onError?.(error);
    }
  }
}

function bytesOfBase64(text: string): ArrayBuffer {
  return Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)).buffer;
}

/** Without the file's own lights and cameras, and without pictures that did not come. */
function bared(object: Object3D): void {
  const gone: Object3D[] = [];
  object.traverse((one) => {
    const { isLight, isCamera } = one as { readonly isLight?: boolean; readonly isCamera?: boolean; };
    if (isLight === true || isCamera === true) gone.push(one);
    if (!(one instanceof Mesh)) return;
    const { material } = one as Mesh;
    for (const each of Array.isArray(material) ? material : [material]) withoutLostPictures(each);
  });
  for (const one of gone) one.removeFromParent();
}

function withoutLostPictures(material: Material): void {
  const pictures = material as unknown as Record<string, unknown>;
  for (const [name, value] of Object.entries(pictures)) {
    if (!(value instanceof Texture)) continue;
    const { image } = value as { readonly image?: { readonly width?: unknown; } | null; };
    if (!(Number(image?.width) > 0)) pictures[name] = null;
  }
}

/** Throws when a place is none. */
function countTriangles(object: Object3D, path: string): number {
  let count = 0;
  object.traverse((one) => {
    if (!(one instanceof Mesh)) return;
    const { geometry } = one as Mesh;
    const place = geometry.getAttribute('position') as BufferAttribute | undefined;
    if (place === undefined) return;
    for (const value of place.array)
      if (!(Math.abs(value) < FARTHEST)) throw new MeshFault(panelTexts.scene.mesh.unreadable(path, panelTexts.scene.mesh.noPlace));
    count += Math.floor((geometry.index?.count ?? place.count) / 3);
  });
  return count;
}
