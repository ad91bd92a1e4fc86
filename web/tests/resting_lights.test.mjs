// When resting lights get maps, with an engine of the test's own.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { RestingLights } from '../../build/web/three/resting-lights.js';

/**
 * Follows a light while a mesh comes every 300 ms for `loads` milliseconds, and 5 s longer; a map takes 2 s. `breaks`:
 * the engine has each mesh before the next comes. Returns {begun, aborted, methods}: when maps were begun and given up,
 * and the methods at each second.
 */
async function follow(context, { loads, breaks = false, radius = 0 }) {
  let now = 0;
  context.mock.method(performance, 'now', () => now);
  const begun = [], aborted = [], methods = [], maps = new Map(), waiting = [];
  let meshes = 0;
  const masks = {
    get restingState() { return meshes; },
    get casterState() { return meshes; },
    startLookups() {},
    buildLookup: (_, { signal }) => new Promise((resolve) => {
      const id = begun.push(now), holds = meshes;
      waiting.push({ until: now + 2000, finish: () => resolve(signal.aborted ? null : (maps.set(id, holds), id)) });
      signal.addEventListener('abort', () => aborted.push(now));
    }),
    lookupState: (id) => ({ holds: true, movers: meshes - maps.get(id), rested: meshes > maps.get(id) }),
    uploadLookupStep: () => true,
    lookup: () => ({ why: '' }),
    removeLookup() {},
  };
  const lights = new RestingLights(masks, 2, () => {});
  const light = {}, numbers = { kind: 'directional', direction: [0, -1, 0], radius };
  for (; now < loads + 5000; now += 100) {
    if (now < loads && now % 300 === 0) meshes += 1;
    lights.revision = meshes;
    lights.follow([{ light, numbers }], now >= loads || (breaks && now % 300 > 0), now);
    for (const of of waiting.splice(0)) (now >= of.until ? of.finish() : waiting.push(of));
    for (let i = 0; i < 5; ++i) await undefined;
    if (now % 1000 === 900) methods.push(lights.methodOf(light).method);
  }
  return { begun, aborted, methods };
}

test('a load of some seconds gets one map, of all of its meshes', async (context) => {
  const { begun, aborted, methods } = await follow(context, { loads: 8000 });
  assert.ok(begun.length === 1 && begun[0] >= 7800 && begun[0] <= 8500, `${begun}`);
  assert.deepEqual([aborted, methods.at(-1)], [[], 'lookup']);
});

test('while meshes keep coming a light gets a map of those that are there, and others later', async (context) => {
  const { begun, aborted, methods } = await follow(context, { loads: 35_000 });
  assert.deepEqual(aborted, []);
  assert.equal(begun.length, 4, `${begun}`);
  assert.ok(begun[0] >= 10_000 && begun[0] <= 10_500, `${begun}`);
  for (const i of [1, 2]) assert.ok(begun[i] - begun[i - 1] >= 10_000 && begun[i] - begun[i - 1] <= 10_500, `${begun}`);
  assert.ok(begun[3] >= 34_800 && begun[3] <= 35_600, `${begun}`);
  assert.ok(methods.slice(0, 12).every((method) => method === 'mask'), `${methods}`);
  assert.ok(methods.slice(13, 35).every((method) => method === 'lookup and movers'), `${methods}`);
  assert.equal(methods.at(-1), 'lookup');
});

test('so it does where the engine has each mesh before the next comes', async (context) => {
  const { begun, aborted, methods } = await follow(context, { loads: 35_000, breaks: true });
  assert.ok(aborted.every((at) => at < 10_000) && begun.filter((at) => at >= 10_000).length === 4, `${begun}, without ${aborted}`);
  assert.ok(methods.slice(13, 35).every((method) => method === 'lookup and movers'), `${methods}`);
  assert.equal(methods.at(-1), 'lookup');
});

test('a light with a radius, whose movers no mask shows, waits for the end', async (context) => {
  const { begun, methods } = await follow(context, { loads: 15_000, radius: 0.1 });
  assert.ok(begun.length === 1 && begun[0] >= 14_800, `${begun}`);
  assert.equal(methods.at(-1), 'lookup');
});
