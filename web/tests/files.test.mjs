// Files from users: good ones are shown, bad ones are explained and change nothing.

import assert from 'node:assert/strict';
import { existsSync, mkdtempSync, openSync, ftruncateSync, closeSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { drop, loaded, noticesOf, settled, stateOf, useBrowser, waitForNotice } from './support/browser.mjs';
import { compare, picture } from './support/pictures.mjs';
import { repository } from './support/server.mjs';

const shared = useBrowser();
const sample = readFileSync(join(repository, 'assets/pavilion.glb'));

/** A glTF of one triangle, whose buffer is in a separate file. */
const triangle = {
  gltf: (uri) => Buffer.from(JSON.stringify({
    asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
    accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: 'VEC3', min: [0, 0, 0], max: [1, 1, 0] }],
    bufferViews: [{ buffer: 0, byteLength: 36 }], buffers: [{ uri, byteLength: 36 }],
  })),
  binary: Buffer.from(new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]).buffer),
};

const sceneName = (page) => page.textContent('#scene-name');

test('a dropped Draco file is decoded in the browser and shown', async () => {
  const page = await shared.open();
  const before = await picture(page);
  const garden = join(repository, '../shared/scenes/garden.draco.glb');
  const [name, bytes] = existsSync(garden) ? ['garden.draco.glb', readFileSync(garden)] : ['again.glb', sample];
  await drop(page, [{ name, bytes }]);
  await page.waitForFunction((wanted) => document.querySelector('#scene-name').textContent.startsWith(wanted), name);
  await loaded(page);
  if (existsSync(garden)) assert.match(await sceneName(page), /21,883 triangles/);
  const { different, pixels } = await compare(page, before, await picture(page));
  assert.ok(different > 0.01 * pixels, 'another picture');
  assert.deepEqual(await noticesOf(page, 'error'), []);
  await shared.check(page);
});

test('a dropped .gltf takes its files along, with their folder or without', async () => {
  const page = await shared.open();
  await drop(page, [{ name: 'one.gltf', bytes: triangle.gltf('one.bin') }, { name: 'one.bin', bytes: triangle.binary }]);
  await page.waitForFunction(() => /^one\.gltf: 1 tri/.test(document.querySelector('#scene-name').textContent));
  await drop(page, [{ name: 'two.gltf', bytes: triangle.gltf('data/two%20b.bin') }, { name: 'two b.bin', bytes: triangle.binary }]);
  await page.waitForFunction(() => /^two\.gltf: 1 tri/.test(document.querySelector('#scene-name').textContent));
  await drop(page, [{ name: 'alone.gltf', bytes: triangle.gltf('missing.bin') }]);
  await waitForNotice(page, /'missing\.bin' does not exist\./);
  assert.match(await sceneName(page), /^two\.gltf/);
  await shared.check(page);
});

const wrong = [
  ['cut off', [{ name: 'cut.glb', bytes: sample.subarray(0, 5000) }], /^'cut\.glb' is cut off: its header says/],
  ['noise', [{ name: 'noise.glb', bytes: Buffer.alloc(400, 'x') }], /^'noise\.glb'.*\.$/],
  ['broken Draco data', [{ name: 'broken.glb', bytes: Buffer.from(sample).fill(0xAB, 60000, 61000) }], /^'broken\.glb'.*can't be decoded/],
  ['a wrong type', [{ name: 'photo.png', bytes: Buffer.from('PNG') }], /^'photo\.png' is not a glTF scene: choose a \.glb/],
  ['an empty file', [{ name: 'empty.glb', bytes: Buffer.alloc(0) }], /^'empty\.glb' is empty\.$/],
  ['two scenes', [{ name: 'a.glb', bytes: sample }, { name: 'b.glb', bytes: sample }], /^The dropped files contain 2 scenes/],
  ['a count that no memory holds', [{ name: 'count.gltf', bytes: Buffer.from(JSON.stringify({
    ...JSON.parse(triangle.gltf('x.bin')),
    accessors: [{ componentType: 5126, count: 1000000000, type: 'VEC3' }], bufferViews: undefined, buffers: undefined,
  })) }], /^('count\.gltf'|That needs more memory).*\.$/],
];

test('a file that can\'t be shown gets a sentence, and the old scene stays', async () => {
  const page = await shared.open();
  const before = await picture(page);
  const [name, state] = [await sceneName(page), await stateOf(page)];
  for (const [what, files, pattern] of wrong) {
    await drop(page, files);
    await waitForNotice(page, pattern).catch(async () => {
      assert.fail(`${what}: ${JSON.stringify(await noticesOf(page))} does not match ${pattern}`);
    });
    assert.equal(await sceneName(page), name, what);
    assert.deepEqual(await stateOf(page), state, what);
  }
  await settled(page);
  assert.equal((await compare(page, before, await picture(page))).different, 0, 'the same picture');
  await shared.check(page);
});

test('a huge file is refused before it is read', async () => {
  const folder = mkdtempSync(join(tmpdir(), 'edgeshade-'));
  try {
    const path = join(folder, 'huge.glb');
    const file = openSync(path, 'w');
    ftruncateSync(file, 6e9); // a sparse file, which takes no space on the disk
    closeSync(file);
    const page = await shared.open();
    const name = await sceneName(page);
    await page.setInputFiles('#files', path);
    await waitForNotice(page, /'huge\.glb' has 6\.0 GB; the browser's viewer reads scenes of up to/);
    assert.equal(await sceneName(page), name);
    await shared.check(page);
  } finally {
    rmSync(folder, { recursive: true });
  }
});

test('an address that is not there, or not a scene, gets a sentence', async () => {
  for (const [model, pattern] of [
    ['assets/nothing.glb', /'nothing\.glb' was not found: the server answered 404\./],
    ['index.html', /^'index\.html'/],
  ]) {
    const page = await shared.open(`/#model=${model}`, { scene: false });
    await waitForNotice(page, pattern);
    assert.match(await sceneName(page), /No scene yet/);
    await shared.check(page, [/404/]);
  }
});

test('the file picker shows what was picked', async () => {
  const page = await shared.open();
  await page.setInputFiles('#files', { name: 'picked.glb', mimeType: 'model/gltf-binary', buffer: sample });
  await page.waitForFunction(() => document.querySelector('#scene-name').textContent.startsWith('picked.glb'));
  await shared.check(page);
});

test('progress goes from the download to the first frame, and only forwards', async () => {
  const page = await shared.open();
  const steps = await page.evaluate(async () => {
    const viewer = document.querySelector('edgeshade-viewer');
    const seen = [];
    viewer.addEventListener('progress', ({ detail }) => seen.push(detail));
    await viewer.load('assets/pavilion.glb');
    return seen;
  });
  for (let i = 1; i < steps.length; ++i) assert.ok(steps[i].fraction >= steps[i - 1].fraction);
  assert.deepEqual([...new Set(steps.map(({ stage }) => stage))],
    ['download', 'read', 'flatten', 'images', 'shadows', 'hand over', 'upload', 'draw']);
  await shared.check(page);
});
