// Opens the comparison in a headless Chromium: writes a pair of pictures to docs/pictures, or frame
// times to results.json beside this file, which it prints too. Needs build/web and `npm ci`.
//
//   node compare/measure.mjs [--only pictures|times] [--frames N] [--hash '#model=…']
//                            [--angle swiftshader|gl-egl] [--serve]
//
// --angle is what Chromium draws with. The pictures were taken with gl-egl, Mesa's software:
// SwiftShader leaves wrong pixels along a few of the volumes' edges. --serve writes nothing and
// serves the page until Ctrl-C.

import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { launchChromium } from '../tests/support/chromium.mjs';
import { repository, serve } from '../tests/support/server.mjs';

const { values: options } = parseArgs({ options: {
  only: { type: 'string' },
  angle: { type: 'string', default: 'swiftshader' },
  frames: { type: 'string', default: '24' },
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

async function open(tab, hash) {
  await tab.goto('about:blank');
  await tab.goto(page + hash);
  return tab.evaluateHandle(() => window.comparison);
}

async function takePictures(tab) {
  const shown = await open(tab, pictures.hash);
  const pair = await shown.evaluate((comparison, part) => comparison.cutOuts(part), pictures.part);
  for (const [side, name] of [['edgeshade', 'edgeshade'], ['cubeMap', 'cube-map']])
    writeFileSync(join(repository, `docs/pictures/threejs-${name}.png`),
      Buffer.from(pair[side].split(',')[1], 'base64'));
}

async function takeTimes(tab) {
  const shown = await open(tab, options.hash);
  const frames = Number(options.frames);
  const results = await shown.evaluate((comparison, count) => comparison.measure({ frames: count }), frames);
  const text = `${JSON.stringify(results, null, 2)}\n`;
  writeFileSync(join(repository, 'web/compare/results.json'), text);
  console.log(text);
}

if (options.serve) {
  console.log(`Open ${page}${options.hash} in a browser; Ctrl-C ends it.`);
} else {
  const browser = await launchChromium({ angle: options.angle });
  try {
    // Both pictures have 960 × 540 pixels in a window of this size.
    const tab = await browser.newPage({ viewport: { width: 1980, height: 900 } });
    tab.setDefaultTimeout(600000);
    if (options.only !== 'times') await takePictures(tab);
    if (options.only !== 'pictures') await takeTimes(tab);
  } finally {
    await browser.close();
    await server.close();
  }
}
