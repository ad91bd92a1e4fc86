// Hours of sunlight in the viewer: the same counts as `edgeshade sunhours`, hover, legend, the
// address.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { settled, smallPage, stateOf, useBrowser, waitForNotice } from './support/browser.mjs';
import { size, sunHours } from './support/native.mjs';
import { changesFromAttributes } from '../element/attributes.js';
import { durationText, hoursText, progressText } from '../page/sun-hours.js';
import { hashOf, readHash } from '../page/url-state.js';

const shared = useBrowser();
const munich = { place: [48.14, 11.57], time: '2026-03-21T10:00+01:00', north: 25 };
const spring = 'place=48.14,11.57&time-of-day=2026-03-21T10:00%2B01:00&north=25';
const address = `${smallPage}&${spring}`;

const change = (page, changes) =>
  page.evaluate((wanted) => document.querySelector('#viewer').change(wanted), changes);
const complete = (page) => page.waitForFunction(() => {
  const hours = document.querySelector('#viewer').sunHours;
  return hours && hours.counted === hours.of;
}, null, { timeout: 120000 }).then(() => settled(page));
const hoursAt = (page, places) => page.evaluate((all) =>
  all.map(([x, y]) => document.querySelector('#viewer').sunHoursAt(x, y)), places);

test('counts are those of the program, and the pointer is told them', async () => {
  const page = await shared.open('/', { size });
  await change(page, { sun: munich, show_lights: false, ground: 'off', sun_hours_step: 30 });
  await page.check('#sun-hours');
  await page.waitForFunction(() => /^Hours of sun: \d+ of 24 sun positions$/.test(
    document.querySelector('#hours-progress').textContent));
  await complete(page);
  assert.equal(await page.textContent('#hours-progress'), 'Hours of sun, from 24 positions');
  assert.equal(await page.textContent('#hours-most'), '12 h');
  const { sun, camera } = await stateOf(page);
  const counts = sunHours({ sun, camera }, 30);
  assert.equal(counts.of, 24);
  const places = [];
  for (let y = 5; y < size.height; y += 10)
    for (let x = 5; x < size.width; x += 10) places.push([x, y]);
  const shown = await hoursAt(page, places.map(([x, y]) => [x + 0.5, y + 0.5]));
  let different = 0;
  const values = new Set();
  shown.forEach((here, i) => {
    const [x, y] = places[i];
    const { lit, surface } = counts.at(x, y);
    if ((here?.lit ?? -1) !== (surface ? lit : -1)) different += 1;
    values.add(here?.lit ?? -1);
    if (here) assert.deepEqual([here.of, here.step], [24, 30]);
  });
  console.log(`${different} of ${places.length} pixels differ`);
  // Pixels on outlines of shadows and surfaces, where the last bits of depth decide.
  assert.ok(different <= 0.0003 * places.length, `${different} of ${places.length} pixels differ`);
  assert.ok(values.size > 12 && values.has(-1), `only ${values.size} values`);

  const of = await page.evaluate(() => document.querySelector('#hours').getBoundingClientRect().top);
  const at = (wanted) => places[shown.findIndex((here, i) =>
    wanted(here) && places[i][0] < 0.7 * size.width && places[i][1] < of - 40)];
  const sunny = at((here) => here?.lit > 3 && here.lit < 24);
  await page.mouse.move(...sunny);
  const { lit } = shown[places.indexOf(sunny)];
  await page.waitForSelector('#hours-here', { state: 'visible' });
  assert.equal(await page.textContent('#hours-here'), `${durationText(30 * lit)} of 12 h`);
  const label = await page.locator('#hours-here').boundingBox();
  assert.ok(Math.abs(label.x + label.width / 2 - sunny[0]) < 2 && Math.abs(label.y - sunny[1]) < 60);
  await page.mouse.move(...at((here) => here === null));
  await page.waitForSelector('#hours-here', { state: 'hidden' });
  await shared.check(page);
});

