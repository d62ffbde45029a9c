// The problems of a scene, shown over it while its list is closed.

import { sceneTexts } from '../texts_scene.ts';

const MOST_SHOWN = 3;

export function SceneTroubles({ troubles }: { readonly troubles: readonly string[]; }) {
  const rest = troubles.length - MOST_SHOWN;
  return (
    <details class="scene-troubles" open>
      <summary>{sceneTexts.troubles(troubles.length)}</summary>
      <ul>
        {troubles.slice(0, MOST_SHOWN).map((words) => <li key={words}>{words}</li>)}
        {rest > 0 ? <li>{sceneTexts.more(rest)}</li> : null}
      </ul>
    </details>
  );
}
