// A building model of many small meshes: a frame's masks take tens of draws from the first, more
// while meshes move, and tens again once they rest. EDGESHADE_MESHES sets their number, 120 otherwise.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { useBrowser } from './support/browser.mjs';
import { openThree } from './support/three.mjs';

const shared = useBrowser();
const count = Number(process.env.EDGESHADE_MESHES ?? 120);

test('many small meshes at rest take few draws, and masks stay the same', async () => {
  const page = await openThree(shared);
  const told = await page.evaluate(async (meshes) => {
    const { three, yard, ExactShadows, cameraOf, drawn, redOf } = window.page;
    const { renderer, scene, mesh, light } = yard({ width: 320, height: 180 });
    const camera = cameraOf({ from: [5, 4, 6], to: [0, 0.6, 0], fov: 50 }, 320 / 180);
    const shadows = new ExactShadows(renderer, { lookups: 0 }).add(scene);
    const pipes = [], side = Math.ceil(Math.sqrt(meshes));
    for (let i = 0; i < meshes; ++i) {
      const pipe = mesh(new three.CylinderGeometry(1 / side, 1 / side, 0.6, 24));
      pipe.position.set(6 * (i % side) / side - 3, 0.4, 6 * Math.floor(i / side) / side - 3);
      scene.add(pipe);
      pipes.push(pipe);
    }
    await drawn(shadows, scene, camera);
    const red = () => {
      shadows.render(scene, camera);
      return redOf(renderer);
    };
    const before = red(), times = [], batches = [shadows.cost.batches];
    for (let i = 0; i < 80 + meshes / 16; ++i) {
      light.position.x += 0.001;
      for (const pipe of i < 2 ? pipes : []) pipe.position.y += i === 0 ? 0.1 : -0.1;
      const since = performance.now();
      shadows.beginMasks(scene, camera);
      times.push(performance.now() - since);
      shadows.endMasks();
      batches.push(shadows.cost.batches);
      await new Promise((resolve) => { setTimeout(resolve); });
    }
    light.position.x = 0.5;
    const after = red();
    const differ = before.reduce((sum, value, i) => sum + (value !== after[i]), 0);
    const median = (of) => [...of].sort((a, b) => a - b)[of.length >> 1];
    return { differ, pixels: before.length, batches, single: median(times.slice(2, 58)), longest: Math.max(...times.slice(58)), merged: median(times.slice(-20)) };
  }, count);
  console.log(`beginMasks() of ${count} meshes: ${told.single.toFixed(1)} ms, merged ${told.merged.toFixed(1)} ms, at most ${told.longest.toFixed(1)} ms while merging; ${told.batches[0]} draws, ${told.batches[1]} after all have moved, then ${told.batches.at(-1)}`);
  assert.ok(told.batches[0] < count / 8, `${told.batches[0]} draws at first`);
  assert.ok(told.batches[1] >= count, `${told.batches[1]} draws of meshes that moved`);
  assert.ok(told.batches.at(-1) < count / 8, `${told.batches.at(-1)} draws`);
  assert.ok(told.differ < told.pixels / 2000, `${told.differ} of ${told.pixels} values differ`); // on boundaries
  await shared.check(page);
});
