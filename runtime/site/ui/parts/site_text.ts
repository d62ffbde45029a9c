// Texts that the page reads: files of the site, and one that the visitor chooses. Both reject with an Error.

import { fetchOfSite } from '../../program/carried_files.ts';
import { panelTexts } from '../texts_panels.ts';

const MOST_BYTES = 1 << 20;

/** `path`: as in site.json. */
export async function readSiteText(path: string, most = MOST_BYTES): Promise<string> {
  const response = await fetchOfSite(path);
  if (!response.ok) throw new Error(`HTTP ${response.status}`);
  return textOf(await response.arrayBuffer(), most);
}

/** Never settles when the visitor chooses none. `kinds`: endings of names, such as `.rviz`. */
export function chooseText(kinds: string): Promise<{ readonly name: string; readonly text: string; }> {
  return new Promise((resolve, reject) => {
    const input = document.createElement('input');
    input.type = 'file';
    input.accept = kinds;
    input.addEventListener('change', () => {
      const file = input.files?.[0];
      if (file === undefined) return;
      if (file.size > MOST_BYTES) reject(new Error(panelTexts.text.tooLong));
      else file.arrayBuffer().then((bytes) => resolve({ name: file.name, text: textOf(bytes) }), reject);
    });
    input.click();
  });
}

function textOf(bytes: ArrayBuffer, most = MOST_BYTES): string {
  if (bytes.byteLength > most) throw new Error(panelTexts.text.tooLong);
  return new TextDecoder().decode(bytes);
}
