// Mouse, touch and keyboard.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { settled, smallPage, stateOf, useBrowser } from './support/browser.mjs';

const shared = useBrowser();
const distance = ({ from, to }) => Math.hypot(...from.map((value, i) => value - to[i]));
const moved = (a, b) => Math.hypot(...a.map((value, i) => value - b[i]));

/** Moves fingers along paths, [[from, to], …], all at once. */
async function swipe(page, paths) {
  const session = await page.context().newCDPSession(page);
  const steps = 8;
  for (let step = 0; step <= steps; ++step) {
    const touchPoints = paths.map(([from, to], id) => ({
      id, x: from[0] + ((to[0] - from[0]) * step) / steps, y: from[1] + ((to[1] - from[1]) * step) / steps,
    }));
    await session.send('Input.dispatchTouchEvent', { type: step ? 'touchMove' : 'touchStart', touchPoints });
  }
  await session.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
  await settled(page);
}

test('one finger orbits, two pinch', async () => {
  const page = await shared.open(smallPage, { hasTouch: true, size: { width: 390, height: 844 } });
  await page.evaluate(() => document.querySelector('#viewer').change({ show_lights: false }));
  const before = (await stateOf(page)).camera;
  await swipe(page, [[[120, 300], [240, 330]]]);
  const orbited = (await stateOf(page)).camera;
  assert.ok(moved(before.from, orbited.from) > 0.1 * distance(before), 'the eye moved');
  assert.ok(Math.abs(distance(orbited) - distance(before)) < 0.01 * distance(before), 'at its distance');
  await swipe(page, [[[180, 300], [120, 250]], [[210, 320], [280, 380]]]);
  const pinched = (await stateOf(page)).camera;
  assert.ok(distance(pinched) < 0.7 * distance(orbited), `nearer: ${distance(pinched)} of ${distance(orbited)}`);
  await shared.check(page);
});

test('the mouse orbits, pans and zooms, the wheel zooms', async () => {
  const page = await shared.open();
  await page.evaluate(() => document.querySelector('#viewer').change({ show_lights: false }));
  const drag = async (button) => {
    await page.mouse.move(300, 300);
    await page.mouse.down({ button });
    await page.mouse.move(380, 320, { steps: 4 });
    await page.mouse.up({ button });
    await settled(page);
    return (await stateOf(page)).camera;
  };
  const before = (await stateOf(page)).camera;
  const orbited = await drag('left');
  assert.deepEqual(orbited.to, before.to);
  assert.ok(moved(orbited.from, before.from) > 0.5);
  const panned = await drag('right');
  assert.ok(moved(panned.to, orbited.to) > 0.1);
  await page.mouse.wheel(0, -300);
  await settled(page);
  assert.ok(distance((await stateOf(page)).camera) < 0.95 * distance(panned));
  await shared.check(page);
});

test('Tab alone reaches everything, in order, and leaves the picture again', async () => {
  const page = await shared.open();
  await page.evaluate(() => document.querySelector('#viewer').change({ split: true, left: { shadows: 'map' } }));
  await page.evaluate(() => { document.querySelector('#figures').open = true; });
  await settled(page);
  const wanted = await page.evaluate(() => {
    const seen = new Set();
    return [...document.querySelectorAll('button, input, select, summary, #divider, edgeshade-viewer')]
      .filter((element) => element.offsetParent && !element.disabled && !element.closest('dialog'))
      // A group of radio buttons is a single tab stop.
      .filter((element) => element.type !== 'radio' || element.checked)
      .map((element) => element.id || element.name || element.textContent)
      .filter((name) => !seen.has(name) && seen.add(name));
  });
  const reached = new Set();
  for (let i = 0; i < 60; ++i) {
    await page.keyboard.press('Tab');
    reached.add(await page.evaluate(() => {
      const element = document.activeElement;
      return element.id || element.name || element.textContent;
    }));
  }
  assert.deepEqual(wanted.filter((name) => !reached.has(name)), []);
  assert.ok(wanted.length > 15);
  await shared.check(page);
});

test('everything has a name that can be read out', async () => {
  const page = await shared.open();
  const session = await page.context().newCDPSession(page);
  const { nodes } = await session.send('Accessibility.getFullAXTree');
  const roles = ['button', 'checkbox', 'radio', 'slider', 'combobox', 'application', 'link'];
  const nameless = nodes.filter((node) => !node.ignored && roles.includes(node.role?.value) && !node.name?.value);
  assert.deepEqual(nameless.map((node) => node.role.value), []);
  assert.ok(nodes.some((node) => node.role?.value === 'application'));
  await shared.check(page);
});

test('keys on the picture do what the help says', async () => {
  const page = await shared.open();
  await page.evaluate(() => document.querySelector('#viewer').focus());
  const press = async (key) => {
    await page.keyboard.press(key);
    await settled(page);
    return stateOf(page);
  };
  const start = await stateOf(page);
  assert.notDeepEqual((await press('ArrowLeft')).camera.from, start.camera.from);
  const before = await stateOf(page);
  assert.notDeepEqual((await press('Shift+ArrowUp')).camera.to, before.camera.to);
  assert.ok(distance((await press('+')).camera) < distance(before.camera));
  assert.notDeepEqual((await press('a')).lights, start.lights);
  assert.equal((await press('n')).lights.length, 2);
  assert.equal((await press('Delete')).lights.length, 1);
  assert.equal((await press('m')).left.shadows === start.left.shadows, false);
  assert.equal((await press('c')).split, true);
  assert.equal((await press('v')).debug, 'volumes');
  assert.equal(start.ground, 'off'); // the scene has a floor
  assert.equal((await press('g')).ground, 'catcher');
  assert.equal((await press('h')).show_lights, false);
  const home = await press('r');
  assert.ok(moved(home.camera.from, start.camera.from) < 1e-6);
  await page.keyboard.press('?');
  assert.equal(await page.isVisible('#keys'), true);
  await page.keyboard.press('Escape');
  assert.equal(await page.isVisible('#keys'), false);
  await shared.check(page);
});
