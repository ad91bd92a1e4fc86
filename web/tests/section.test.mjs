// Sections: the tool by mouse, touch and keys, the panel, the address, the element's attributes.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { changesFromAttributes, withOthers } from '../element/attributes.js';
import { kindOfSection } from '../page/section.js';
import { hashOf, readHash } from '../page/url-state.js';
import { settled, smallPage, stateOf, useBrowser, waitForNotice } from './support/browser.mjs';
import { rendered } from './support/native.mjs';
import { compare, picture } from './support/pictures.mjs';

const shared = useBrowser();
const change = async (page, changes) => {
  await page.evaluate((wanted) => document.querySelector('edgeshade-viewer').change(wanted), changes);
  await settled(page);
};
/** The eye looks along -z at the middle of the picture, where the handle of a plane through x = 0 is. */
const camera = { from: [0, 1, 9], to: [0, 1, 0], fov: 40 };
const plane = (d) => ({ planes: [[1, 0, 0, d]], shadows: 'cut', fill: '#cc5540' });

/** The page's place of the picture's middle, whose surroundings hold the handle. */
const middleOf = (page) => page.evaluate(() => {
  const box = document.querySelector('edgeshade-viewer').getBoundingClientRect();
  return [box.left + box.width / 2, box.top + box.height / 2];
});

/** Shows a plane whose handle is in the middle of the picture. Returns that place. */
async function aim(page) {
  const middle = [];
  for (const [axis, command] of ['sectionX', 'sectionY', 'sectionZ', 'sectionX'].entries()) {
    await page.evaluate((one) => document.querySelector('edgeshade-viewer').run(one), command);
    const [plane] = (await stateOf(page)).section.planes;
    middle[axis % 3] = -plane[3] / plane[axis % 3];
  }
  const [x, y, z] = middle;
  await change(page, { lights: [[0.3, 1, 0.4, 0]], camera: { from: [x, y, z + 9], to: [x, y, z], fov: 40 } });
  return middleOf(page);
}

/** Waits until the light rests and is looked up. */
const lookedUp = (page) => page.waitForFunction(() => {
  const { lights } = document.querySelector('edgeshade-viewer').stats;
  return lights.length > 0 && lights.every(({ method }) => method === 'primitive-map');
});

const offset = ({ section: { planes: [[x, , , d]] } }) => -d / x;

test('the mouse drags a plane along its normal, and the address keeps it', async () => {
  const page = await shared.open(smallPage);
  const [x, y] = await aim(page);
  const before = await stateOf(page);
  await page.mouse.move(x + 4, y);
  await page.mouse.down();
  await page.mouse.move(x + 64, y + 10, { steps: 5 });
  await page.mouse.up();
  await settled(page);
  const after = await stateOf(page);
  assert.ok(offset(after) > offset(before) + 0.1, `${offset(before)} to ${offset(after)}`);
  assert.deepEqual(after.camera, before.camera);
  // The address follows a little later.
  await page.waitForFunction((last) => decodeURIComponent(location.hash).includes(last), String(offset(after)));
  assert.ok((await page.evaluate(() => location.hash)).includes('section-fill'));
  const again = await shared.open(`/${await page.evaluate(() => location.hash)}`);
  assert.deepEqual((await stateOf(again)).section, after.section);
  await shared.check(page);
  await shared.check(again);
});

test('a finger drags it too', async () => {
  const page = await shared.open(smallPage, { hasTouch: true, size: { width: 390, height: 844 } });
  const [x, y] = await aim(page);
  const before = await stateOf(page);
  const session = await page.context().newCDPSession(page);
  for (const [type, step] of [['touchStart', 0], ['touchMove', 20], ['touchMove', 45]])
    await session.send('Input.dispatchTouchEvent', { type, touchPoints: [{ id: 0, x: x + step, y: y - 8 }] });
  await session.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
  await settled(page);
  const after = await stateOf(page);
  assert.ok(offset(after) > offset(before) + 0.05, `${offset(before)} to ${offset(after)}`);
  assert.deepEqual(after.camera, before.camera);
  await shared.check(page);
});

