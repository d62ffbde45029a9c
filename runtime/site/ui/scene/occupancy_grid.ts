// nav_msgs/msg/OccupancyGrid as a picture on the ground, in the colours that RViz has for maps and for costmaps, with the
// parts that map_msgs/msg/OccupancyGridUpdate brings later.

import { DataTexture, DoubleSide, Group, Mesh, MeshBasicMaterial, NearestFilter, PlaneGeometry, SRGBColorSpace } from 'three';
import type { MapScheme } from '../model/display_look.ts';
import { asNumber } from '../model/field_path.ts';
import { member } from '../model/json.ts';
import { readHeader, readPose } from '../model/transform.ts';
import type { HeaderView, Transform } from '../model/transform.ts';
import { panelTexts } from '../texts_panels.ts';
import { sceneTexts } from '../texts_scene.ts';
import { isPlace } from './places.ts';
import type { Anchored, Display, DisplayContext } from './display.ts';
import { emptied } from './dispose.ts';
import { placeAt } from './shapes.ts';

/** Cells along one side that every graphics card takes; larger maps are thinned out. */
const MOST_SIDE = 4096;
const ALPHA = 0.8;

interface Grid {
  readonly header: HeaderView;
  readonly width: number;
  readonly height: number;
  readonly resolution: number;
  readonly origin: Transform;
  /** Our own: updates are written into it. */
  readonly cells: Int8Array;
}

interface Region {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

export class GridDisplay implements Display {
  readonly group = new Group();
  problem = '';
  private readonly context: DisplayContext;
  private grid: Grid | null = null;
  private texture: DataTexture | null = null;
  private step = 1;
  /** The picture must be recreated. */
  private isNew = false;
  private changed: Region[] = [];

  constructor(context: DisplayContext) {
    this.context = context;
  }

  take(message: unknown): void {
    if (member(message, 'info') === undefined && member(message, 'x') !== undefined) {
      this.update(message);
      return;
    }
    this.grid = readGrid(message);
    this.problem = this.grid === null ? panelTexts.scene.noMap : '';
    this.isNew = true;
    this.changed = [];
  }

  repaint(): void {
    this.isNew = true;
  }

  build(): undefined {
    if (this.isNew) this.rebuild();
    else if (this.changed.length > 0 && this.grid !== null && this.texture !== null) {
      for (const region of this.changed) this.paint(this.grid, this.texture, region);
      this.texture.needsUpdate = true;
    }
    this.isNew = false;
    this.changed = [];
  }

  *anchored(): Iterable<Anchored> {
    if (this.group.children.length > 0 && this.grid !== null) yield { object: this.group, header: this.grid.header };
  }

  close(): void {
    emptied(this.group);
  }

  /** Part of a map that is known. */
  private update(message: unknown): void {
    const { grid } = this;
    if (grid === null) return; // it comes whole, sooner or later
    const [x, y, width, height] = ['x', 'y', 'width', 'height'].map((name) => asNumber(member(message, name)));
    const cells = member(message, 'data');
    const fits = x !== undefined && y !== undefined && width !== undefined && height !== undefined && cells instanceof Int8Array
      && x >= 0 && y >= 0 && width > 0 && height > 0 && x + width <= grid.width && y + height <= grid.height && cells.length === width * height;
    if (!fits) {
      this.problem = sceneTexts.noMapUpdate;
      return;
    }
    for (let row = 0; row < height; row += 1)
      grid.cells.set(cells.subarray(row * width, (row + 1) * width), (y + row) * grid.width + x);
    this.changed.push({ x, y, width, height });
  }

