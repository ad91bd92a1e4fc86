// Calls to a worker, with a worker of the test's own.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { setTimeout as pause } from 'node:timers/promises';
import { WorkerCalls } from '../masks/worker-calls.js';

const idle = 40; // milliseconds

function started() {
  const workers = [];
  const calls = new WorkerCalls(() => {
    const worker = { asked: [], isEnded: false, postMessage: (message) => worker.asked.push(message), terminate() { worker.isEnded = true; } };
    workers.push(worker);
    return worker;
  }, 'counts', idle);
  const answer = (number, result) => workers.at(-1).onmessage({ data: { number, result } });
  return { calls, workers, answer };
}

test('a worker ends once it has had no calls for a while, and the next call starts another one', async () => {
  const { calls, workers, answer } = started();
  const first = calls.ask({ of: 1 });
  answer(1, 'one');
  assert.equal(await first, 'one');
  await pause(3 * idle);
  assert.equal(workers[0].isEnded, true);
  const second = calls.ask({ of: 2 });
  assert.equal(workers.length, 2);
  answer(2, 'two');
  assert.equal(await second, 'two');
  calls.dispose();
});

test('a call goes on for as long as it takes, though the worker answered a cancelled one before', async () => {
  const { calls, workers, answer } = started();
  const cancelled = new AbortController(), first = calls.ask({ of: 1 }, { signal: cancelled.signal });
  cancelled.abort();
  assert.equal(await first, null);
  answer(1, 'too late');
  const second = calls.ask({ of: 2 });
  await pause(3 * idle);
  assert.equal(workers[0].isEnded, false);
  answer(2, 'two');
  assert.equal(await second, 'two');
  calls.dispose();
});
