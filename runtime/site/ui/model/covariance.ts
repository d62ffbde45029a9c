// How sure a pose is: of the 6 by 6 covariance of geometry_msgs/msg/PoseWithCovariance the ellipse on the ground and the
// spread of the heading, both of one standard deviation. Pure. The numbers may be anything.

import { asNumber } from './field_path.ts';

export interface Spread {
  /** Half the length of its axes in metres, the longer one first; null: it says nothing of the place. */
  readonly ellipse: { readonly radii: readonly [number, number]; readonly angle: number; } | null;
  /** Radians to either side; 0: it says nothing of the heading. */
  readonly heading: number;
}

const COUNT = 36;
/** Metres and radians: less is not to be seen, more is "unknown" rather than a measure. */
const LEAST = 1e-4;
const MOST = 1e4;

/** null: it is not covariance, or says nothing. */
export function readCovariance(value: unknown): Spread | null {
  if (!(Array.isArray(value) || value instanceof Float64Array) || value.length !== COUNT) return null;
  const at = (row: number, column: number): number => asNumber(value[row * 6 + column]);
  const ellipse = ellipseOf(at(0, 0), (at(0, 1) + at(1, 0)) / 2, at(1, 1));
  const spread = deviation(at(5, 5));
  const heading = Math.min(Math.PI, spread);
  return ellipse === null && heading === 0 ? null : { ellipse, heading };
}

/** The ellipse of a symmetric matrix: the square roots of its eigenvalues, and the direction of the first eigenvector. */
function ellipseOf(xx: number, xy: number, yy: number): Spread['ellipse'] {
  const middle = (xx + yy) / 2;
  const apart = Math.hypot((xx - yy) / 2, xy);
  const longer = deviation(middle + apart);
  if (!(middle - apart >= -1e-9 * middle) || longer === 0) return null;
  // A line in place of an ellipse would not be seen.
  const shorter = Math.max(deviation(middle - apart), longer / 1000);
  return { radii: [longer, shorter], angle: Math.atan2(2 * xy, xx - yy) / 2 };
}

function deviation(variance: number): number {
  const root = Math.sqrt(variance);
  return root >= LEAST && root <= MOST ? root : 0;
}
