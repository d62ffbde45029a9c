// Lights of a scene that cast shadows: their maps, and what those cover.

import { DirectionalLight, SpotLight } from 'three';
import type { Light, Vector3 } from 'three';
import { drawsInSoftware } from './resolution.ts';

export interface PlacedLight {
  readonly light: Light;
  readonly casts: boolean;
  /** Where it shines, of length 1, as it is placed now. */
  readonly ahead: () => Vector3;
}

export function castFrom(light: Light, on: boolean): void {
  light.castShadow = on;
  if (!on || !(light instanceof DirectionalLight || light instanceof SpotLight)) return;
  const side = drawsInSoftware() ? 1024 : 2048;
  light.shadow.mapSize.set(side, side);
  light.shadow.bias = -0.0005;
  light.shadow.normalBias = 0.01;
}

/** A light from afar: its shadows are those of what is at most `reach` metres from the middle. */
export function fitShadow(light: DirectionalLight, ahead: Vector3, middle: Vector3, reach: number): void {
  light.target.position.copy(middle);
  light.position.copy(middle).addScaledVector(ahead, -4 * reach);
  light.target.updateMatrixWorld();
  const { camera } = light.shadow;
  [camera.left, camera.right, camera.bottom, camera.top] = [-reach, reach, -reach, reach];
  [camera.near, camera.far] = [0.1 * reach, 8 * reach];
  camera.updateProjectionMatrix();
}
