// The head of the page: what this workspace is, run control for all nodes, theme, about.

import { useLayoutEffect, useState } from 'preact/hooks';
import type { Session } from '../../contract/session.ts';
import { readTheme, writePreference } from '../model/preferences.ts';
import type { Store, Theme } from '../model/preferences.ts';
import { texts } from '../texts.ts';
import { IconButton } from './button.tsx';
import { Icon, Mark } from './icon.tsx';
import { isAlive } from './node_state.tsx';
import { TimeControl } from './time_control.tsx';
import { MenuButton } from './menu.tsx';
import type { MenuItem } from './menu.tsx';
import { TabsControl, useJoin } from './tabs_control.tsx';
import { useNodes } from './watch.ts';

export interface PageHeaderProps {
  readonly session: Session;
  readonly store: Store | null;
  readonly onAbout: () => void;
  /** A phone has no room for icons with words and no tooltips: one menu has them all. */
  readonly narrow: boolean;
  readonly layoutItems: readonly MenuItem[];
}

export function PageHeader({ session, store, onAbout, narrow, layoutItems }: PageHeaderProps) {
  const nodes = useNodes(session);
  const alive = nodes.filter((node) => isAlive(node.state)).length;
  const { site, link } = session;
  const authors = site.authors.map((author) => author.name).join(', ');
  const linkName = texts.link[link];
  const theme = useThemeChoice(store, site.ui['theme']);
  const joining = useJoin(session);
  const menu = (): readonly MenuItem[] => [
    { id: 'about', words: texts.about.open, icon: 'info', choose: onAbout },
    { id: 'theme', words: theme.words, icon: theme.icon, choose: theme.change },
    ...(session.tab() === undefined ? [{ id: 'tabs', words: texts.tabs.join, icon: 'tabs', choose: joining.join } as const] : []),
    ...layoutItems.map((item, index) => (index === 0 ? { ...item, apart: true } : item)),
  ];
  return (
    <header class="head">
      <Mark />
      <div class="head-names">
        <h1 class="head-title">{site.title === '' ? site.name : site.title}</h1>
        <p class="head-facts">
          {site.version === '' ? null : <span>{texts.version(site.version)}</span>}
          {authors === '' ? null : <span>{texts.by(authors)}</span>}
        </p>
      </div>
      <div class="head-tools">
        <button
          type="button"
          class="link-chip"
          onClick={onAbout}
          title={texts.about.openLink(linkName)}
          aria-label={texts.about.openLink(linkName)}
        >
          <Icon name="link" />
          <span>{linkName}</span>
        </button>
        <TimeControl session={session} />
        <div class="head-run">
          <RunButton
            icon="play"
            words={texts.startAll}
            disabled={alive === nodes.length}
            onClick={() => session.startAll()}
            main
          />
          <RunButton
            icon="stop"
            words={texts.stopAll}
            disabled={alive === 0}
            onClick={() => session.stopAll()}
          />
          <RunButton
            icon="restart"
            words={texts.restartAll}
            disabled={alive === 0}
            onClick={() => session.restartAll()}
          />
        </div>
      </div>
      <div class="head-more">
        <TabsControl session={session} bare={narrow} {...joining} />
        {narrow
          ? (
            <MenuButton icon="more" label={texts.pageMenu} words={texts.pageMenuShort} items={menu()} />
          )
          : (
            <>
              <MenuButton icon="layout" label={texts.layout.menu} items={layoutItems} />
              <IconButton icon={theme.icon} label={theme.words} onClick={theme.change} />
              <IconButton icon="info" label={texts.about.open} onClick={onAbout} />
            </>
          )}
      </div>
    </header>
  );
}

interface RunButtonProps {
  readonly icon: 'play' | 'stop' | 'restart';
  readonly words: string;
  readonly disabled: boolean;
  readonly main?: boolean;
  readonly onClick: () => void;
}

function RunButton({ icon, words, disabled, main, onClick }: RunButtonProps) {
  return (
    <button
      type="button"
      class={`button ${main === true ? 'button-main' : ''}`}
      aria-disabled={disabled ? 'true' : undefined}
      onClick={() => {
        if (!disabled) onClick();
      }}
    >
      <Icon name={icon} />
      {words}
    </button>
  );
}

const NEXT_THEME: Readonly<Record<Theme, Theme>> = {
  system: 'light',
  light: 'dark',
  dark: 'system',
};
const THEME_ICON = { system: 'system', light: 'sun', dark: 'moon' } as const;

function useThemeChoice(store: Store | null, chosenByAuthor: unknown) {
  const [theme, setTheme] = useState<Theme>(() => readTheme(store, chosenByAuthor));
  useLayoutEffect(() => {
    if (theme === 'system') delete document.documentElement.dataset['theme'];
    else document.documentElement.dataset['theme'] = theme;
  }, [theme]);
  const change = (): void => {
    const next = NEXT_THEME[theme];
    setTheme(next);
    writePreference(store, 'theme', next);
  };
  return { icon: THEME_ICON[theme], words: texts.theme[theme], change };
}
