// Products of textures of a WebGPURenderer, which only the reading of texels samples: nodes.

import { float, mat3, select, texture as textureOf, uniform, vec3, vec4 } from 'three/tsl';

/** The drawing of TextureProducts: what they begin is {plan}, for productAt(). */
export const nodeProducts = {
  versionOf: ({ version }) => version,
  begun: () => ({ plan: null }),
  draw(product, plan) {
    product.plan = plan;
    plan.texture.version = plan.version;
  },
  freed() {},
};

/**
 * A product at its coordinates, 0..1: as the fragment shader of edgeshade/three's ProductDrawing, but that a
 * WebGPURenderer takes an alphaMap's red.
 */
export function productAt({ plan: { textures, matrices, seeThrough } }, coordinates) {
  const [alphaMap, map, transmissionMap] = textures.map((texture, i) =>
    texture && textureOf(texture, mat3(uniform(matrices[i])).mul(vec3(coordinates, 1)).xy).level(float(0)));
  const [opacity, transmission] = seeThrough.map((share) => uniform(share));
  const base = map ?? vec4(1);
  const alpha = (alphaMap ? alphaMap.r : float(1)).mul(base.a).toVar();
  if (!seeThrough[2]) return vec4(alpha);
  // Opaque materials ignore alpha.
  const solid = select(opacity.lessThan(0), float(1), opacity.mul(alpha));
  const through = float(1).sub(solid.mul(float(1).sub(transmission.mul(transmissionMap ? transmissionMap.r : float(1)))));
  return vec4(base.rgb.mul(through), 1);
}
