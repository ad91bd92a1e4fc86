// The page that compares with three.js's own maps: it shows, measures and saves, if three.js is
// installed.

import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { promisify } from 'node:util';
import { drop, useBrowser } from './support/browser.mjs';
import { times } from './support/long.mjs';
import { packedGltf, smallGlb, smallGltf, texelsAsPng, texturedGltf } from './support/scenes.mjs';
import { repository } from './support/server.mjs';

const shared = useBrowser();
const skip = existsSync(join(repository, 'web/node_modules/three/package.json')) ? false
  : "three is not installed; 'npm ci' in web/ does that.";

/** Opens the page with a small scene. */
async function opened(query = '', { model = '/tests/small.gltf', ...options } = {}) {
  const page = await shared.open(`/compare/?antialias=off&model=${model}&light=-0.61,0.71,-0.35,0&${query}`, { scene: false, size: { width: 740, height: 300 }, ...options });
  await page.waitForFunction(() => window.comparison);
  await page.evaluate(() => window.comparison.then(() => null));
  return page;
}

const sentenceOf = (page) => page.textContent('#problem');
const nameOf = (page) => page.textContent('#scene-name');
const dropHere = (page, files) => drop(page, files, '#picture');

/** Width of the first texture in the scene on show. */
const textureWidth = (page) => page.evaluate(async () => {
  let found = null;
  (await window.comparison).world.scene.traverse(({ material }) => { found ??= material?.map?.image?.width ?? null; });
  return found;
});

/** In the page: a method's pixels, RGBA, as a picture. */
const evaluated = (page, act, asked) => page.evaluate(async ({ text, given }) => {
  const comparison = await window.comparison;
  const { world, frameOf } = comparison;
  const size = [160, 90];
  world.pixelsOf(world.method('exact'), frameOf(), ...size);
  await world.exact.ready(); // the page goes on meanwhile, with its own lens
  world.setLens(45, size[0] / size[1]);
  const pixelsOf = (name, changes = {}) => world.pixelsOf(world.method(name, 512), { ...frameOf(), ...changes }, ...size);
  return (0, eval)(`(${text})`)({ comparison, world, frameOf, pixelsOf, size }, given);
}, { text: act.toString(), given: asked });

test('the page measures, shows its table and saves the JSON', { skip }, async () => {
  const page = await opened('left=exact&right=pcf-512');
  const tick = (names) => page.evaluate((wanted) => {
    for (const box of document.querySelectorAll('#contenders input, #sizes input')) box.checked = wanted.includes(box.value);
  }, names);
  await tick([]);
  await page.click('#measure');
  await page.waitForFunction(() => /There is nothing to measure/.test(document.querySelector('#problem').textContent));
  await tick(['exact', 'pcf', 'none', '512']);
  await page.selectOption('#frames', '12');
  await page.click('#measure');
  await page.waitForSelector('#results[open] table', { timeout: 60000 });
  const rows = await page.evaluate(() => [...document.querySelectorAll('#table tbody tr')].map((row) => row.cells[0].textContent));
  assert.deepEqual(rows, ['edgeshade', 'Map, PCF, 512', 'No shadows']);
  assert.match(await page.textContent('#table-notes'), /Median of 12 frames of \d+ × \d+ pixels.*small\.gltf, 36 triangles, a sun.*three\.js r\d+/);
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#save')]);
  assert.match(download.suggestedFilename(), /^edgeshade-small-\d{4}-\d\d-\d\d\.json$/);
  const results = JSON.parse(readFileSync(await download.path(), 'utf8'));
  for (const key of ['date', 'model', 'triangles', 'device', 'browser', 'processors', 'three_revision', 'size', 'antialias', 'gpu_timer', 'settings', 'loading', 'results'])
    assert.ok(results[key] !== undefined && results[key] !== '', key);
  assert.deepEqual(Object.keys(results.settings).sort(), ['ambient', 'bias', 'camera', 'frames', 'light', 'normal_bias', 'rounds', 'softness']);
  assert.ok(results.loading.milliseconds > 0 && results.loading.frames > 0);
  const [exact, map, without] = results.results;
  for (const result of results.results)
    for (const motion of [result.light_moves, result.light_rests]) {
      const { median, least, most } = motion.frame_ms;
      assert.ok(least > 0 && least <= median && median <= most, `${result.id}: ${least}, ${median}, ${most}`);
      assert.ok(motion.cpu_ms.median <= median && motion.ratio_to_exact > 0, result.id);
      assert.equal(motion.gpu_ms !== null, results.gpu_timer);
    }
  assert.equal(exact.light_moves.ratio_to_exact, 1);
  assert.ok(exact.bytes_gpu > 0 && without.bytes_gpu === 0);
  assert.equal(map.bytes_gpu, 512 * 512 * 8, 'depths, and the colours that three.js has beside them');
  assert.ok(map.wrong_percent > 0 && map.wrong_percent < 5, `${map.wrong_percent} % of the map's pixels are wrong`);
  assert.ok(map.wrong_beyond_1px_percent <= map.wrong_percent && map.mean_difference_percent > 0);
  assert.equal(without.wrong_percent, null);
  await shared.check(page);
});

