// Links to files of the site that are not at the address beside the page: in a store, in parts, or carried by the page.

import { fileName } from '../../contract/file_name.ts';

/** Those files. */
export interface LinkedFiles {
  has(path: string): boolean;
  /** An address that lasts as long as the page. */
  address(path: string): Promise<string>;
}

/** From now on, a link to such a file downloads it under its own name. */
export function followFileLinks(files: LinkedFiles): void {
  document.addEventListener('click', (event) => follow(event, files));
}

function follow(event: MouseEvent, files: LinkedFiles): void {
  const link = event.composedPath().find((each) => each instanceof HTMLAnchorElement);
  let path: string;
  try {
    path = decodeURIComponent(link?.getAttribute('href') ?? '');
  } catch {
    return;
  }
  if (link === undefined || !files.has(path)) return;
  event.preventDefault();
  void files.address(path).then((address) => {
    const given = document.createElement('a');
    given.href = address;
    given.download = fileName(path);
    given.click();
  });
}
