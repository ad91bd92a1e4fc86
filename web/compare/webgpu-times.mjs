// Frame times of three.js's WebGPURenderer with lights at rest: looked up, with three.js's own maps kept,
// and without shadows, in turns in one run of Chromium, by both back ends. Prints JSON. Needs build/web
// and `npm ci`.
//
//   node compare/webgpu-times.mjs [--frames 8]

import { parseArgs } from 'node:util';
import { launchChromium } from '../tests/support/chromium.mjs';
import { serve } from '../tests/support/server.mjs';

/** In the page: milliseconds of the fastest frame of each way, by back end, with a moving camera. */
async function measured(page, { frames, wide }) {
  const results = [];
  for (const backend of ['WebGL', 'WebGPU']) {
    const pixel = new Uint8Array(4);
    const finish = ({ backend: { gl, device } }) => (gl ? gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel) : device.queue.onSubmittedWorkDone());
    const ways = {};
    for (const way of ['lookedUp', 'map1024', 'map2048', 'noShadows']) {
      const renderer = await page.rendererOf(backend, wide);
      const { scene, camera } = await page.sceneOf('pavilion');
      const [light, target] = page.lampOf('DirectionalLight', [-6.2, 6.2, -3]);
      Object.assign(light.shadow.camera, { left: -9, right: 9, top: 9, bottom: -9, far: 30 });
      scene.add(light, target);
      let draw = () => renderer.render(scene, camera);
      if (way === 'lookedUp') {
        const shadows = page.shadowsOf(renderer).add(scene);
        if (await page.rested(shadows, scene, camera) !== 1) throw new Error([...shadows.notLookedUp.values()].join());
        draw = () => shadows.render(scene, camera);
      } else {
        renderer.shadowMap.enabled = way !== 'noShadows';
        if (way !== 'noShadows') light.shadow.mapSize.setScalar(Number(way.slice(3)));
        draw();
        light.shadow.autoUpdate = false; // it rests, and so do the casters
      }
      draw();
      ways[way] = { renderer, camera, draw, times: [] };
    }
    for (let i = 0; i < frames; ++i)
      for (const { renderer, camera, draw, times } of Object.values(ways)) {
        camera.position.x = -2.6 + 0.01 * i;
        const since = performance.now();
        draw();
        await finish(renderer);
        times.push(performance.now() - since);
      }
    results.push({ backend, ...Object.fromEntries(Object.entries(ways).map(([way, { times }]) => [`${way}Ms`, Number(Math.min(...times).toFixed(1))])) });
    for (const { renderer } of Object.values(ways)) renderer.dispose();
  }
  return results;
}

const { values: { frames } } = parseArgs({ options: { frames: { type: 'string', default: '8' } } });
const wide = { width: 640, height: 360 };
const server = await serve(), browser = await launchChromium({ webGpu: true, composites: true });
try {
  const page = await browser.newPage({ viewport: wide });
  await page.goto(`${server.address}/tests/three-webgpu.html`);
  await page.waitForFunction(() => window.page);
  const results = await page.evaluate(async ([text, given]) => (0, eval)(`(${text})`)(await import('/tests/three-webgpu.js'), given), [measured.toString(), { frames: Number(frames), wide }]);
  console.log(JSON.stringify({ size: wide, frames: Number(frames), results }, null, 2));
} finally {
  await browser.close();
  await server.close();
}
