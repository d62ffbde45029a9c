// The programs that a site carries.

import { carriedPrograms, type SiteDescription, type SiteProgram } from '../contract/session.ts';

/** Sorted, each once. */
export function programsOf(site: SiteDescription): SiteProgram[] {
  const all = new Map(carriedPrograms(site).map((program) => [`${program.package}/${program.executable}`, program]));
  return [...all].sort(([a], [b]) => (a < b ? -1 : 1)).map(([, program]) => program);
}
