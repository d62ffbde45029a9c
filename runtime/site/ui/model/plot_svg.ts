// A plot as an SVG drawing for a paper: axes with round numbers, lines, a legend. Pure; text is escaped.

export interface Line {
  readonly name: string;
  readonly color: string;
  /** x and y of each point; a gap where either is not finite. */
  readonly points: readonly (readonly [number, number])[];
}

export interface Extent {
  readonly least: number;
  readonly most: number;
}

const WIDTH = 720;
const HEIGHT = 405;
const BOX = { left: 70, right: 16, top: 16, bottom: 46 };
const LEGEND_ROW = 18;

/** The visible part of the axes; null: all of the points. */
export interface SeenPart {
  readonly x: Extent | null;
  readonly y: Extent | null;
}

export function plotSvg(lines: readonly Line[], xTitle: string, seen: SeenPart = { x: null, y: null }): string {
  const x = seen.x ?? extentOf(lines.flatMap((line) => line.points.map(([value]) => value)));
  const y = seen.y ?? padded(extentOf(lines.flatMap((line) => line.points.map(([, value]) => value))));
  const height = HEIGHT + LEGEND_ROW * lines.length;
  const right = WIDTH - BOX.right;
  const bottom = HEIGHT - BOX.bottom;
  const atX = (value: number): number => BOX.left + ((value - x.least) / (x.most - x.least)) * (right - BOX.left);
  const atY = (value: number): number => bottom - ((value - y.least) / (y.most - y.least)) * (bottom - BOX.top);
  const parts = [
    `<svg xmlns="http://www.w3.org/2000/svg" width="${WIDTH}" height="${height}" viewBox="0 0 ${WIDTH} ${height}" font-family="sans-serif" font-size="12">`,
    `<rect width="${WIDTH}" height="${height}" fill="#ffffff"/>`,
    `<clipPath id="seen"><rect x="${BOX.left}" y="${BOX.top}" width="${right - BOX.left}" height="${bottom - BOX.top}"/></clipPath>`,
  ];
  for (const tick of ticks(x, 8)) {
    const at = fixed(atX(tick));
    parts.push(`<line x1="${at}" y1="${BOX.top}" x2="${at}" y2="${bottom}" stroke="#dddddd"/>`);
    parts.push(`<text x="${at}" y="${bottom + 16}" text-anchor="middle">${round(tick)}</text>`);
  }
  for (const tick of ticks(y, 6)) {
    const at = fixed(atY(tick));
    parts.push(`<line x1="${BOX.left}" y1="${at}" x2="${right}" y2="${at}" stroke="#dddddd"/>`);
    parts.push(`<text x="${BOX.left - 6}" y="${fixed(atY(tick) + 4)}" text-anchor="end">${round(tick)}</text>`);
  }
  parts.push(
    `<path d="M${BOX.left} ${BOX.top}V${bottom}H${right}" fill="none" stroke="#333333"/>`,
    `<text x="${(BOX.left + right) / 2}" y="${bottom + 36}" text-anchor="middle">${escaped(xTitle)}</text>`,
  );
  lines.forEach((line, index) => {
    const path = pathOf(line.points, atX, atY);
    parts.push(`<path d="${path}" fill="none" stroke="${escaped(line.color)}" stroke-width="1.5" stroke-linejoin="round" clip-path="url(#seen)"/>`);
    const row = HEIGHT + LEGEND_ROW * index;
    parts.push(
      `<rect x="${BOX.left}" y="${row}" width="14" height="4" fill="${escaped(line.color)}"/>`,
      `<text x="${BOX.left + 22}" y="${row + 7}">${escaped(line.name)}</text>`,
    );
  });
  return `${parts.join('\n')}\n</svg>\n`;
}

function pathOf(points: Line['points'], atX: (x: number) => number, atY: (y: number) => number): string {
  let pen = 'M';
  let path = '';
  for (const [x, y] of points) {
    if (!Number.isFinite(x) || !Number.isFinite(y)) {
      pen = 'M';
      continue;
    }
    path += `${pen}${fixed(atX(x))} ${fixed(atY(y))}`;
    pen = 'L';
  }
  return path;
}

/** The least and the most of the finite ones; 0 to 1 when there are none. */
export function extentOf(values: readonly number[]): Extent {
  let least = Number.POSITIVE_INFINITY;
  let most = Number.NEGATIVE_INFINITY;
  for (const value of values) {
    if (!Number.isFinite(value)) continue;
    least = Math.min(least, value);
    most = Math.max(most, value);
  }
  if (least > most) return { least: 0, most: 1 };
  if (least === most) return { least: least - 0.5, most: most + 0.5 };
  return { least, most };
}

export function padded({ least, most }: Extent): Extent {
  const room = (most - least) * 0.06;
  return { least: least - room, most: most + room };
}

/** Round numbers within the extent, about `count` of them. */
export function ticks({ least, most }: Extent, count: number): readonly number[] {
  const rough = (most - least) / count;
  if (!(rough > 0) || !Number.isFinite(rough)) return [];
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * ([1, 2, 5, 10].find((factor) => power * factor >= rough) ?? 10);
  const first = Math.ceil(least / step);
  const last = Math.floor(most / step);
  if (!(last - first < 100)) return [];
  return Array.from({ length: last - first + 1 }, (_, index) => (first + index) * step);
}

function round(value: number): string {
  return String(Number(value.toPrecision(6)));
}

function fixed(value: number): string {
  return String(Number(value.toFixed(2)));
}

function escaped(text: string): string {
  // Characters that XML has no place for are skipped.
  const plain = text.replace(/[\u0000-\u0008\u000b\u000c\u000e-\u001f]/g, '');
  return plain.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;').replaceAll('"', '&quot;');
}
