// Which coordinates can be drawn.

/** Coordinates beyond this many metres are not drawn: the numbers of what stands beside them would lose their precision. */
export const FARTHEST = 1e7;

export function isPlace(x: number, y: number, z: number): boolean {
  return Math.abs(x) < FARTHEST && Math.abs(y) < FARTHEST && Math.abs(z) < FARTHEST;
}
