// A row of a list of topics, services or actions: name and type, which open what is inside.

import type { ComponentChildren } from 'preact';
import { useEffect, useRef } from 'preact/hooks';
import { Icon } from './icon.tsx';
import { Name } from './name.tsx';

export interface GraphRowProps {
  /** The id of the element with the row's contents, unique in the page. */
  readonly id: string;
  readonly name: string;
  readonly type: string;
  /** At the end of the row. */
  readonly flow: ComponentChildren;
  readonly open: boolean;
  /** Another panel asked for it: it comes into sight. */
  readonly asked?: boolean;
  readonly onToggle: () => void;
  /** Shown while it is open; null: nothing yet. */
  readonly inside: () => ComponentChildren;
}

/** Until somebody scrolls: other rows come, what is inside is loaded, and the panel may be behind another one at first. */
function keptInSight(row: HTMLElement): () => void {
  const body = row.closest('.panel-body');
  const watch = new ResizeObserver(() => {
    // Only the panel scrolls: scrollIntoView would move the page as well.
    if (body !== null) body.scrollTop += row.getBoundingClientRect().top - body.getBoundingClientRect().top;
  });
  watch.observe(row);
  if (row.parentElement !== null) watch.observe(row.parentElement);
  const panel = row.closest('.panel');
  const ends = ['pointerdown', 'wheel', 'keydown'] as const;
  const end = (): void => {
    watch.disconnect();
    for (const name of ends) panel?.removeEventListener(name, end);
  };
  for (const name of ends) panel?.addEventListener(name, end, { passive: true });
  return end;
}

export function GraphRow({ id, name, type, flow, open, asked = false, onToggle, inside }: GraphRowProps) {
  const row = useRef<HTMLLIElement>(null);
  useEffect(() => (asked && row.current !== null ? keptInSight(row.current) : undefined), [asked]);
  const content = open ? inside() : null;
  return (
    <li class={`topic ${open ? 'topic-open' : ''}`} ref={row}>
      <button
        type="button"
        class="topic-head"
        aria-expanded={open}
        aria-controls={open ? id : undefined}
        onClick={onToggle}
      >
        <Icon name="chevron" class="topic-turn" />
        <span class="topic-names">
          <span class="topic-name">
            <Name text={name} />
          </span>
          <span class="topic-type">
            <Name text={type} />
          </span>
        </span>
        <span class="topic-flow">{flow}</span>
      </button>
      {content === null ? null : (
        <div class="topic-inside" id={id}>
          {content}
        </div>
      )}
    </li>
  );
}
