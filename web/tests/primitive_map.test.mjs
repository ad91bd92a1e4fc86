// Resting lights use primitive maps, which a worker builds.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { smallElement, smallPage, stateOf, useBrowser } from './support/browser.mjs';
import { times } from './support/long.mjs';
import { rendered, views } from './support/native.mjs';
import { compare, picture } from './support/pictures.mjs';

const shared = useBrowser();
const change = (page, changes) =>
  page.evaluate((all) => document.querySelector('edgeshade-viewer').change(all), changes);
const lightsOf = (page) =>
  page.evaluate(() => document.querySelector('edgeshade-viewer').stats.lights);
const lookedUp = (page) => page.waitForFunction(() => {
  const { lights } = document.querySelector('edgeshade-viewer').stats;
  return lights.length > 0 && lights.every(({ method }) => method === 'primitive-map');
});

test('lights at rest see what the native program looks up', async () => {
  const page = await shared.open('/tests/plain.html');
  await change(page, { left: { shadows: 'primitive-map' } });
  for (const { name, camera, lights, astray = 100, share = 0.0055 } of views.slice(0, times(2, views.length))) {
    await change(page, { camera, lights });
    await lookedUp(page);
    const native = rendered(await stateOf(page), ['--shadows', 'primitive-map']);
    const { pixels, different, astray: apart } = await compare(page, await picture(page), native);
    const [{ build_ms, bytes }] = await lightsOf(page);
    console.log(`${name}: ${different} of ${pixels} pixels differ, ${apart} away from outlines; ` +
      `built in ${build_ms.toFixed(0)} ms, ${(bytes / 1e6).toFixed(1)} MB`);
    assert.ok(different <= share * pixels, `${name}: ${different} of ${pixels} pixels differ`);
    assert.ok(apart <= astray, `${name}: ${apart} pixels differ away from outlines`);
  }
  await shared.check(page);
});

test('by itself the viewer counts while a light moves and looks up once it rests', async () => {
  const page = await shared.open('/tests/plain.html');
  await change(page, { left: { shadows: 'auto' }, lights: [[1.5, 2.2, 2, 1]] });
  assert.equal((await lightsOf(page))[0].method, 'volumes');
  await lookedUp(page);
  await change(page, { lights: [[1.6, 2.2, 2, 1]] });
  assert.equal((await lightsOf(page))[0].method, 'volumes');
  await lookedUp(page);
  await shared.check(page);
});

/** Keeps the addresses of all workers in window.workers. */
function keepWorkers() {
  window.workers = [];
  window.Worker = class extends window.Worker {
    constructor(address, options) {
      super(address, options);
      window.workers.push(String(address));
    }
  };
}

/** Allows no worker except the one that reads scenes. */
function refuseMapWorkers() {
  window.Worker = class extends window.Worker {
    constructor(address, options) {
      if (String(address).includes('map-worker')) throw new Error('refused');
      super(address, options);
    }
  };
}

const mapWorkers = (page) =>
  page.evaluate(() => window.workers.filter((address) => address.includes('map-worker')).length);

test('one worker builds the maps of one light after the other', async () => {
  const page = await shared.open(smallElement, { init: keepWorkers });
  await change(page, { left: { shadows: 'primitive-map' } });
  await lookedUp(page);
  await change(page, { lights: [[1.6, 2.2, 2, 1]] });
  await lookedUp(page);
  assert.equal(await mapWorkers(page), 1);
  await shared.check(page);
});

test('without such a worker maps are built between frames', async () => {
  const page = await shared.open('/tests/plain.html', { init: refuseMapWorkers });
  await change(page, { left: { shadows: 'primitive-map' } });
  await lookedUp(page);
  await shared.check(page);
});

test('a worker that can\'t be had is not waited for', async () => {
  const page = await shared.open(smallElement);
  await page.route('**/map-worker.js', (route) => route.abort());
  await change(page, { left: { shadows: 'primitive-map' } });
  await lookedUp(page);
  await shared.check(page, [/map-worker|Failed to load resource/]);
});

test('a viewer that leaves the page and comes back gets its map', async () => {
  const page = await shared.open('/tests/plain.html');
  await page.evaluate(async () => {
    const viewer = document.querySelector('edgeshade-viewer');
    viewer.change({ left: { shadows: 'primitive-map' }, lights: [[1.3, 2.2, 2, 1]] });
    for (let i = 0; i < 60; ++i) await new Promise((resolve) => requestAnimationFrame(resolve));
    const { parentNode } = viewer;
    viewer.remove();
    await new Promise((resolve) => setTimeout(resolve, 50));
    parentNode.append(viewer);
  });
  await lookedUp(page);
  await shared.check(page);
});

test('leaves cast what the native program has them cast, where that is asked for', async () => {
  const page = await shared.open('/tests/plain.html');
  // The ivy between the sun and the terrace.
  const seen = { camera: { from: [0.8, 1.9, 1.6], to: [-1.6, 0.45, -1], fov: 45 }, lights: [[-0.2, 0.5, -1, 0]] };
  await change(page, { ...seen, left: { shadows: 'primitive-map' } });
  await lookedUp(page);
  const without = await picture(page);
  await change(page, { cast_cutouts: true });
  assert.notEqual((await lightsOf(page))[0].method, 'primitive-map', 'a map of other casters');
  await lookedUp(page);
  const shown = await picture(page);
  const native = rendered(await stateOf(page), ['--shadows', 'primitive-map', '--cast-cutouts']);
  const { pixels, different, astray } = await compare(page, shown, native);
  assert.ok(different <= 0.005 * pixels, `${different} of ${pixels} pixels differ`);
  assert.ok(astray <= 150, `${astray} pixels differ away from outlines`);
  assert.ok((await compare(page, shown, without)).different > 1000, 'leaves make a difference');
  await change(page, { cast_cutouts: false });
  await shared.check(page);
});

const lightCount = times(6, 50);

test(`${lightCount} lights in a row leave memory flat`, async () => {
  const page = await shared.open(smallPage);
  await change(page, { left: { shadows: 'primitive-map' } });
  const bytes = [];
  for (let i = 0; i < lightCount; ++i) {
    await change(page, { lights: [[0.3 + 0.01 * i, 1, 0.2, 0]] });
    await lookedUp(page);
    bytes.push(await page.evaluate(() => document.querySelector('edgeshade-viewer').stats.primitive_map_bytes));
  }
  assert.ok(Math.max(...bytes) < 1.5 * bytes[0] + 1e5, `${bytes[0]} bytes became ${Math.max(...bytes)}`);
  await shared.check(page);
});

test('a lost context takes its maps along, and they are made again', async () => {
  const page = await shared.open(smallElement);
  await change(page, { left: { shadows: 'primitive-map' } });
  await lookedUp(page);
  await page.evaluate(async () => {
    const canvas = document.querySelector('edgeshade-viewer').shadowRoot.querySelector('canvas');
    const lose = canvas.getContext('webgl').getExtension('WEBGL_lose_context');
    const lost = new Promise((resolve) => canvas.addEventListener('webglcontextlost', resolve, { once: true }));
    lose.loseContext();
    await lost;
    const restored = new Promise((resolve) => canvas.addEventListener('webglcontextrestored', resolve, { once: true }));
    setTimeout(() => lose.restoreContext(), 50);
    await restored;
  });
  await lookedUp(page);
  await shared.check(page);
});
