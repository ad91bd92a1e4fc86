// The graphics context may be lost at any time.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { loaded, settled, smallPage, useBrowser, waitForNotice } from './support/browser.mjs';
import { compare, picture } from './support/pictures.mjs';

const shared = useBrowser();
const chatter = [/CONTEXT_LOST_WEBGL/, /context lost/i]; // Chromium's own messages

/** Keeps the extension, which can't be requested while the context is lost. */
function keepLoseContext() {
  const { getContext } = HTMLCanvasElement.prototype;
  HTMLCanvasElement.prototype.getContext = function (...rest) {
    const context = getContext.apply(this, rest);
    if (rest[0] === 'webgl') window.loseContext = context.getExtension('WEBGL_lose_context');
    return context;
  };
}

test('a lost context comes back with the same picture, twice', async () => {
  const page = await shared.open(smallPage, { init: keepLoseContext });
  const before = await picture(page);
  for (let round = 0; round < 2; ++round) {
    const events = page.evaluate(() => Promise.all(['contextlost', 'contextrestored'].map((type) =>
      new Promise((resolve) => {
        document.querySelector('#viewer').addEventListener(type, () => resolve(type), { once: true });
      }))));
    await page.evaluate(() => window.loseContext.loseContext());
    await waitForNotice(page, /context was lost/);
    await page.keyboard.press('Tab'); // using the page meanwhile is harmless
    await page.evaluate(() => document.querySelector('#viewer').run('orbitLeft'));
    await page.evaluate(() => document.querySelector('#viewer').run('orbitRight'));
    await page.evaluate(() => window.loseContext.restoreContext());
    assert.deepEqual(await events, ['contextlost', 'contextrestored']);
    await settled(page);
    const { different, pixels } = await compare(page, before, await picture(page));
    assert.ok(different < 1e-4 * pixels, `${different} pixels differ`);
  }
  await page.evaluate(() => document.querySelector('#viewer').load('tests/small.gltf'));
  await loaded(page);
  await shared.check(page, chatter);
});

test('a resized picture and another pixel ratio are drawn at their own resolution', async () => {
  const page = await shared.open(smallPage, { deviceScaleFactor: 2, size: { width: 500, height: 400 } });
  const sizeOf = () => page.evaluate(() => {
    const canvas = document.querySelector('#viewer').shadowRoot.querySelector('canvas');
    return [canvas.width, canvas.height, canvas.clientWidth * devicePixelRatio, canvas.clientHeight * devicePixelRatio];
  });
  for (const size of [{ width: 900, height: 601 }, { width: 1201, height: 333 }]) {
    await page.setViewportSize(size);
    await settled(page);
    const [width, height, wantedWidth, wantedHeight] = await sizeOf();
    assert.deepEqual([width, height], [wantedWidth, wantedHeight]);
    const png = await picture(page);
    assert.ok((await compare(page, png, png)).colors > 8);
  }
  await shared.check(page);
});

test('nothing is drawn while nothing changes', async () => {
  const page = await shared.open();
  const frames = await page.evaluate(() => new Promise((resolve) => {
    let count = 0;
    document.querySelector('#viewer').addEventListener('frame', () => { count += 1; });
    setTimeout(() => resolve(count), 700);
  }));
  assert.equal(frames, 0);
  await shared.check(page);
});
