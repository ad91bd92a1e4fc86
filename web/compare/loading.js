// Time until a model's exact shadows are ready, and whether they block the page meanwhile.

import { finish, frameStart } from './timing.js';

const nextTask = () => new Promise((resolve) => { setTimeout(resolve); });

/**
 * Milliseconds of a first frame until it is finished, including compiling programs and uploading
 * the model.
 */
function firstFrame(world, draw) {
  const since = performance.now();
  draw();
  finish(world.context);
  return performance.now() - since;
}

/**
 * Draws frames by each of `draws` {none, map, exact}, the last one until all exact shadows are
 * ready. Returns {none_ms, map_ms, milliseconds, frames, longest_call_ms, long_tasks_ms}: the first
 * two for the first frames of the others, the rest for exact shadows. Long tasks are the page's
 * tasks above 50 ms, null if the browser doesn't report them.
 */
export async function watchLoading(world, draws) {
  const none_ms = firstFrame(world, draws.none);
  const map_ms = firstFrame(world, draws.map);
  await nextTask();
  const tells = PerformanceObserver.supportedEntryTypes?.includes('longtask') ?? false;
  const tasks = [];
  const take = (entries) => tasks.push(...entries.map(({ duration }) => duration));
  const observer = new PerformanceObserver((list) => take(list.getEntries()));
  if (tells) observer.observe({ entryTypes: ['longtask'] });
  const began = performance.now();
  let frames = 0, longest = 0, ready = false, waited = null;
  do {
    await frameStart();
    const since = performance.now();
    draws.exact();
    longest = Math.max(longest, performance.now() - since);
    frames += 1;
    waited ??= world.exact.ready().finally(() => { ready = true; });
    waited.catch(() => {}); // awaited below
  } while (!ready);
  await waited;
  const milliseconds = performance.now() - began;
  await frameStart();
  await nextTask();
  take(observer.takeRecords());
  observer.disconnect();
  return { none_ms, map_ms, milliseconds, frames, longest_call_ms: longest, long_tasks_ms: tells ? tasks : null };
}
