// Alpha-tested materials of a WebGPURenderer in the mask engine's form.

import { AlphaTests } from '../three/alpha-tests.js';

/** The lot of meshes that the mask engine can't have as they are drawn: a verb with its object. */
export const otherwise = "has the shadow of three.js's own map";

/** A texture that three.js can upload now, or null. */
const uploadable = (texture) => (texture.isRenderTargetTexture || (texture.version > 0 && texture.image && texture.image.complete !== false) ? texture : null);

/** Whether nodes take the place of what a material's textures and opacity say of its alpha. */
const hasOwnAlpha = ({ colorNode, opacityNode, alphaTestNode, maskNode, fragmentNode }) => Boolean(colorNode ?? opacityNode ?? alphaTestNode ?? maskNode ?? fragmentNode);

/** The same of what it lets through. */
const hasOwnTint = (material) => Boolean(hasOwnAlpha(material) || material.transmissionNode);

export class NodeAlphaTests {
  #tests;

  /** `reading`: a TexelReading; `products`: TextureProducts. */
  constructor(reading, products) {
    this.#tests = new AlphaTests(uploadable, reading, products, otherwise);
  }

  /** As AlphaTests.of(). */
  of(material, cutsOut, geometry) {
    if (!cutsOut || !hasOwnAlpha(material)) return this.#tests.of(material, cutsOut, geometry);
    return { ...this.#tests.of(material, false, geometry), why: `${otherwise}: nodes compute its alpha` };
  }

  /** As AlphaTests.tintOf(). */
  tintOf(mesh) {
    const tint = this.#tests.tintOf(mesh);
    return hasOwnTint(mesh.material) ? { ...tint, why: 'tints without what nodes compute of it' } : tint;
  }
}
