// The workspace's README or lab sheet (`text` of `ui` in site.json), beside the machine that it is about.

import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import { problemOf } from '../model/problem.ts';
import type { PageAction } from '../model/page_action.ts';
import { MarkdownView } from '../parts/markdown_view.tsx';
import { PanelFrame } from '../parts/panel.tsx';
import { readSiteText } from '../parts/site_text.ts';
import { runInTerminal } from '../parts/terminal_line.ts';
import { TextActions } from '../parts/text_actions.ts';
import { texts } from '../texts.ts';
import { panelTexts } from '../texts_panels.ts';
import { textActionTexts } from '../texts_text_actions.ts';
import type { PanelProps } from './panel_props.ts';

export function TextPanel({ session, instance, open }: PanelProps) {
  const file = session.site.ui['text'];
  const path = typeof file === 'string' ? file : null;
  const [text, setText] = useState<string | null>(null);
  const [said, setSaid] = useState('');
  const actions = useRef<TextActions | null>(null);
  actions.current ??= new TextActions(session, setSaid);
  const files = useMemo(() => new Set(session.site.files.map((one) => one.path)), [session]);

  useEffect(() => {
    if (path === null || !files.has(path)) return undefined;
    let current = true;
    readSiteText(path).then(
      (found) => {
        if (current) setText(found);
      },
      (error: unknown) => {
        if (current) setSaid(panelTexts.text.failed(problemOf(error).what));
      },
    );
    return () => {
      current = false;
    };
  }, [path, files]);
  useEffect(() => () => actions.current?.close(), []);

  const act = (action: PageAction): void => {
    switch (action.kind) {
      case 'open':
        setSaid(open(action.panel, action.state ?? undefined) ? '' : panelTexts.text.noPanel(action.panel));
        return;
      case 'run':
        open('terminal');
        setSaid(runInTerminal(action.line) ? textActionTexts.runs(action.line) : textActionTexts.busy);
        return;
      case 'pause':
      case 'resume':
        session.time[action.kind]();
        setSaid(action.kind === 'pause' ? textActionTexts.paused : textActionTexts.resumed);
        return;
      case 'step':
        session.time.step(Math.round(action.ms * 1e6));
        setSaid(textActionTexts.stepped(action.ms));
        return;
      case 'start':
      case 'stop':
      case 'restart': {
        const node = session
          .nodes()
          .find((one) => [one.id, one.label, one.label.replace(/^\//, '')].includes(action.node));
        if (node === undefined) {
          setSaid(panelTexts.text.noNode(action.node));
          return;
        }
        session[action.kind](node.id);
        setSaid(panelTexts.text.did[action.kind](node.label));
        return;
      }
      default:
        actions.current?.act(action);
    }
  };

  return (
    <PanelFrame id="text" title={texts.panels.text} icon="text">
      {path === null || !files.has(path) ? <p class="hint">{panelTexts.text.none}</p> : null}
      {text === null || path === null ? null : (
        <div class="text" role="group" aria-label={texts.panels.text} tabIndex={0}>
          <MarkdownView text={text} file={path} files={files} instance={instance} act={act} />
        </div>
      )}
      <p class="text-said" role="status">
        {said}
      </p>
    </PanelFrame>
  );
}
