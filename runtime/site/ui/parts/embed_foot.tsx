// Below the panels of a page that stands in another one: whose they are, and the way to the whole page.

import { useEffect, useLayoutEffect } from 'preact/hooks';
import type { Session, SiteDescription } from '../../contract/session.ts';
import type { EmbedView } from '../model/embed_link.ts';
import { readTheme } from '../model/preferences.ts';
import type { Store } from '../model/preferences.ts';
import { embedTexts as words } from '../texts_embed.ts';
import { Icon } from './icon.tsx';

/** The author's theme, or what the visitor chose on the whole page: there is no button here. */
export function useEmbedTheme(embed: EmbedView | null, store: Store | null, chosenByAuthor: unknown): void {
  useLayoutEffect(() => {
    if (embed === null) return;
    const theme = readTheme(store, chosenByAuthor);
    if (theme !== 'system') document.documentElement.dataset['theme'] = theme;
  }, [embed, store, chosenByAuthor]);
}

/** The page around the frame may ask for things. The code for that comes in a frame only. */
export function useEmbedHost(embed: EmbedView | null, session: Session, store: Store | null): void {
  useEffect(() => {
    if (embed === null || window.parent === window) return undefined;
    let close: (() => void) | null = () => undefined;
    void import('./embed_host.ts').then(({ hostEmbedding }) => {
      if (close !== null) close = hostEmbedding(session, store);
    });
    return () => {
      close?.();
      close = null;
    };
  }, [embed, session, store]);
}

/** `address` is asked when the link is used: what is shown may have changed. */
export function WholePageLink({ address, title }: { readonly address: () => string; readonly title?: string; }) {
  const renew = (event: Event): void => {
    if (event.currentTarget instanceof HTMLAnchorElement) event.currentTarget.href = address();
  };
  return (
    <a
      class="embed-whole"
      href={address()}
      target="_blank"
      rel="noopener"
      title={title}
      onClick={renew}
      onAuxClick={renew}
      onContextMenu={renew}
    >
      {words.whole}
      <Icon name="link" />
    </a>
  );
}

export function EmbedFoot({ site, whole }: { readonly site: SiteDescription; readonly whole: () => string; }) {
  const title = site.title === '' ? site.name : site.title;
  return (
    <footer class="embed-foot" aria-label={words.foot}>
      <h1 class="embed-title">{title}</h1>
      <WholePageLink address={whole} title={words.wholeLong(title)} />
    </footer>
  );
}
