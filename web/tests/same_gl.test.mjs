// With the same GL, browser and native program draw the same pictures: other tests' differences
// come from their rasterisers.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { stateOf, useBrowser } from './support/browser.mjs';
import { times } from './support/long.mjs';
import { rendered, size, sunHours, views } from './support/native.mjs';
import { compare, picture } from './support/pictures.mjs';

const shared = useBrowser({ angle: 'gl-egl' });

test('on the system\'s own GL hardly a pixel differs', async (context) => {
  const page = await shared.open('/tests/plain.html', { scene: false });
  const renderer = await page.evaluate(() => {
    const gl = document.createElement('canvas').getContext('webgl');
    return gl?.getParameter(gl.getExtension('WEBGL_debug_renderer_info')?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER) ?? '';
  });
  if (!/llvmpipe/.test(renderer)) {
    context.skip(`Chromium draws with ${renderer || 'nothing'} here`);
    await page.context().close();
    return;
  }
  await page.waitForFunction(() => document.querySelector('edgeshade-viewer')?.loaded);
  for (const { name, camera, lights } of views.slice(0, times(3, views.length))) {
    await page.evaluate((changes) => document.querySelector('edgeshade-viewer').change(changes),
      { camera, lights, shading: 'base' }); // glass takes shadow once its light rests
    const native = rendered(await stateOf(page), ['--shading', 'base'], { filtersExactly: false });
    const { pixels, different } = await compare(page, await picture(page), native);
    console.log(`${name}: ${different} of ${pixels} pixels differ`);
    // Pixels on outlines of shadows and surfaces, where the last bits of depth decide.
    assert.ok(different <= 0.0003 * pixels, `${name}: ${different} of ${pixels} pixels differ`);
  }
  await page.evaluate(() => document.querySelector('edgeshade-viewer').change({ lights: [[0, 1, 0, 0]], ground: 'off',
    sun: { place: [48.14, 11.57], time: '2026-03-21T10:00+01:00', north: 25 }, sun_hours: true, sun_hours_step: 30 }));
  await page.waitForFunction(() => {
    const { counted, of } = document.querySelector('edgeshade-viewer').sunHours ?? {};
    return of > 0 && counted === of;
  });
  const counts = sunHours(await stateOf(page), 30);
  const shown = await page.evaluate(({ width, height }) => {
    const lit = [];
    for (let y = 2; y < height; y += 5)
      for (let x = 2; x < width; x += 5)
        lit.push(document.querySelector('edgeshade-viewer').sunHoursAt(x + 0.5, y + 0.5)?.lit ?? -1);
    return lit;
  }, size);
  const different = shown.filter((lit, i) => {
    const there = counts.at(2 + 5 * (i % 160), 2 + 5 * Math.floor(i / 160));
    return lit !== (there.surface ? there.lit : -1);
  }).length;
  console.log(`hours of sun: ${different} of ${shown.length} pixels differ`);
  assert.ok(different <= 0.0003 * shown.length, `${different} of ${shown.length} hours of sun differ`);
  await page.context().close();
});
