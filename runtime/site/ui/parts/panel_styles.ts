// The styles of the panels that are loaded when they are opened.

import { addressOfSite } from '../../program/carried_files.ts';

let coming: Promise<void> | undefined;

/** Once for the page. A sheet that does not come leaves panels plain: they still work. */
export function panelStyles(): Promise<void> {
  coming ??= new Promise((done) => {
    const link = document.createElement('link');
    link.rel = 'stylesheet';
    link.onload = () => done();
    link.onerror = () => done();
    void addressOfSite('panels.css').then((address) => {
      link.href = address;
      document.head.append(link);
    }, () => done());
  });
  return coming;
}
