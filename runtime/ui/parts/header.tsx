// The head of the page: what this workspace is, run control for all nodes, theme, about.

import type { ComponentChildren } from 'preact';
import { useLayoutEffect, useState } from 'preact/hooks';
import type { Session } from '../../wasm_js/session.ts';
import { readTheme, writePreference } from '../model/preferences.ts';
import type { Store, Theme } from '../model/preferences.ts';
import { texts } from '../texts.ts';
import { IconButton } from './button.tsx';
import { Icon, Mark } from './icon.tsx';
import { isAlive } from './node_state.tsx';
import { TimeControl } from './time_control.tsx';
import { TabsControl } from './tabs_control.tsx';
import { useNodes } from './watch.ts';

export interface PageHeaderProps {
  readonly session: Session;
  readonly store: Store | null;
  readonly onAbout: () => void;
  /** Buttons of the page itself, beside the theme's. */
  readonly children?: ComponentChildren;
}

export function PageHeader({ session, store, onAbout, children }: PageHeaderProps) {
  const nodes = useNodes(session);
  const alive = nodes.filter((node) => isAlive(node.state)).length;
  const { site, link } = session;
  const authors = site.authors.map((author) => author.name).join(', ');
  const linkName = texts.link[link];
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
        <TabsControl session={session} />
        {children}
        <ThemeButton store={store} chosenByAuthor={site.ui['theme']} />
        <IconButton icon="info" label={texts.about.open} onClick={onAbout} />
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

const kNextTheme: Readonly<Record<Theme, Theme>> = {
  system: 'light',
  light: 'dark',
  dark: 'system',
};
const kThemeIcon = { system: 'system', light: 'sun', dark: 'moon' } as const;

function ThemeButton({
  store,
  chosenByAuthor,
}: {
  readonly store: Store | null;
  readonly chosenByAuthor: unknown;
}) {
  const [theme, setTheme] = useState<Theme>(() => readTheme(store, chosenByAuthor));
  useLayoutEffect(() => {
    if (theme === 'system') delete document.documentElement.dataset['theme'];
    else document.documentElement.dataset['theme'] = theme;
  }, [theme]);
  const change = (): void => {
    const next = kNextTheme[theme];
    setTheme(next);
    writePreference(store, 'theme', next);
  };
  return <IconButton icon={kThemeIcon[theme]} label={texts.theme[theme]} onClick={change} />;
}
