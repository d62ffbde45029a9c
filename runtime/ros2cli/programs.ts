// The programs that a site carries.

import type { SiteDescription, SiteProgram } from '../wasm_js/session.ts';

/** Sorted, each once. */
export function programsOf(site: SiteDescription): SiteProgram[] {
  const own = site.nodes.filter((node) => node.kind !== 'command');
  const all = new Map([...own, ...site.programs].map((program) => [`${program.package}/${program.executable}`, program]));
  return [...all].sort(([a], [b]) => (a < b ? -1 : 1)).map(([, program]) => program);
}
