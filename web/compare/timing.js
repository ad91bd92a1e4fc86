// Frame times, each until the picture is finished.

const frameStart = () => new Promise((resolve) => requestAnimationFrame(resolve));

/** Returns when the context has drawn everything: a pixel can be read only then. */
export function finish(context) {
  context.readPixels(0, 0, 1, 1, context.RGBA, context.UNSIGNED_BYTE, new Uint8Array(4));
}

export function median(values) {
  const sorted = [...values].sort((a, b) => a - b);
  const middle = sorted.length >> 1;
  return sorted.length % 2 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}

/**
 * Milliseconds of `frames` frames after `warmUp` more. `drawOne(i, started)` draws frame i, calls
 * started() when it begins to, or later with when it did, and its promise resolves when the picture is finished.
 */
export async function timeFrames({ frames, warmUp }, drawOne) {
  const times = [];
  for (let i = 0; i < warmUp + frames; ++i) {
    let since = 0;
    await frameStart();
    await drawOne(i, (at = performance.now()) => { since = at; });
    if (i >= warmUp) times.push(performance.now() - since);
  }
  return times;
}
