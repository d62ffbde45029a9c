// The frame of a panel: a titled region with a row of tools.

import type { ComponentChildren } from 'preact';
import { Icon } from './icon.tsx';
import type { IconName } from './icon.tsx';

export interface PanelFrameProps {
  readonly id: string;
  readonly title: string;
  readonly icon: IconName;
  readonly note?: string;
  readonly tools?: ComponentChildren;
  readonly children: ComponentChildren;
}

export function PanelFrame({ id, title, icon, note, tools, children }: PanelFrameProps) {
  return (
    <section
      class={`panel panel-${id}`}
      id={`panel-${id}`}
      aria-labelledby={`panel-${id}-title`}
      tabIndex={-1}
    >
      <header class="panel-head">
        <h2 class="panel-title" id={`panel-${id}-title`}>
          <Icon name={icon} />
          {title}
          {note === undefined ? null : <span class="panel-note">{note}</span>}
        </h2>
        {tools === undefined ? null : <div class="panel-tools">{tools}</div>}
      </header>
      <div class="panel-body">{children}</div>
    </section>
  );
}
