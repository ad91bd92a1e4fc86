// Cost in Chromium of a frame with a new pose: the figures of docs/measured/posing.md, as JSON.
// Needs build/web and `npm ci`.
//
//   node compare/measure-posing.mjs FILE.glb

import { base64Of, withViewerTab } from './viewer-tab.mjs';

const sides = {
  volumes: { shadows: 'volumes' },
  'map 1024': { shadows: 'map', map_size: 1024 },
  'map 2048': { shadows: 'map', map_size: 2048 },
};

/** In the page: loads the scene and draws `frames` of each side, with a new pose each, then with
 * the same pose. A frame is timed until its picture is finished; means of the last 30. */
async function measure({ base64, wanted, frames }) {
  const viewer = document.querySelector('edgeshade-viewer');
  Object.assign(viewer.style, { width: '960px', height: '540px' });
  const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
  await viewer.load(new File([bytes], 'scene.glb'));
  viewer.change({ show_lights: false, shading: 'base', ground: 'off', lights: [[0.6, 1, 0.35, 0]] });
  const drawn = (change) => new Promise((resolve) => {
    viewer.addEventListener('frame', resolve, { once: true });
    viewer.change(change);
  });
  const told = {};
  for (const [name, side] of Object.entries(wanted)) {
    await drawn({ left: side });
    viewer.stats; // from now on frames are timed until they are finished
    for (let frame = 0; frame < frames; ++frame)
      await drawn({ time: (frame / 30) % viewer.animationSeconds });
    const moving = viewer.stats;
    for (let frame = 0; frame < frames; ++frame)
      await drawn({ ambient: 0.4 + 0.001 * (frame % 2) });
    told[name] = { pose_ms: moving.pose_ms, plan_ms: moving.plan_ms,
      moving_ms: moving.frame_ms + moving.pose_ms, still_ms: viewer.stats.frame_ms };
  }
  return told;
}

await withViewerTab(async (tab) => {
  const base64 = base64Of(process.argv[2]);
  console.log(JSON.stringify(await tab.evaluate(measure, { base64, wanted: sides, frames: 40 }), null, 1));
});
