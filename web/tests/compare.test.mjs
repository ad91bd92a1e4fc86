// The comparison with three.js's cube shadow map: the page works, where three.js is installed.

import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { promisify } from 'node:util';
import { useBrowser } from './support/browser.mjs';
import { repository } from './support/server.mjs';

const shared = useBrowser();
const skip = existsSync(join(repository, 'web/node_modules/three/package.json')) ? false
  : "three is not installed; 'npm ci' in web/ does that.";

test('both pictures show the scene, alike but for the shadows\' edges, and are timed', { skip }, async () => {
  const page = await shared.open('/compare/#map-size=512', { size: { width: 700, height: 700 } });
  const results = await page.evaluate(async () => {
    const comparison = await window.comparison;
    const { width, height } = document.querySelector('#three');
    const whole = { x: 0, y: 0, width, height, scale: 1 };
    const pixelsOf = async (address) => {
      const bitmap = await createImageBitmap(await (await fetch(address)).blob());
      const context = new OffscreenCanvas(width, height).getContext('2d');
      context.drawImage(bitmap, 0, 0);
      return context.getImageData(0, 0, width, height).data;
    };
    const { edgeshade, cubeMap } = await comparison.cutOuts(whole);
    const [a, b] = [await pixelsOf(edgeshade), await pixelsOf(cubeMap)];
    let different = 0;
    for (let i = 0; i < a.length; ++i) different += Math.abs(a[i] - b[i]) > 12 ? 1 : 0;
    const started = performance.now();
    const figures = await comparison.measure({ frames: 2, warmUp: 1, patience: 5 });
    return { share: different / a.length, figures, took: performance.now() - started };
  });
  assert.ok(results.share > 1e-4 && results.share < 0.06, `${results.share} of the values differ`);
  const { figures } = results;
  for (const side of ['edgeshade', 'cube_map'])
    for (const what of ['light_moves', 'camera_moves']) assert.ok(figures[side][what].median_ms > 0, `${side} ${what}`);
  const frames = [results.figures.edgeshade, results.figures.cube_map].flatMap((side) => Object.values(side))
    .filter((times) => times.median_ms).reduce((sum, times) => sum + 2 * times.median_ms, 0);
  assert.ok(frames < results.took, `${frames} ms of frames in ${results.took} ms`);
  assert.equal(figures.map_size, 512);
  assert.match(await page.textContent('#results'), /light moves/);
  await shared.check(page);
});

test('see-through materials, clear coats and coordinates look as three.js has them', { skip }, async () => {
  const folder = mkdtempSync(join(tmpdir(), 'edgeshade-'));
  try {
    const script = join(repository, 'web/compare/measure-materials.mjs');
    const told = await promisify(execFile)('node', [script, '--keep', folder,
      '--only', 'see-through,clear coat,second coordinates'], { timeout: 300000 });
    const rows = [...told.stdout.matchAll(/^\| ([^|]+) \| ([\d.]+) \| ([\d.]+) \| ([\d.]+) \| ([\d.]+) \|$/gm)];
    assert.equal(rows.length, 3, told.stdout);
    for (const [, name, , off, , on] of rows) {
      assert.ok(Number(off) < 1.5, `${name}: ${off} without an environment`);
      assert.ok(Number(on) < 3.5, `${name}: ${on} with one`);
    }
  } finally {
    rmSync(folder, { recursive: true });
  }
});