  private rebuild(): void {
    emptied(this.group);
    this.texture = null;
    const { grid } = this;
    if (grid === null) return;
    const { width, height, resolution, origin } = grid;
    this.step = Math.ceil(Math.max(width, height) / MOST_SIDE);
    const [columns, rows] = [Math.ceil(width / this.step), Math.ceil(height / this.step)];
    const texture = new DataTexture(new Uint8Array(columns * rows * 4), columns, rows);
    texture.colorSpace = SRGBColorSpace;
    texture.magFilter = NearestFilter;
    this.paint(grid, texture, { x: 0, y: 0, width, height });
    texture.needsUpdate = true;
    this.texture = texture;
    const material = new MeshBasicMaterial({
      map: texture,
      side: DoubleSide,
      transparent: true,
      opacity: this.context.look.alpha ?? ALPHA,
      depthWrite: false,
      polygonOffset: true,
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 1,
    });
    const [along, across] = [columns * this.step * resolution, rows * this.step * resolution];
    const ground = new Mesh(new PlaneGeometry(along, across).translate(along / 2, across / 2, 0), material);
    ground.renderOrder = -1;
    placeAt(ground, origin);
    this.group.add(ground);
    this.problem = this.step > 1 ? panelTexts.scene.thinned(this.step) : '';
  }

  private paint({ cells, width }: Grid, texture: DataTexture, region: Region): void {
    const { data: pixels, width: columns } = texture.image as { readonly data: Uint8Array; readonly width: number; };
    const colors = COLORS[this.context.look.scheme ?? 'map'];
    const { step } = this;
    const first = (value: number): number => Math.ceil(value / step);
    for (let row = first(region.y); row * step < region.y + region.height; row += 1) {
      for (let column = first(region.x); column * step < region.x + region.width; column += 1) {
        const color = ((cells[row * step * width + column * step] ?? -1) & 255) * 4;
        const to = (row * columns + column) * 4;
        for (let part = 0; part < 4; part += 1) pixels[to + part] = colors[color + part] ?? 0;
      }
    }
  }
}

function readGrid(message: unknown): Grid | null {
  const info = member(message, 'info');
  const width = asNumber(member(info, 'width'));
  const height = asNumber(member(info, 'height'));
  const resolution = asNumber(member(info, 'resolution'));
  const origin = readPose(member(info, 'origin'));
  const cells = member(message, 'data');
  const isSound = cells instanceof Int8Array && Number.isInteger(width) && Number.isInteger(height) && width > 0 && height > 0
    && cells.length === width * height && resolution > 0 && origin !== null
    && isPlace(...origin.translation) && isPlace(width * resolution, height * resolution, 0);
  return isSound ? { header: readHeader(message), width, height, resolution, origin, cells: cells.slice() } : null;
}

type Color = readonly [red: number, green: number, blue: number, alpha: number];

/** Red, green, blue and alpha of each cell, by its value as an unsigned byte. */
const COLORS: Readonly<Record<MapScheme, Uint8Array>> = {
  map: paletteOf((cell) => (cell <= 100 ? gray(255 - (255 * cell) / 100) : oddColor(cell))),
  costmap: paletteOf((cell) => {
    if (cell === 0) return [0, 0, 0, 0]; // free: what is below is seen
    if (cell < 99) return [(255 * cell) / 100, 0, 255 - (255 * cell) / 100, 255];
    if (cell === 99) return [0, 255, 255, 255]; // the robot's inscribed circle
    return cell === 100 ? [255, 0, 255, 255] : oddColor(cell);
  }),
  raw: paletteOf(gray),
};

function paletteOf(color: (cell: number) => Color): Uint8Array {
  return Uint8Array.from(Array.from({ length: 256 }, (_, cell) => color(cell).map(Math.round)).flat());
}

function gray(light: number): Color {
  return [light, light, light, 255];
}

/** Values that no cell should have, green and from red to yellow; -1, as an unsigned byte 255, is not known. */
function oddColor(cell: number): Color {
  if (cell === 255) return [112, 137, 134, 255];
  return cell <= 127 ? [0, 255, 0, 255] : [255, (255 * (cell - 128)) / (254 - 128), 0, 255];
}
