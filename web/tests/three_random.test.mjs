// Exact shadows in three.js of small worlds that change at random: after every change they are what rays find.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { useBrowser } from './support/browser.mjs';
import { isLong, times } from './support/long.mjs';
import { openThree } from './support/three.mjs';

const shared = useBrowser({ sharesPages: true });

/** What the adapter draws of a random world and its changes, beside rays: a list of {after, light, method, surfaces, wrong, beyond}. */
async function course({ seed, steps }) {
  const { randomWorld } = await import('/tests/random-world.js');
  const { ExactShadows, rendererOf, comparedWithRays, drawn, channelOf } = window.page;
  const size = { width: 120, height: 80 };
  const renderer = rendererOf(size), world = randomWorld(seed, size), { scene, lights, unit, random } = world;
  const lookups = random.oneOf([0, 1, 1, 2, 3]), most = Math.min(lookups, lights.length);
  const shadows = new ExactShadows(renderer, { keepsState: random.isTrue(0.3), lookups }).add(scene);
  const told = [];
  let after = 'start';
  for (let i = 0; i < steps; ++i) {
    renderer.clippingPlanes = world.planes;
    await drawn(shadows, scene, world.camera);
    const rest = random.oneOf([0, 3000, 20000]); // none, one in which casters come to rest, and one for maps to be built
    for (const since = performance.now(); performance.now() - since < rest && shadows.cost.lookedUp < most;) {
      await new Promise((resolve) => { setTimeout(resolve, 200); });
      await drawn(shadows, scene, world.camera);
    }
    for (const [channel, light] of lights.entries()) {
      const { method } = shadows.lights.find((one) => one.light === light);
      told.push({ after, light: light.type, method, ...comparedWithRays(channelOf(renderer, channel), renderer, scene, world.camera, light, { unit }) });
    }
    after = world.step();
  }
  shadows.dispose();
  renderer.dispose();
  renderer.domElement.remove();
  return told;
}

/** Few by default, whose lights are shadowed in all ways. */
const seeds = isLong ? Array.from({ length: 40 }, (_, i) => 1 + i) : [3, 12, 13];

test('worlds that change at random', async () => {
  const methods = {};
  for (const seed of seeds) {
    const page = await openThree(shared, 'three', { haste: 5 });
    const told = await page.evaluate(([text, given]) => (0, eval)(`(${text})`)(given), [course.toString(), { seed, steps: times(8, 14) }]);
    for (const [i, { after, light, method, surfaces, wrong, beyond }] of told.entries()) {
      methods[method] = (methods[method] ?? 0) + 1;
      const name = `seed ${seed}, picture ${i}, ${light} by ${method} after ${after}`;
      assert.equal(beyond, 0, `pixels beyond outlines are wrong: ${name}`);
      assert.ok(wrong <= 0.02 * surfaces, `${wrong} of ${surfaces} pixels are wrong: ${name}`);
    }
    await shared.check(page);
  }
  console.log(methods);
  for (const method of ['mask', 'lookup', 'lookup and movers']) assert.ok(methods[method] > 0, `no light has ${method}`);
});
