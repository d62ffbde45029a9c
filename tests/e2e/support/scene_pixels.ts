// Counts the pixels of a drawn scene by colour.
import type { Page } from 'playwright-core';

/** How many pixels of the drawing have a colour like this. */
export async function pixels(page: Page, kind: 'red' | 'green' | 'blue'): Promise<number> {
  const png = (await page.locator('.scene-canvas').screenshot()).toString('base64');
  return page.evaluate(
    async ([data, wanted]) => {
      const bytes = Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0));
      const picture = await createImageBitmap(new Blob([bytes]));
      const context = new OffscreenCanvas(picture.width, picture.height).getContext('2d', { willReadFrequently: true });
      context?.drawImage(picture, 0, 0);
      const all = context?.getImageData(0, 0, picture.width, picture.height).data ?? [];
      const place = { red: 0, green: 1, blue: 2 }[wanted];
      let count = 0;
      for (let i = 0; i < all.length; i += 4) {
        const others = [0, 1, 2].filter((one) => one !== place).map((one) => all[i + one] ?? 0);
        if ((all[i + place] ?? 0) > Math.max(...others) + 40) count += 1;
      }
      return count;
    },
    [png, kind] as const,
  );
}
