// Variants of materials: a menu if a scene has some, and the address keeps the current one.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { drop, settled, useBrowser } from './support/browser.mjs';
import { compare, picture } from './support/pictures.mjs';
import { smallGlb, variedGltf } from './support/scenes.mjs';

const shared = useBrowser();
const isNamed = (page, name) => page.waitForFunction(
  (wanted) => document.querySelector('#scene-name').textContent.startsWith(wanted), name);

test('a menu of variants is there where a scene has some', async () => {
  const page = await shared.open('/');
  assert.ok(await page.isHidden('#variants'));
  await drop(page, [{ name: 'varied.gltf', bytes: variedGltf() }]);
  await isNamed(page, 'varied.gltf');
  await settled(page);
  assert.ok(await page.isVisible('#variants'));
  assert.equal(await page.inputValue('#variant'), '');
  await page.evaluate(() => document.querySelector('#viewer').change({ ambient: 0.6 }));
  await settled(page);
  const plain = await picture(page);

  const load = page.evaluate(() => new Promise((resolve) => {
    document.querySelector('#viewer').addEventListener('load', () => resolve(), { once: true });
  }));
  await page.selectOption('#variant', 'midnight');
  await load;
  await settled(page);
  const { different, pixels } = await compare(page, plain, await picture(page));
  assert.ok(different > 0.001 * pixels, `${different} of ${pixels} pixels differ`);
  assert.equal(await page.inputValue('#variant'), 'midnight');
  assert.equal(await page.evaluate(() => document.querySelector('#viewer').state.ambient), 0.6, 'the view stays');
  await page.waitForFunction(() => location.hash.includes('variant=midnight'));

  await drop(page, [{ name: 'small.glb', bytes: smallGlb() }]);
  await isNamed(page, 'small.glb');
  await settled(page);
  assert.ok(await page.isHidden('#variants'));
  await page.waitForFunction(() => !location.hash.includes('variant='));
  await shared.check(page);
});
