// Loading again and again takes no more memory.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { useBrowser } from './support/browser.mjs';

const shared = useBrowser();

test('50 loads in a row leave memory flat', async () => {
  const page = await shared.open('/', { size: { width: 120, height: 160 } });
  const session = await page.context().newCDPSession(page);
  /** Bytes of JavaScript's heap and of the page's own WebAssembly memory. */
  const used = async () => {
    await session.send('HeapProfiler.collectGarbage');
    const { usedSize, backingStorageSize } = await session.send('Runtime.getHeapUsage');
    return usedSize + (backingStorageSize ?? 0);
  };
  const loadTimes = (count) => page.evaluate(async (times) => {
    for (let i = 0; i < times; ++i) await document.querySelector('#viewer').load('assets/pavilion.glb');
  }, count);
  await loadTimes(5);
  const before = await used();
  await loadTimes(50);
  const after = await used();
  console.log(`${(before / 1e6).toFixed(1)} MB after 5 loads, ${(after / 1e6).toFixed(1)} MB after 55`);
  assert.ok(after < 1.05 * before + 2e6, `${before} bytes became ${after}`);
  assert.equal(await page.evaluate(() => performance.now() > 0), true);
  await shared.check(page);
});
