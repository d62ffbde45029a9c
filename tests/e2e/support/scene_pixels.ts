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

/** How bright the drawing is around points of it, each by its share of width and height: means of 5 x 5 pixels, 0 to 255. */
export async function brightness(page: Page, points: readonly (readonly [number, number])[]): Promise<readonly number[]> {
  const png = (await page.locator('.scene-canvas').screenshot()).toString('base64');
  return page.evaluate(
    async ([data, places]) => {
      const bytes = Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0));
      const picture = await createImageBitmap(new Blob([bytes]));
      const context = new OffscreenCanvas(picture.width, picture.height).getContext('2d', { willReadFrequently: true });
      context?.drawImage(picture, 0, 0);
      return places.map(([x, y]) => {
        const all = context?.getImageData(Math.round(x * picture.width) - 2, Math.round(y * picture.height) - 2, 5, 5).data ?? [];
        let sum = 0;
        for (let i = 0; i < all.length; i += 4) sum += (all[i] ?? 0) + (all[i + 1] ?? 0) + (all[i + 2] ?? 0);
        return sum / 75;
      });
    },
    [png, points] as const,
  );
}
