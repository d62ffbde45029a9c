// The theme that the visitor chose, over the one that `pack` wrote into the page for its author. Before anything is
// drawn, so that nothing flashes.

export function useChosenTheme(): void {
  try {
    const theme = localStorage.getItem('ros2wasm.theme');
    if (theme === 'light' || theme === 'dark') document.documentElement.dataset['theme'] = theme;
    else if (theme === 'system') delete document.documentElement.dataset['theme'];
  } catch {
    // Storage is refused: the author's theme it is, or the system's.
  }
}
