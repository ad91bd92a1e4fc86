// Difference between a method's shadows and the exact ones, pixel by pixel.

/** `look` of a frame for accuracyOf(): white where the light reaches a side that faces it. */
export const maskLook = 'mask';

/**
 * `reference`, `other`: RGBA of masks of one view. Returns {surfaces, shadowed, wrong, beyond,
 * apart}. surfaces: pixels with a surface; shadowed: those in shadow; wrong: those that differ by
 * more than half a light; beyond: wrong ones with no boundary of the reference mask or of visible
 * geometry within a pixel; apart: sum of all differences, as shares of the light.
 */
export function accuracyOf(reference, other, width, height) {
  // 0: no surface; 1: in shadow; 2: lit.
  const kinds = new Uint8Array(width * height);
  for (let i = 0; i < kinds.length; ++i) kinds[i] = reference[4 * i + 3] === 0 ? 0 : reference[4 * i] > 127 ? 2 : 1;
  const atBoundary = (x, y) => {
    for (let v = Math.max(0, y - 1); v <= Math.min(height - 1, y + 1); ++v)
      for (let u = Math.max(0, x - 1); u <= Math.min(width - 1, x + 1); ++u)
        if (kinds[v * width + u] !== kinds[y * width + x]) return true;
    return false;
  };
  const told = { surfaces: 0, shadowed: 0, wrong: 0, beyond: 0, apart: 0 };
  for (let y = 0, i = 0; y < height; ++y)
    for (let x = 0; x < width; ++x, ++i) {
      if (kinds[i] === 0) continue;
      told.surfaces += 1;
      told.shadowed += kinds[i] === 1;
      const off = Math.abs(reference[4 * i] - other[4 * i]);
      told.apart += off / 255;
      if (off < 128) continue;
      told.wrong += 1;
      told.beyond += !atBoundary(x, y);
    }
  return told;
}
