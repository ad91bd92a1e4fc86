// First impressions of the element and its page: words while they start, smooth edges at rest, and each light's
// method with its reason.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { loaded, smallPage, stateOf, useBrowser } from './support/browser.mjs';
import { methodLines, methodText } from '../page/methods.js';

const shared = useBrowser();
const size = { width: 480, height: 300 };

test('a picture at rest is averaged from 16, without antialiasing from one', async () => {
  const page = await shared.open(smallPage, { size, antialias: true });
  assert.equal((await stateOf(page)).smooth, 16);
  await page.waitForFunction(() => document.querySelector('#viewer').smoothing.shown === 16);
  assert.equal(await page.inputValue('#smooth'), '16');
  await shared.check(page);
  const plain = await shared.open(smallPage, { size });
  assert.equal((await stateOf(plain)).smooth, 1);
  assert.equal(await plain.evaluate(() => document.querySelector('#viewer').smoothing.of), 0);
  await shared.check(plain);
});

test('while the element starts it says so, and its box stays as it is', async () => {
  const page = await shared.open('/tests/plain.html', { size: { width: 1280, height: 720 }, scene: false, init: () => {
    const { compile } = WebAssembly; // waits until the test lets it go on
    const gate = new Promise((resolve) => { window.goOn = resolve; });
    WebAssembly.compile = (...args) => gate.then(() => compile(...args));
  } });
  const look = () => page.evaluate(() => {
    const viewer = document.querySelector('edgeshade-viewer');
    const bar = viewer.shadowRoot.querySelector('.progress');
    const { x, y, width, height } = viewer.getBoundingClientRect();
    return { words: bar.hidden ? null : bar.querySelector('.stage').textContent, box: [x, y, width, height] };
  });
  await page.waitForFunction(() => document.querySelector('edgeshade-viewer').shadowRoot);
  const starting = await look();
  assert.match(starting.words, /^Starting … \d+ %$/);
  await page.evaluate(() => window.goOn());
  await loaded(page);
  assert.deepEqual(await look(), { words: null, box: starting.box });
  await shared.check(page);
});

test('the panel says how each light is shadowed, and why', async () => {
  const page = await shared.open(smallPage, { size });
  const lines = () => page.$$eval('#light-methods li', (items) => items.map((item) => item.textContent));
  await page.waitForFunction(() => /^Light 1: shadows are [a-z ]+; reason: .+\.$/.test(document.querySelector('#light-methods').textContent));
  assert.equal((await lines()).length, (await stateOf(page)).lights.length);
  await page.evaluate(() => document.querySelector('#viewer').change({ left: { shadows: 'map' } }));
  await page.waitForFunction(() => /^Light 1: shadows are sampled from a shadow map; as chosen: .+\.$/.test(document.querySelector('#light-methods').textContent));
  await page.evaluate(() => document.querySelector('#viewer').run('addLight'));
  await page.waitForFunction(() => document.querySelectorAll('#light-methods li').length === 2);
  await shared.check(page);
});

test('methods in words', () => {
  assert.equal(methodText({ method: 'volumes', why: 'it moves' }, 1), 'Light 2: shadows are counted by shadow volumes; reason: it moves.');
  assert.equal(methodText({ method: 'map', why: '1024 texels' }, 0), 'Light 1: shadows are sampled from a shadow map; as chosen: 1024 texels.');
  assert.equal(methodText({ method: 'none', why: '' }, 0), 'Light 1: shadows are left out; as chosen.');
  const many = methodLines(Array.from({ length: 9 }, () => ({ method: 'volumes', why: 'it moves' })));
  assert.equal(many.length, 7);
  assert.equal(many.at(-1), '3 further lights');
});
