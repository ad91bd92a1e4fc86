// Sums of three products that nearly cancel, and the signs that edgeshade/three-webgpu computes of them.

import { DataTexture, FloatType, NodeMaterial, QuadMesh, RenderTarget, RGBAFormat } from 'three/webgpu';
import { float, int, ivec2, screenCoordinate, textureLoad, vec4 } from 'three/tsl';
import { isAtLeastZero } from '/three-webgpu/exact-sign.js';

/** A number in -1..1 that depends on `n` alone. */
const noise = (n) => { const x = Math.sin(n * 12.9898) * 43758.5453; return 2 * (x - Math.floor(x)) - 1; };

/** A double as an integer times 2 ** -1100, exactly. */
function exact(value) {
  const view = new DataView(new ArrayBuffer(8));
  view.setFloat64(0, value);
  const all = view.getBigUint64(0), exponent = Number((all >> 52n) & 2047n);
  const digits = (all & (2n ** 52n - 1n)) | (exponent ? 2n ** 52n : 0n);
  return (value < 0 ? -digits : digits) << BigInt(Math.max(exponent, 1) + 25);
}

/** Products of floats are exact in doubles. */
const signOf = (a, b) => a.reduce((sum, value, i) => sum + exact(value * b[i]), 0n) >= 0n;

const inFloats = (a, b) => Math.fround(Math.fround(Math.fround(a[0] * b[0]) + Math.fround(a[1] * b[1])) + Math.fround(a[2] * b[2])) >= 0;

/** Lines through two points of a tile, as edges are stored, and rays that all but meet them. */
function nearTies(count) {
  return Array.from({ length: count }, (_, n) => {
    const scale = 10 ** (-(n % 5)); // short edges, too
    const [x, y] = [noise(7 * n), noise(7 * n + 1)].map(Math.fround);
    const [u, v] = [x + scale * noise(7 * n + 2), y + scale * noise(7 * n + 3)].map(Math.fround);
    const edge = [y - v, u - x, x * v - y * u].map(Math.fround);
    const share = 0.5 + 0.5 * noise(7 * n + 4);
    const ray = [x + share * (u - x), y + share * (v - y), 1].map(Math.fround);
    if (n % 16 === 0) return [edge, [x, y, 1]]; // at its end
    if (n % 16 === 1) return [[edge[0], 0, -edge[0]], [1, y, 1]]; // 0
    if (n % 16 === 2) return [[1, -1, 2 ** -(20 + n % 100)], [x, x, noise(n) < 0 ? -1 : 1]]; // the last decides
    return [edge, ray];
  });
}

const textureOf = (vectors) => {
  const texture = new DataTexture(Float32Array.from(vectors.flatMap((vector) => [...vector, 0])), vectors.length, 1, RGBAFormat, FloatType);
  texture.needsUpdate = true;
  return texture;
};

/** {count, wrong, mirrored: wrong for the neighbour, inFloats: wrong in floats}. */
export async function exactSigns(renderer, count = 8192) {
  const cases = nearTies(count);
  const textures = [cases.map(([edge]) => edge), cases.map(([, ray]) => ray)].map(textureOf);
  const at = ivec2(int(screenCoordinate.x), 0);
  const [edge, ray] = textures.map((texture) => textureLoad(texture, at).xyz);
  const material = new NodeMaterial();
  material.fragmentNode = vec4(float(isAtLeastZero(edge, ray)), float(isAtLeastZero(edge.negate(), ray)), 0, 1);
  const target = new RenderTarget(count, 1);
  const before = renderer.getRenderTarget();
  renderer.setRenderTarget(target);
  new QuadMesh(material).render(renderer);
  renderer.setRenderTarget(before);
  const pixels = await renderer.readRenderTargetPixelsAsync(target, 0, 0, count, 1);
  const told = { count, wrong: 0, mirrored: 0, inFloats: 0 };
  for (const [i, [a, b]] of cases.entries()) {
    told.wrong += (pixels[4 * i] > 127) !== signOf(a, b);
    told.mirrored += (pixels[4 * i + 1] > 127) !== signOf(a.map((value) => -value), b);
    told.inFloats += inFloats(a, b) !== signOf(a, b);
  }
  return told;
}
