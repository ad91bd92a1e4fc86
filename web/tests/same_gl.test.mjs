// With the same GL, browser and native program draw the same pictures: differences on SwiftShader
// (picture.test.mjs) come from its rasteriser.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { stateOf, useBrowser } from './support/browser.mjs';
import { times } from './support/long.mjs';
import { rendered, views } from './support/native.mjs';
import { compare, picture } from './support/pictures.mjs';

const shared = useBrowser();

test('on the system\'s own GL hardly a pixel differs', async (context) => {
  const page = await shared.open('/tests/plain.html', { scene: false });
  const renderer = await page.evaluate(() => {
    const gl = document.createElement('canvas').getContext('webgl');
    return gl?.getParameter(gl.getExtension('WEBGL_debug_renderer_info')?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER) ?? '';
  });
  if (!/llvmpipe/.test(renderer)) {
    context.skip(`Chromium draws with ${renderer || 'nothing'} here`);
    await page.close();
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
  await page.close();
});
