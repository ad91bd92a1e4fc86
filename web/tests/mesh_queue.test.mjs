// New meshes on their way into the engine, with an engine of the test's own.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Mesh, MeshBasicMaterial, SphereGeometry } from 'three';
import { Casters } from '../three/casters.js';
import { MeshQueue } from '../three/mesh-queue.js';

/** A queue with an engine that prepares batches when the test says so. `ofTaken(bytes)`: called as the engine takes a mesh over. */
function started(ofTaken = () => {}) {
  const engine = { answers: [], added: [], released: [], isPrepared: true, isBusy: true, pieces: () => [], uploadStep: () => true };
  const masks = {
    prepareTogether: (shapes, places) => new Promise((resolve) => {
      engine.answers.push(() => resolve({ meshes: shapes.map(({ name }) => name), merged: places.length ? [{ members: places.map((_, i) => i), bytes: '' }] : [] }));
    }),
    *taking(bytes) {
      ofTaken(bytes, engine);
      yield* engine.pieces();
      return 1;
    },
    *takingMerged() { return 2; },
    uploadStep: () => engine.uploadStep(),
    release: (number) => engine.released.push(number),
    addMerged: (_, numbers) => {
      engine.added.push(numbers.length);
      return numbers;
    },
  };
  const queue = new MeshQueue(masks, assert.fail, () => engine.isPrepared, () => engine.isBusy);
  const add = (name) => queue.add({ entry: { number: null, users: 1 }, merges: true, shape: () => ({ name, indices: new Array(3e5) }), matrix: () => [],
    isWanted: () => true, placed() {}, done() {} });
  /** Lets the engine answer the oldest batch. */
  const answer = async () => {
    engine.answers.shift()();
    await new Promise((resolve) => { setTimeout(resolve); });
  };
  return { queue, engine, add, answer };
}

test('meshes that ask for further programs as they are taken over wait for these', async (context) => {
  let now = 0;
  context.mock.method(performance, 'now', () => now);
  const { queue, engine, add, answer } = started((name, of) => { of.isPrepared &&= name !== 'open'; });
  for (const name of ['closed', 'open', 'last']) add(name);
  queue.advance();
  await answer();
  queue.advance();
  assert.deepEqual(engine.added, [], 'they wait for the others');
  now += 5000; // longer than they wait
  await answer();
  queue.advance();
  queue.advance();
  assert.deepEqual(engine.added, [], 'and for the programs of the open one');
  engine.isPrepared = true;
  queue.advance();
  assert.deepEqual(engine.added, [1, 1]);
});

test('ready meshes wait for others only while the GPU is busy', async () => {
  const { queue, engine, add, answer } = started();
  for (const name of ['first', 'second']) add(name);
  queue.advance();
  await answer();
  queue.advance();
  queue.advance();
  assert.deepEqual(engine.added, [], 'the GPU is busy, and more come');
  engine.isBusy = false;
  queue.advance();
  assert.deepEqual(engine.added, [1]);
});

test('a queue tells whether it has something to do at once', async () => {
  const { queue, engine, add, answer } = started();
  assert.equal(queue.hasSteps, false);
  add('one');
  assert.equal(queue.hasSteps, true, 'to read it');
  queue.advance();
  assert.equal(queue.hasSteps, false, 'the engine prepares it');
  await answer();
  assert.equal(queue.hasSteps, true, 'to take it over');
  queue.advance();
  queue.advance();
  assert.deepEqual([queue.hasSteps, engine.added], [false, [1]]);
});

test('a frame takes no steps that have been taken since the frame before', async (context) => {
  let now = 0;
  context.mock.method(performance, 'now', () => now);
  const sent = [];
  const masks = { prepareTogether: ([{ indices }]) => {
    now += 20; // a step of its own
    sent.push(indices.length);
    return new Promise(() => {});
  } };
  const told = { touched() {}, failed: assert.fail };
  const casters = new Casters(masks, {}, { parts: () => 0, of: () => [] }, { warn: assert.fail }, told);
  const meshes = [1, 2, 3, 4].map((i) => {
    const mesh = new Mesh(new SphereGeometry(1, 40, 40 + i), new MeshBasicMaterial());
    mesh.castShadow = true;
    return mesh;
  });
  const frame = () => {
    casters.follow(meshes, 'exact', 'none');
    return sent.length;
  };
  assert.equal(frame(), 0, 'they are found');
  assert.equal(frame(), 1, 'no step came between');
  casters.advance();
  assert.equal(sent.length, 2);
  assert.equal(frame(), 2, 'a step came between');
  assert.equal(frame(), 3);
});

test('a large mesh is taken over and uploaded in steps, and let go if nobody uses it any more', async (context) => {
  let now = 0;
  context.mock.method(performance, 'now', () => now);
  const { queue, engine, answer } = started();
  let pieces = 0, uploads = 0;
  engine.pieces = function* () {
    for (; pieces < 20; ++pieces, now += 3) yield; // milliseconds
  };
  engine.uploadStep = () => {
    now += 5;
    uploads += 1;
    return uploads === 4;
  };
  let done = 0;
  const add = () => {
    const entry = { number: null, users: 1 };
    queue.add({ entry, merges: false, shape: () => ({ name: 'large', indices: new Array(3e5) }), isWanted: () => true, done() { done += 1; } });
    return entry;
  };
  const frame = () => {
    const since = now;
    const changed = queue.advance();
    assert.ok(now - since <= 11, `${now - since} ms in a frame`);
    return changed;
  };
  const kept = add();
  frame();
  await answer();
  const changes = [];
  while (kept.number === null) changes.push(frame());
  assert.ok(changes.length >= 7, `${changes.length} frames`);
  assert.deepEqual(new Set(changes.slice(0, -1)), new Set([false]), 'the GL stays as it is');
  assert.equal(done, 0, 'it is added once it is uploaded');
  for (let i = 0; uploads < 4; ++i) assert.ok(frame() && i < 4);
  frame();
  assert.deepEqual([done, uploads, queue.hasSteps, engine.released], [1, 4, false, []]);

  pieces = uploads = 0;
  const dropped = add();
  frame();
  await answer();
  frame();
  assert.ok(pieces > 0 && pieces < 20);
  dropped.users = 0;
  for (let i = 0; i < 12; ++i) frame();
  assert.deepEqual([dropped.number, engine.released, uploads, queue.hasSteps], [null, [1], 0, false]);
});
