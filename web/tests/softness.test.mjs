// Lights with an extent: sliders, pictures that become soft, the address, the attributes.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { smallPage, stateOf, useBrowser } from './support/browser.mjs';
import { rendered, size as pictureSize } from './support/native.mjs';
import { compare, picture } from './support/pictures.mjs';
import { changesFromAttributes } from '../element/attributes.js';
import { withExtent } from '../element/lights.js';
import { hashOf, readHash } from '../page/url-state.js';

const shared = useBrowser();
const sun = [0.5, 1, 0.4];

const change = (page, changes) =>
  page.evaluate((wanted) => document.querySelector('#viewer').change(wanted), changes);
const pointsOf = (page) => page.evaluate(() => document.querySelector('#viewer').lightPoints);
const soft = (page, points) => page.waitForFunction((wanted) =>
  document.querySelector('#viewer').lightPoints.shown === wanted, points, { timeout: 120000 });

test('an extent is put on any light, and taken away again', () => {
  assert.deepEqual(withExtent([...sun, 0], 0.53), { direction: sun, angle: 0.53 });
  assert.deepEqual(withExtent([1, 2, 3, 1, 9], 0.5), { position: [1, 2, 3], range: 9, radius: 0.5 });
  const panel = { position: [1, 2, 3], color: [1, 0, 0], size: [1, 2], facing: [0, -1, 0] };
  assert.deepEqual(withExtent(panel, 0.5), { position: [1, 2, 3], color: [1, 0, 0], radius: 0.5 });
  assert.deepEqual(withExtent({ direction: sun, angle: 2 }, 0), { direction: sun });
});

test('attributes give lights extents', () => {
  const read = (attributes) => changesFromAttributes((name) => attributes[name] ?? null);
  const { lights, light_samples: samples } = read({
    light: '1,2,3', sun: '0,1,0', 'light-radius': '0.5', 'sun-angle': '0.53', 'light-samples': '16' });
  assert.deepEqual(lights, [{ direction: [0, 1, 0], angle: 0.53 }, { position: [1, 2, 3], radius: 0.5 }]);
  assert.equal(samples, 16);
  assert.throws(() => read({ light: '1,2,3', 'light-radius': 'large' }), /The attribute light-radius/);
});

test('the address keeps extents and points', () => {
  const state = {
    camera: { from: [1, 2, 3], to: [0, 0, 0], fov: 45 }, chosen_light: 0, light_samples: 100,
    lights: [{ direction: sun, angle: 0.53 }, { position: [1, 2, 3], size: [1, 2], facing: [0, -1, 0] }],
    ambient: 0.3, ground: 'off', left: { shadows: 'auto', mask_scale: 1 }, split: false, debug: 'none',
    show_lights: true, playing: false, speed: 1, time: 0,
  };
  const { changes, problems } = readHash(hashOf(null, state));
  assert.deepEqual(problems, []);
  assert.deepEqual(changes.lights, state.lights);
  assert.equal(changes.light_samples, 100);
});

test('sliders make lights larger, shadows follow, and the address keeps it', async () => {
  const page = await shared.open(`${smallPage}&light-samples=16`);
  await change(page, { lights: [[...sun, 0]] });
  await page.fill('#sun-angle', '4');
  const { lights: [light] } = await stateOf(page);
  assert.equal(light.angle, 4);
  assert.equal(await page.isVisible('#light-radius'), false);
  await soft(page, 16);
  await page.waitForFunction(() => document.querySelector('#light-points').textContent === 'Soft shadow: 16 points');
  await page.waitForFunction(() => /light=.*angle.*&light-samples=16/.test(decodeURIComponent(location.hash)));
  await page.click('#light-kind label:last-child');
  await page.waitForSelector('#light-radius', { state: 'visible' });
  await page.fill('#light-radius', '60');
  const { lights: [lamp] } = await stateOf(page);
  const size = await page.evaluate(() => document.querySelector('#viewer').sceneSize);
  assert.ok(Math.abs(lamp.radius - 0.36 * 0.1 * size) < 1e-9 * size);
  await soft(page, 16);
  await page.fill('#light-radius', '0');
  assert.equal((await stateOf(page)).lights[0].radius, undefined);
  await page.waitForFunction(() => document.querySelector('#light-points').hidden);
  await shared.check(page);
});

test('the picture is hard while something moves, then that of the program', async () => {
  const page = await shared.open('/', { size: pictureSize });
  await change(page, { show_lights: false, ambient: 0.4, light_samples: 16, left: { shadows: 'volumes' },
    lights: [{ direction: sun, angle: 5 }] });
  await soft(page, 16);
  const state = await stateOf(page);
  const native = rendered({ ...state, lights: [[...sun, 0]] }, ['--sun-angle', '5', '--light-samples', '16']);
  const final = await picture(page);
  const { different, pixels } = await compare(page, final, native);
  // Along outlines the canvas has several samples per pixel, which all take the light seen by the
  // pixel's middle.
  assert.ok(different <= 0.01 * pixels, `${different} of ${pixels} pixels differ`);
  await change(page, { camera: { ...state.camera, fov: state.camera.fov + 0.01 } });
  const { shown, of } = await pointsOf(page);
  assert.equal(of, 16);
  assert.ok(shown === 0 || shown === 16); // either the next frame hasn't come yet, or it is hard
  await soft(page, 16);
  await shared.check(page);
});