test('keys and panel cut, flip, fill and make whole', async () => {
  const page = await shared.open(smallPage);
  await page.evaluate(() => document.querySelector('#viewer').focus());
  const press = async (key) => {
    await page.keyboard.press(key);
    await settled(page);
    return (await stateOf(page)).section;
  };
  for (const [key, kind] of [['1', 'x'], ['2', 'y'], ['3', 'z'], ['4', 'free'], ['5', 'box']]) {
    assert.equal(kindOfSection(await press(key)), kind);
    assert.equal(await page.inputValue('#section'), kind);
  }
  assert.equal((await press('o')).shadows, 'whole');
  assert.equal(await press('z'), null);
  await page.selectOption('#section', 'y');
  const cut = (await stateOf(page)).section;
  assert.equal(kindOfSection(cut), 'y');
  await page.click('#section-flip');
  assert.deepEqual((await stateOf(page)).section.planes[0], cut.planes[0].map((value) => 0 - value));
  await page.check('#section-whole');
  await page.uncheck('#section-filled');
  await settled(page);
  const { shadows, fill } = (await stateOf(page)).section;
  assert.deepEqual([shadows, fill], ['whole', 'none']);
  await page.selectOption('#section', 'off');
  assert.equal((await stateOf(page)).section, null);
  await shared.check(page);
});

test('the picture is that of render --section', async () => {
  const page = await shared.open('/tests/plain.html');
  for (const shadows of ['cut', 'whole']) {
    await change(page, { ambient: 0.4, ground: 'off', lights: [[0.5, 1, 0.3, 0]], show_lights: false,
      section: { planes: [[0, -1, 0, 2]], shadows } });
    const wanted = rendered(await stateOf(page),
      ['--ground', 'off', '--section', '0,-1,0,2', '--section-shadows', shadows]);
    for (const method of ['volumes', 'primitive-map']) {
      await change(page, { left: { shadows: method } });
      if (method === 'primitive-map') await lookedUp(page);
      const { pixels, different, astray } = await compare(page, await picture(page), wanted);
      assert.ok(different < 0.004 * pixels && astray < 40, `${shadows}, ${method}: ${different} of ${pixels} differ, ${astray} astray`);
    }
  }
  await shared.check(page);
});

test('attributes cut the scene, and a wrong one says so', async () => {
  const read = (attributes) => changesFromAttributes((name) => attributes[name] ?? null).section;
  assert.deepEqual(read({ section: '0,1,0,-2; 1 0 0 3', 'section-shadows': 'whole', 'section-fill': 'none' }),
    { planes: [[0, 1, 0, -2], [1, 0, 0, 3]], shadows: 'whole', fill: 'none' });
  assert.equal(read({ section: 'off' }), null);
  assert.equal(read({}), undefined);
  assert.throws(() => read({ section: '1,2,3' }), /section is '1,2,3'.*4 numbers/);
  assert.ok(withOthers(['section-shadows']).includes('section'));
  const page = await shared.open(smallPage);
  const set = (name, value) => page.evaluate(([n, v]) => document.querySelector('#viewer').setAttribute(n, v), [name, value]);
  await set('section', '1,0,0,0.25');
  assert.deepEqual((await stateOf(page)).section, plane(0.25));
  await set('section', '0,0,0,1');
  await waitForNotice(page, /section\.planes\[0\]/);
  assert.deepEqual((await stateOf(page)).section, plane(0.25));
  await shared.check(page);
});

test('planes survive the address to the last bit', () => {
  const section = { planes: [[0.1, -1 / 3, 1e-7, 1234567.891], [0, 1, 0, -2]], shadows: 'whole', fill: 'none' };
  const state = { camera: { ...camera }, lights: [[0, 1, 0, 0]], left: {}, ambient: 0.4, exposure: 0, speed: 1,
    shading: 'full', ground: 'off', show_lights: true, debug: 'none', section };
  const { changes, problems } = readHash(hashOf(null, state));
  assert.deepEqual(problems, []);
  assert.deepEqual(changes.section, section);
  assert.match(readHash('#section=1,2,x,4').problems[0], /section.*1,2,x,4/);
});
