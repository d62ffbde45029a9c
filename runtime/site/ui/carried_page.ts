// The program of a site in one HTML file (`ros2wasm pack -o NAME.html`): takes the files that stand behind it in the page
// and starts the page's program from them.
// The page's policy names this script by its hash; all others come from blob: addresses that only it makes.

import type { CarriedFiles } from '../program/carried_files.ts';
import { importer, PageFiles } from '../program/page_files.ts';
import { useChosenTheme } from './chosen_theme.ts';
import { problemOf, problemText } from './model/problem.ts';
import { followFileLinks } from './parts/file_links.ts';

/** As binary files in elements that browsers do not run: base64 of what deflate made. */
function packedFiles(): Map<string, string> {
  const files = new Map<string, string>();
  for (const block of document.querySelectorAll<HTMLScriptElement>('script[data-path]')) {
    files.set(block.dataset['path'] ?? '', block.text);
    block.remove();
  }
  return files;
}

async function start(): Promise<void> {
  const files = new PageFiles(packedFiles());
  await files.readList();
  Object.assign(globalThis, {
    ros2wasmFiles: files satisfies CarriedFiles,
    [importer]: async (name: string): Promise<unknown> => import(await files.moduleAddress(name)),
  });
  followFileLinks(files);
  const sheet = document.createElement('link');
  sheet.rel = 'stylesheet';
  sheet.href = await files.address('styles.css');
  document.head.append(sheet);
  await import(await files.moduleAddress('start.js'));
}

function tell(error: unknown): void {
  const place = document.querySelector('main');
  const text = document.createElement('pre');
  text.textContent = problemText(problemOf(error));
  place?.replaceChildren(text);
}

useChosenTheme();
document.addEventListener('DOMContentLoaded', () => void start().catch(tell));
