// Runs before anything is drawn, as a classic script: sets the theme, and explains where the page's modules cannot load: in
// a folder opened from disk, and in a frame whose sandbox leaves the page no origin, unless the host lets anybody read its files.

import { useChosenTheme } from './chosen_theme.ts';

useChosenTheme();
if (location.protocol === 'file:') document.documentElement.dataset['from'] = 'disk';
else if (self.origin === 'null') document.documentElement.dataset['from'] = 'sandbox';
