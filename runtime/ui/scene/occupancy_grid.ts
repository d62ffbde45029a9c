// nav_msgs/msg/OccupancyGrid as a picture on the ground: free is white, occupied black, unknown grey-green.

import { DataTexture, DoubleSide, Mesh, MeshBasicMaterial, NearestFilter, PlaneGeometry, SRGBColorSpace } from 'three';
import { asNumber } from '../model/field_path.ts';
import { member } from '../model/json.ts';
import { readPose } from '../model/transform.ts';
import { panelTexts } from '../texts_panels.ts';
import { isPlace } from './display.ts';
import type { Built } from './newest_display.ts';
import { placeAt } from './shapes.ts';

/** Cells along one side that every graphics card takes; larger maps are thinned out. */
const kMostSide = 4096;

export function occupancyGrid(message: unknown): Built {
  const info = member(message, 'info');
  const width = asNumber(member(info, 'width'));
  const height = asNumber(member(info, 'height'));
  const resolution = asNumber(member(info, 'resolution'));
  const origin = readPose(member(info, 'origin'));
  const cells = member(message, 'data');
  const isSound =
    cells instanceof Int8Array && Number.isInteger(width) && Number.isInteger(height) && width > 0 && height > 0 &&
    cells.length === width * height && resolution > 0 && origin !== null &&
    isPlace(...origin.translation) && isPlace(width * resolution, height * resolution, 0);
  if (!isSound) return { object: null, problem: panelTexts.scene.noMap };

  const step = Math.ceil(Math.max(width, height) / kMostSide);
  const [columns, rows] = [Math.ceil(width / step), Math.ceil(height / step)];
  const pixels = new Uint8Array(columns * rows * 4);
  for (let row = 0; row < rows; row += 1)
    for (let column = 0; column < columns; column += 1)
      pixels.set(colorOf(cells[row * step * width + column * step] ?? -1), (row * columns + column) * 4);
  const texture = new DataTexture(pixels, columns, rows);
  texture.colorSpace = SRGBColorSpace;
  texture.magFilter = NearestFilter;
  texture.needsUpdate = true;
  const material = new MeshBasicMaterial({
    map: texture, side: DoubleSide, transparent: true, opacity: 0.8, depthWrite: false, polygonOffset: true,
    polygonOffsetFactor: 1, polygonOffsetUnits: 1,
  });
  const [along, across] = [columns * step * resolution, rows * step * resolution];
  const ground = new Mesh(new PlaneGeometry(along, across).translate(along / 2, across / 2, 0), material);
  ground.renderOrder = -1;
  if (origin !== null) placeAt(ground, origin);
  return { object: ground, problem: step > 1 ? panelTexts.scene.thinned(step) : '' };
}

function colorOf(cell: number): readonly [number, number, number, number] {
  if (cell < 0 || cell > 100) return [112, 137, 134, 255];
  const light = Math.round(255 * (1 - cell / 100));
  return [light, light, light, 255];
}
