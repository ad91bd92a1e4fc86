// A camera of three.js in the mask engine's form.

/** In view space, the row of the projection that is 0 on the near plane. */
const nearRow = (p) => [3, 7, 11, 15].map((i) => p[i] + p[i - 1]);

/** A row of view space in the world. */
const inWorld = (row, v) => [0, 4, 8, 12].map((begin) => row.reduce((sum, value, i) => sum + value * v[begin + i], 0));

/**
 * {viewFromWorld, clipFromView, plane}. `plane`: [a, b, c, d] in the world, below which an oblique
 * near plane clips, as those of mirrors; null for others, whose depths the engine doesn't need.
 */
export function engineViewOf({ matrixWorldInverse, projectionMatrix }) {
  const viewFromWorld = [...matrixWorldInverse.elements], clipFromView = [...projectionMatrix.elements];
  const oblique = clipFromView[2] !== 0 || clipFromView[6] !== 0;
  const plane = oblique ? inWorld(nearRow(clipFromView), viewFromWorld) : null;
  if (clipFromView[0] < 0 && clipFromView[5] < 0) {
    // CubeCamera turns its pictures by half: the engine's camera turns instead.
    for (let i = 0; i < 16; ++i) if (i % 4 < 2) viewFromWorld[i] *= -1;
    for (let i = 0; i < 8; ++i) clipFromView[i] *= -1;
  }
  return { viewFromWorld, clipFromView, plane };
}
