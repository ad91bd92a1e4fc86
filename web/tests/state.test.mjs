// The address bar keeps the state, the panel shows it.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { loaded, settled, stateOf, useBrowser, waitForNotice } from './support/browser.mjs';
import { hashOf, readHash } from '../page/url-state.js';
import { anglesOf, directionOf } from '../page/sun.js';

const shared = useBrowser();

function requireClose(actual, expected, path = '') {
  if (typeof expected === 'number')
    assert.ok(Math.abs(actual - expected) <= 1e-5 * Math.max(1, Math.abs(expected)), `${path}: ${actual}, not ${expected}`);
  else if (expected && typeof expected === 'object')
    for (const key of Object.keys(expected)) requireClose(actual[key], expected[key], `${path}.${key}`);
  else assert.equal(actual, expected, path);
}

const view = {
  camera: { from: [3, 4.25, 8], to: [0.5, 1, -0.125], fov: 38 },
  lights: [[1.5, 2.25, 2, 1, 6.5], [0.48, 0.64, 0.6, 0]],
  chosen_light: 1,
  ambient: 0.25,
  ground: '#8090a0',
  cast_cutouts: true,
  cull: 'off',
  left: { shadows: 'volumes', mask_scale: 2 },
  right: { shadows: 'map', map_size: 512 },
  split: true,
  split_at: 0.375,
  debug: 'volumes',
  show_lights: false,
  speed: 2,
};

test('the address brings back what was set, in a new page', async () => {
  const page = await shared.open();
  await page.evaluate((changes) => document.querySelector('#viewer').change(changes), view);
  await page.waitForFunction(() => location.hash.includes('right=map'));
  const hash = await page.evaluate(() => location.hash);
  assert.match(hash, /^#model=tests\/small\.gltf&camera=3,4\.25,8,/);
  await shared.check(page);

  const again = await shared.open(`/${hash}`);
  requireClose(await stateOf(again), view);
  assert.equal(await again.isChecked('#split'), true);
  assert.equal(await again.isVisible('#divider'), true);
  assert.equal(await again.inputValue('#right-map-size'), '512');
  assert.equal(await again.inputValue('#ground'), 'color');
  assert.equal(await again.inputValue('#ground-color'), '#8090a0');
  await shared.check(again);
});

test('an address in words that make no sense starts without them and says so', async () => {
  const page = await shared.open('/#model=tests/small.gltf&camera=1,2,banana&light=0,1,0,0&split=0.5&shadows=fog');
  await waitForNotice(page, /camera.*banana/);
  await waitForNotice(page, /fog/);
  await shared.check(page);
});

test('an address typed anew is followed', async () => {
  const page = await shared.open();
  await page.evaluate(() => { location.hash = '#model=tests/small.gltf&ambient=0.75'; });
  await page.waitForFunction(() => document.querySelector('#viewer').state.ambient > 0.7);
  await loaded(page);
  await shared.check(page);
});

test('the panel changes the picture\'s state', async () => {
  const page = await shared.open();
  await page.check('input[name=left-shadows][value=map]', { force: true });
  await page.selectOption('#left-map-size', '512');
  requireClose(await stateOf(page), { left: { shadows: 'map', map_size: 512 } });
  await page.fill('#azimuth', '90');
  await page.fill('#elevation', '30');
  const [x, y, z] = (await stateOf(page)).lights[0];
  requireClose(anglesOf([x, y, z]), { azimuth: 90, elevation: 30 });
  await page.click('#light-add');
  assert.equal((await stateOf(page)).lights.length, 2);
  await page.check('#split');
  await settled(page);
  await page.focus('#divider');
  const before = (await stateOf(page)).split_at;
  await page.keyboard.press('ArrowRight');
  assert.ok((await stateOf(page)).split_at > before);
  await page.click('#figures summary');
  await page.waitForFunction(() => /Triangles36/.test(document.querySelector('#stats').textContent));
  await shared.check(page);
});

test('the picture button saves a PNG', async () => {
  const page = await shared.open();
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#screenshot')]);
  assert.equal(download.suggestedFilename(), 'small.png');
  await shared.check(page);
});

test('words and numbers survive the address', () => {
  const state = { ...view, left: { shadows: 'map', map_size: 4096 }, time: 1.5 };
  const { model, changes, problems } = readHash(hashOf({ url: 'a b/ü&#.glb' }, state));
  assert.deepEqual(model, { url: 'a b/ü&#.glb' });
  const painted = { url: 'a.glb', variant: 'midnight & blue' };
  assert.deepEqual(readHash(hashOf(painted, state)).model, painted);
  assert.deepEqual(problems, []);
  requireClose(changes, state);
});

test('compass and height turn into a direction and back', () => {
  for (const azimuth of [0, 45, 180, 359]) requireClose(anglesOf(directionOf(azimuth, 33)), { azimuth, elevation: 33 });
});
