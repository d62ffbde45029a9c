// A scene on a canvas: its stage, its view, the camera under the visitor's pointer, and the meshes of the site.

import { fetchOfSite } from '../../program/carried_files.ts';
import type { PageTimer, Session } from '../../contract/session.ts';
import { USUAL_VIEW } from '../model/camera_view.ts';
import type { CameraView } from '../model/camera_view.ts';
import type { TransformTree } from '../model/transform_tree.ts';
import { panelTexts } from '../texts_panels.ts';
import { controlCamera } from './camera_control.ts';
import type { CameraHost } from './camera_control.ts';
import { MeshShelf } from './mesh_shelf.ts';
import { SceneView } from './scene_view.ts';
import type { SceneHost } from './scene_view.ts';
import { Stage } from './stage.ts';

const WORDS_MS = 250;

export interface OpenScene {
  readonly view: SceneView;
  readonly stage: Stage;
  close(): void;
}

export interface SceneOpening extends Pick<SceneHost, 'showsFrame' | 'arranged'> {
  readonly session: Session;
  readonly canvas: HTMLCanvasElement;
  readonly veil: HTMLCanvasElement;
  readonly tree: TransformTree;
  readonly view: CameraView;
  /** The part of the camera's host that depends on the panel. */
  readonly hand: (scene: Pick<OpenScene, 'view' | 'stage'>) => Omit<CameraHost, 'view' | 'look' | 'home' | 'groundAt' | 'aim'>;
  /** Why nothing can be drawn; empty: it can. */
  readonly onProblem: (words: string) => void;
  /** Information in words has changed; at a pace that can be read. */
  readonly onWords: () => void;
}

/** null: this browser cannot draw it; `onProblem` was called. */
export function openScene(opening: SceneOpening): OpenScene | null {
  const { session, canvas, veil, tree, onProblem, onWords } = opening;
  let scene: SceneView | null = null;
  let alarm: PageTimer | undefined;
  const stage = Stage.open(canvas, veil, opening.view, () => scene?.arrange());
  if (stage === null) {
    onProblem(panelTexts.scene.noWebGl);
    return null;
  }
  const view = new SceneView(stage, tree, opening.view, {
    showsFrame: opening.showsFrame,
    arranged: opening.arranged,
    now: () => session.time.view().now / 1000,
    wake(at) {
      alarm?.close();
      const inMs = at * 1000 - session.time.view().now;
      alarm = session.node().timer(Math.max(10, Math.min(inMs, 1e9)), () => {
        alarm?.close();
        alarm = undefined;
        view.messageTaken();
      });
    },
  });
  scene = view;
  const stop = controlCamera(canvas, {
    view: () => view.view,
    look: (next) => view.look(next),
    home: () => view.look({ ...USUAL_VIEW, top: view.view.top }),
    groundAt: (x, y) => stage.groundAt(x, y),
    aim: (pose) => view.aim(pose),
    ...opening.hand({ view, stage }),
  });
  const lost = (): void => onProblem(panelTexts.scene.lost);
  const back = (): void => onProblem('');
  canvas.addEventListener('webglcontextlost', lost);
  canvas.addEventListener('webglcontextrestored', back);
  let told = -1;
  const timer = setInterval(() => {
    if (told !== view.version) onWords();
    told = view.version;
  }, WORDS_MS);
  return {
    view,
    stage,
    close() {
      clearInterval(timer);
      canvas.removeEventListener('webglcontextlost', lost);
      canvas.removeEventListener('webglcontextrestored', back);
      stop();
      alarm?.close();
      view.close();
    },
  };
}

/** Its meshes are files of the site. */
export function shelfOf(session: Session, view: SceneView): MeshShelf {
  const sizes = new Map(session.site.files.map(({ path, size }) => [path, size]));
  return new MeshShelf({
    size: (path) => sizes.get(path),
    async read(path) {
      const response = await fetchOfSite(path);
      if (!response.ok) throw new Error(`HTTP ${response.status}`);
      return response.arrayBuffer();
    },
  }, () => view.messageTaken());
}
