// English texts of the page inside another one.

export const embedTexts = {
  whole: 'Open the whole page',
  wholeLong: (title: string): string => `Open the whole page of ${title} in a tab of its own`,
  foot: 'About these panels',
};
