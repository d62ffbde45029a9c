// Gives back what three's objects hold in the graphics card: geometries, materials, textures.

import { Material, Texture } from 'three';
import type { Object3D } from 'three';

export function disposeOf(object: Object3D): void {
  object.traverse((one) => {
    const { geometry, material } = one as { readonly geometry?: unknown; readonly material?: unknown; };
    if (isDisposable(geometry)) geometry.dispose();
    for (const each of Array.isArray(material) ? (material as readonly unknown[]) : [material])
      if (each instanceof Material) disposeMaterial(each);
    if (isDisposable(one)) one.dispose(); // instances
  });
}

function disposeMaterial(material: Material): void {
  const { map } = material as { readonly map?: unknown; };
  if (map instanceof Texture) map.dispose();
  material.dispose();
}

function isDisposable(value: unknown): value is { readonly dispose: () => void; } {
  return typeof value === 'object' && value !== null && typeof (value as { dispose?: unknown; }).dispose === 'function';
}

/** Takes all parts out of a group for good. */
export function emptied(group: Object3D): void {
  for (const child of [...group.children]) {
    group.remove(child);
    disposeOf(child);
  }
}
