// The background follows the theme, and a page's own style.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { settled, stateOf, useBrowser } from './support/browser.mjs';
import { picture } from './support/pictures.mjs';

const shared = useBrowser();

/** The picture's first pixel, where there is only sky: [r, g, b]. */
async function sky(page) {
  await settled(page);
  const base64 = (await picture(page)).toString('base64');
  return page.evaluate(async (png) => {
    const bitmap = await createImageBitmap(await (await fetch(`data:image/png;base64,${png}`)).blob());
    const context = new OffscreenCanvas(1, 1).getContext('2d');
    context.drawImage(bitmap, 0, 0);
    return [...context.getImageData(0, 0, 1, 1).data.subarray(0, 3)];
  }, base64);
}

const styled = (page) => page.evaluate(() => getComputedStyle(document.querySelector('edgeshade-viewer'))
  .backgroundColor.match(/\d+/g).slice(0, 3).map(Number));

test('the background is a light or a dark one, and changes with the theme', async () => {
  const page = await shared.open();
  const light = await sky(page);
  assert.deepEqual(light, [219, 227, 235], 'as the native program has it');
  await page.emulateMedia({ colorScheme: 'dark' });
  const dark = await sky(page);
  assert.deepEqual(dark, await styled(page));
  assert.ok(Math.max(...dark) < 80, `${dark} is dark`);
  await page.emulateMedia({ colorScheme: 'light' });
  assert.deepEqual(await sky(page), light);
  await shared.check(page);
});

test('a page in the dark starts dark, a reset keeps it, and the state can override it', async () => {
  const page = await shared.open(undefined, { colorScheme: 'dark' });
  const dark = await sky(page);
  assert.ok(Math.max(...dark) < 80, `${dark} is dark`);
  await page.evaluate(() => document.querySelector('edgeshade-viewer').reset());
  assert.deepEqual(await sky(page), dark);
  await page.evaluate(() => document.querySelector('edgeshade-viewer').change({ background: [1, 0, 0.2] }));
  assert.deepEqual(await sky(page), [255, 0, 51]);
  assert.deepEqual((await stateOf(page)).background, [1, 0, 0.2]);
  await shared.check(page);
});

test('a page\'s own background of the element is the scene\'s', async () => {
  const page = await shared.open(undefined, { init: () => addEventListener('DOMContentLoaded', () => {
    document.head.append(Object.assign(document.createElement('style'), { textContent: '#viewer { background: #102030 }' }));
  }) });
  assert.deepEqual(await sky(page), [16, 32, 48]);
  await shared.check(page);
});
