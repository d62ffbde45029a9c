// Meshes in the 3D view, in Chromium: all formats with their colours, and files that are hostile.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import { asciiStl, binaryStl, collada, gltf, gltfNumbers, MATERIALS, WEDGE_TRIANGLES, obj } from '../../support/wedge_meshes.ts';
import { SOFTWARE_WEB_GL } from '../support/chromium.ts';
import { PageStage } from '../support/page_stage.ts';
import { pixels } from '../support/scene_pixels.ts';

const OUTPUT = fileURLToPath(new URL('../../output', import.meta.url));
const EXPECTED = /GL Driver Message|GPU stall|status of 404/;
// A picture of one green pixel.
const GREEN = Buffer.from('iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR42mNg2MIAAAFsALUvuW7EAAAAAElFTkSuQmCC', 'base64');
let stage: PageStage;

before(async () => {
  stage = await PageStage.open(SOFTWARE_WEB_GL);
});

after(() => stage.close());

const DOUBLED = Array.from({ length: 40 },
  (_, i) => `<node id="n${i}">${i === 39 ? '<instance_geometry url="#g"/>' : `<instance_node url="#n${i + 1}"/><instance_node url="#n${i + 1}"/>`}</node>`)
  .join('');

const FILES: Readonly<Record<string, string | Buffer>> = {
  'wedge.stl': asciiStl(),
  'wedge.bin.stl': binaryStl(),
  'wedge.dae': collada(),
  'wedge.obj': obj(),
  'wedge.mtl': MATERIALS,
  'wedge.gltf': gltf(),
  'wedge.bin': gltfNumbers(),
  'green.png': GREEN,
  'skin.dae': collada('green.png'),
  'cut.stl': binaryStl(WEDGE_TRIANGLES + 5),
  'loop.dae': collada('', DOUBLED),
  'far.obj': obj([[NaN, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 0, 1]]),
  'many.stl': Buffer.concat([Buffer.alloc(84, 255), Buffer.alloc(100)]),
  'wrong.gltf': '{"asset": 7',
  'words.dae': '<!DOCTYPE r [<!ENTITY a "b">]><COLLADA>&a;</COLLADA>',
  'away.dae': collada('https://example.org/skin.png'),
};

function on(body: (page: Page, asked: readonly string[]) => Promise<void>): Promise<void> {
  const state = { grid: false, frames: false, names: false, view: { distance: 9 } };
  const layout = JSON.stringify({ row: ['nodes', { scene: state }], sizes: [1, 4], shown: 'scene' });
  return stage.on('world', {}, async (page) => {
    const asked: string[] = [];
    await page.route('**/share/meshes/*', (route) => {
      const name = route.request().url().split('/').at(-1) ?? '';
      asked.push(name);
      const file = FILES[name];
      return file === undefined ? route.fulfill({ status: 404 }) : route.fulfill({ body: file });
    });
    await page.goto(`${stage.served.url}?scene=world#layout=${encodeURIComponent(layout)}`);
    await page.reload(); // with another fragment alone nothing is loaded
    await page.locator('.scene-canvas').waitFor();
    await body(page, asked);
  }, EXPECTED);
}

async function robot(page: Page, files: readonly string[]): Promise<void> {
  const visuals = files.map((file, index) =>
    `<visual><origin xyz="0 ${
      (index - (files.length - 1) / 2) * 2.2
    } 0"/><geometry><mesh filename="${file}"/></geometry><material name="red"><color rgba="0.9 0 0 1"/></material></visual>`
  );
  const data = `<robot name="r"><link name="map">${visuals.join('')}</link></robot>`;
  await page.evaluate((text) => globalThis.send('/robot_description', 'std_msgs/msg/String', { data: text }), data);
}

async function seen(page: Page, kind: 'red' | 'green' | 'blue'): Promise<void> {
  while ((await pixels(page, kind)) < 300);
}

