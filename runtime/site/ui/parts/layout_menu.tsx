// The items of the menu of the page's layout: a link to what is seen now, the same for a manifest, the way back to the usual one, and
// whether nodes and checks show where the manifest declares them, which authors want to know and students do not.

import { useLayoutEffect, useState } from 'preact/hooks';
import { copyText } from '../model/clipboard.ts';
import { readPreference, writePreference } from '../model/preferences.ts';
import type { Store } from '../model/preferences.ts';
import { texts } from '../texts.ts';
import type { MenuItem } from './menu.tsx';
import type { LayoutControl } from './use_layout.ts';

const SHOWN = ['no', 'yes'] as const;

export function useLayoutItems(control: LayoutControl, store: Store | null, announce: (text: string) => void): readonly MenuItem[] {
  const [places, setPlaces] = useState(() => readPreference(store, 'places', SHOWN, 'no') === 'yes');
  useLayoutEffect(() => void document.documentElement.toggleAttribute('data-places', places), [places]);
  const togglePlaces = (): void => {
    setPlaces(!places);
    writePreference(store, 'places', places ? 'no' : 'yes');
  };
  const copy = async (): Promise<void> => {
    const copied = await copyText(await control.link());
    announce(copied ? texts.copied : texts.layout.linkInAddress);
  };
  const copyYaml = async (): Promise<void> => {
    announce((await copyText(control.yaml())) ? texts.copied : texts.copyFailed);
  };
  return [
    { id: 'link', words: texts.layout.copyLink, icon: 'link', choose: () => void copy() },
    { id: 'yaml', words: texts.layout.copyYaml, icon: 'copy', choose: () => void copyYaml() },
    { id: 'usual', words: texts.layout.usual, icon: 'restart', choose: control.reset },
    { id: 'places', words: places ? texts.layout.hidePlaces : texts.layout.showPlaces, icon: 'code', apart: true, choose: togglePlaces },
  ];
}
