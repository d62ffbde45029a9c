// The words of figures.

export const figureTexts = {
  none: 'No program shows a figure: matplotlib.pyplot.show() opens one.',
  topic: 'Figure',
  waiting: 'The figure has not been drawn yet.',
  ended: 'The program no longer shows this figure.',
  view: (title: string): string => `${title}. The pointer and keys go to the program; Tab leaves the figure`,
  home: 'Show all, as at first',
  back: 'Previous view',
  forward: 'Next view',
  pan: 'Move by dragging, zoom with the right button',
  zoom: 'Zoom to a rectangle',
  fill: 'Make the figure as large as the panel',
  save: 'Save the figure (PNG)',
  saved: 'Figure saved',
} as const;