test('the legend has the colours of the picture', async () => {
  const page = await shared.open(`${address}&ground=%23808080&lights=off&sun-hours=60`, { size });
  await complete(page);
  const apart = await page.evaluate(async () => {
    const viewer = document.querySelector('#viewer');
    const { hourColors } = await import('/element/edgeshade-viewer.js');
    const bitmap = await createImageBitmap(await viewer.screenshot(), { colorSpaceConversion: 'none' });
    const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d', { willReadFrequently: true });
    context.drawImage(bitmap, 0, 0);
    const channel = (color, c) => parseInt(color.slice(1 + 2 * c, 3 + 2 * c), 16);
    const seen = new Map();
    let worst = 0;
    for (let y = 5; y < bitmap.height; y += 10)
      for (let x = 5; x < bitmap.width; x += 10) {
        const here = viewer.sunHoursAt(x + 0.5, y + 0.5);
        if (!here) continue;
        const place = (hourColors.length - 1) * here.lit / here.of;
        const from = Math.min(Math.floor(place), hourColors.length - 2);
        const pixel = context.getImageData(x, y, 1, 1).data;
        for (const c of [0, 1, 2]) {
          const [a, b] = [channel(hourColors[from], c), channel(hourColors[from + 1], c)];
          worst = Math.max(worst, Math.abs(a + (b - a) * (place - from) - pixel[c]));
        }
        seen.set(here.lit, true);
      }
    return { worst, seen: seen.size, gradient: document.querySelector('#hours-scale > div').style.background };
  });
  assert.ok(apart.worst <= 3.5, `${apart.worst}`);
  assert.ok(apart.seen > 4, `only ${apart.seen} hours are to be seen`);
  assert.match(apart.gradient, /linear-gradient\(90deg, rgb\(14, 21, 82\).*rgb\(255, 238, 105\)/);
  await shared.check(page);
});

test('what moves starts anew, and is the usual picture until all is counted', async () => {
  const page = await shared.open(`${address}&sun-hours=30`);
  await complete(page);
  assert.ok((await hoursAt(page, [[260, 260]]))[0]);
  await change(page, { sun: { time: '2026-03-21T15:00+01:00' } });
  await settled(page);
  assert.equal((await page.evaluate(() => document.querySelector('#viewer').sunHours)).counted, 24);
  assert.ok((await hoursAt(page, [[260, 260]]))[0], 'another time of that day changes nothing');
  const counted = await page.evaluate(() => {
    const viewer = document.querySelector('#viewer');
    viewer.change({ camera: { fov: viewer.state.camera.fov + 1 } });
    return new Promise((resolve) => {
      viewer.addEventListener('frame', () => resolve([viewer.sunHours.counted, viewer.sunHoursAt(260, 260)]), { once: true });
    });
  });
  assert.deepEqual(counted, [0, null]);
  await complete(page);
  assert.ok((await hoursAt(page, [[260, 260]]))[0]);
  await page.click('#play-day');
  await page.waitForFunction(() => document.querySelector('#hours-progress').textContent === 'Hours of sun: shown when nothing moves');
  assert.deepEqual(await hoursAt(page, [[260, 260]]), [null]);
  await page.click('#play-day');
  await page.waitForSelector('#hours-scale', { state: 'visible' });
  await page.uncheck('#sun-hours');
  await page.waitForSelector('#hours', { state: 'hidden' });
  assert.equal(await page.evaluate(() => document.querySelector('#viewer').sunHours), null);
  await shared.check(page);
});

test('box, step and key change the state, and the address keeps it', async () => {
  const page = await shared.open(address);
  assert.equal(await page.isVisible('#hours'), false);
  await page.check('#sun-hours');
  await page.selectOption('#sun-hours-step', '60');
  assert.deepEqual((({ sun_hours: on, sun_hours_step: step }) => [on, step])(await stateOf(page)), [true, 60]);
  await page.waitForFunction(() => location.hash.includes('&sun-hours=60'));
  const hash = await page.evaluate(() => location.hash);
  await page.evaluate(() => document.querySelector('#viewer').focus());
  await page.keyboard.press('y');
  assert.equal((await stateOf(page)).sun_hours, false);
  await page.waitForFunction(() => !location.hash.includes('sun-hours') && !document.querySelector('#sun-hours').checked);
  await shared.check(page);

  const again = await shared.open(`/${hash}`);
  await complete(again);
  assert.equal(await again.isChecked('#sun-hours'), true);
  assert.equal(await again.inputValue('#sun-hours-step'), '60');
  await again.uncheck('#by-place');
  assert.equal((await stateOf(again)).sun_hours, false, 'they are of a place and a day');
  await shared.check(again);
});

test('a night of months has none, and a step that makes no sense says so', async () => {
  const page = await shared.open(`${smallPage}&place=78.2,15.6&time-of-day=2026-12-21T12:00%2B01:00&sun-hours=10`);
  await page.waitForFunction(() => document.querySelector('#hours-progress').textContent === 'The sun does not rise on this day.');
  assert.equal(await page.isVisible('#hours-scale'), false);
  await assert.rejects(change(page, { sun_hours_step: 7 }), /sun_hours_step is 7, but must be minutes that divide a day/);
  await shared.check(page);
  const wrong = await shared.open(`${address}&sun-hours=often`);
  await waitForNotice(wrong, /sun-hours.*often/);
  assert.equal((await stateOf(wrong)).sun_hours, false);
  await shared.check(wrong);
});

test('words of the state, the attributes and the page', () => {
  const read = (attributes) => changesFromAttributes((name) => attributes[name] ?? null);
  assert.deepEqual(read({ 'sun-hours': '' }), { sun_hours: true });
  assert.deepEqual(read({ 'sun-hours': '15' }), { sun_hours: true, sun_hours_step: 15 });
  assert.deepEqual(read({ 'sun-hours': 'off' }), { sun_hours: false });
  assert.throws(() => read({ 'sun-hours': 'often' }), /The attribute sun-hours is 'often'/);
  const state = { camera: { from: [1, 2, 3], to: [0, 0, 0], fov: 45 }, lights: [[0, 1, 0, 0]], sun: munich,
    sun_hours: true, sun_hours_step: 15, ambient: 0.4, speed: 1, shading: 'full', left: {}, right: {} };
  const { changes, problems } = readHash(hashOf(null, state));
  assert.deepEqual(problems, []);
  assert.deepEqual([changes.sun_hours, changes.sun_hours_step], [true, 15]);
  assert.deepEqual([0, 45, 60, 200].map(durationText), ['0 h', '45 min', '1 h', '3 h 20 min']);
  assert.equal(hoursText({ lit: 20, of: 57, step: 10 }), '3 h 20 min of 9 h 30 min');
  assert.equal(progressText({ counted: 37, of: 61 }), 'Hours of sun: 37 of 61 sun positions');
});
