// The biases with which a map has the fewest wrong pixels.

import { accuracyOf, maskLook } from './accuracy.js';

/** Of depths a texel long and of normals a texel long. */
const biases = [0, -0.25, -0.5, -1, -2, -4];
const normalBiases = [0, 0.5, 1, 2, 3];
const places = (value) => Number(value.toPrecision(2));

/**
 * `frame`: what is seen, of which the biases are tried; the camera stays. {biases, wrong, of}: three.js's {bias,
 * normalBias}, and the pixels that are wrong with them, of so many.
 */
export function bestBiases(world, method, reference, mapSize, frame, width, height) {
  const texel = (2 * world.radius) / mapSize; // about, of a map that holds the scene
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
