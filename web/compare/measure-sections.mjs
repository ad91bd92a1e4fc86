// Time that a step of a dragged section plane takes in the page's WebAssembly, and the map of a
// light at rest in a cut scene: figures of docs/measured/sections.md, as JSON, which
// tests/bench/sections.py --web FILE writes into its table. Needs build/web and `npm ci`.
//
//   node compare/measure-sections.mjs FILE.glb...

import { basename } from 'node:path';
import { base64Of, withViewerTab } from './viewer-tab.mjs';

/**
 * In the page: loads the scene, drags a plane through its middle three fifths, then lets the light
 * rest. Times are milliseconds.
 */
async function measure({ base64, steps }) {
  const viewer = document.querySelector('edgeshade-viewer');
  Object.assign(viewer.style, { width: '320px', height: '180px' });
  const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
  await viewer.load(new File([bytes], 'scene.glb'));
  viewer.change({ show_lights: false, shading: 'base', ground: 'off', lights: [[0.6, 1, 0.35, 0]], left: { shadows: 'volumes' } });
  const drawn = () => new Promise((resolve) => viewer.addEventListener('frame', resolve, { once: true }));
  await drawn();

  let handedOver = 0; // while data goes to WebGL
  for (const name of ['bufferData', 'bufferSubData']) {
    const own = WebGLRenderingContext.prototype[name];
    WebGLRenderingContext.prototype[name] = function (...of) {
      const before = performance.now();
      own.apply(this, of);
      handedOver += performance.now() - before;
    };
  }
  // The box reaches 0.4 of the scene's height to either side of its middle.
  viewer.run('sectionBox');
  const { planes } = viewer.state.section;
  const low = -planes.find(([, y]) => y > 0)[3], high = planes.find(([, y]) => y < 0)[3];
  const middle = 0.5 * (low + high), height = (high - low) / 0.8;
  const median = (of) => of.toSorted((a, b) => a - b)[Math.floor(of.length / 2)];
  const told = {};
  for (const shadows of ['cut', 'whole']) {
    viewer.run('sectionOff');
    await drawn();
    const cut = [], uploaded = [];
    for (let step = 0; step < steps; ++step) {
      const plane = [0.02, -1, 0.01, middle + (0.6 * step / steps - 0.3) * height];
      handedOver = 0;
      const before = performance.now();
      viewer.change({ section: { planes: [plane], shadows, fill: '#808080' } });
      cut.push(performance.now() - before - handedOver);
      uploaded.push(handedOver);
      await drawn();
    }
    const [first, ...others] = cut;
    told[shadows] = { first_ms: first, cut_ms: median(others), cut_ms_worst: Math.max(...others), upload_ms: median(uploaded) };
  }

  // The map of the light: while it is built the page's longest stop is a task of this length.
  const stops = [];
  const observer = new PerformanceObserver((list) => stops.push(...list.getEntries().map(({ duration }) => duration)));
  observer.observe({ type: 'longtask' });
  const looked = async () => {
    stops.length = 0;
    viewer.change({ left: { shadows: 'lookup' } });
    const start = performance.now();
    do await new Promise(requestAnimationFrame);
    while (viewer.stats.lights[0]?.method !== 'primitive-map' && performance.now() - start < 30000);
    await new Promise((resolve) => setTimeout(resolve, 100));
    const [light] = viewer.stats.lights;
    return { method: light.method, build_ms: light.build_ms, ready_ms: performance.now() - start - 100, longest_task_ms: Math.max(0, ...stops) };
  };
  const { section } = viewer.state;
  viewer.run('sectionOff');
  await drawn();
  told.lookup_of_whole = await looked(); // it compiles the programs that both draw with
  viewer.change({ left: { shadows: 'volumes' }, section: { ...section, shadows: 'cut' } });
  await drawn();
  told.lookup_of_cut = await looked();
  return told;
}

await withViewerTab(async (tab) => {
  const told = {};
  for (const file of process.argv.slice(2))
    told[basename(file, '.glb')] = await tab.evaluate(measure, { base64: base64Of(file), steps: 40 });
  console.log(JSON.stringify(told, null, 1));
});
