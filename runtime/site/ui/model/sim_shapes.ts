// Models that a visitor adds to a simulated world, as SDF. Pure.

export const kSimShapes = ['box', 'sphere', 'cylinder'] as const;
export type SimShape = (typeof kSimShapes)[number];

/** Metres. */
const kSize = 0.3;
/** Kilograms. */
const kMass = 1;
const kColors: Readonly<Record<SimShape, string>> = { box: '0.85 0.33 0.2 1', sphere: '0.2 0.52 0.85 1', cylinder: '0.26 0.62 0.33 1' };

/** The height of its middle when it stands on the ground, in metres. */
export const kSimShapeHeight = kSize / 2;

const kGeometries: Readonly<Record<SimShape, string>> = {
  box: `<box><size>${kSize} ${kSize} ${kSize}</size></box>`,
  sphere: `<sphere><radius>${kSize / 2}</radius></sphere>`,
  cylinder: `<cylinder><radius>${kSize / 2}</radius><length>${kSize}</length></cylinder>`,
};

/** Solid and even, about the centre: those across and along the axis of a cylinder. */
export function momentsOf(shape: SimShape): readonly [across: number, along: number] {
  const radius = kSize / 2;
  switch (shape) {
    case 'box':
      return [(kMass * kSize * kSize) / 6, (kMass * kSize * kSize) / 6];
    case 'sphere':
      return [0.4 * kMass * radius * radius, 0.4 * kMass * radius * radius];
    case 'cylinder':
      return [(kMass * (3 * radius * radius + kSize * kSize)) / 12, 0.5 * kMass * radius * radius];
  }
}

export function sdfOf(shape: SimShape, name: string): string {
  const geometry = `<geometry>${kGeometries[shape]}</geometry>`;
  const [across, along] = momentsOf(shape);
  const color = kColors[shape];
  return `<sdf version="1.9"><model name="${name}"><link name="link">`
    + `<inertial><mass>${kMass}</mass><inertia><ixx>${across}</ixx><iyy>${across}</iyy><izz>${along}</izz></inertia></inertial>`
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
