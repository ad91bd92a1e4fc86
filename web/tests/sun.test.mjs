// A sun by place and time: the panel, the address, the element's attributes, a day that plays.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { settled, smallPage, stateOf, useBrowser, waitForNotice } from './support/browser.mjs';
import { rendered, size } from './support/native.mjs';
import { compare, picture } from './support/pictures.mjs';
import { changesFromAttributes, withOthers } from '../element/attributes.js';
import { dateOf, dayOf, daysOfYear, offsets, offsetText, partsOf, timeOf } from '../page/local-time.js';
import { hashOf, readHash } from '../page/url-state.js';

const shared = useBrowser();
const munich = { place: [48.14, 11.57], time: '2026-06-21T14:30+02:00', north: 25 };
const address = `${smallPage}&place=48.14,11.57&time-of-day=2026-06-21T14:30%2B02:00&north=25`;

const sunOf = (page) => page.evaluate(() => document.querySelector('#viewer').sun);
const change = (page, changes) =>
  page.evaluate((wanted) => document.querySelector('#viewer').change(wanted), changes);
const near = (actual, expected, most) =>
  assert.ok(Math.abs(actual - expected) <= most, `${actual}, not ${expected}`);

test('an address places it, as the program does', async () => {
  const page = await shared.open(address);
  const { sun, lights } = await stateOf(page);
  assert.deepEqual(sun, munich);
  assert.equal(lights.length, 1);
  const now = await sunOf(page);
  near(now.azimuth, 217.464, 0.001);
  near(now.altitude, 61.227, 0.001);
  assert.equal(now.up, true);
  assert.match(now.rise, /^2026-06-21T05:1\d:\d\d\+02:00$/);
  const clockwise = (now.azimuth + 25) * Math.PI / 180;
  const level = Math.cos(now.altitude * Math.PI / 180);
  [level * Math.sin(clockwise), Math.sin(now.altitude * Math.PI / 180), -level * Math.cos(clockwise), 0]
    .forEach((expected, i) => near(lights[0][i], expected, 1e-9));
  assert.equal(await page.isChecked('#by-place'), true);
  assert.equal(await page.inputValue('#date'), '2026-06-21');
  assert.equal(await page.inputValue('#utc-offset'), '+02:00');
  assert.match(await page.textContent('#sun-now'), /^Azimuth 217\.5°, height 61\.2°: up from 05:1\d to 21:1\d\.$/);
  await shared.check(page);
});

test('the picture is that of --place, by day and by night', async () => {
  const page = await shared.open('/', { size });
  for (const time of ['2026-06-21T18:30+02:00', '2026-06-21T01:00+02:00']) {
    await change(page, { sun: { ...munich, time }, show_lights: false, ambient: 0.4 });
    await settled(page);
    const state = await stateOf(page);
    const native = rendered({ ...state, lights: [] },
      ['--place', '48.14,11.57', '--time-of-day', time, '--north', '25']);
    const { different, pixels } = await compare(page, await picture(page), native);
    assert.ok(different <= 0.005 * pixels, `${time}: ${different} of ${pixels} pixels differ`);
  }
  assert.equal((await sunOf(page)).up, false);
  assert.match(await page.textContent('#sun-now'), /below the horizon/);
  await shared.check(page);
});

test('its way is drawn with the handles', async () => {
  const page = await shared.open(address);
  const shown = await picture(page);
  await change(page, { show_lights: false });
  const hidden = await picture(page);
  await change(page, { show_lights: true, sun: { time: '2026-12-21T12:00+01:00' } });
  const winter = await picture(page);
  for (const [a, b] of [[shown, hidden], [shown, winter]])
    assert.ok((await compare(page, a, b)).different > 100);
  await shared.check(page);
});

test('sliders, date and place move it, and the address keeps it', async () => {
  const page = await shared.open();
  assert.equal(await page.isVisible('#sun-place'), false);
  await page.check('#by-place');
  await page.waitForSelector('#sun-place', { state: 'visible' });
  assert.ok((await stateOf(page)).sun);
  await page.fill('#latitude', '-33.87');
  await page.fill('#longitude', '151.21');
  await page.press('#longitude', 'Tab');
  await page.fill('#date', '2024-02-29');
  await page.selectOption('#utc-offset', '+11:00');
  await page.fill('#time-of-day', '545');
  await page.fill('#north', '-30');
  assert.deepEqual((await stateOf(page)).sun,
    { place: [-33.87, 151.21], time: '2024-02-29T09:05+11:00', north: -30 });
  await page.waitForFunction(() => document.querySelector('#day').max === '366'); // a leap year has
                                                                                  // 366 days
  await page.fill('#day', '366');
  assert.equal((await stateOf(page)).sun.time, '2024-12-31T09:05+11:00');
  await page.waitForFunction(() => document.querySelector('#date').value === '2024-12-31');
  await page.waitForFunction(() => /place=-33\.87,151\.21&time-of-day=2024-12-31T09%3A05%2B11%3A00&north=-30/.test(location.hash));
  const hash = await page.evaluate(() => location.hash);
  await page.uncheck('#by-place');
  assert.equal((await stateOf(page)).sun, null);
  assert.equal((await stateOf(page)).lights.length, 1, 'it stays as a plain sun');
  await page.waitForFunction(() => !location.hash.includes('place='));
  await shared.check(page);

  const again = await shared.open(`/${hash}`);
  assert.deepEqual((await stateOf(again)).sun,
    { place: [-33.87, 151.21], time: '2024-12-31T09:05+11:00', north: -30 });
  await shared.check(again);
});

