// The properties that a panel gets, and the parts of a panel: it is one file here and one row in index.ts.

import type { ComponentType } from 'preact';
import type { Session, SiteDescription } from '../../contract/session.ts';
import type { Json } from '../model/json.ts';
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
  /** Names this open panel among all: a panel may be open more than once. Fit for the id of an element. */
  readonly instance: string;
  /**
   * The state that the panel needs to look the same when the page or a link is opened again: small (below 8 KiB as JSON), null
   * at first. It comes from links too, so read it as hostile: the readers in model/json.ts help.
   */
  readonly state: Json;
  readonly setState: (state: Json) => void;
  /** The visitor has just opened it by the "+" menu: it may take the keyboard. */
  readonly justAdded: boolean;
  /**
   * Shows a panel: with a state, the one that has it, or else a new one with it; without, any of its kind, or else a
   * new one. False when there is no panel of that id.
   */
  readonly open: (panelId: string, state?: Json) => boolean;
}

export type PanelComponent = ComponentType<PanelProps>;

export type PanelGroup = 'run' | 'see' | 'act' | 'files';

export interface PanelRow {
  /** Small letters and underscores. It stands in links and manifests, and never changes. */
  readonly id: string;
  readonly title: string;
  readonly icon: IconName;
  /** Where it stands in the "+" menu. */
  readonly group: PanelGroup;
  /** Whether this site can use it; every site can without. The "+" menu has only those. */
  readonly fits?: (site: SiteDescription) => boolean;
  /** May be open more than once, each with a state of its own. */
  readonly many?: boolean;
  /** Goes on while another tab is in front of it, once it was seen. */
  readonly keeps?: boolean;
  /** With that state it gathers what comes from early on, also before it is first seen. It `keeps` too. */
  readonly collects?: (state: Json) => boolean;
  /** A visitor looks at it while using other panels: one that opens does not cover it. */
  readonly watched?: boolean;
  /** Part of the usual layout of some sites: a text to read first, something to look at above the consoles, or a list. */
  readonly usual?: {
    readonly place: 'guide' | 'stage' | 'list';
    readonly when: (site: SiteDescription) => boolean;
  };
  /** Part of the first view; or loaded when the panel is opened. */
  readonly source:
    | { readonly kind: 'ready'; readonly component: PanelComponent; }
    | {
      readonly kind: 'lazy';
      readonly load: () => Promise<PanelComponent>;
      /** It needs no styles but those of the first view. */
      readonly plain?: boolean;
    };
}
