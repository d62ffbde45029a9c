// One small solid, a pyramid on a square of two metres, in the formats of meshes, each with a colour of its own where the
// format has any.

type Place = readonly [x: number, y: number, z: number];

const CORNERS: readonly Place[] = [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0], [0, 0, 1.5]];
const FACES: readonly (readonly [number, number, number])[] = [[0, 2, 1], [0, 3, 2], [0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]];
export const WEDGE_TRIANGLES = FACES.length;

const cornersOf = (face: readonly number[]): readonly Place[] => face.map((index) => CORNERS[index] ?? [0, 0, 0]);

export function asciiStl(): string {
  const facets = FACES.map((face) =>
    `facet normal 0 0 0\nouter loop\n${cornersOf(face).map((place) => `vertex ${place.join(' ')}\n`).join('')}endloop\nendfacet\n`
  );
  return `solid wedge\n${facets.join('')}endsolid wedge\n`;
}

/** `said`: how many triangles the head promises. */
export function binaryStl(said = WEDGE_TRIANGLES): Buffer {
  const bytes = Buffer.alloc(84 + 50 * FACES.length);
  bytes.writeUInt32LE(said, 80);
  for (const [index, face] of FACES.entries())
    for (const [i, value] of cornersOf(face).flat().entries()) bytes.writeFloatLE(value, 84 + 50 * index + 12 + 4 * i);
  return bytes;
}

/** Green, or with that picture; in units of a metre's tenth. `nodes`: in place of its only one. */
export function collada(picture = '',
  nodes =
    '<node id="n"><instance_geometry url="#g"><bind_material><technique_common><instance_material symbol="m" target="#m"/></technique_common></bind_material></instance_geometry></node>'): string
{
  const color = picture === ''
    ? '<color>0 0.7 0 1</color>'
    : '<texture texture="sampler" texcoord="UV"/>';
  const images = picture === '' ? '' : `<library_images><image id="i"><init_from>${picture}</init_from></image></library_images>`;
  const parameters = picture === ''
    ? ''
    : '<newparam sid="surface"><surface type="2D"><init_from>i</init_from></surface></newparam><newparam sid="sampler"><sampler2D><source>surface</source></sampler2D></newparam>';
  const numbers = CORNERS.flat().map((value) => value * 10);
  const uv = CORNERS.flatMap(([x, y]) => [(x + 1) / 2, (y + 1) / 2]);
  const source = (id: string, values: readonly number[], names: string): string =>
    `<source id="${id}"><float_array id="${id}a" count="${values.length}">${
      values.join(' ')
    }</float_array><technique_common><accessor source="#${id}a" count="${values.length / names.length}" stride="${names.length}">${
      [...names].map((name) => `<param name="${name}" type="float"/>`).join('')
    }</accessor></technique_common></source>`;
  return `<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit meter="0.1" name="decimetre"/><up_axis>Z_UP</up_axis></asset>${images}
<library_effects><effect id="e"><profile_COMMON>${parameters}<technique sid="t"><lambert><diffuse>${color}</diffuse></lambert></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="m"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g"><mesh>${source('p', numbers, 'XYZ')}${
    source('t', uv, 'ST')
  }<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles material="m" count="${FACES.length}"><input semantic="VERTEX" source="#v" offset="0"/><input semantic="TEXCOORD" source="#t" offset="0"/><p>${
    FACES.flat().join(' ')
  }</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s">${nodes}</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>`;
}

export const MATERIALS = 'newmtl blue\nKd 0 0 0.9\n';

export function obj(corners: readonly Place[] = CORNERS): string {
  return `mtllib wedge.mtl\n${corners.map((place) => `v ${place.join(' ')}\n`).join('')}usemtl blue\n${
    FACES.map((face) => `f ${face.map((index) => index + 1).join(' ')}\n`).join('')
  }`;
}

export function gltfNumbers(): Buffer {
  const places = new Float32Array(FACES.flatMap((face) => cornersOf(face).flat()));
  return Buffer.from(places.buffer);
}

/** Red. `more`: in place of parts of it. */
export function gltf(uri = 'wedge.bin', more: object = {}): string {
  const byteLength = gltfNumbers().length;
  return JSON.stringify({
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, material: 0 }] }],
    materials: [{ pbrMetallicRoughness: { baseColorFactor: [0.8, 0, 0, 1], metallicFactor: 0 }, doubleSided: true }],
    accessors: [{ bufferView: 0, componentType: 5126, count: FACES.length * 3, type: 'VEC3', min: [-1, -1, 0], max: [1, 1, 1.5] }],
    bufferViews: [{ buffer: 0, byteLength }],
    buffers: [{ uri, byteLength }],
    ...more,
  });
}
