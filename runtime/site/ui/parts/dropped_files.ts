// Files that are dropped anywhere on the page: kept until the panel for bags, which may have to come first, takes them.

const waiting: File[] = [];
let taker: ((file: File) => void) | undefined;

/** `came` is called when a file waits for somebody to take it. The result ends it. */
export function watchDrops(came: () => void): () => void {
  const over = (event: DragEvent): void => {
    if (event.dataTransfer?.types.includes('Files') !== true) return;
    event.preventDefault();
    event.dataTransfer.dropEffect = 'copy';
  };
  const drop = (event: DragEvent): void => {
    const file = event.dataTransfer?.files[0];
    if (file === undefined) return;
    event.preventDefault();
    if (taker === undefined) waiting.push(file);
    else taker(file);
    came();
  };
  window.addEventListener('dragover', over);
  window.addEventListener('drop', drop);
  return () => {
    window.removeEventListener('dragover', over);
    window.removeEventListener('drop', drop);
  };
}

/** Takes what has come and what comes. The result ends it. */
export function takeDrops(take: (file: File) => void): () => void {
  taker = take;
  for (const file of waiting.splice(0)) take(file);
  return () => {
    if (taker === take) taker = undefined;
  };
}
