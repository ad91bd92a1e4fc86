// Opens the comparison in a headless Chromium, writes the pair of pictures to docs/pictures and the
// frame times to results.json beside this file, and prints them. Needs build/web and `npm ci`.
//
//   node compare/measure.mjs [--frames N] [--hash '#model=…'] [--serve]
//
// --serve writes nothing and serves the page until Ctrl-C.

import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { launchChromium } from '../tests/support/chromium.mjs';
import { repository, serve } from '../tests/support/server.mjs';

const { values: options } = parseArgs({ options: {
  frames: { type: 'string', default: '30' },
  hash: { type: 'string', default: '' },
  serve: { type: 'boolean', default: false },
} });

/** What the pictures in docs show: of 960 × 540 pixels a part, enlarged. */
const pictures = {
  hash: '#camera=-3.25,1,6.5,-2.5,0.15,4.75,36&light=0.3,2.3,1.9,1&ambient=0.35',
  part: { x: 40, y: 150, width: 400, height: 240, scale: 3 },
};

const server = await serve();
const page = `${server.address}/compare/`;
if (options.serve) {
  console.log(`Open ${page}${options.hash} in a browser; Ctrl-C ends it.`);
} else {
  const browser = await launchChromium();
  try {
    // Both pictures have 960 × 540 pixels in a window of this size.
    const tab = await browser.newPage({ viewport: { width: 1980, height: 900 } });
    tab.setDefaultTimeout(300000);
    const open = async (hash) => {
      await tab.goto('about:blank');
      await tab.goto(page + hash);
      return tab.evaluateHandle(() => window.comparison);
    };
    const shown = await open(pictures.hash);
    const pair = await shown.evaluate((comparison, part) => comparison.cutOuts(part), pictures.part);
    for (const [side, name] of [['edgeshade', 'edgeshade'], ['cubeMap', 'cube-map']])
      writeFileSync(join(repository, `docs/pictures/threejs-${name}.png`),
        Buffer.from(pair[side].split(',')[1], 'base64'));
    const measured = await open(options.hash);
    const results = await measured.evaluate((comparison, frames) => comparison.measure({ frames }), Number(options.frames));
    const text = `${JSON.stringify(results, null, 2)}\n`;
    writeFileSync(join(repository, 'web/compare/results.json'), text);
    console.log(text);
  } finally {
    await browser.close();
    await server.close();
  }
}
