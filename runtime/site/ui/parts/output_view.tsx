// The outputs of a cell: text, errors, and values in the best of their forms. All of them are hostile: they come from programs
// and files. Text becomes text nodes, drawings become images, and only the harmless parts of HTML stay.

import { styleClasses } from '../model/ansi.ts';
import { parseAnsi } from '../model/ansi.ts';
import { svgAddress } from '../model/html.ts';
import { isRecord, textMember } from '../model/json.ts';
import { joined } from '../model/notebook.ts';
import type { CellOutput } from '../model/notebook.ts';
import { viewTexts } from '../texts_views.ts';
import { HtmlView } from './html_view.tsx';
import { MarkdownView } from './markdown_view.tsx';

/** Upper bound of the characters of a text that are drawn: those at its end. */
const MOST_DRAWN = 200_000;
const BASE64 = /^[A-Za-z0-9+/=\s]*$/;

export function OutputView({ output, instance }: { readonly output: CellOutput; readonly instance: string; }) {
  switch (textMember(output, 'output_type')) {
    case 'stream':
      return <Printed text={joined(output['text'])} kind={textMember(output, 'name') === 'stderr' ? 'stderr' : 'stdout'} />;
    case 'error': {
      const traceback = output['traceback'];
      const lines = Array.isArray(traceback) ? traceback.filter((line) => typeof line === 'string').join('\n') : '';
      const what = `${textMember(output, 'ename')}: ${textMember(output, 'evalue')}`;
      return <Printed text={lines === '' ? what : lines} kind="error" />;
    }
    case 'display_data':
    case 'execute_result':
      return <Value data={output['data']} metadata={output['metadata']} instance={instance} />;
    default:
      return null;
  }
}

function Printed({ text, kind }: { readonly text: string; readonly kind: 'stdout' | 'stderr' | 'error'; }) {
  const shown = text.length > MOST_DRAWN ? text.slice(text.indexOf('\n', text.length - MOST_DRAWN) + 1) : text;
  const lines = (shown.endsWith('\n') ? shown.slice(0, -1) : shown).split('\n');
  return (
    <pre class={`printed printed-${kind}`} role={kind === 'error' ? 'alert' : undefined}>
      {shown === text ? null : <span class="hint">{`${viewTexts.notebook.begins}\n`}</span>}
      {lines.map((line, index) => [
        index === 0 ? null : '\n',
        ...parseAnsi(line).map((span) => {
          const classes = styleClasses(span.style);
          return classes === '' ? span.text : <span class={classes}>{span.text}</span>;
        }),
      ])}
    </pre>
  );
}

interface ValueProps {
  readonly data: unknown;
  readonly metadata: unknown;
  readonly instance: string;
}

const noFiles: ReadonlySet<string> = new Set();

function Value({ data, metadata, instance }: ValueProps) {
  if (!isRecord(data)) return null;
  const form = (mime: string): string | null => {
    const found = Object.hasOwn(data, mime) ? data[mime] : undefined;
    return typeof found === 'string' || Array.isArray(found) ? joined(found) : null;
  };
  const plain = form('text/plain') ?? '';
  const html = form('text/html');
  if (html !== null) return <HtmlView html={html} />;
  const markdown = form('text/markdown') ?? latex(form('text/latex'));
  if (markdown !== null)
    return (
      <div class="text value-text">
        <MarkdownView text={markdown} file="" files={noFiles} instance={instance} act={() => undefined} />
      </div>
    );
  const svg = form('image/svg+xml');
  if (svg !== null) return <img class="value-image" src={svgAddress(svg)} alt={plain} />;
  for (const mime of ['image/png', 'image/jpeg', 'image/gif', 'image/webp']) {
    const bytes = form(mime);
    if (bytes === null || !BASE64.test(bytes)) continue;
    const size = isRecord(metadata) && isRecord(metadata[mime]) ? metadata[mime] : {};
    return (
      <img
        class="value-image"
        src={`data:${mime};base64,${bytes.replace(/\s/g, '')}`}
        alt={plain}
        width={pixels(size['width'])}
        height={pixels(size['height'])}
      />
    );
  }
  const json = data['application/json'];
  if (json !== undefined && plain === '') return <Printed text={JSON.stringify(json, null, 2)} kind="stdout" />;
  return <Printed text={plain} kind="stdout" />;
}

function pixels(value: unknown): number | undefined {
  return typeof value === 'number' && value > 0 && value <= 4096 ? Math.round(value) : undefined;
}

/** As the reader of Markdown takes formulas. */
function latex(text: string | null): string | null {
  if (text === null) return null;
  const inner = text.trim().replace(/^\$+|\$+$/g, '');
  return `$$${inner}$$`;
}
