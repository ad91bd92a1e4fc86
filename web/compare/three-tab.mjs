// A tab of headless Chromium with the tests' page of three.js, for measurements. Needs build/web and
// `npm ci`.

import { parseArgs } from 'node:util';
import { launchChromium } from '../tests/support/chromium.mjs';
import { serve } from '../tests/support/server.mjs';

/**
 * Prints as JSON what `measured({wide: {width, height}, frames})` returns in the page. Options of the
 * command line: --size, --frames, --angle.
 */
export async function measureInThree(measured) {
  const { values: options } = parseArgs({ options: {
    size: { type: 'string', default: '640x360' },
    frames: { type: 'string', default: '15' },
    angle: { type: 'string', default: 'swiftshader' },
  } });
  const [width, height] = options.size.split('x').map(Number);
  const server = await serve();
  const browser = await launchChromium({ angle: options.angle, composites: true });
  try {
    const page = await browser.newPage();
    await page.goto(`${server.address}/tests/three.html?three=three`);
    await page.waitForFunction(() => window.page);
    console.log(JSON.stringify(await page.evaluate(measured, { wide: { width, height }, frames: Number(options.frames) }), null, 2));
  } finally {
    await browser.close();
    await server.close();
  }
}
