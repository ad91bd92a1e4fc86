// Workers that build maps in slices hear messages in between, and wait for no timers.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { useBrowser } from './support/browser.mjs';
import { openThree } from './support/three.mjs';

const shared = useBrowser();

test('a turn ends after the messages that came before it', async () => {
  const page = await openThree(shared);
  const heard = await page.evaluate(async () => {
    const { turns } = await import('/element/event-loop.js');
    const turn = turns(), { port1, port2 } = new MessageChannel(), all = [];
    port1.onmessage = ({ data }) => all.push(data);
    await turn();
    const counts = [];
    for (let i = 0; i < 5; ++i) {
      port2.postMessage(i);
      await turn();
      counts.push(all.length);
    }
    await Promise.all([turn(), turn()]);
    return counts;
  });
  assert.deepEqual(heard, [1, 2, 3, 4, 5]);
  await shared.check(page);
});

test('the worker that builds a light\'s map sets no timers', async () => {
  const page = await openThree(shared);
  const told = await page.evaluate(async () => {
    const { Worker } = window, timers = [];
    new BroadcastChannel('timers').onmessage = ({ data }) => timers.push(data);
    let lookups = 0;
    window.Worker = class extends Worker {
      constructor(url, options) {
        lookups += url.href.endsWith('lookup-worker.js') ? 1 : 0;
        const script = `import ${JSON.stringify(url.href)};
          const { setTimeout: set } = globalThis, told = new BroadcastChannel('timers');
          globalThis.setTimeout = (call, wait, ...values) => {
            told.postMessage(wait ?? 0);
            return set(call, wait, ...values);
          };`;
        super(URL.createObjectURL(new Blob([script], { type: 'text/javascript' })), options);
      }
    };
    const { three, rendererOf, lampOf, whiten, ExactShadows, rested } = window.page;
    const { building, viewOf } = await import('/tests/building.js');
    const model = building(400), scene = new three.Scene(), { camera } = viewOf(model);
    scene.add(model, ...lampOf({ kind: 'DirectionalLight', position: [0.5, 1, -0.3] }));
    whiten(scene);
    const shadows = new ExactShadows(rendererOf({ width: 80, height: 60 })).add(scene);
    await rested(shadows, scene, camera);
    await new Promise((resolve) => { setTimeout(resolve, 50); });
    return { lookups, timers, lookedUp: shadows.cost.lookedUp };
  });
  assert.deepEqual(told, { lookups: 1, timers: [], lookedUp: 1 });
  await shared.check(page);
});
