// A turtle seen from above, drawn by lines: one unit long, in ten looks.

import type { SceneTurtle } from '../model/turtle_scene.ts';

interface Look {
  readonly shell: string;
  readonly rim: string;
  readonly skin: string;
}

const LOOKS: readonly Look[] = [
  { shell: '#3fae5a', rim: '#1c6631', skin: '#b9e38c' },
  { shell: '#dd5a3c', rim: '#86290f', skin: '#f6c783' },
  { shell: '#ecba31', rim: '#8f6306', skin: '#f9e8a8' },
  { shell: '#25aaa4', rim: '#0c5a5b', skin: '#a5e8d8' },
  { shell: '#a268d6', rim: '#562a80', skin: '#e6c0f4' },
  { shell: '#f28d2e', rim: '#964808', skin: '#ffdca6' },
  { shell: '#e870a9', rim: '#8b2b5a', skin: '#ffd3e2' },
  { shell: '#8c9aad', rim: '#414e64', skin: '#e0e6ef' },
  { shell: '#9fca40', rim: '#4f700c', skin: '#e7f6ae' },
  { shell: '#a57349', rim: '#523319', skin: '#e9cea8' },
];

/** `at` in pixels of the drawing, `unit` in pixels. */
export function drawTurtle(
  context: CanvasRenderingContext2D,
  turtle: SceneTurtle,
  at: { readonly x: number; readonly y: number; },
  unit: number,
): void {
  const look = LOOKS[Math.abs(Math.floor(turtle.shape)) % LOOKS.length] ?? LOOKS[0];
  if (look === undefined) return;
  context.save();
  context.translate(at.x, at.y);
  context.rotate(-turtle.theta);
  context.scale(unit, unit);
  context.lineJoin = 'round';
  context.lineCap = 'round';
  context.lineWidth = 0.035;
  context.strokeStyle = look.rim;
  context.fillStyle = look.skin;
  for (const side of [1, -1]) {
    paint(context, flipper(side, [0.16, 0.2], [0.3, 0.52], [0.05, 0.5], [0, 0.24]));
    paint(context, flipper(side, [-0.14, 0.2], [-0.2, 0.44], [-0.43, 0.38], [-0.32, 0.1]));
  }
  const tail = new Path2D();
  tail.moveTo(-0.34, 0.06);
  tail.quadraticCurveTo(-0.5, 0.03, -0.52, 0);
  tail.quadraticCurveTo(-0.5, -0.03, -0.34, -0.06);
  paint(context, tail);
  const head = new Path2D();
  head.ellipse(0.4, 0, 0.14, 0.115, 0, 0, 2 * Math.PI);
  paint(context, head);
  drawShell(context, look);
  context.fillStyle = '#1a202b';
  for (const side of [1, -1]) {
    context.beginPath();
    context.arc(0.45, side * 0.058, 0.023, 0, 2 * Math.PI);
    context.fill();
  }
  context.restore();
}

type Point = readonly [number, number];

function flipper(side: number, shoulder: Point, front: Point, tip: Point, back: Point): Path2D {
  const path = new Path2D();
  path.moveTo(shoulder[0], side * shoulder[1]);
  path.quadraticCurveTo(front[0], side * front[1], tip[0], side * tip[1]);
  path.quadraticCurveTo(back[0] + 0.06, side * (back[1] + 0.14), back[0], side * back[1]);
  path.closePath();
  return path;
}

/** A rim, and on it a row of plates with seams to the side. */
function drawShell(context: CanvasRenderingContext2D, look: Look): void {
  const shell = new Path2D();
  shell.moveTo(0.32, 0);
  shell.bezierCurveTo(0.32, 0.28, -0.22, 0.38, -0.36, 0);
  shell.bezierCurveTo(-0.22, -0.38, 0.32, -0.28, 0.32, 0);
  context.fillStyle = look.shell;
  paint(context, shell);
  context.save();
  context.lineWidth = 0.028;
  const plates = new Path2D();
  for (const [x, half] of [[0.17, 0.07], [0, 0.09], [-0.18, 0.075]] as const) {
    const reach = 0.085;
    plates.moveTo(x + reach, 0);
    for (const [dx, dy] of [[0.5, 1], [-0.5, 1], [-1, 0], [-0.5, -1], [0.5, -1], [1, 0]] as const)
      plates.lineTo(x + dx * reach, dy * half);
  }
  for (const side of [1, -1]) {
    for (const [x, y, dx] of [[0.21, 0.07, 0.03], [0.085, 0.08, 0], [-0.09, 0.085, -0.02], [-0.22, 0.075, -0.05]] as const) {
      plates.moveTo(x, side * y);
      plates.lineTo(x + dx, side * 0.21);
    }
  }
  context.clip(shell);
  context.globalAlpha = 0.75;
  context.stroke(plates);
  context.restore();
}

function paint(context: CanvasRenderingContext2D, path: Path2D): void {
  context.fill(path);
  context.stroke(path);
}
