// Alpha-tested materials of a WebGPURenderer in the mask engine's form.

import { AlphaTests } from '../three/alpha-tests.js';

const otherwise = "has the shadow of three.js's own map";

/** A texture that three.js can upload now, or null. */
const uploadable = (texture) => (texture.isRenderTargetTexture || (texture.version > 0 && texture.image && texture.image.complete !== false) ? texture : null);

/** Whether nodes take the place of what a material's textures and opacity say of its alpha. */
const hasOwnAlpha = ({ colorNode, opacityNode, alphaTestNode, maskNode, fragmentNode }) => Boolean(colorNode ?? opacityNode ?? alphaTestNode ?? maskNode ?? fragmentNode);

export class NodeAlphaTests {
  #tests;

  /** `reading`: a TexelReading. */
  constructor(reading) {
    this.#tests = new AlphaTests(uploadable, reading, otherwise);
  }

  /** As AlphaTests.of(). */
  of(material, cutsOut) {
    if (!cutsOut || !hasOwnAlpha(material)) return this.#tests.of(material, cutsOut);
    return { ...this.#tests.of(material, false), why: `${otherwise}: nodes compute its alpha` };
  }
}
