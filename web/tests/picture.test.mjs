// What is drawn is what the native program draws.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { stateOf, useBrowser, waitForNotice } from './support/browser.mjs';
import { compare, picture } from './support/pictures.mjs';
import { repository } from './support/server.mjs';

const shared = useBrowser();
const program = process.env.EDGESHADE_PROGRAM ?? join(repository, 'build/release/edgeshade');

/** The native program's picture of the sample from the same eye. */
function rendered({ from, to, fov }, options) {
  const folder = mkdtempSync(join(tmpdir(), 'edgeshade-'));
  try {
    const png = join(folder, 'native.png');
    execFileSync(program, ['render', join(repository, 'assets/pavilion.glb'), png,
      '--size', '1280x720', '--camera-from', `${from}`, '--camera-to', `${to}`, '--fov', `${fov}`,
      '--ambient', '0.4', ...options], { stdio: 'pipe', timeout: 60000 });
    return readFileSync(png);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** How many pixels differ from the native picture, and of how many. */
async function difference(page, options) {
  const native = rendered((await stateOf(page)).camera, options);
  const { pixels, different, colors } = await compare(page, await picture(page), native);
  console.log(`${options.join(' ')}: ${different} of ${pixels} pixels differ`);
  assert.ok(colors > 500, `a picture, not a plain surface (${colors} colours)`);
  return { pixels, different };
}

async function requireAlike(page, options) {
  const { pixels, different } = await difference(page, options);
  assert.ok(different <= 0.002 * pixels, `${different} of ${pixels} pixels differ`);
}

const change = (page, changes) =>
  page.evaluate((value) => document.querySelector('edgeshade-viewer').change(value), changes);

test('the first frame of the sample equals the native picture', async () => {
  const page = await shared.open('/tests/plain.html');
  await requireAlike(page, ['--sun', '-0.62,0.62,-0.30']);
  await shared.check(page);
});

test('a point light, and two suns, equal the native pictures', async () => {
  const page = await shared.open('/tests/plain.html');
  await change(page, { lights: [[1.5, 2.2, 2.0, 1]] });
  await requireAlike(page, ['--light', '1.5,2.2,2.0']);
  await change(page, { lights: [[-0.62, 0.62, -0.3, 0], [0.5, 1, 0.4, 0]] });
  // Bright textures show how differently the two rasterisers filter; shadows must add little to it.
  const suns = ['--sun', '-0.62,0.62,-0.30', '--sun', '0.5,1,0.4'];
  const { pixels, different } = await difference(page, suns);
  await change(page, { left: { shadows: 'none' } });
  const unshadowed = await difference(page, [...suns, '--shadows', 'none']);
  assert.ok(different - unshadowed.different <= 0.0005 * pixels);
  await shared.check(page);
});

/** A context with the least that WebGL 1 promises; what goes beyond it throws. */
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
  await requireAlike(page, ['--sun', '-0.62,0.62,-0.30']);
  await shared.check(page);
});

test('a browser without WebGL, or without a stencil, says so', async () => {
  for (const [init, pattern] of [
    [() => { HTMLCanvasElement.prototype.getContext = () => null; }, /gives no WebGL/],
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
