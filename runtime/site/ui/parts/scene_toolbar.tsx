// The buttons above a scene: the frame to look from, the view, the tools, and layouts of rviz.

import { fileName } from '../../contract/file_name.ts';
import { USUAL_VIEW } from '../model/camera_view.ts';
import type { SceneOptions } from '../model/scene_options.ts';
import type { Tools } from '../scene/use_tools.ts';
import { panelTexts } from '../texts_panels.ts';
import { sceneTexts } from '../texts_scene.ts';
import { IconButton } from './button.tsx';
import { MenuButton } from './menu.tsx';
import { SceneToolButtons } from './scene_tools.tsx';
import { chooseText, readSiteText } from './site_text.ts';

/** A file that the visitor or the site has. */
export type NamedText = Promise<{ readonly name: string; readonly text: string; }>;

export function siteFile(path: string): NamedText {
  return readSiteText(path).then((text) => ({ name: fileName(path), text }));
}

interface SceneToolbarProps {
  readonly options: SceneOptions;
  readonly change: (next: Partial<SceneOptions>) => void;
  /** The frames that can be chosen, and the one that is looked from now. */
  readonly frames: readonly string[];
  readonly fixed: string;
  readonly tools: Tools;
  /** Paths of the site's files of rviz. */
  readonly files: readonly string[];
  readonly showAs: (file: NamedText) => void;
  readonly forget: () => void;
}

export function SceneToolbar({ options, change, frames, fixed, tools, files, showAs, forget }: SceneToolbarProps) {
  const { short } = sceneTexts;
  return (
    <>
      <select
        class="select scene-frame"
        aria-label={panelTexts.scene.frame}
        value={options.frame}
        onChange={(event) => change({ frame: event.currentTarget.value })}
      >
        <option value="">{panelTexts.scene.usualFrame(options.frame === '' ? fixed : '')}</option>
        {frames.map((name) => (
          <option key={name} value={name}>{name}</option>
        ))}
        {options.frame === '' || frames.includes(options.frame) ? null : (
          <option value={options.frame}>{panelTexts.scene.missingFrame(options.frame)}</option>
        )}
      </select>
      <IconButton
        icon="list"
        label={panelTexts.scene.list}
        words={short.list}
        pressed={options.list}
        onClick={() => change({ list: !options.list })}
      />
      <IconButton
        icon="above"
        label={panelTexts.scene.top}
        words={short.top}
        pressed={options.view.top}
        onClick={() => change({ view: { ...options.view, top: !options.view.top } })}
      />
      <IconButton
        icon="home"
        label={panelTexts.scene.home}
        words={short.home}
        onClick={() => change({ view: { ...USUAL_VIEW, top: options.view.top } })}
      />
      <SceneToolButtons tool={tools.tool} choose={tools.choose} options={options} />
      <MenuButton
        icon="layout"
        label={panelTexts.scene.rviz}
        words={short.rviz}
        items={[
          ...files.map((path) => ({ id: path, words: fileName(path), choose: () => showAs(siteFile(path)) })),
          { id: '', words: panelTexts.scene.rvizOpen, choose: () => showAs(chooseText('.rviz')) },
        ]}
      />
      <IconButton icon="restart" label={panelTexts.scene.forget} words={short.forget} onClick={forget} />
    </>
  );
}
