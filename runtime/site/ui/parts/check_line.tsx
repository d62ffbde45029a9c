// One check of a list: its title and state, the value that was seen, and where the manifest declares it.

import type { ComponentChildren } from 'preact';
import type { SourcePlace } from '../../contract/session.ts';
import { placeText } from '../model/problem.ts';
import { texts } from '../texts.ts';
import { Icon } from './icon.tsx';
import type { IconName } from './icon.tsx';
import { Name } from './name.tsx';

export interface CheckLook {
  readonly words: string;
  readonly icon: IconName;
  /** The end of a class of colours: `state-good`. */
  readonly tone: string;
}

export interface CheckLineProps {
  readonly kind: string;
  readonly title: string;
  readonly look: CheckLook;
  readonly seen: string;
  readonly source: SourcePlace | undefined;
  /** Beside the state. */
  readonly children?: ComponentChildren;
}

export function CheckLine({ kind, title, look, seen, source, children }: CheckLineProps) {
  return (
    <li class={kind}>
      <p class="check-title">
        <Name text={title} />
      </p>
      <p class="node-state">
        <span class={`state state-${look.tone}`}>
          <Icon name={look.icon} />
          {look.words}
        </span>
        {children}
      </p>
      <p class="node-facts">
        <span class="check-seen">{seen}</span>
        {source === undefined ? null : (
          <span class="node-place" title={texts.nodes.declared}>
            {placeText(source)}
          </span>
        )}
      </p>
    </li>
  );
}
