// Meshes: where names of files lead, what is read of the formats, and files that are none.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Box3, Color } from 'three';
import { besidePath, meshKindOf, sitePathOf } from '../../../runtime/site/ui/model/mesh_file.ts';
import { MeshShelf } from '../../../runtime/site/ui/scene/mesh_shelf.ts';
import type { MeshWish, PlacedMesh } from '../../../runtime/site/ui/scene/mesh_shelf.ts';
import { RobotModel } from '../../../runtime/site/ui/scene/robot_model.ts';
import { asciiStl, binaryStl, gltf, gltfNumbers, MATERIALS, WEDGE_TRIANGLES, obj } from '../../support/wedge_meshes.ts';

test('names of meshes lead to files of the site, and nowhere else', () => {
  for (
    const [name, path] of [
      ['package://arm/meshes/hand.stl', 'share/arm/meshes/hand.stl'],
      ['model://arm/hand.dae', 'share/arm/hand.dae'],
      ['file:///opt/ros/jazzy/share/arm/hand.stl', 'share/arm/hand.stl'],
      ['/home/me/ws/install/arm/share/arm/hand.stl', 'share/arm/hand.stl'],
      ['file://$(find arm)/meshes/hand.stl', 'share/arm/meshes/hand.stl'],
      ['package://arm//meshes/./x/../hand.stl', 'share/arm/meshes/hand.stl'],
      ['package://../../site.json', null],
      ['package://arm/../../../index.html', null],
      ['package://arm', null],
      ['https://example.org/share/arm/hand.stl', null],
      ['//example.org/share/arm/hand.stl', 'share/arm/hand.stl'],
      ['hand.stl', null],
      ['javascript:alert(1)', null],
      ['data:model/stl,solid', null],
      ['', null],
      [`package://${'a/'.repeat(2000)}b.stl`, null],
    ] as const
  )
    assert.equal(sitePathOf(name), path, name);
  const dae = 'share/arm/meshes/hand.dae';
  for (
    const [name, path] of [
      ['skin.png', 'share/arm/meshes/skin.png'],
      ['../pictures/my%20skin.png', 'share/arm/pictures/my skin.png'],
      ['.\\skin.png', 'share/arm/meshes/skin.png'],
      ['package://other/a.png', 'share/other/a.png'],
      ['50%.png', 'share/arm/meshes/50%.png'],
      ['../../../site.json', null],
      ['%2e%2e/../../../site.json', null],
      ['http://example.org/a.png', null],
      ['blob:x', null],
    ] as const
  )
    assert.equal(besidePath(dae, name), path, name);
  assert.deepEqual(['a.STL', 'a.dae', 'a.glb', 'a.exe', 'stl', ''].map(meshKindOf), ['stl', 'dae', 'glb', null, null, null]);
});

interface Tried {
  readonly placed: PlacedMesh;
  readonly asked: readonly string[];
}

/** Places it once its file is there. */
async function placed(files: Readonly<Record<string, string | Buffer>>, wish: Partial<MeshWish> & { readonly file: string; }): Promise<Tried> {
  const asked: string[] = [];
  const come = Promise.withResolvers<void>();
  const shelf = shelfOf(files, asked, () => come.resolve());
  const whole = { scale: [1, 1, 1], look: { color: new Color('#ff0000'), alpha: 1 }, ownLook: true, ...wish } as const;
  const first = shelf.place(whole);
  if (first.problem === '' && first.object.children.length === 0) await come.promise;
  // The second time the file is at hand.
  const again = shelf.place(whole);
  if (wish.bytes === undefined) assert.deepEqual([again.problem, again.object.children.length], [first.problem, first.object.children.length]);
  return { placed: first, asked };
}

function shelfOf(files: Readonly<Record<string, string | Buffer>>, asked: string[], changed: () => void): MeshShelf {
  return new MeshShelf({
    size: (path) => files[path]?.length,
    async read(path) {
      asked.push(path);
      return Uint8Array.from(Buffer.from(files[path] ?? '')).buffer;
    },
  }, changed);
}

test('STL, OBJ and glTF are read with what they name, once, and scaled', async () => {
  for (
    const [name, more, asked] of [
      ['a.stl', { 'share/m/a.stl': asciiStl() }, 1],
      ['b.stl', { 'share/m/b.stl': binaryStl() }, 1],
      ['wedge.obj', { 'share/m/wedge.obj': obj(), 'share/m/wedge.mtl': MATERIALS }, 2],
      ['wedge.gltf', { 'share/m/wedge.gltf': gltf(), 'share/m/wedge.bin': gltfNumbers() }, 2],
      ['own.gltf', { 'share/m/own.gltf': gltf(`data:application/octet-stream;base64,${gltfNumbers().toString('base64')}`) }, 1],
    ] as const
  ) {
    const { placed: mesh, asked: paths } = await placed(more, { file: `package://m/${name}`, scale: [2, 1, 0.5] });
    assert.equal(mesh.problem, '', name);
    const { min, max } = new Box3().setFromObject(mesh.object);
    assert.deepEqual([...min.toArray(), ...max.toArray()].map((value) => Math.round(value * 1e6) / 1e6 + 0), [-2, -1, 0, 2, 1, 0.75], name);
    assert.equal(paths.length, asked, name);
  }
  const { placed: inMessage, asked } = await placed({}, { file: 'embedded://wedge.stl', bytes: binaryStl() });
  assert.deepEqual([inMessage.problem, inMessage.object.children.length, asked], ['', 1, []]);
});