test('a robot and markers show meshes of all formats with their colours', () =>
  on(async (page) => {
    for (
      const [file, color] of [
        ['wedge.stl', 'red'],
        ['wedge.dae', 'green'],
        ['wedge.obj', 'blue'],
        ['wedge.gltf', 'red'],
        ['skin.dae', 'green'],
        ['wedge.bin.stl', 'red'],
      ] as const
    ) {
      await robot(page, [`package://meshes/${file}`]);
      await seen(page, color);
    }
    await robot(page, ['wedge.stl', 'wedge.dae', 'wedge.obj', 'wedge.gltf'].map((file) => `package://meshes/${file}`));
    for (const color of ['red', 'green', 'blue'] as const) await seen(page, color);
    assert.equal(await page.locator('.scene-problem').count(), 0);
    await page.locator('.scene-canvas').screenshot({ path: join(OUTPUT, 'scene_meshes.png') });
    await robot(page, []);
    while ((await pixels(page, 'green')) > 0);
    const marker = async (embedded: boolean): Promise<void> => {
      await page.evaluate((own) => {
        const still = { x: 0, y: 0, z: 0 };
        const header = { stamp: { sec: 1, nanosec: 0 }, frame_id: 'map' };
        globalThis.send('/markers', 'visualization_msgs/msg/MarkerArray', {
          markers: [{
            header,
            ns: '',
            id: 1,
            type: 10,
            action: 0,
            pose: { position: still, orientation: { ...still, w: 1 } },
            scale: { x: 1, y: 1, z: 1 },
            color: { r: 0, g: 0, b: 1, a: 1 },
            lifetime: { sec: 0, nanosec: 0 },
            frame_locked: false,
            points: [],
            colors: [],
            texture_resource: '',
            texture: { header, format: '', data: [] },
            uv_coordinates: [],
            text: '',
            mesh_resource: 'package://meshes/wedge.dae',
            mesh_file: { filename: '', data: [] },
            mesh_use_embedded_materials: own,
          }],
        });
      }, embedded);
    };
    while ((await pixels(page, 'blue')) < 300) await marker(false);
    assert.ok((await pixels(page, 'green')) < 100);
    while ((await pixels(page, 'green')) < 300) await marker(true);
  }));

// Guarantee, hostile input: meshes of hostile files end in words, not in hanging or requests to elsewhere, and meshes
// that the site lacks are named
test('hostile meshes end in words with a code', () =>
  on(async (page, asked) => {
    const problem = page.locator('.scene-problem');
    for (
      const [file, words] of [
        ['https://example.org/wedge.stl', 'https://example.org/wedge.stl is not drawn: only files of the site are'],
        ['package://meshes/none.stl', 'the site has no file share/meshes/none.stl'],
        ['package://meshes/gone.stl', 'package://meshes/gone.stl cannot be read: HTTP 404'],
        ['package://meshes/cut.stl', 'its length does not fit its count of triangles'],
        ['package://meshes/many.stl', 'its length does not fit its count of triangles'],
        ['package://meshes/loop.dae', 'more than 2,000,000 triangles'],
        ['package://meshes/far.obj', 'a coordinate in it is not a number'],
        ['package://meshes/wrong.gltf', 'it is not a valid glTF document'],
        ['package://meshes/words.dae', 'it is not a COLLADA document'],
        ['package://meshes/<img src=x onerror=alert(1)>.stl'.replaceAll('<', '&lt;'), '<img src=x onerror=alert(1)>.stl'],
      ] as const
    ) {
      await robot(page, [file]);
      await problem.getByText(words).waitFor();
      assert.match((await problem.textContent()) ?? '', /\(R2W0743\)$/);
    }
    // Its picture is not fetched: requests to elsewhere fail the page. The rest is drawn.
    await robot(page, ['package://meshes/away.dae']);
    await problem.getByText('names https://example.org/skin.png, which the site does not have (R2W0743)').waitFor();
    assert.ok(!asked.includes('none.stl'));
  }));
