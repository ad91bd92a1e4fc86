// Time that the page's WebAssembly takes in Chromium to plan a frame whose light moves: figures of
// docs/measured/processor.md, as JSON. Needs build/web and `npm ci`.
//
//   node compare/measure-planning.mjs FILE.glb...

import { basename } from 'node:path';
import { base64Of, withViewerTab } from './viewer-tab.mjs';

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

await withViewerTab(async (tab) => {
  const told = {};
  for (const file of process.argv.slice(2))
    told[basename(file, '.glb')] = await tab.evaluate(measure, { base64: base64Of(file), wanted: sides, frames: 40 });
  console.log(JSON.stringify(told, null, 1));
});
