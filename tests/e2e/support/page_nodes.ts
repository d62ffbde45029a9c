// Actions of a visitor on the nodes of a page.

import type { Page } from 'playwright-core';

/** Milliseconds from the button that stops a node to the one that starts it. Within the page: a busy machine is slow to click for us. */
export function msToStop(page: Page, node: string): Promise<number> {
  return page.evaluate(async ([stop, start]) => {
    const button = (label: string) => document.querySelector<HTMLButtonElement>(`button[aria-label="${label}"]`);
    const begun = performance.now();
    button(stop)?.click();
    while (button(start) === null) await new Promise((resolve) => setTimeout(resolve, 20));
    return performance.now() - begun;
  }, [`Stop /${node}`, `Start /${node}`] as const);
}

/** Types a line into the standard input of a node. */
export async function typeInto(page: Page, node: string, line: string): Promise<void> {
  await page.getByRole('button', { name: `Type into /${node}` }).click();
  await page.getByRole('textbox', { name: `Standard input of /${node}` }).waitFor();
  await page.keyboard.type(line);
  await page.keyboard.press('Enter');
}
