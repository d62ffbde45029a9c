// The frame of a panel: a titled region with a row of tools. The title is seen on the panel's tab.

import { createContext } from 'preact';
import type { ComponentChildren } from 'preact';
import { useContext } from 'preact/hooks';
import type { IconName } from './icon.tsx';

export interface PanelFrameProps {
  readonly id: string;
  readonly title: string;
  readonly icon: IconName;
  readonly note?: string;
  readonly tools?: ComponentChildren;
  readonly children: ComponentChildren;
}

/** The open panel around a component: its key, and its title with a number when it is not the first of its kind. */
export const OpenPanel = createContext<{ readonly key: string; readonly title: string; } | null>(
  null,
);

/** Is the panel around a component in front of the others of its group? */
export const PanelInSight = createContext(true);

export function PanelFrame({ id, title, note, tools, children }: PanelFrameProps) {
  const open = useContext(OpenPanel);
  const key = open?.key ?? id;
  const noted = note !== undefined && note !== '';
  return (
    <section
      class={`panel panel-${id}`}
      id={`panel-${key}`}
      aria-labelledby={`panel-${key}-title`}
      tabIndex={-1}
    >
      <h2 class="visually-hidden" id={`panel-${key}-title`}>
        {open?.title ?? title}
      </h2>
      {noted || tools !== undefined
        ? (
          <div class="panel-head">
            {noted ? <span class="panel-note">{note}</span> : null}
            {tools === undefined ? null : <div class="panel-tools">{tools}</div>}
          </div>
        )
        : null}
      <div class="panel-body">{children}</div>
    </section>
  );
}
