// The stage of a scene: three's renderer on a canvas, light, cameras and the ground's grid. It draws when it was asked
// to and is in sight, once per animation frame at most, and not at all otherwise.

import {
  AmbientLight,
  Color,
  DirectionalLight,
  GridHelper,
  OrthographicCamera,
  PerspectiveCamera,
  Plane,
  Raycaster,
  Scene,
  Mesh,
  MeshStandardMaterial,
  Vector2,
  Vector3,
  WebGLRenderer,
} from 'three';
import type { Intersection, Material, Object3D } from 'three';
import { eyeOf, FIELD_OF_VIEW, metresPerPixel } from '../model/camera_view.ts';
import type { CameraView } from '../model/camera_view.ts';
import type { Vector } from '../model/transform.ts';
import { disposeOf } from './dispose.ts';
import { drawsInSoftware, Resolution } from './resolution.ts';
import { castFrom, fitShadow } from './shadow.ts';
import type { PlacedLight } from './shadow.ts';

const MOST_PIXEL_RATIO = 2;
const REST_MS = 400;
/** Pixels beside a point or a line that count as on it. */
const REACH = 5;
/** Where the stage's own sun shines. */
const SUNLIGHT = new Vector3(-3, -2, -6).normalize();
const GROUND = new Plane(new Vector3(0, 0, 1), 0);

export interface StageColors {
  readonly text: string;
  readonly line: string;
  readonly accent: string;
}

export class Stage {
  readonly scene = new Scene();
  colors: StageColors;
  private readonly renderer: WebGLRenderer;
  private readonly perspective = new PerspectiveCamera((FIELD_OF_VIEW * 180) / Math.PI, 1, 0.01, 1000);
  private readonly flat = new OrthographicCamera(-1, 1, 1, -1, 0.01, 1000);
  private readonly observer: ResizeObserver;
  private grid: GridHelper | null = null;
  private gridShown = true;
  private gridHeight = 0;
  private shadows = false;
  private view: CameraView;
  /** The point around which the view is: the origin of the frame that it follows. */
  private origin: Vector = [0, 0, 0];
  private frame = 0;
  private drawings = 0;
  private readonly sun = new DirectionalLight(0xffffff, 1.6);
  private readonly back = new DirectionalLight(0xffffff, 0.5);
  /** Those of a world; without any the stage has its own. */
  private lights: readonly PlacedLight[] = [];
  private shadowsTooDear: () => void = () => undefined;
  private readonly resolution = new Resolution();
  /** Nothing moves any more: the next picture may take its time. */
  private atRest = false;
  private resting: ReturnType<typeof setTimeout> | undefined;

  private readonly canvas: HTMLCanvasElement;
  /** Over the canvas: the coarse picture, which fades where the fine one takes its place. */
  private readonly veil: HTMLCanvasElement;
  private readonly beforeDrawing: () => void;

  private constructor(
    canvas: HTMLCanvasElement,
    veil: HTMLCanvasElement,
    context: WebGL2RenderingContext,
    view: CameraView,
    beforeDrawing: () => void,
  ) {
    this.canvas = canvas;
    this.veil = veil;
    this.view = view;
    this.beforeDrawing = beforeDrawing;
    this.colors = colorsOf(canvas);
    this.renderer = new WebGLRenderer({ canvas, context });
    this.perspective.up.set(0, 0, 1);
    this.flat.up.set(0, 1, 0);
    this.sun.position.set(3, 2, 6);
    this.back.position.set(-4, -3, 2);
    this.scene.add(new AmbientLight(0xffffff, 1.5), this.sun, this.sun.target, this.back);
    this.setColors();
    this.observer = new ResizeObserver(() => this.draw());
    this.observer.observe(canvas);
    canvas.addEventListener('webglcontextrestored', this.draw);
  }

