// Drawn by the same GL, browser and native program give the same pictures: what is left between them
// elsewhere is the rasterisers'.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { stateOf, useBrowser } from './support/browser.mjs';
import { rendered, views } from './support/native.mjs';
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
  for (const { name, camera, lights } of views) {
    await page.evaluate((changes) => document.querySelector('edgeshade-viewer').change(changes),
      { camera, lights, shading: 'base' }); // glass waits for its light to rest
    const native = rendered(await stateOf(page), ['--shading', 'base'], { filtersExactly: false });
    const { pixels, different } = await compare(page, await picture(page), native);
    console.log(`${name}: ${different} of ${pixels} pixels differ`);
    // Pixels on outlines of shadows and of surfaces, where the last bits of depth decide.
    assert.ok(different <= 0.0003 * pixels, `${name}: ${different} of ${pixels} pixels differ`);
  }
  await page.context().close();
});
