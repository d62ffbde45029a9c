// What a panel is given, and what makes one: a panel is one file here and one row in index.ts.

import type { ComponentType } from 'preact';
import type { Session } from '../../wasm_js/session.ts';
import type { Store } from '../model/preferences.ts';
import type { IconName } from '../parts/icon.tsx';

/** The one node that the visitor looks at, or null for all of them. */
export interface NodeFocus {
  readonly id: string | null;
  readonly set: (id: string | null) => void;
}

export interface PanelProps {
  readonly session: Session;
  readonly focus: NodeFocus;
  readonly store: Store | null;
  /** Tells people who use a screen reader. Sparingly. */
  readonly announce: (text: string) => void;
}

export type PanelComponent = ComponentType<PanelProps>;

export interface PanelRow {
  readonly id: string;
  readonly title: string;
  readonly icon: IconName;
  /** The column it stands in when there is room for three. */
  readonly place: 'left' | 'middle' | 'right';
  /** Part of the first view; or loaded when the panel is opened. */
  readonly source:
    | { readonly kind: 'ready'; readonly component: PanelComponent }
    | { readonly kind: 'lazy'; readonly load: () => Promise<PanelComponent> };
}
