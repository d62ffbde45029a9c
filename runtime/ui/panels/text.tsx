// The workspace's README or lab sheet (`text` of `ui` in site.json), beside the machine that it is about.

import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import type { PagePublisher } from '../../wasm_js/session.ts';
import { problemOf } from '../model/problem.ts';
import type { PageAction } from '../model/page_action.ts';
import { matched } from '../parts/matched.ts';
import { codecOf } from '../parts/message_feed.ts';
import { MarkdownView } from '../parts/markdown_view.tsx';
import { PanelFrame } from '../parts/panel.tsx';
import { readSiteText } from '../parts/site_text.ts';
import { texts } from '../texts.ts';
import { panelTexts } from '../texts_panels.ts';
import type { PanelProps } from './panel_props.ts';


export function TextPanel({ session, instance, open }: PanelProps) {
  const file = session.site.ui['text'];
  const path = typeof file === 'string' ? file : null;
  const [text, setText] = useState<string | null>(null);
  const [said, setSaid] = useState('');
  const publishers = useRef(new Map<string, PagePublisher>());
  const leaving = useRef(new AbortController());
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
  useEffect(
    () => () => {
      leaving.current.abort();
      for (const publisher of publishers.current.values()) publisher.close();
    },
    [],
  );

  const publish = async (topic: string, type: string, value: string): Promise<string> => {
    const [codec, { readMessage }] = await Promise.all([
      codecOf(session),
      import('../../decode/read_yaml.ts'),
    ]);
    const known = codec.types.get(type);
    if (typeof known === 'string') return panelTexts.text.failed(known);
    const now = session.time.view().now;
    const stamp = { sec: Math.floor(now / 1000), nanosec: Math.floor((now % 1000) * 1e6) };
    const read = readMessage(value, known.shape, { now: stamp });
    if (read.kind === 'failed') return panelTexts.text.failed(read.reason);
    const made = codec.encode(type, read.value);
    if (made.kind === 'failed') return panelTexts.text.failed(`${made.path} ${made.reason}`.trim());
    const key = `${topic} ${type}`;
    const publisher = publishers.current.get(key) ?? session.node().publisher(topic, type);
    publishers.current.set(key, publisher);
    if (publisher.problem !== undefined) {
      publishers.current.delete(key);
      return panelTexts.text.failed(publisher.problem.message);
    }
    await matched(publisher);
    const problem = publisher.publish(made.bytes);
    return problem === undefined ? panelTexts.text.published(topic) : panelTexts.text.failed(problem.message);
  };

  const setParam = async (node: string, name: string, value: string): Promise<string> => {
    const { setText } = await import('../../ros2cli/parameter_calls.ts');
    const caller = { session, codec: () => codecOf(session), signal: leaving.current.signal };
    const full = node.startsWith('/') ? node : `/${node}`;
    const { successful, reason } = await setText(caller, full, name, value);
    return successful ? panelTexts.text.set(name, full) : panelTexts.text.refused(full, reason);
  };

  const act = (action: PageAction): void => {
    switch (action.kind) {
      case 'open':
        setSaid(open(action.panel, action.state ?? undefined) ? '' : panelTexts.text.noPanel(action.panel));
        return;
      case 'publish':
        publish(action.topic, action.type, action.value).then(setSaid, (error: unknown) =>
          setSaid(panelTexts.text.failed(problemOf(error).what)),
        );
        return;
      case 'set_param':
        setParam(action.node, action.name, action.value).then(setSaid, (error: unknown) =>
          setSaid(panelTexts.text.failed(problemOf(error).what)),
        );
        return;
      default: {
        const node = session
          .nodes()
          .find((one) => [one.id, one.label, one.label.replace(/^\//, '')].includes(action.node));
        if (node === undefined) {
          setSaid(panelTexts.text.noNode(action.node));
          return;
        }
        session[action.kind](node.id);
        setSaid(panelTexts.text.did[action.kind](node.label));
      }
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
