// Models that a visitor adds to a simulated world, as SDF. Pure.

export const SIM_SHAPES = ['box', 'sphere', 'cylinder'] as const;
export type SimShape = (typeof SIM_SHAPES)[number];

/** Metres. */
const SIZE = 0.3;
/** Kilograms. */
const MASS = 1;
const COLORS: Readonly<Record<SimShape, string>> = { box: '0.85 0.33 0.2 1', sphere: '0.2 0.52 0.85 1', cylinder: '0.26 0.62 0.33 1' };

/** The height of its middle when it stands on the ground, in metres. */
export const SIM_SHAPE_HEIGHT = SIZE / 2;

const GEOMETRIES: Readonly<Record<SimShape, string>> = {
  box: `<box><size>${SIZE} ${SIZE} ${SIZE}</size></box>`,
  sphere: `<sphere><radius>${SIZE / 2}</radius></sphere>`,
  cylinder: `<cylinder><radius>${SIZE / 2}</radius><length>${SIZE}</length></cylinder>`,
};

/** Solid and even, about the centre: those across and along the axis of a cylinder. */
export function momentsOf(shape: SimShape): readonly [across: number, along: number] {
  const radius = SIZE / 2;
  switch (shape) {
    case 'box':
      return [(MASS * SIZE * SIZE) / 6, (MASS * SIZE * SIZE) / 6];
    case 'sphere':
      return [0.4 * MASS * radius * radius, 0.4 * MASS * radius * radius];
    case 'cylinder':
      return [(MASS * (3 * radius * radius + SIZE * SIZE)) / 12, 0.5 * MASS * radius * radius];
  }
}

export function sdfOf(shape: SimShape, name: string): string {
  const geometry = `<geometry>${GEOMETRIES[shape]}</geometry>`;
  const [across, along] = momentsOf(shape);
  const color = COLORS[shape];
  return `<sdf version="1.9"><model name="${name}"><link name="link">`
    + `<inertial><mass>${MASS}</mass><inertia><ixx>${across}</ixx><iyy>${across}</iyy><izz>${along}</izz></inertia></inertial>`
    + `<collision name="collision">${geometry}</collision>`
    + `<visual name="visual">${geometry}<material><ambient>${color}</ambient><diffuse>${color}</diffuse></material></visual>`
    + '</link></model></sdf>';
}

/** `box`, or the first of `box_1`, `box_2` and so on that is free. */
export function freeName(shape: SimShape, taken: ReadonlySet<string>): string {
  let name: string = shape;
  for (let number = 1; taken.has(name); number += 1) name = `${shape}_${number}`;
  return name;
}
