// Alpha-tested materials of three.js in the mask engine's form.

import { sameNumbers } from './mesh-shape.js';

/** Whether alpha decides where a surface is. */
export const isAlphaTested = (material) => material.alphaTest > 0;

/** The texture that holds its alpha: alphaMap, with alpha in green, takes precedence over map. */
const textureOf = ({ alphaMap, map }) => alphaMap ?? map ?? null;

/** three.js's name of that texture's coordinates. */
export const texcoordsNameOf = (material) => `uv${textureOf(material)?.channel || ''}`;

export const sameAlpha = (a, b) => a.texture === b.texture && a.channel === b.channel && a.opacity === b.opacity &&
  a.cutoff === b.cutoff && sameNumbers(a.texcoordTransform, b.texcoordTransform);

export class AlphaTests {
  #renderer;

  constructor(renderer) {
    this.#renderer = renderer;
  }

  /** A material's alpha, in the form of ShadowMasks.setAlpha(). */
  of(material) {
    const texture = textureOf(material);
    const alpha = { texture: null, channel: 'alpha', opacity: material.opacity, cutoff: material.alphaTest,
      texcoordTransform: [1, 0, 0, 0, 1, 0, 0, 0, 1] };
    if (!texture) return alpha;
    const webGlTexture = this.#uploaded(texture);
    if (texture === material.alphaMap) {
      alpha.channel = 'green';
      if (!webGlTexture) alpha.opacity = 0; // fully transparent: three.js samples black for what
                                            // isn't loaded yet
    }
    if (!webGlTexture) return alpha;
    if (texture.matrixAutoUpdate) texture.updateMatrix();
    return { ...alpha, texture: webGlTexture, texcoordTransform: [...texture.matrix.elements] };
  }

  /** The texture on the GPU as three.js uses it for the next picture, or null. */
  #uploaded(texture) {
    const { image, version } = texture;
    const kept = this.#renderer.properties.get(texture);
    const waits = version > 0 && kept.__version !== version && !texture.isRenderTargetTexture;
    if ((waits || texture.isVideoTexture) && image && image.complete !== false) this.#renderer.initTexture(texture);
    return kept.__webglTexture ?? null;
  }
}
