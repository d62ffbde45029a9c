// The result of a site's checks: lines for people, and JUnit XML for CI. Pure.

import type { CheckView } from '../contract/site_checks.ts';

/** Characters that XML 1.0 cannot contain, not even escaped. */
const impossible = /[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\u{10000}-\u{10ffff}]/gu;
const entities: Readonly<Record<string, string>> = {
  '&': '&amp;',
  '<': '&lt;',
  '>': '&gt;',
  '"': '&quot;',
  '\t': '&#9;',
  '\n': '&#10;',
  '\r': '&#13;',
};

function xml(text: string): string {
  return text.replace(impossible, '\ufffd').replace(/[&<>"\t\n\r]/g, (sign) => entities[sign] ?? sign);
}

function seconds(ms: number): string {
  return (ms / 1000).toFixed(3);
}

export function junitXml(site: string, checks: readonly CheckView[]): string {
  const failed = checks.filter(({ state }) => state !== 'passed').length;
  const longest = Math.max(0, ...checks.map(({ afterMs }) => afterMs ?? 0));
  const counts = `tests="${checks.length}" failures="${failed}" errors="0" skipped="0" time="${seconds(longest)}"`;
  const cases = checks.map((check) => {
    const place = check.source === undefined ? '' : ` file="${xml(check.source.file)}" line="${check.source.line}"`;
    const head = `    <testcase classname="${xml(site)}" name="${xml(check.title)}"${place} time="${seconds(check.afterMs ?? 0)}"`;
    if (check.state === 'passed') return `${head}/>`;
    return `${head}>\n      <failure message="${xml(`not seen within ${seconds(check.withinMs)} s; seen: ${check.seen}`)}"/>\n    </testcase>`;
  });
  return [
    '<?xml version="1.0" encoding="UTF-8"?>',
    `<testsuites ${counts}>`,
    `  <testsuite name="${xml(site)}" ${counts}>`,
    ...cases,
    '  </testsuite>',
    '</testsuites>',
    '',
  ].join('\n');
}

/** Control characters of what nodes said do not reach the terminal. */
function plain(text: string): string {
  return text.replace(/[\u0000-\u001f\u007f-\u009f]/g, ' ');
}

export function checkLine(check: CheckView): string {
  const how = check.state === 'passed' ? 'passed' : check.state === 'failed' ? 'failed' : 'waits';
  const place = check.source === undefined ? '' : `\n  --> ${check.source.file}:${check.source.line}:${check.source.column}`;
  const seen = check.state === 'passed'
    ? ` (${plain(check.seen)})`
    : `${place}\n  = seen: ${plain(check.seen)}\n  = within: ${seconds(check.withinMs)} s of the site's time`;
  return `[check] ${how}: ${plain(check.title)}${seen}`;
}
