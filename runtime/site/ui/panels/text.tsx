// The workspace's README or lab sheet (`text` of `ui` in site.json), beside the machine that it is about.

import { useEffect, useMemo, useState } from 'preact/hooks';
import { problemOf } from '../model/problem.ts';
import { MarkdownView } from '../parts/markdown_view.tsx';
import { PanelFrame } from '../parts/panel.tsx';
import { readSiteText } from '../parts/site_text.ts';
import { usePageActions } from '../parts/use_page_actions.ts';
import { texts } from '../texts.ts';
import { panelTexts } from '../texts_panels.ts';
import type { PanelProps } from './panel_props.ts';

export function TextPanel({ session, instance, open }: PanelProps) {
  const file = session.site.ui['text'];
  const path = typeof file === 'string' ? file : null;
  const [text, setText] = useState<string | null>(null);
  const { act, said, say } = usePageActions(session, open);
  const files = useMemo(() => new Set(session.site.files.map((one) => one.path)), [session]);

  useEffect(() => {
    if (path === null || !files.has(path)) return undefined;
    let current = true;
    readSiteText(path).then(
      (found) => {
        if (current) setText(found);
      },
      (error: unknown) => {
        if (current) say(panelTexts.text.failed(problemOf(error).what));
      },
    );
    return () => {
      current = false;
    };
  }, [path, files]);

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
