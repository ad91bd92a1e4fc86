// Programs of masks that are taken over while the GPU never rests, with an engine of the test's own.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { DrawPreparation } from '../three/draw-preparation.js';
import { PendingDraws } from '../three/pending-draws.js';

test('while the GPU is busy, a step takes over one program, and others come between', (context) => {
  let now = 0, isSignaled = false, left = 3;
  context.mock.method(performance, 'now', () => now);
  const calls = [], SIGNALED = 1;
  const gl = { SIGNALED, fenceSync: () => ({}), deleteSync() {}, flush() {}, getSyncParameter: () => isSignaled && SIGNALED };
  const masks = {
    isPrepared: true,
    prepareToDraw() {
      calls.push(now);
      return calls.length > 1 && (left -= 1) < 0; // the first call begins all of them
    },
  };
  const draws = new PendingDraws(gl);
  const preparation = new DrawPreparation(masks, draws);
  for (; now < 2000 && !preparation.isDone; now += 4) {
    preparation.advance({}, []);
    preparation.advance({}, []); // meshes that are to be added ask as well
    if (now % 100 === 0) draws.mark();
  }
  assert.equal(calls[0], 0);
  assert.ok(calls[1] >= 900, `${calls}`);
  for (const [i, at] of calls.entries()) assert.ok(i === 0 || at >= calls[i - 1] + 40, `${calls}`);
  assert.ok(preparation.isDone);
  // Further programs, while the GPU never rests.
  [calls.length, left, masks.isPrepared] = [0, 2, false];
  for (const end = now + 3000; now < end && !masks.isPrepared; now += 4) {
    preparation.advance({}, []);
    masks.isPrepared = left < 0;
    if (now % 100 === 0) draws.mark();
  }
  assert.ok(preparation.isDone, `${calls}`);
  // Others, while it rests between frames.
  [calls.length, left, masks.isPrepared, isSignaled] = [0, 2, false, true];
  for (const end = now + 100; now < end; now += 4) {
    preparation.advance({}, []);
    masks.isPrepared = left < 0;
  }
  assert.ok(preparation.isDone && calls.length >= 2);
});
