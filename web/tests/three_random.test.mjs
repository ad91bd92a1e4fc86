// Exact shadows in three.js of small worlds that change at random: after every change they are what rays find.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { useBrowser } from './support/browser.mjs';
import { isLong, times } from './support/long.mjs';
import { openThree } from './support/three.mjs';

const shared = useBrowser({ sharesPages: true });

/** Pictures of a random world and its changes beside rays: a list of {after, light, method, surfaces, wrong, beyond}. */
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

/** Runs a course in a page; returns its result. */
async function picturesOf(course, given) {
  const page = await openThree(shared, 'three', { haste: 5 });
  const result = await page.evaluate(([text, of]) => (0, eval)(`(${text})`)(of), [course.toString(), given]);
  await shared.check(page);
  return result;
}

/** Few by default, whose lights are shadowed in all ways. */
const seeds = isLong ? Array.from({ length: 40 }, (_, i) => 1 + i) : [3, 12, 13];

test('worlds that change at random', async () => {
  const methods = {};
  for (const seed of seeds) {
    const pictures = await picturesOf(course, { seed, steps: times(8, 14) });
    for (const [i, { after, light, method, surfaces, wrong, beyond }] of pictures.entries()) {
      methods[method] = (methods[method] ?? 0) + 1;
      const name = `seed ${seed}, picture ${i}, ${light} by ${method} after ${after}`;
      assert.equal(beyond, 0, `pixels beyond outlines are wrong: ${name}`);
      assert.ok(wrong <= 0.02 * surfaces, `${wrong} of ${surfaces} pixels are wrong: ${name}`);
    }
  }
  console.log(methods);
  for (const method of ['mask', 'lookup', 'lookup and movers']) assert.ok(methods[method] > 0, `no light has ${method}`);
});

/** The same with panes that tint and leaves that are cut out, where their light is looked up. */
async function seeThroughCourse({ seed, steps }) {
  const { randomWorld } = await import('/tests/random-world.js');
  const { comparedTints } = await import('/tests/tint-rays.js');
  const { ExactShadows, rendererOf, drawn } = window.page;
  const size = { width: 120, height: 80 };
  const renderer = rendererOf(size), world = randomWorld(seed, size, { seeThrough: true }), { scene, lights, unit } = world;
  const shadows = new ExactShadows(renderer, { transparentCast: 'tint' }).add(scene);
  /** Light that a pane lets through; null: it is no pane. */
  const tintOf = ({ name, material: { color, opacity } }) => (name === 'pane' ? color.toArray().map((share) => share * (1 - opacity)) : null);
  const told = [];
  let after = 'start';
  for (let i = 0; i < steps; ++i) {
    await drawn(shadows, scene, world.camera);
    for (const since = Date.now(); Date.now() - since < 20000 && shadows.lights[0].method !== 'lookup';) {
      await new Promise((resolve) => { setTimeout(resolve, 400); });
      await drawn(shadows, scene, world.camera);
    }
    const [{ method }] = shadows.lights;
    told.push({ after, light: lights[0].type, method, ...comparedTints(renderer, scene, world.camera, lights[0], tintOf, unit) });
    after = world.step();
  }
  shadows.dispose();
  renderer.dispose();
  renderer.domElement.remove();
  return told;
}

test('panes and leaves that change at random', async () => {
  let tinted = 0;
  for (const seed of isLong ? seeds : [6]) {
    const pictures = await picturesOf(seeThroughCourse, { seed, steps: times(5, 10) });
    for (const [i, { after, light, method, compared, wrong, beyond, ...of }] of pictures.entries()) {
      const name = `seed ${seed}, picture ${i}, ${light} after ${after}`;
      tinted += of.tinted;
      assert.equal(method, 'lookup', name);
      assert.equal(beyond, 0, `pixels beyond outlines are wrong: ${name}`);
      assert.ok(wrong <= 0.1 * compared, `${wrong} of ${compared} pixels are wrong: ${name}`);
    }
  }
  console.log(`${tinted} tinted pixels`);
  assert.ok(tinted > 500, `${tinted} pixels are tinted`);
});
