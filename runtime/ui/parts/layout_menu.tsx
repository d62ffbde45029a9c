// The menu of the page's layout: a link to what is seen now, the same for a manifest, and the way back to the usual one.

import { copyText } from '../model/clipboard.ts';
import { texts } from '../texts.ts';
import { MenuButton } from './menu.tsx';
import type { LayoutControl } from './use_layout.ts';

export interface LayoutMenuProps {
  readonly control: LayoutControl;
  readonly announce: (text: string) => void;
}

export function LayoutMenu({ control, announce }: LayoutMenuProps) {
  const copy = async (): Promise<void> => {
    const copied = await copyText(await control.link());
    announce(copied ? texts.copied : texts.layout.linkInAddress);
  };
  const copyYaml = async (): Promise<void> => {
    announce((await copyText(control.yaml())) ? texts.copied : texts.copyFailed);
  };
  return (
    <MenuButton
      icon="layout"
      label={texts.layout.menu}
      items={[
        { id: 'link', words: texts.layout.copyLink, icon: 'link', choose: () => void copy() },
        { id: 'yaml', words: texts.layout.copyYaml, icon: 'copy', choose: () => void copyYaml() },
        { id: 'usual', words: texts.layout.usual, icon: 'restart', choose: control.reset },
      ]}
    />
  );
}
