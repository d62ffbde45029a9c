// The stage of a scene: three's renderer on a canvas, light, cameras and the ground's grid. It draws when it was asked
// to and is in sight, once per animation frame at most, and not at all otherwise.

import {
  AmbientLight, Color, DirectionalLight, GridHelper, OrthographicCamera, PerspectiveCamera, Plane, Raycaster, Scene,
  Vector2, Vector3, WebGLRenderer,
} from 'three';
import { eyeOf, kFieldOfView } from '../model/camera_view.ts';
import type { CameraView } from '../model/camera_view.ts';
import type { Vector } from '../model/transform.ts';
import { disposeOf } from './dispose.ts';

const kMostPixelRatio = 2;
const kGround = new Plane(new Vector3(0, 0, 1), 0);

export interface StageColors {
  readonly text: string;
  readonly line: string;
  readonly accent: string;
}

export class Stage {
  readonly scene = new Scene();
  colors: StageColors;
  private readonly renderer: WebGLRenderer;
  private readonly perspective = new PerspectiveCamera((kFieldOfView * 180) / Math.PI, 1, 0.01, 1000);
  private readonly flat = new OrthographicCamera(-1, 1, 1, -1, 0.01, 1000);
  private readonly observer: ResizeObserver;
  private grid: GridHelper | null = null;
  private gridShown = true;
  private view: CameraView;
  private frame = 0;
  private drawings = 0;

  private readonly canvas: HTMLCanvasElement;
  private readonly beforeDrawing: () => void;

  private constructor(
    canvas: HTMLCanvasElement,
    context: WebGL2RenderingContext,
    view: CameraView,
    beforeDrawing: () => void,
  ) {
    this.canvas = canvas;
    this.view = view;
    this.beforeDrawing = beforeDrawing;
    this.colors = colorsOf(canvas);
    this.renderer = new WebGLRenderer({ canvas, context, antialias: true, alpha: true });
    this.perspective.up.set(0, 0, 1);
    this.flat.up.set(0, 1, 0);
    const sun = new DirectionalLight(0xffffff, 1.6);
    sun.position.set(3, 2, 6);
    const back = new DirectionalLight(0xffffff, 0.5);
    back.position.set(-4, -3, 2);
    this.scene.add(new AmbientLight(0xffffff, 1.5), sun, back);
    this.setColors();
    this.observer = new ResizeObserver(() => this.draw());
    this.observer.observe(canvas);
    canvas.addEventListener('webglcontextrestored', this.draw);
  }

  /** null: this browser has no WebGL, or not for this page. */
  static open(canvas: HTMLCanvasElement, view: CameraView, beforeDrawing: () => void): Stage | null {
    const context = canvas.getContext('webgl2', { antialias: true, alpha: true });
    return context === null ? null : new Stage(canvas, context, view, beforeDrawing);
  }

  /** The page's colours have changed, or are read for the first time. */
  setColors(): void {
    this.colors = colorsOf(this.canvas);
    if (this.grid !== null) {
      this.scene.remove(this.grid);
      disposeOf(this.grid);
    }
    const line = new Color(this.colors.line);
    this.grid = new GridHelper(20, 20, line, line);
    // Its own ground is the plane of x and z.
    this.grid.rotation.x = Math.PI / 2;
    this.grid.material.transparent = true;
    this.grid.material.opacity = 0.55;
    this.grid.visible = this.gridShown;
    this.scene.add(this.grid);
    this.draw();
  }

  showGrid(shown: boolean): void {
    this.gridShown = shown;
    if (this.grid !== null) this.grid.visible = shown;
    this.draw();
  }

  setView(view: CameraView): void {
    this.view = view;
    this.draw();
  }

  get height(): number {
    return this.canvas.clientHeight;
  }

  /** Draws in the next animation frame. */
  readonly draw = (): void => {
    if (this.frame === 0) this.frame = requestAnimationFrame(this.drawNow);
  };

  /** Where a point of the canvas, in pixels from its corner, meets the ground; null when it looks past it. */
  groundAt(x: number, y: number): Vector | null {
    const { clientWidth, clientHeight } = this.canvas;
    const caster = new Raycaster();
    const place = new Vector2((x / clientWidth) * 2 - 1, 1 - (y / clientHeight) * 2);
    caster.setFromCamera(place, this.place());
    const met = caster.ray.intersectPlane(kGround, new Vector3());
    return met === null || met.length() > 1e6 ? null : [met.x, met.y, 0];
  }

  close(): void {
    cancelAnimationFrame(this.frame);
    this.frame = -1; // nothing is drawn any more
    this.observer.disconnect();
    this.canvas.removeEventListener('webglcontextrestored', this.draw);
    disposeOf(this.scene);
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  private readonly drawNow = (): void => {
    this.frame = 0;
    const { clientWidth, clientHeight } = this.canvas;
    if (clientWidth === 0 || clientHeight === 0) return; // behind another tab; being shown resizes it
    this.beforeDrawing();
    const ratio = Math.min(kMostPixelRatio, devicePixelRatio);
    const size = this.renderer.getSize(new Vector2());
    if (size.x !== clientWidth || size.y !== clientHeight || this.renderer.getPixelRatio() !== ratio) {
      this.renderer.setPixelRatio(ratio);
      this.renderer.setSize(clientWidth, clientHeight, false);
    }
    this.renderer.render(this.scene, this.place());
    this.drawings += 1;
    this.canvas.dataset['drawings'] = String(this.drawings);
  };

  /** The camera of the view, where it belongs. */
  private place(): PerspectiveCamera | OrthographicCamera {
    const { target, distance, top } = this.view;
    const aspect = this.canvas.clientWidth / Math.max(1, this.canvas.clientHeight);
    const camera = top ? this.flat : this.perspective;
    if (camera instanceof PerspectiveCamera) {
      camera.aspect = aspect;
    } else {
      camera.top = distance * Math.tan(kFieldOfView / 2);
      camera.bottom = -camera.top;
      camera.right = camera.top * aspect;
      camera.left = -camera.right;
    }
    camera.near = distance / 100;
    camera.far = distance * 100 + 1000;
    camera.position.set(...eyeOf(this.view));
    camera.lookAt(...target);
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    return camera;
  }
}

/** The sheet of styles says them as ordinary colours, which a custom property would not resolve. */
function colorsOf(canvas: HTMLCanvasElement): StageColors {
  const { color, borderTopColor, caretColor } = getComputedStyle(canvas);
  return { text: color, line: borderTopColor, accent: caretColor };
}
