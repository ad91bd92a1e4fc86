// Antialiasing at rest: the program's --smooth, and the viewer's menu, attribute and address.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { smallPage, stateOf, useBrowser } from './support/browser.mjs';
import { rendered, size } from './support/native.mjs';
import { compare, picture } from './support/pictures.mjs';
import { changesFromAttributes } from '../element/attributes.js';

const shared = useBrowser();
const change = (page, changes) =>
  page.evaluate((wanted) => document.querySelector('#viewer').change(wanted), changes);
const smooth = (page, pictures) => page.waitForFunction((wanted) =>
  document.querySelector('#viewer').smoothing.shown === wanted, pictures, { timeout: 120000 });

test('the picture at rest is that of --smooth', async () => {
  const page = await shared.open('/', { size });
  await change(page, { show_lights: false, ambient: 0.4, shading: 'base', left: { shadows: 'volumes' },
    lights: [[-0.62, 0.62, -0.3, 0]], smooth: 16 });
  await smooth(page, 16);
  const final = await picture(page);
  const state = await stateOf(page);
  const share = async (options) => {
    const { different, pixels } = await compare(page, final, rendered(state, ['--shading', 'base', ...options]));
    return different / pixels;
  };
  const [same, hard] = [await share(['--smooth', '16']), await share([])];
  console.log(`${100 * same} % of the pixels differ, without --smooth ${100 * hard} %`);
  // Other rasterisers take other samples along outlines; one sample of 16 makes a step of more than
  // 2.
  assert.ok(same <= 0.03, `${100 * same} % of the pixels differ`);
  assert.ok(hard > 3 * same && hard > 0.08, `without it ${100 * hard} % do`);
  await change(page, { camera: { fov: state.camera.fov + 0.01 } });
  assert.ok([0, 16].includes(await page.evaluate(() => document.querySelector('#viewer').smoothing.shown)));
  await smooth(page, 16);
  await shared.check(page);
});

test('the menu, the attribute and the address ask for it', async () => {
  const page = await shared.open(smallPage);
  await page.selectOption('#smooth', '4');
  assert.equal((await stateOf(page)).smooth, 4);
  await smooth(page, 4);
  await page.waitForFunction(() => location.hash.includes('&smooth=4'));
  await shared.check(page);
  const again = await shared.open(`${smallPage}&smooth=9`);
  await smooth(again, 9);
  assert.equal(await again.inputValue('#smooth'), '9');
  await assert.rejects(change(again, { smooth: 257 }), /smooth is 257/);
  await again.selectOption('#smooth', '16'); // the default
  await again.waitForFunction(() => !location.hash.includes('smooth'));
  await again.selectOption('#smooth', '1');
  await again.waitForFunction(() => location.hash.includes('&smooth=1&'));
  await again.waitForFunction(() => document.querySelector('#viewer').smoothing.of === 0);
  await shared.check(again);
  assert.deepEqual(changesFromAttributes((name) => ({ smooth: '16' })[name] ?? null), { smooth: 16 });
});
