// The text that a visitor can paste into a bug report. Holds no console text and no messages.

import type { Session } from '../../contract/session.ts';
import { placeText } from './problem.ts';

export function siteReport(session: Session, userAgent: string, isolated: boolean): string {
  const { site, link } = session;
  const nodes = session.nodes().map((node) => {
    const state = node.state.kind === 'exited'
      ? `exited ${node.state.code}`
      : node.state.kind === 'crashed'
      ? `crashed ${node.state.code}: ${node.state.message}`
      : node.state.kind;
    const place = node.source === undefined ? '' : ` (${placeText(node.source)})`;
    return `  ${node.id} ${node.label}${place}: ${state}`;
  });
  return [
    `site: ${site.name} ${site.version} (${site.distro}), made with ${site.generator}`,
    `link: ${link}, isolated: ${isolated ? 'yes' : 'no'}`,
    `browser: ${userAgent}`,
    'nodes:',
    ...nodes,
    ...changedSources(session),
    `topics: ${session.topics().length}`,
    '',
  ].join('\n');
}

/** The packed sources that were changed in this browser: an error may come from these changes. */
function changedSources({ sources }: Session): readonly string[] {
  const changed = (sources?.list() ?? []).filter(({ state }) => state === 'changed');
  const lines = changed.map(({ file, sha256, changedSha256 }) => `  ${file}: packed sha256 ${sha256}, here ${changedSha256 ?? ''}`);
  return lines.length === 0 ? [] : ['changed sources:', ...lines];
}
