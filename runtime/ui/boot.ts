// Runs before anything is drawn, as a classic script: sets the chosen theme, so that nothing flashes, and
// explains the one case where the page's modules cannot load at all, a folder opened from disk.

(() => {
  try {
    const theme = localStorage.getItem('ros2wasm.theme');
    if (theme === 'light' || theme === 'dark') document.documentElement.dataset['theme'] = theme;
  } catch {
    // Storage is refused: the system's theme it is.
  }
  if (location.protocol === 'file:') document.documentElement.dataset['from'] = 'disk';
})();
