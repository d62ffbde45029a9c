// Draws what a turtle simulator shows on a canvas of any size: the sheet with its strokes, kept apart in twice its own
// resolution, and the turtles. Draws when something has changed, at most once per frame.

import { Sheet } from '../model/turtle_scene.ts';
import type { Picture, Scene, SceneTurtle, Stroke } from '../model/turtle_scene.ts';
import { drawTurtle } from './turtle_drawing.ts';

const SCALE = 2;

export interface TurtleSheetOptions {
  readonly canvas: HTMLCanvasElement;
  /** Asks for all that was drawn; null: nobody answers. */
  readonly ask: () => Promise<Picture | null>;
  /** Called after each drawing. */
  readonly onDrawn: (scene: Scene) => void;
}

export class TurtleSheet {
  private readonly options: TurtleSheetOptions;
  private readonly paper = document.createElement('canvas');
  private readonly sheet = new Sheet();
  private readonly resized: ResizeObserver;
  private scene: Scene | null = null;
  private driven = '';
  private frame = 0;
  private closed = false;

  constructor(options: TurtleSheetOptions) {
    this.options = options;
    this.resized = new ResizeObserver(() => this.fit());
    this.resized.observe(options.canvas);
  }

  take(scene: Scene, publisher: string): void {
    this.scene = scene;
    const { cleared, strokes, ask } = this.sheet.take(scene, publisher);
    const { paper } = this;
    if (paper.width !== scene.width * SCALE || paper.height !== scene.height * SCALE) {
      paper.width = scene.width * SCALE;
      paper.height = scene.height * SCALE;
    } else if (cleared) {
      paper.getContext('2d')?.clearRect(0, 0, paper.width, paper.height);
    }
    this.pen(strokes);
    this.fit();
    this.wake();
    if (ask) void this.fill();
  }

  /** The turtle that is marked when there are several. */
  mark(name: string): void {
    this.driven = name;
    this.wake();
  }

  /** The turtle at a place of the page. */
  turtleAt(clientX: number, clientY: number): SceneTurtle | null {
    const { scene } = this;
    if (scene === null) return null;
    const box = this.options.canvas.getBoundingClientRect();
    const x = ((clientX - box.left) / box.width) * scene.width;
    const y = ((clientY - box.top) / box.height) * scene.height;
    const near = scene.turtles
      .map((turtle) => {
        const [left, top] = pixelOf(scene, turtle);
        return { turtle, far: Math.hypot(left - x, top - y) };
      })
      .filter(({ far }) => far < scene.meter * 0.8)
      .sort((a, b) => a.far - b.far);
    return near[0]?.turtle ?? null;
  }

  close(): void {
    this.closed = true;
    this.resized.disconnect();
    cancelAnimationFrame(this.frame);
  }

  /** As many pixels as the screen has there. */
  private fit(): void {
    const { canvas } = this.options;
    const width = Math.round(canvas.clientWidth * devicePixelRatio);
    const height = Math.round(canvas.clientHeight * devicePixelRatio);
    if (width === 0 || height === 0 || (canvas.width === width && canvas.height === height)) return;
    canvas.width = width;
    canvas.height = height;
    // At once: a canvas of a new size is empty.
    this.draw();
  }

  private wake(): void {
    if (this.frame !== 0 || this.closed) return;
    this.frame = requestAnimationFrame(() => {
      this.frame = 0;
      this.draw();
    });
  }

  private async fill(): Promise<void> {
    const picture = await this.options.ask().catch(() => null);
    if (this.closed) return;
    const strokes = picture === null ? null : this.sheet.takePicture(picture);
    const context = this.paper.getContext('2d');
    if (picture === null || strokes === null || context === null) {
      this.sheet.askAgain();
      return;
    }
    const pixels = document.createElement('canvas');
    pixels.width = picture.width;
    pixels.height = picture.height;
    pixels
      .getContext('2d')
      ?.putImageData(new ImageData(picture.rgba, picture.width, picture.height), 0, 0);
    context.clearRect(0, 0, this.paper.width, this.paper.height);
    context.drawImage(pixels, 0, 0, this.paper.width, this.paper.height);
    this.pen(strokes);
    this.wake();
  }

  private pen(strokes: readonly Stroke[]): void {
    const context = this.paper.getContext('2d');
    if (context === null) return;
    // Strokes count from the middle of the first pixel, a canvas from its corner.
    context.setTransform(SCALE, 0, 0, SCALE, SCALE / 2, SCALE / 2);
    context.lineCap = 'round';
    for (const stroke of strokes) {
      context.strokeStyle = stroke.color;
      context.lineWidth = Math.max(1, stroke.width);
      context.beginPath();
      context.moveTo(stroke.x1, stroke.y1);
      context.lineTo(stroke.x2, stroke.y2);
      context.stroke();
    }
    context.setTransform(1, 0, 0, 1, 0, 0);
  }

  private draw(): void {
    const { scene } = this;
    const { canvas } = this.options;
    const context = canvas.getContext('2d');
    if (scene === null || context === null || canvas.clientWidth === 0) return;
    const scale = canvas.width / scene.width;
    context.fillStyle = scene.background;
    context.fillRect(0, 0, canvas.width, canvas.height);
    context.imageSmoothingQuality = 'high';
    context.drawImage(this.paper, 0, 0, canvas.width, canvas.height);
    const unit = scene.meter * scale;
    for (const turtle of scene.turtles) {
      const [x, y] = pixelOf(scene, turtle);
      drawTurtle(context, turtle, { x: x * scale, y: y * scale }, unit);
    }
    if (scene.turtles.length > 1) this.names(context, scene, scale);
    this.options.onDrawn(scene);
  }

  /** Draws the names of all turtles when there are several; that of the driven one is bold. */
  private names(context: CanvasRenderingContext2D, scene: Scene, scale: number): void {
    const { canvas } = this.options;
    const size = Math.round(12 * devicePixelRatio);
    const half = scene.meter * scale * 0.55;
    context.textAlign = 'center';
    context.textBaseline = 'top';
    context.lineJoin = 'round';
    context.lineWidth = 3 * devicePixelRatio;
    context.strokeStyle = 'rgb(10 15 25 / 70%)';
    context.fillStyle = '#ffffff';
    for (const turtle of scene.turtles) {
      context.font = `${turtle.name === this.driven ? 700 : 400} ${size}px system-ui, sans-serif`;
      const [left, top] = pixelOf(scene, turtle);
      const room = context.measureText(turtle.name).width / 2 + 2;
      const x = Math.max(room, Math.min(left * scale, canvas.width - room));
      const below = top * scale + half;
      const y = below + size > canvas.height ? below - 2 * half - size : below;
      context.strokeText(turtle.name, x, y);
      context.fillText(turtle.name, x, y);
    }
  }
}

/** Middle of the turtle on the sheet, from its upper left corner. */
function pixelOf(scene: Scene, turtle: SceneTurtle): readonly [number, number] {
  return [turtle.x * scene.meter + 0.5, scene.height - 0.5 - turtle.y * scene.meter];
}
