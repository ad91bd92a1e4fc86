// The ground beneath scenes without a floor, as in the native program.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { loaded, settled, smallElement, stateOf, useBrowser } from './support/browser.mjs';
import { rendered } from './support/native.mjs';
import { compare, picture } from './support/pictures.mjs';
import { smallGltf } from './support/scenes.mjs';

const shared = useBrowser();
const camera = { from: [5, 6, 8], to: [0, 0.8, 0], fov: 40 };

/** Only the pillar of the small scene. */
function pillar() {
  const gltf = JSON.parse(smallGltf());
  delete gltf.animations;
  gltf.scenes[0].nodes = [1];
  return Buffer.from(JSON.stringify(gltf));
}

const show = (page, bytes) => page.evaluate(async (base64) => {
  const content = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
  await document.querySelector('edgeshade-viewer').load([new File([content], 'scene.gltf')]);
}, bytes.toString('base64'));

const change = async (page, changes) => {
  await page.evaluate((wanted) => document.querySelector('edgeshade-viewer').change(wanted), changes);
  await settled(page);
};

test('a scene without a floor gets a ground that catches shadow, others none', async () => {
  const page = await shared.open(smallElement);
  await show(page, pillar());
  assert.equal((await stateOf(page)).ground, 'catcher');
  await show(page, smallGltf());
  assert.equal((await stateOf(page)).ground, 'off');
  await shared.check(page);
});

test('grounds look as they do natively', async () => {
  const page = await shared.open(smallElement);
  const scene = pillar();
  await show(page, scene);
  await change(page, { camera, ambient: 0.4, lights: [[0.5, 1, 0.3, 0]] });
  const pictures = [];
  for (const ground of ['catcher', '#8090a0', 'off']) {
    await change(page, { ground });
    const shown = await picture(page);
    const { pixels, different, astray } =
      await compare(page, shown, rendered(await stateOf(page), ['--ground', ground], { scene }));
    assert.ok(different < 0.004 * pixels, `${ground}: ${different} of ${pixels} pixels differ`);
    assert.ok(astray < 40, `${ground}: ${astray} astray`);
    pictures.push(shown);
  }
  const { different } = await compare(page, pictures[0], pictures[2]);
  assert.ok(different > 800, `a shadow of ${different} pixels`);
  await shared.check(page);
});

test('the panel chooses the ground', async () => {
  const page = await shared.open('/#model=tests/small.gltf');
  await loaded(page);
  await page.selectOption('#ground', 'color');
  await settled(page);
  assert.match((await stateOf(page)).ground, /^#[0-9a-f]{6}$/);
  assert.equal(await page.isVisible('#ground-color'), true);
  await page.selectOption('#ground', 'catcher');
  await settled(page);
  assert.equal((await stateOf(page)).ground, 'catcher');
  assert.equal(await page.isVisible('#ground-color'), false);
  await shared.check(page);
});

test('words that are no ground are refused', async () => {
  const page = await shared.open('/#model=tests/small.gltf');
  await loaded(page);
  const said = await page.evaluate(() => {
    try {
      document.querySelector('#viewer').change({ ground: 'lava' });
      return '';
    } catch (error) {
      return error.message;
    }
  });
  assert.match(said, /ground.*lava.*catcher/);
  await shared.check(page);
});
