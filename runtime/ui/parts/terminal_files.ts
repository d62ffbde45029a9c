// The files of the page's terminal, and of the commands that a launch file starts: bags, and texts.

import type { BagPlace } from '../../ros2cli/command.ts';
import { fetchOfSite } from '../../wasm_js/carried_files.ts';
import type { Session } from '../../wasm_js/session.ts';

/** Of a file that is read or written. */
export const kMostTextBytes = 1 << 20;

/** The shelf of the panel for bags, which comes with the first command that needs it. */
export function bagsOf(session: Session): BagPlace {
  const place = async (): Promise<BagPlace> => (await import('./bag_desk.ts')).bagDesk(session).place;
  return {
    open: async (name) => (await place()).open(name),
    create: async (name) => (await place()).create(name),
  };
}

/** What was written with `>`, by name; as long as the page is open. */
export const written = new Map<string, string>();

/** A text that was written here, or a file of the site by its path, with or without the folders that it begins with. */
export async function readText(session: Session, name: string): Promise<string | undefined> {
  const own = written.get(name);
  if (own !== undefined) return own;
  const prefix = `${session.prefix}/`;
  const path = name.startsWith(prefix) ? name.slice(prefix.length) : name;
  const { files } = session.site;
  const found = files.find((file) => file.path === path) ?? files.find((file) => file.path.endsWith(`/${path}`));
  if (found === undefined || found.size > kMostTextBytes) return undefined;
  const response = await fetchOfSite(found.path);
  if (!response.ok) throw new Error(`HTTP ${response.status}`);
  return await response.text();
}
