// The buttons of a scene's tools.

import type { SceneOptions } from '../model/scene_options.ts';
import type { SceneTool } from '../scene/tools.ts';
import { panelTexts } from '../texts_panels.ts';
import { sceneTexts } from '../texts_scene.ts';
import { IconButton } from './button.tsx';
import type { IconName } from './icon.tsx';

export interface SceneToolButtonsProps {
  readonly tool: SceneTool | null;
  readonly choose: (tool: SceneTool | null) => void;
  readonly options: SceneOptions;
}

export function SceneToolButtons({ tool, choose, options }: SceneToolButtonsProps) {
  const buttons: readonly (readonly [SceneTool, IconName, string])[] = [
    ['goal', 'goal', panelTexts.scene.goal(options.goal)],
    ['estimate', 'estimate', sceneTexts.tools.estimate(options.estimate)],
    ['point', 'target', sceneTexts.tools.point(options.point)],
    ['inspect', 'info', sceneTexts.tools.inspect],
    ['measure', 'ruler', sceneTexts.tools.measure],
  ];
  return (
    <>
      {buttons.map(([name, icon, label]) => (
        <IconButton
          key={name}
          icon={icon}
          label={label}
          words={sceneTexts.short[name]}
          pressed={tool === name}
          onClick={() => choose(tool === name ? null : name)}
        />
      ))}
    </>
  );
}
