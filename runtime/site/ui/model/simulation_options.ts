// The state of a panel Simulation: its view, what is drawn, what it goes with. It comes from links too.

import { readView, writeView } from './camera_view.ts';
import type { CameraView } from './camera_view.ts';
import { flagMember, member, textMember } from './json.ts';
import type { Json } from './json.ts';
import { readImages } from './scene_options.ts';
import type { ImageOverlay } from './scene_options.ts';

export const SIM_FLAGS = ['shadows', 'grid', 'collisions', 'contacts', 'rays', 'frames', 'names'] as const;
export type SimFlag = (typeof SIM_FLAGS)[number];

export interface SimulationOptions {
  readonly view: CameraView;
  readonly flags: Readonly<Record<SimFlag, boolean>>;
  /** Is the list of models open? */
  readonly list: boolean;
  /** The link that the view goes with, `model::link`; empty: none. */
  readonly follow: string;
  readonly images: readonly ImageOverlay[];
}

const USUALLY: Readonly<Record<SimFlag, boolean>> = {
  shadows: true,
  grid: true,
  collisions: false,
  contacts: false,
  rays: false,
  frames: false,
  names: false,
};

/** `shadows`: whether they are drawn when the visitor did not choose. */
export function readSimulation(state: Json, shadows = USUALLY.shadows): SimulationOptions {
  const flag = (name: SimFlag): boolean => flagMember(state, name, name === 'shadows' ? shadows : USUALLY[name]);
  return {
    view: readView(member(state, 'view')),
    flags: {
      shadows: flag('shadows'),
      grid: flag('grid'),
      collisions: flag('collisions'),
      contacts: flag('contacts'),
      rays: flag('rays'),
      frames: flag('frames'),
      names: flag('names'),
    },
    list: flagMember(state, 'list', true),
    follow: textMember(state, 'follow'),
    images: readImages(member(state, 'images')),
  };
}

export function writeSimulation({ view, flags, list, follow, images }: SimulationOptions, shadows = USUALLY.shadows): Json {
  const usually = { ...USUALLY, shadows };
  return {
    view: writeView(view),
    list,
    ...Object.fromEntries(SIM_FLAGS.filter((name) => flags[name] !== usually[name]).map((name) => [name, flags[name]])),
    ...(follow === '' ? {} : { follow }),
    ...(images.length === 0 ? {} : { images: images.map((one) => ({ ...one })) }),
  };
}
