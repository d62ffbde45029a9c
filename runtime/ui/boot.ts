// Runs before anything is drawn, as a classic script: sets the theme that the visitor chose over the one that `pack`
// wrote into the page for its author, so that nothing flashes, and explains the one case where the page's modules cannot load at all, a folder opened from disk.

(() => {
  try {
    const theme = localStorage.getItem('ros2wasm.theme');
    if (theme === 'light' || theme === 'dark') document.documentElement.dataset['theme'] = theme;
    else if (theme === 'system') delete document.documentElement.dataset['theme'];
  } catch {
    // Storage is refused: the author's theme it is, or the system's.
  }
  if (location.protocol === 'file:') document.documentElement.dataset['from'] = 'disk';
})();