  /** null: this browser has no WebGL, or not for this page. */
  static open(canvas: HTMLCanvasElement, veil: HTMLCanvasElement, view: CameraView, beforeDrawing: () => void): Stage | null {
    const context = canvas.getContext('webgl2', { antialias: !drawsInSoftware(), alpha: true });
    return context === null ? null : new Stage(canvas, veil, context, view, beforeDrawing);
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
    this.grid.position.z = this.gridHeight;
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

  /** Taken into account by the next drawing. */
  setOrigin(origin: Vector): void {
    this.origin = origin;
  }

  /** Solid objects throw shadows and take them. `tooDear` is called when pictures with shadows take too long. */
  showShadows(shown: boolean, tooDear: () => void = () => undefined): void {
    this.shadows = shown;
    this.shadowsTooDear = tooDear;
    this.renderer.shadowMap.enabled = shown;
    this.castAll();
  }

  /** Lights of a world, whose objects the caller puts into the scene; an empty list brings the stage's own back. */
  useLights(lights: readonly PlacedLight[]): void {
    this.lights = lights;
    this.sun.visible = lights.length === 0;
    this.back.visible = lights.length === 0;
    this.castAll();
  }

  private castAll(): void {
    castFrom(this.sun, this.shadows);
    for (const { light, casts } of this.lights) castFrom(light, this.shadows && casts);
    this.scene.traverse((one) => {
      // Whether a material takes shadows, and of how many lights, is part of its program.
      if (one instanceof Mesh) { for (const each of [one.material].flat()) (each as Material).needsUpdate = true; }
    });
    this.draw();
  }

  /** The grid stands on a floor, with which its lines would compete. */
  raiseGrid(height: number): void {
    this.gridHeight = height;
    if (this.grid !== null) this.grid.position.z = height;
  }

  /** The point under one of the canvas, in the plane through `place` that faces the eye; null when there is none. */
  besideAt(x: number, y: number, place: Vector): Vector | null {
    const { ray } = this.ray(x, y);
    const plane = new Plane().setFromNormalAndCoplanarPoint(this.ahead(), new Vector3(...place));
    const met = ray.intersectPlane(plane, new Vector3());
    return met === null ? null : [met.x, met.y, met.z];
  }

  /** Into the picture, of length 1. */
  ahead(): Vector3 {
    return this.place().getWorldDirection(new Vector3());
  }

  /** Draws in the next animation frame. */
  readonly draw = (): void => {
    if (this.frame === 0) this.frame = requestAnimationFrame(this.drawNow);
  };

  /** Where a point of the canvas, in pixels from its corner, meets the ground; null when it looks past it. */
  groundAt(x: number, y: number): Vector | null {
    const met = this.ray(x, y).ray.intersectPlane(GROUND, new Vector3());
    return met === null || met.length() > 1e6 ? null : [met.x, met.y, 0];
  }

  /** The visible parts of an object under a point of the canvas, nearest first. */
  hits(x: number, y: number, object: Object3D): readonly Intersection[] {
    return this.ray(x, y).intersectObject(object, true).filter((hit) => isSeen(hit.object));
  }

  private ray(x: number, y: number): Raycaster {
    const { clientWidth, clientHeight } = this.canvas;
    const caster = new Raycaster();
    caster.setFromCamera(new Vector2((x / clientWidth) * 2 - 1, 1 - (y / clientHeight) * 2), this.place());
    const reach = REACH * metresPerPixel(this.view, clientHeight);
    caster.params.Points.threshold = reach;
    caster.params.Line.threshold = reach;
    return caster;
  }

  close(): void {
    cancelAnimationFrame(this.frame);
    clearTimeout(this.resting);
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
    this.placeLights();
    const { atRest } = this;
    this.atRest = false;
    clearTimeout(this.resting);
    if (atRest) this.coverWithLast();
    else this.veil.classList.remove('scene-veil-fading');
    const ratio = Math.min(MOST_PIXEL_RATIO, devicePixelRatio) * (atRest ? 1 : this.resolution.share);
    const size = this.renderer.getSize(new Vector2());
    if (size.x !== clientWidth || size.y !== clientHeight || this.renderer.getPixelRatio() !== ratio) {
      this.renderer.setPixelRatio(ratio);
      this.renderer.setSize(clientWidth, clientHeight, false);
    }
    const began = performance.now();
    this.renderer.render(this.scene, this.place());
    this.drawings += 1;
    this.canvas.dataset['drawings'] = String(this.drawings);
    if (atRest) return;
    // The cost of a picture is known when the page has its next frame.
    requestAnimationFrame(() => {
      if (this.resolution.tell(performance.now() - began)) this.canvas.dataset['resolution'] = this.resolution.share.toFixed(2);
      if (this.shadows && this.resolution.isPoor) this.shadowsTooDear();
    });
    if (this.resolution.share < 1) this.resting = setTimeout(this.rest, REST_MS);
  };

  /** Fits lights that shine from afar, and their shadows, to what is around the middle of the picture. */
  private placeLights(): void {
    const { target, distance } = this.view;
    const reach = Math.max(2, Math.min(40, distance * 1.5));
    const middle = new Vector3(...target).add(new Vector3(...this.origin));
    if (this.shadows) {
      this.scene.traverse((one) => {
        if (!(one instanceof Mesh) || !((one as Mesh).material instanceof MeshStandardMaterial)) return;
        const { transparent } = (one as Mesh).material as MeshStandardMaterial;
        one.castShadow = !transparent;
        one.receiveShadow = !transparent;
      });
      if (this.lights.length === 0) fitShadow(this.sun, SUNLIGHT, middle, reach);
    }
    for (const { light, ahead } of this.lights)
      if (light instanceof DirectionalLight) fitShadow(light, ahead(), middle, reach);
  }

  /** Puts the picture as it was last drawn over the canvas, from where it fades. */
  private coverWithLast(): void {
    const { canvas, veil } = this;
    // The browser may have thrown the drawing away once it was shown: it is drawn again, as coarse as it was.
    this.renderer.render(this.scene, this.place());
    [veil.width, veil.height] = [canvas.width, canvas.height];
    veil.getContext('2d')?.drawImage(canvas, 0, 0);
    veil.classList.add('scene-veil-fading');
  }

  private readonly rest = (): void => {
    this.atRest = true;
    this.draw();
  };

  /** The camera of the view, where it belongs. */
  private place(): PerspectiveCamera | OrthographicCamera {
    const { target, distance, top } = this.view;
    const aspect = this.canvas.clientWidth / Math.max(1, this.canvas.clientHeight);
    const camera = top ? this.flat : this.perspective;
    if (camera instanceof PerspectiveCamera) {
      camera.aspect = aspect;
    } else {
      camera.top = distance * Math.tan(FIELD_OF_VIEW / 2);
      camera.bottom = -camera.top;
      camera.right = camera.top * aspect;
      camera.left = -camera.right;
    }
    camera.near = distance / 100;
    camera.far = distance * 100 + 1000;
    const [x, y, z] = this.origin;
    camera.position.set(...eyeOf(this.view)).add(new Vector3(x, y, z));
    camera.lookAt(target[0] + x, target[1] + y, target[2] + z);
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

function isSeen(object: Object3D): boolean {
  for (let one: Object3D | null = object; one !== null; one = one.parent) if (!one.visible) return false;
  return true;
}
