import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import type { MonitoredPage } from './program.ts';

export const sceneBytes = (name: string): Buffer =>
  readFileSync(fileURLToPath(new URL(`scenes/${name}`, import.meta.url)));

/** A minimal scene, a textured square, at a URL of the server. */
export const ASKED = 'examples/asked.usda';
export async function serveAsked(page: Page): Promise<void> {
  await page.route(`**/${ASKED}`, (route) => route.fulfill({ body: sceneBytes('textured.usda') }));
  await page.route('**/examples/textures/checker.png', (route) =>
    route.fulfill({ body: sceneBytes('textures/checker.png') }),
  );
}

/** Drops files on the page as a file manager does. */
export async function drop(visit: MonitoredPage, given: readonly { name: string; content: Buffer }[]): Promise<void> {
  const files = given.map(({ name, content }) => ({ name, text: content.toString('base64') }));
  await visit.page.evaluate((dropped) => {
    const transfer = new DataTransfer();
    for (const { name, text } of dropped) {
      transfer.items.add(new File([Uint8Array.from(atob(text), (character) => character.charCodeAt(0))], name));
    }
    document.body.dispatchEvent(new DragEvent('drop', { dataTransfer: transfer, bubbles: true, cancelable: true }));
  }, files);
}

/** Fraction of pixels of the checkerboard's magenta. */
export const pinkShare = (pixels: Uint8Array): number => {
  let pink = 0;
  for (let i = 0; i + 2 < pixels.length; i += 3) {
    if (pixels[i]! > 1.4 * pixels[i + 1]! && pixels[i + 2]! > 1.2 * pixels[i + 1]!) pink++;
  }
  return (3 * pink) / pixels.length;
};
