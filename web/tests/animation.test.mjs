// Animations play, pause, keep their speed, and stand still for users who want less motion.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { drop, settled, smallPage, stateOf, useBrowser } from './support/browser.mjs';
import { rendered, size } from './support/native.mjs';
import { compare, picture } from './support/pictures.mjs';
import { smallGlb } from './support/scenes.mjs';
import { repository } from './support/server.mjs';

const shared = useBrowser();
const duration = 2; // of the small scene

const change = (page, changes) =>
  page.evaluate((value) => document.querySelector('#viewer').change(value), changes);

const framesIn = (page, milliseconds) => page.evaluate((length) => new Promise((resolve) => {
  let count = 0;
  document.querySelector('#viewer').addEventListener('frame', () => { count += 1; });
  setTimeout(() => resolve(count), length);
}), milliseconds);

async function requireAlike(page, first, second, what) {
  const { different } = await compare(page, first, second);
  assert.equal(different, 0, what);
}

async function requireOther(page, first, second, what) {
  const { different, pixels } = await compare(page, first, second);
  assert.ok(different > 0.001 * pixels, `${what}: ${different} of ${pixels} pixels differ`);
}

/** Seconds of the animation per second of the frames' clock. */
const pace = (page, speed) => page.evaluate((wanted) => new Promise((resolve) => {
  const viewer = document.querySelector('#viewer');
  let first = null;
  const onFrame = () => {
    const now = document.timeline.currentTime / 1000;
    const { time } = viewer.state;
    first ??= { now, time };
    if (now - first.now < 0.15) return;
    viewer.removeEventListener('frame', onFrame);
    viewer.change({ playing: false });
    resolve((time - first.time) / (now - first.now));
  };
  viewer.change({ time: 0, speed: wanted, playing: true });
  viewer.addEventListener('frame', onFrame);
}), speed);

test('a dropped .glb plays, and pauses where it is', async () => {
  const page = await shared.open(smallPage);
  await drop(page, [{ name: 'moving.glb', bytes: smallGlb() }]);
  await page.waitForFunction(() => document.querySelector('#scene-name').textContent.startsWith('moving.glb'));
  assert.equal(await page.evaluate(() => document.querySelector('#viewer').animationSeconds), duration);
  await settled(page);
  const before = await picture(page);
  assert.equal(await framesIn(page, 300), 0, 'it waits to be played');

  await page.click('#play');
  await page.waitForFunction(() => document.querySelector('#viewer').state.time > 0.3);
  await page.click('#play');
  await settled(page);
  const { time, playing } = await stateOf(page);
  assert.equal(playing, false);
  const paused = await picture(page);
  await requireOther(page, before, paused, 'the stone and its shadow have moved');
  assert.equal(await framesIn(page, 300), 0, 'nothing is drawn while it stands');
  assert.equal((await stateOf(page)).time, time);
  await requireAlike(page, paused, await picture(page), 'the picture stays');

  await change(page, { time: 0 });
  await requireAlike(page, before, await picture(page), 'back at its start');
  await change(page, { time });
  await requireAlike(page, paused, await picture(page), 'and at the same time again');
  await shared.check(page);
});

test('it goes at its speed, and round and round', async () => {
  const page = await shared.open(smallPage);
  for (const speed of [0.25, 1, 4]) {
    const found = await pace(page, speed);
    assert.ok(Math.abs(found - speed) < 0.05 * speed, `${found} instead of ${speed}`);
  }
  await page.selectOption('#speed', '10');
  assert.equal((await stateOf(page)).speed, 10);
  await change(page, { time: 0.9 * duration, playing: true });
  await page.waitForFunction(() => document.querySelector('#viewer').state.time < 1);
  await shared.check(page);
});

test('a wish for less motion pauses it; who presses Play still sees it move', async () => {
  const page = await shared.open(smallPage);
  await change(page, { playing: true });
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.waitForFunction(() => !document.querySelector('#viewer').state.playing);
  await settled(page);
  assert.equal(await framesIn(page, 300), 0);
  await page.click('#play');
  assert.equal((await stateOf(page)).playing, true);
  assert.ok(await framesIn(page, 500) > 0);
  await shared.check(page);
});

test('an address that plays does so unless less motion is wanted', async () => {
  for (const [reducedMotion, playing] of [['no-preference', true], ['reduce', false]]) {
    const page = await shared.open(`${smallPage}&playing=on`, { reducedMotion });
    assert.equal((await stateOf(page)).playing, playing, reducedMotion);
    await shared.check(page);
  }
});

const asset = (name) => readFileSync(join(repository, 'assets', name));

/** A file of the repository, dropped onto the page without the viewer's ground. */
async function dropped(page, name) {
  await drop(page, [{ name, bytes: asset(name) }]);
  await page.waitForFunction((text) => document.querySelector('#scene-name').textContent.startsWith(text), name);
  await change(page, { show_lights: false, ground: 'off', shading: 'base', ambient: 0.4,
    lights: [[0.6, 1, 0.5, 0]], camera: { from: [3, 2, 4], to: [0, 0.9, 0], fov: 45 } });
}

/**
 * Compares with the native program's picture of the page's scene at its time, allowing for
 * differences between two rasterisers.
 */
async function requireNative(page, name, clip) {
  const state = await stateOf(page);
  const native = rendered(state, ['--shading', 'base', '--time', `${state.time}`, '--animation', clip],
    { scene: asset(name) });
  const { different, pixels } = await compare(page, await picture(page), native);
  assert.ok(different <= 0.003 * pixels, `${name}, ${clip} at ${state.time} s: ${different} of ${pixels} pixels differ`);
}

test('a figure with a skin walks, and waves when that clip is chosen', async () => {
  const page = await shared.open(smallPage, { size });
  await dropped(page, 'walking-figure.glb');
  assert.deepEqual(await page.evaluate(() => [...document.querySelector('#clip').options].map(({ text }) => text)),
    ['walk', 'wave', 'jump']);
  const before = await picture(page);
  await page.click('#play');
  await page.waitForFunction(() => document.querySelector('#viewer').state.time > 0.3);
  await page.click('#play');
  await settled(page);
  await requireOther(page, before, await picture(page), 'its legs and their shadow have moved');
  await requireNative(page, 'walking-figure.glb', 'walk');

  await page.selectOption('#clip', { label: 'wave' });
  const { animation, time } = await stateOf(page);
  assert.deepEqual([animation, time], [1, 0], 'the other clip, from its start');
  assert.equal(await page.evaluate(() => document.querySelector('#viewer').animationSeconds), 2);
  await change(page, { time: 0.7 });
  await requireNative(page, 'walking-figure.glb', 'wave');
  await page.waitForFunction(() => /animation=1/.test(location.hash) && /time=0.7/.test(location.hash));
  assert.ok((await page.evaluate(() => document.querySelector('#viewer').stats)).pose_ms > 0);
  await page.evaluate(() => document.querySelector('#viewer').focus());
  await page.keyboard.press('x');
  assert.equal((await stateOf(page)).animation, 2);
  await assert.rejects(change(page, { animation: 3 }), /animation is 3, but the scene has 3 animations/);
  await shared.check(page);
});

test('a ball with morph targets morphs', async () => {
  const page = await shared.open(smallPage, { size });
  await dropped(page, 'morphing-ball.glb');
  for (const time of [0.25, 1, 1.5]) {
    await change(page, { time });
    await requireNative(page, 'morphing-ball.glb', 'morph');
  }
  await shared.check(page);
});
