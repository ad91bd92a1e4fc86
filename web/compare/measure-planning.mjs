// Time that the page's WebAssembly takes in Chromium to plan a frame whose light moves: figures of
// docs/measured/processor.md, as JSON. Needs build/web and `npm ci`.
//
//   node compare/measure-planning.mjs FILE.glb...

import { readFileSync } from 'node:fs';
import { basename } from 'node:path';
import { launchChromium } from '../tests/support/chromium.mjs';
import { serve } from '../tests/support/server.mjs';

const sides = { volumes: { shadows: 'volumes' }, 'map 2048': { shadows: 'map', map_size: 2048 } };

/** In the page: loads the scene and draws `frames` of each side, each with the sun elsewhere. */
async function measure({ base64, wanted, frames }) {
  const viewer = document.querySelector('edgeshade-viewer');
  Object.assign(viewer.style, { width: '320px', height: '180px' });
  const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
  await viewer.load(new File([bytes], 'scene.glb'));
  viewer.change({ show_lights: false, shading: 'base', ground: 'off' });
  const drawn = (change) => new Promise((resolve) => {
    viewer.addEventListener('frame', resolve, { once: true });
    viewer.change(change);
  });
  const told = {};
  for (const [name, left] of Object.entries(wanted)) {
    for (let frame = 0; frame < frames; ++frame) {
      await drawn({ left, lights: [[0.6 + 0.003 * frame, 1, 0.35, 0]] });
      viewer.stats; // from now on frames are timed
    }
    told[name] = viewer.stats.plan_ms;
  }
  return told;
}

const server = await serve();
const browser = await launchChromium({ angle: 'swiftshader' });
try {
  const tab = await browser.newPage({ viewport: { width: 960, height: 540 } });
  await tab.goto(`${server.address}/tests/plain.html`);
  await tab.waitForFunction(() => document.querySelector('edgeshade-viewer')?.loaded);
  const told = {};
  for (const file of process.argv.slice(2)) {
    const base64 = readFileSync(file).toString('base64');
    told[basename(file, '.glb')] = await tab.evaluate(measure, { base64, wanted: sides, frames: 40 });
  }
  console.log(JSON.stringify(told, null, 1));
} finally {
  await browser.close();
  await server.close();
}
