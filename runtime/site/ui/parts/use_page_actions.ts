// The actions of a lab sheet's links, for each panel that shows one: they open panels, run lines of the terminal, act on
// nodes and on the graph. `said` is the result of the last one.

import { useEffect, useRef, useState } from 'preact/hooks';
import type { Session } from '../../contract/session.ts';
import type { PageAction } from '../model/page_action.ts';
import type { PanelProps } from '../panels/panel_props.ts';
import { panelTexts } from '../texts_panels.ts';
import { textActionTexts } from '../texts_text_actions.ts';
import { runInTerminal } from './terminal_line.ts';
import { TextActions } from './text_actions.ts';

export interface PageActions {
  readonly act: (action: PageAction) => void;
  readonly said: string;
  readonly say: (text: string) => void;
}

export function usePageActions(session: Session, open: PanelProps['open']): PageActions {
  const [said, say] = useState('');
  const actions = useRef<TextActions | null>(null);
  actions.current ??= new TextActions(session, say);
  useEffect(() => () => actions.current?.close(), []);

  const act = (action: PageAction): void => {
    switch (action.kind) {
      case 'open':
        say(open(action.panel, action.state ?? undefined) ? '' : panelTexts.text.noPanel(action.panel));
        return;
      case 'run':
        open('terminal');
        say(runInTerminal(action.line) ? textActionTexts.runs(action.line) : textActionTexts.busy);
        return;
      case 'pause':
      case 'resume':
        session.time[action.kind]();
        say(action.kind === 'pause' ? textActionTexts.paused : textActionTexts.resumed);
        return;
      case 'step':
        session.time.step(Math.round(action.ms * 1e6));
        say(textActionTexts.stepped(action.ms));
        return;
      case 'start':
      case 'stop':
      case 'restart': {
        const node = session
          .nodes()
          .find((one) => [one.id, one.label, one.label.replace(/^\//, '')].includes(action.node));
        if (node === undefined) {
          say(panelTexts.text.noNode(action.node));
          return;
        }
        session[action.kind](node.id);
        say(panelTexts.text.did[action.kind](node.label));
        return;
      }
      default:
        actions.current?.act(action);
    }
  };
  return { act, said, say };
}
