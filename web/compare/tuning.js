// Finds the biases with which a map has the fewest wrong pixels.

import { accuracyOf, maskLook } from './accuracy.js';

/** Biases to try, in texels: as a depth, and as an offset along the normal. */
const biases = [0, -0.25, -0.5, -1, -2, -4];
const normalBiases = [0, 0.5, 1, 2, 3];
const places = (value) => Number(value.toPrecision(2));

/**
 * `frame`: the view to try biases in; the camera stays. Returns {biases, wrong, of}: three.js's
 * {bias, normalBias}, the number of pixels that are wrong with them, and the number of all.
 */
export function bestBiases(world, method, reference, mapSize, frame, width, height) {
  const texel = (2 * world.radius) / mapSize; // approximately, for a map that holds the scene
  const exact = world.pixelsOf(reference, { ...frame, look: maskLook }, width, height);
  let best = null;
  for (const slope of normalBiases)
    for (const share of biases) {
      const tried = { bias: places(share / mapSize), normalBias: places(slope * texel) };
      const pixels = world.pixelsOf(method, { ...frame, look: maskLook, biases: tried }, width, height);
      const { wrong, surfaces } = accuracyOf(exact, pixels, width, height);
      if (!best || wrong < best.wrong) best = { biases: tried, wrong, of: surfaces };
    }
  return best;
}