test('what is not a mesh of the site is said with R2W0743, and nothing is asked for', async () => {
  const many = Buffer.alloc(84 + 50 * 2_000_001);
  many.writeUInt32LE(2_000_001, 80);
  const files = {
    'share/m/cut.stl': binaryStl(WEDGE_TRIANGLES + 1),
    'share/m/empty.stl': `solid a\n${' '.repeat(100)}\nendsolid a\n`,
    'share/m/many.stl': many.subarray(0, 1 << 20),
    'share/m/far.obj': obj([[1e30, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 0, 1]]),
    'share/m/bare.obj': obj(),
    'share/m/words.gltf': '<html>',
    'share/m/cycle.gltf': gltf('wedge.bin', { nodes: [{ children: [1] }, { children: [0], mesh: 0 }] }),
    'share/m/vast.gltf': gltf('wedge.bin', { accessors: [{ componentType: 5126, count: 1e9, type: 'VEC3' }] }),
    'share/m/away.gltf': gltf('https://example.org/wedge.bin'),
    'share/m/words.dae': 'words',
    'share/m/note.txt': '',
    'share/m/all.stl': many,
  };
  for (
    const [file, words] of [
      ['package://m/none.stl', /^the site has no file share\/m\/none\.stl \(R2W0743\)$/],
      ['https://example.org/a.stl', /^https:\/\/example\.org\/a\.stl is not drawn: only files of the site are/],
      ['package://m/note.txt', /^package:\/\/m\/note\.txt is not drawn: meshes are STL/],
      ['package://m/cut.stl', /cannot be read: its length does not fit/],
      ['package://m/empty.stl', /it has no triangles/],
      ['package://m/far.obj', /a coordinate in it is not a number, or too far away/],
      ['package://m/words.gltf', /it is not a valid glTF/],
      ['package://m/cycle.gltf', /it is not a valid glTF/],
      ['package://m/vast.gltf', /it is not a valid glTF/],
      ['package://m/away.gltf', /names https:\/\/example\.org\/wedge\.bin, which the site does not have/],
      ['package://m/words.dae', /it is not a COLLADA document/],
      ['package://m/many.stl', /cannot be read/],
      ['package://m/all.stl', /is not drawn: it (has more than 2,000,000 triangles|is larger than 64 MiB)/],
    ] as const
  ) {
    const { placed: mesh, asked } = await placed(files, { file });
    assert.match(mesh.problem, words);
    assert.match(mesh.problem, /\(R2W0743\)$/);
    assert.equal(mesh.object.children.length, 0, file);
    assert.ok(asked.length <= 1, file);
  }
  // Drawn, but not all of it.
  const { placed: bare } = await placed(files, { file: 'package://m/bare.obj' });
  assert.equal(bare.problem, 'share/m/bare.obj names wedge.mtl, which the site does not have (R2W0743)');
  assert.equal(bare.object.children.length, 1);
});

test('what is no longer shown makes room: all that is drawn has a bound', async () => {
  const triangles = 1_200_000;
  const large = Buffer.alloc(84 + 50 * triangles);
  large.writeUInt32LE(triangles, 80);
  const come = Promise.withResolvers<void>();
  const shelf = shelfOf({ 'share/m/large.stl': large }, [], () => come.resolve());
  const wish = { file: 'package://m/large.stl', scale: [1, 1, 1], look: { color: new Color(), alpha: 1 }, ownLook: false } as const;
  const all = [shelf.place(wish)];
  await come.promise;
  all.push(shelf.place(wish), shelf.place(wish), shelf.place(wish));
  assert.deepEqual(all.map(({ problem }) => problem), ['', '', '',
    'package://m/large.stl is not drawn: all together are more than 4,000,000 triangles (R2W0743)']);
  all[0]?.close();
  all[0]?.close();
  assert.deepEqual([shelf.place(wish).problem, shelf.place(wish).object.children.length], ['', 0]);
});

test('a robot shows its meshes when they have come, and says each that is missing', async () => {
  const come = Promise.withResolvers<void>();
  const robot = new RobotModel({
    colors: { text: '#000', accent: '#fff' },
    look: {},
    keep: 1,
    meshes: shelfOf({ 'share/arm/hand.stl': asciiStl() }, [], () => come.resolve()),
  });
  const visual = (file: string): string => `<visual><geometry><mesh filename="${file}" scale="1 1 -2"/></geometry></visual>`;
  robot.take({ data: `<robot name="r"><link name="a">${visual('package://arm/hand.stl')}${visual('package://arm/foot.stl')}</link></robot>` });
  robot.build();
  await come.promise;
  const { min, max } = new Box3().setFromObject(robot.group);
  assert.deepEqual([min.z, max.z], [-3, 0]);
  assert.equal(robot.problem, 'the site has no file share/arm/foot.stl (R2W0743)');
  robot.close();
  assert.deepEqual([robot.problem, robot.group.children.length], ['', 0]);
});