test('a day plays, round and round, until it is paused or the sun is moved', async () => {
  const page = await shared.open(address);
  const minutes = async () => partsOf((await stateOf(page)).sun.time).minutes;
  const start = await minutes();
  await page.click('#play-day');
  await page.waitForFunction(() => document.querySelector('#viewer').state.sun.time > '2026-06-21T15');
  assert.ok(await minutes() > start);
  assert.equal(await page.getAttribute('#play-day', 'aria-pressed'), 'true');
  await page.click('#play-day');
  const paused = await minutes();
  await settled(page);
  assert.equal(await minutes(), paused);
  await change(page, { sun: { time: '2026-06-21T23:59+02:00' }, day_playing: true });
  await page.waitForFunction(() => document.querySelector('#viewer').state.sun.time < '2026-06-21T12');
  await page.fill('#azimuth', '90'); // the compass: the light is moved manually
  const state = await stateOf(page);
  assert.equal(state.sun, null);
  assert.equal(state.day_playing, false);
  await page.waitForFunction(() => !document.querySelector('#by-place').checked); // the panel follows
  await shared.check(page);
});

test('keys move it, and who wants less motion is not played a day', async () => {
  const page = await shared.open(`${address}&day=playing`, { reducedMotion: 'reduce' });
  assert.equal((await stateOf(page)).day_playing, false);
  await page.evaluate(() => document.querySelector('#viewer').focus());
  for (const [key, time] of [['0', '2026-06-21T14:40+02:00'], ['9', '2026-06-21T14:30+02:00'],
    ['8', '2026-06-22T14:30+02:00'], ['7', '2026-06-21T14:30+02:00']]) {
    await page.keyboard.press(key);
    assert.equal((await stateOf(page)).sun.time, time);
  }
  await page.keyboard.press('j');
  assert.equal((await stateOf(page)).day_playing, true);
  await page.emulateMedia({ reducedMotion: 'no-preference' });
  await settled(page); // otherwise neither is noticed
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.waitForFunction(() => !document.querySelector('#viewer').state.day_playing);
  await shared.check(page);
});

test('an address or a change that makes no sense says so', async () => {
  const page = await shared.open(`${smallPage}&place=48.14,11.57`);
  await waitForNotice(page, /only one of 'place' and 'time-of-day'/);
  for (const [sun, message] of [
    [{ place: [91, 0], time: '2026-06-21T14:30Z' }, /sun\.place: 91 is not a valid latitude/],
    [{ place: [0, 0], time: '2025-02-29T14:30Z' }, /sun\.time: .*month 2 of 2025 has no day 29/],
    [{ place: [0, 0], time: 'noon' }, /sun\.time: 'noon' is not a valid time/],
    [{ place: [0, 0] }, /'place' and a 'time'/]])
    await assert.rejects(change(page, { sun }), message);
  assert.equal((await stateOf(page)).sun, null);
  await shared.check(page);
  const wrong = await shared.open(`${smallPage}&place=48.14,11.57&time-of-day=yesterday`);
  await waitForNotice(wrong, /yesterday/);
  await shared.check(wrong);
});

test('attributes say it together', () => {
  const said = { place: '48.14, 11.57', 'time-of-day': munich.time, north: '25', 'day-playing': '' };
  const { sun, day_playing: playing } = changesFromAttributes((name) => said[name] ?? null);
  assert.deepEqual(sun, munich);
  assert.equal(playing, true);
  assert.deepEqual(withOthers(['north']).sort(), ['north', 'place', 'time-of-day']);
  assert.throws(() => changesFromAttributes((name) => (name === 'place' ? '48' : null)), /place is '48'.*2 numbers/);
});

test('words survive the address', () => {
  const state = { camera: { from: [1, 2, 3], to: [0, 0, 0], fov: 45 }, lights: [[0, 1, 0, 0]], sun: munich, day_playing: true,
    ambient: 0.4, speed: 1, shading: 'full', left: {}, right: {} };
  const { changes, problems } = readHash(hashOf({ url: 'a.glb' }, state));
  assert.deepEqual(problems, []);
  assert.deepEqual(changes.sun, munich);
  assert.equal(changes.day_playing, true);
});

test('sliders know the calendar', () => {
  assert.deepEqual(partsOf('2024-02-29T12:05:30-03:30'), { date: '2024-02-29', minutes: 725, offset: '-03:30' });
  assert.equal(timeOf({ date: '2024-02-29', minutes: 5, offset: '+05:45' }), '2024-02-29T00:05+05:45');
  assert.equal(daysOfYear(2024), 366);
  assert.equal(daysOfYear(1900), 365);
  for (const date of ['1900-01-01', '2000-02-29', '2024-12-31', '2100-12-31'])
    assert.equal(dateOf(Number(date.slice(0, 4)), dayOf(date)), date);
  assert.deepEqual([-570, 0, 345].map(offsetText), ['-09:30', '+00:00', '+05:45']);
  assert.equal(new Set(offsets).size, offsets.length);
});
