// The example with only WebGL 1: a page with its own shaders, and with a light and a ring that
// move.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { useBrowser } from './support/browser.mjs';
import { repository } from './support/server.mjs';

const shared = useBrowser();

test('a page of at most 100 lines draws masks into its own picture', async () => {
  const text = readFileSync(join(repository, 'web/examples/plain-webgl.html'), 'utf8');
  assert.ok(text.split('\n').length <= 101);
  const page = await shared.open('/examples/plain-webgl.html', { scene: false, size: { width: 640, height: 400 },
    init: () => { window.requestAnimationFrame = (draw) => { window.drawAt = draw; }; } });
  await page.waitForFunction(() => window.drawAt, null, { polling: 50 });
  const told = await page.evaluate(() => [0, 9000].map((milliseconds) => {
    window.drawAt(milliseconds);
    const gl = document.querySelector('canvas').getContext('webgl');
    // Points on the floor, from the top left: the first in the ring's shadow at the start, the
    // second at the end.
    return [[150, 250], [500, 350]].map(([x, y]) => {
      const pixel = new Uint8Array(4);
      gl.readPixels(x, 399 - y, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
      return pixel[0];
    });
  }));
  const [[darkAtFirst, litAtFirst], [litAtLast, darkAtLast]] = told;
  const ambient = Math.round(255 * 0.8 * 0.15);
  assert.deepEqual([darkAtFirst, darkAtLast].map((red) => Math.abs(red - ambient) <= 1), [true, true], `${told}`);
  assert.ok(litAtFirst > 80 && litAtLast > 80, `${told}`);
  await shared.check(page);
});