test('the exact picture is the adapter\'s', { skip }, async () => {
  const page = await opened();
  const { same, apart } = await evaluated(page, async ({ world, frameOf, pixelsOf, size: [width, height] }) => {
    const { ExactShadows } = await import('edgeshade/three');
    const three = await import('three');
    const ours = pixelsOf('exact');
    const without = pixelsOf('none');
    pixelsOf('exact');
    // The same scene, drawn after `exact` by an adapter of the test's own.
    const { scene, camera, renderer } = world;
    world.exact.dispose();
    const exact = world.method('exact');
    exact.rig.group.visible = true;
    const shadows = new ExactShadows(renderer).add(scene);
    shadows.render(scene, camera);
    await shadows.ready();
    const target = new three.WebGLRenderTarget(width, height);
    renderer.setRenderTarget(target);
    shadows.render(scene, camera);
    const theirs = new Uint8Array(ours.length);
    renderer.readRenderTargetPixels(target, 0, 0, width, height, theirs);
    const differing = (a, b) => a.reduce((count, value, i) => count + (value !== b[i] ? 1 : 0), 0);
    return { same: differing(ours, theirs), apart: differing(ours, without) };
  });
  assert.equal(same, 0, 'values that differ');
  assert.ok(apart > 300, `${apart} values are others without shadows`);
  await shared.check(page);
});

for (const [light, names] of [['sun', ['exact', 'exact-soft', 'basic', 'pcf', 'vsm', 'pcss', 'csm', 'sunlight', 'bvh']], ['lamp', ['exact', 'exact-soft', 'basic', 'pcf', 'pcss', 'bvh']]])
  test(`methods differ in shadow alone, and mean the same shadows, of a ${light}`, { skip }, async () => {
    const page = await opened();
    await page.evaluate(async (kind) => (await window.comparison).change({ light: kind, softness: 5 }), light);
    const told = await evaluated(page, async ({ world, frameOf, pixelsOf, size }, asked) => {
      const { accuracyOf } = await import('/compare/accuracy.js');
      world.exact.lightSamples = 16;
      const masks = asked.map((name) => pixelsOf(name, { look: 'mask' }));
      const [bare, exact] = [pixelsOf('none'), pixelsOf('exact')];
      return asked.map((name, m) => {
        const shown = pixelsOf(name);
        let lit = 0, dark = 0, off = 0;
        for (let i = 0; i < shown.length; i += 4) {
          const apart = (other) => Math.max(...[0, 1, 2, 3].map((c) => Math.abs(shown[i + c] - other[i + c])));
          const where = masks[m][i];
          if (bare[i + 3] === 0) off += apart(bare) > 0; // behind the model
          else if (where === 255) {
            lit += 1;
            off += apart(bare) > 2;
          } else if (where === 0 && masks[0][i] === 0) {
            dark += 1;
            off += apart(exact) > 2;
          }
        }
        return { name, lit, dark, off, ...accuracyOf(masks[0], masks[m], ...size) };
      });
    }, names);
    for (const { name, lit, dark, off, surfaces, wrong, apart } of told) {
      assert.ok(lit > 500 && dark > 100, `${name}: ${lit} pixels are lit, ${dark} in shadow`);
      assert.ok(off <= 0.002 * surfaces, `${name}: ${off} of ${surfaces} pixels differ in other than shadow`);
      assert.ok(wrong <= 0.05 * surfaces, `${name}: ${wrong} of ${surfaces} pixels are wrong`);
      if (name === 'bvh') assert.ok(wrong <= 0.002 * surfaces, `${name}: ${wrong} of ${surfaces} pixels are wrong`);
      else if (name !== 'exact') assert.ok(apart > 0, `${name} has shadows of its own`);
    }
    await shared.check(page);
  });

