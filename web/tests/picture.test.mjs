// The viewer draws the same picture as the native program, on another rasteriser.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { stateOf, useBrowser, waitForNotice } from './support/browser.mjs';
import { times } from './support/long.mjs';
import { rendered, views } from './support/native.mjs';
import { compare, picture } from './support/pictures.mjs';

const shared = useBrowser({ angle: 'swiftshader' });

/** Glass takes shadow once its light rests, which these views don't wait for. */
const look = ['--shading', 'base'];

/** Requires the native picture, except for outlines, which two rasterisers with 4 and 8 subpixel
 * bits put into neighbouring pixels, and slivers whose depth the coarser one loses
 * (docs/robustness.md): at most `most` pixels away from outlines, and a `share` of all. */
async function requireAlike(page, name, most = 100, share = 0.0055, options = []) {
  const native = rendered(await stateOf(page), options);
  const { pixels, different, astray, colors } = await compare(page, await picture(page), native);
  console.log(`${name}: ${different} of ${pixels} pixels differ, ${astray} away from outlines`);
  assert.ok(colors > 500, `${name}: a picture, not a plain surface (${colors} colours)`);
  assert.ok(different <= share * pixels, `${name}: ${different} of ${pixels} pixels differ`);
  assert.ok(astray <= most, `${name}: ${astray} pixels differ away from outlines`);
}

test('the first frame of the sample equals the native picture', async () => {
  const page = await shared.open('/tests/plain.html');
  await requireAlike(page, 'first frame');
  await shared.check(page);
});

test('other eyes and lights see what the native program draws', async () => {
  const page = await shared.open('/tests/plain.html');
  for (const { name, camera, lights, astray, share } of views.slice(0, times(4, views.length))) {
    await page.evaluate((changes) => document.querySelector('edgeshade-viewer').change(changes),
      { camera, lights, shading: 'base' });
    await requireAlike(page, name, astray, share, look);
  }
  await shared.check(page);
});

test('a light with a range, and volumes counted at lower resolutions, are the native ones too', async () => {
  const page = await shared.open('/tests/plain.html');
  const lights = [[1.5, 2.2, 2, 1, 4.5]];
  for (const scale of [1, 2, 4]) {
    await page.evaluate((changes) => document.querySelector('edgeshade-viewer').change(changes),
      { lights, shading: 'base', left: { mask_scale: scale } });
    // Where the rasterisers disagree about a texel, several pixels differ.
    await requireAlike(page, `mask scale ${scale}`, 25 * scale * scale, undefined, look);
  }
  await shared.check(page);
});

/** Restricts contexts to the least that WebGL 1 promises, and throws on anything more. */
function leastWebGl() {
  const type = WebGLRenderingContext.prototype;
  const { getParameter, vertexAttribPointer, drawElements } = type;
  type.getExtension = () => null;
  type.getSupportedExtensions = () => [];
  type.getParameter = function (name) {
    if (name === this.MAX_VERTEX_ATTRIBS) return 8;
    return getParameter.call(this, name);
  };
  type.vertexAttribPointer = function (index, ...rest) {
    if (index >= 8) throw new Error(`attribute ${index}`);
    return vertexAttribPointer.call(this, index, ...rest);
  };
  type.drawElements = function (mode, count, kind, offset) {
    if (kind === this.UNSIGNED_INT) throw new Error('32-bit indices');
    return drawElements.call(this, mode, count, kind, offset);
  };
}

test('8 attributes, no instancing and no 32-bit indices give the same picture', async () => {
  const page = await shared.open('/tests/plain.html', { init: leastWebGl });
  await requireAlike(page, 'least WebGL');
  await shared.check(page);
});

test('a browser without WebGL, or without a stencil, says so', async () => {
  for (const [init, pattern] of [
    [() => { HTMLCanvasElement.prototype.getContext = () => null; }, /provides no WebGL/],
    [() => {
      const { getContextAttributes } = WebGLRenderingContext.prototype;
      WebGLRenderingContext.prototype.getContextAttributes = function () {
        return { ...getContextAttributes.call(this), stencil: false };
      };
    }, /without a stencil buffer/],
  ]) {
    const page = await shared.open('/', { init, scene: false });
    await waitForNotice(page, pattern);
    await shared.check(page);
  }
});
