// Loading repeatedly takes no more memory.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { useBrowser } from './support/browser.mjs';
import { times } from './support/long.mjs';

const shared = useBrowser();

/**
 * Keeps references to the memories of the page's own programs; those of workers are out of reach.
 */
function keepMemories() {
  const { instantiate } = WebAssembly;
  window.memories = [];
  WebAssembly.instantiate = async (...rest) => {
    const instance = await instantiate.apply(WebAssembly, rest);
    window.memories.push(...Object.values(instance.exports).filter((value) => value instanceof WebAssembly.Memory));
    return instance;
  };
}

const first = times(6, 20), more = times(6, 50);

test(`${more} loads in a row leave memory flat`, async () => {
  const page = await shared.open('/', { size: { width: 120, height: 160 }, init: keepMemories });
  const session = await page.context().newCDPSession(page);
  /** Bytes of JavaScript's heap and of the page's WebAssembly memories. */
  const used = async () => {
    await session.send('HeapProfiler.collectGarbage');
    const { usedSize, backingStorageSize } = await session.send('Runtime.getHeapUsage');
    const program = await page.evaluate(() =>
      window.memories.map(({ buffer }) => buffer.byteLength).reduce((sum, bytes) => sum + bytes, 0));
    assert.ok(program > 1e6, 'the program\'s memory is counted');
    return usedSize + (backingStorageSize ?? 0) + program;
  };
  const loadTimes = async (count) => {
    await page.evaluate(async (times) => {
      for (let i = 0; i < times; ++i) await document.querySelector('#viewer').load('assets/pavilion.glb');
    }, count);
    // Its light gets a map once it rests, whenever the machine comes to that.
    await page.waitForFunction(() => document.querySelector('#viewer').stats.lights[0]?.method === 'primitive-map');
  };
  await loadTimes(first); // until the allocator has room for two scenes at once
  const leavesFlat = async (count) => {
    const before = await used();
    await loadTimes(count);
    const after = await used();
    console.log(`${(before / 1e6).toFixed(1)} MB, ${(after / 1e6).toFixed(1)} MB after ${count} more loads`);
    return after < 1.05 * before + 2e6;
  };
  // The program's memory grows by a fifth at once, and may do so once. Three times as many loads then show a leak of a
  // third of the size.
  assert.ok(await leavesFlat(more) || await leavesFlat(3 * more), 'it grows with each load');
  await shared.check(page);
});