test('files that are dropped are shown, with what they name and packed by meshopt or Draco', { skip }, async () => {
  const page = await opened();
  const png = { name: 'a b.png', bytes: texelsAsPng() };
  for (const [files, pattern] of [
    [[{ name: 'own.glb', bytes: smallGlb() }], /^own\.glb: 36 triangles/],
    [[{ name: 'textured.gltf', bytes: texturedGltf({ uri: 'a%20b.png' }) }, png], /^textured\.gltf: 36 triangles/],
    [[{ name: 'draco.gltf', bytes: packedGltf('draco') }], /^draco\.gltf: 2 triangles/],
    [[{ name: 'meshopt.gltf', bytes: packedGltf('meshopt') }], /^meshopt\.gltf: 2 triangles/],
  ]) {
    await dropHere(page, files);
    await page.waitForFunction((name) => document.querySelector('#scene-name').textContent.startsWith(name), files[0].name);
    assert.match(await nameOf(page), pattern);
    assert.equal(await sentenceOf(page), '');
    if (files.includes(png)) assert.equal(await textureWidth(page), 8);
  }
  await shared.check(page);
});

test('what can\'t be shown gets a sentence, and what was shown stays', { skip }, async () => {
  const page = await opened();
  const before = await nameOf(page);
  for (const [files, pattern] of [
    [[{ name: 'notes.txt', bytes: Buffer.from('hello') }], /^'notes\.txt' is not a glTF scene/],
    [[{ name: 'broken.glb', bytes: Buffer.from('glTF and no more') }], /^'broken\.glb' can't be shown: three\.js reads no glTF out of it \(.+\)\.$/],
    [[{ name: 'words.gltf', bytes: Buffer.from('no JSON') }], /^'words\.gltf' can't be shown/],
    [[{ name: 'bare.gltf', bytes: Buffer.from('{"asset":{"version":"2.0"},"scenes":[{}],"scene":0}') }], /there is no surface in it\)\.$/],
  ]) {
    await dropHere(page, files);
    await page.waitForFunction((name) => document.querySelector('#problem').textContent.includes(name), files[0].name);
    assert.match(await sentenceOf(page), pattern);
    assert.equal(await nameOf(page), before);
  }
  await dropHere(page, [{ name: 'small.gltf', bytes: smallGltf() }]);
  await page.waitForFunction(() => document.querySelector('#problem').hidden);
  await shared.check(page);
  const gone = await opened('', { model: 'nothing.glb' });
  assert.match(await sentenceOf(gone), /'nothing\.glb' was not found: the server answered 404\./);
  assert.match(await nameOf(gone), /No model yet/);
  await shared.check(gone, [/404/]);
});

test('the best biases are found, and the line is dragged', { skip }, async () => {
  const page = await opened('right=basic-512&bias=-0.02');
  assert.equal(await page.inputValue('#bias'), '-0.02');
  const wrong = () => evaluated(page, async ({ frameOf, pixelsOf, size }) => {
    const { accuracyOf } = await import('/compare/accuracy.js');
    return accuracyOf(pixelsOf('exact', { look: 'mask' }), pixelsOf('basic', { look: 'mask' }), ...size).wrong;
  });
  const before = await wrong();
  await page.click('#tune');
  await page.waitForFunction(() => /pixels are wrong with the best/.test(document.querySelector('#progress').textContent));
  assert.ok(await wrong() < before, `${before} pixels before`);
  await page.press('#divider', 'End');
  assert.equal(await page.getAttribute('#divider', 'aria-valuetext'), '100 % edgeshade');
  await shared.check(page);
});

test('see-through materials, clear coats and coordinates look as three.js has them', { skip }, async () => {
  const folder = mkdtempSync(join(tmpdir(), 'edgeshade-'));
  try {
    const asked = ['see-through', ...times([], ['clear coat', 'second coordinates'])];
    const script = join(repository, 'web/compare/measure-materials.mjs');
    const told = await promisify(execFile)('node', [script, '--keep', folder,
      '--only', asked.join()], { timeout: 300000 });
    const rows = [...told.stdout.matchAll(/^\| ([^|]+) \| ([\d.]+) \| ([\d.]+) \| ([\d.]+) \| ([\d.]+) \|$/gm)];
    assert.equal(rows.length, asked.length, told.stdout);
    for (const [, name, , off, , on] of rows) {
      assert.ok(Number(off) < 1.5, `${name}: ${off} without an environment`);
      assert.ok(Number(on) < 3.5, `${name}: ${on} with one`);
    }
  } finally {
    rmSync(folder, { recursive: true });
  }
});
