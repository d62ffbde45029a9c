// The programs that a site carries.

import type { SiteDescription, SiteProgram } from '../wasm_js/session.ts';

/** Sorted, each once. */
export function programsOf(site: SiteDescription): SiteProgram[] {
  const all = new Map([...site.nodes, ...site.programs].map((program) => [`${program.package}/${program.executable}`, program]));
  return [...all].sort(([a], [b]) => (a < b ? -1 : 1)).map(([, program]) => program);
}
