// Hours of sun in edgeshade/three-webgpu: the counts of edgeshade/three, which the program's judge.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { useBrowser } from './support/browser.mjs';

const shared = useBrowser({ webGpu: true });

test('leaves, glass and clipping groups shade hours of sun as in edgeshade/three', async () => {
  const page = await shared.open('/tests/three-webgpu.html', { scene: false, size: { width: 400, height: 300 }, haste: 3 });
  await page.waitForFunction(() => window.page);
  const told = await page.evaluate(async () => {
    const tools = await import('/tests/three-webgpu.js');
    const camera = tools.cameraOf(tools.yardView), options = { place: [48.14, 11.57], date: '2026-03-21', step: 60 };
    const countsOf = async (renderer, scene, ground, chosen) => {
      const shadows = tools.shadowsOf(renderer, chosen).add(scene);
      shadows.render(scene, camera);
      const [cells, vertices] = [await shadows.sunHours(ground, { ...options, grid: 0.2 }), await shadows.sunHours(ground, options)];
      shadows.dispose();
      return [...cells.counts, ...vertices.counts].join();
    };
    const results = {};
    for (const backend of ['WebGLRenderer', 'WebGL', 'WebGPU']) {
      const renderer = await tools.rendererOf(backend, { width: 40, height: 30 });
      const counts = {}, sheets = tools.sheets(tools.casterOf);
      for (const [name, chosen] of Object.entries({ cut: {}, tint: { transparentCast: 'tint' }, opaque: { transparentCast: 'opaque' }, whole: { alphaTestedCast: 'whole' }, none: { alphaTestedCast: 'none' } }))
        counts[name] = await countsOf(renderer, sheets, sheets.children[0], chosen);
      const { scene, outer, material } = tools.house(), planes = [new tools.three.Plane(new tools.three.Vector3(0.1, -1, 0.05).normalize(), 1.37)];
      const floor = scene.children.find(({ isMesh }) => isMesh);
      renderer.localClippingEnabled = true;
      for (const clipShadows of [false, true]) {
        Object.assign(backend === 'WebGLRenderer' ? material : outer, { clippingPlanes: planes, clipShadows });
        counts[clipShadows ? 'clipped' : 'unclipped'] = await countsOf(renderer, scene, floor);
      }
      results[backend] = counts;
    }
    const { three, NodeShadows } = tools, idle = new NodeShadows(await tools.rendererOf('WebGL'));
    results.refused = await idle.sunHours(new three.Mesh(), options).catch(({ message }) => message);
    idle.dispose();
    return results;
  });
  await shared.check(page);
  const { WebGLRenderer, refused, ...backends } = told;
  const { cut, tint, whole, none, opaque, clipped, unclipped } = WebGLRenderer;
  assert.equal(new Set([cut, whole, none, opaque, clipped, unclipped]).size, 6);
  assert.equal(tint, cut);
  for (const [name, counts] of Object.entries(backends)) assert.deepEqual(counts, WebGLRenderer, name);
  assert.match(refused, /needs a render/);
});
