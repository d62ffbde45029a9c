// The styles of the panels that are loaded when they are opened.

let coming: Promise<void> | undefined;

/** Once for the page. A sheet that does not come leaves panels plain: they still work. */
export function panelStyles(): Promise<void> {
  coming ??= new Promise((done) => {
    const link = document.createElement('link');
    link.rel = 'stylesheet';
    link.href = 'panels.css';
    link.onload = () => done();
    link.onerror = () => done();
    document.head.append(link);
  });
  return coming;
}
