// Runs before anything is drawn, as a classic script: sets the theme, and explains the one case where the page's modules
// cannot load at all, a folder opened from disk.

import { useChosenTheme } from './chosen_theme.ts';

useChosenTheme();
if (location.protocol === 'file:') document.documentElement.dataset['from'] = 'disk';
