// A button that opens a menu: arrow keys, first letters, Home, End and Escape work as menus do everywhere. A long menu
// has groups with headings, and a field to search its items.

import { useEffect, useLayoutEffect, useRef, useState } from 'preact/hooks';
import { IconWords } from './button.tsx';
import { Icon } from './icon.tsx';
import type { IconName } from './icon.tsx';
import { SearchField } from './search_field.tsx';

export interface MenuItem {
  readonly id: string;
  readonly words: string;
  readonly icon?: IconName;
  readonly disabled?: boolean;
  /** A line above it. */
  readonly apart?: boolean;
  /** Heading of the group that it belongs to; items of one group follow each other. */
  readonly group?: string;
  readonly choose: () => void;
}

export interface MenuButtonProps {
  readonly icon: IconName;
  readonly label: string;
  /** As of an IconButton. */
  readonly words?: string;
  readonly items: readonly MenuItem[];
  readonly class?: string;
  /** Label of a field that searches the items; no field without it. */
  readonly search?: string;
}

const MARGIN = 8;

export function MenuButton({ icon, label, words, items, class: extra, search }: MenuButtonProps) {
  const [open, setOpen] = useState(false);
  const button = useRef<HTMLButtonElement>(null);
  const close = (focus: boolean): void => {
    setOpen(false);
    if (focus) button.current?.focus();
  };
  return (
    <>
      <button
        type="button"
        class={`icon-button ${extra ?? ''}`}
        aria-label={label}
        title={label}
        aria-haspopup="menu"
        aria-expanded={open}
        ref={button}
        onClick={() => setOpen(!open)}
        onKeyDown={(event) => {
          if (event.key !== 'ArrowDown' || open) return;
          event.preventDefault();
          setOpen(true);
        }}
      >
        <Icon name={icon} />
        <IconWords words={words} />
      </button>
      {open ? <Menu label={label} items={items} search={search} anchor={button.current} close={close} /> : null}
    </>
  );
}

interface MenuProps {
  readonly label: string;
  readonly items: readonly MenuItem[];
  readonly search: string | undefined;
  readonly anchor: HTMLElement | null;
  readonly close: (focus: boolean) => void;
}

function Menu({ label, items, search, anchor, close }: MenuProps) {
  const list = useRef<HTMLDivElement>(null);
  const [sought, setSought] = useState('');
  const found = items.filter(({ words }) => words.toLowerCase().includes(sought.trim().toLowerCase()));
  const entries = (): HTMLElement[] => [
    ...(list.current?.querySelectorAll<HTMLElement>('[role="menuitem"]') ?? []),
  ];

  useLayoutEffect(() => {
    const box = list.current;
    if (box === null || anchor === null) return;
    const at = anchor.getBoundingClientRect();
    const left = Math.min(at.left, innerWidth - box.offsetWidth - MARGIN);
    const below = innerHeight - at.bottom - MARGIN;
    box.style.left = `${Math.max(MARGIN, left)}px`;
    if (below >= Math.min(box.scrollHeight, 160)) {
      box.style.top = `${at.bottom + 2}px`;
      box.style.maxHeight = `${below}px`;
    } else {
      box.style.bottom = `${innerHeight - at.top + 2}px`;
      box.style.maxHeight = `${at.top - MARGIN}px`;
    }
    entries()[0]?.focus();
  }, []);

  useEffect(() => {
    const outside = (event: Event): void => {
      const { target } = event;
      if (!(target instanceof Node)) return;
      if (list.current?.contains(target) !== true && anchor?.contains(target) !== true) close(false);
    };
    addEventListener('pointerdown', outside, true);
    return () => removeEventListener('pointerdown', outside, true);
  }, []);

  const onKeyDown = (event: KeyboardEvent): void => {
    const all = entries();
    const at = all.findIndex((entry) => entry === document.activeElement);
    const targets: Readonly<Record<string, number>> = {
      ArrowDown: (at + 1) % all.length,
      ArrowUp: (at + all.length - 1) % all.length,
      Home: 0,
      End: all.length - 1,
    };
    if (event.key === 'Escape' || event.key === 'Tab') {
      if (event.key === 'Escape') event.preventDefault();
      event.stopPropagation();
      close(true);
      return;
    }
    const writes = event.target instanceof HTMLInputElement;
    if (writes && event.key === 'Enter') {
      event.preventDefault();
      all[0]?.click();
      return;
    }
    if (writes && event.key !== 'ArrowDown' && event.key !== 'ArrowUp') return;
    const letter = event.key.length === 1 ? event.key.toLowerCase() : '';
    const after = [...all.slice(at + 1), ...all.slice(0, at + 1)];
    const target = all[targets[event.key] ?? -1]
      ?? (letter === '' || letter === ' '
        ? undefined
        : after.find((entry) => entry.textContent.trim().toLowerCase().startsWith(letter)));
    if (target === undefined) return;
    event.preventDefault();
    target.focus();
  };

  const entry = (item: MenuItem) => (
    <button
      type="button"
      role="menuitem"
      key={item.id}
      class={item.apart === true ? 'menu-apart' : ''}
      tabIndex={-1}
      aria-disabled={item.disabled === true ? 'true' : undefined}
      onClick={() => {
        if (item.disabled === true) return;
        close(true);
        item.choose();
      }}
    >
      {item.icon === undefined ? null : <Icon name={item.icon} />}
      {item.words}
    </button>
  );
  const groups = [...new Set(found.map(({ group }) => group))];
  return (
    <div class={`menu ${groups.length > 1 ? 'menu-grouped' : ''}`} ref={list} onKeyDown={onKeyDown}>
      {search === undefined ? null : <SearchField value={sought} label={search} onText={setSought} />}
      <div class="menu-items" role="menu" aria-label={label}>
        {groups.map((group) => {
          const own = found.filter((item) => item.group === group).map(entry);
          if (group === undefined) return own;
          return (
            <div key={group} class="menu-group" role="group" aria-label={group}>
              <span class="menu-heading" aria-hidden="true">{group}</span>
              {own}
            </div>
          );
        })}
      </div>
    </div>
  );
}
