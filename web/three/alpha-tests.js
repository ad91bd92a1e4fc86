// Alpha-tested materials of three.js in the mask engine's form.

import { sameNumbers } from './mesh-shape.js';

/** Choices of how alpha-tested meshes with castShadow cast: in masks, and in lookups. */
const casting = {
  exact: { whole: false, cutsOut: true },
  'exact-or-whole': { whole: true, cutsOut: true },
  whole: { whole: true, cutsOut: false },
  none: { whole: false, cutsOut: false },
};

/** {whole: whether they cast whole triangles, cutsOut: whether lookups have what alpha leaves}. */
export function alphaTestedCasting(choice) {
  if (!Object.hasOwn(casting, choice)) throw new Error(`alphaTestedCast is '${choice}', which is not one of ${Object.keys(casting).join(', ')}.`);
  return casting[choice];
}

/** Whether alpha decides where a surface is. */
export const isAlphaTested = (material) => material.alphaTest > 0;

/** The texture that holds its alpha: alphaMap, with alpha in green, takes precedence over map. */
const textureOf = ({ alphaMap, map }) => alphaMap ?? map ?? null;

/** three.js's name of that texture's coordinates. */
export const texcoordsNameOf = (material) => `uv${textureOf(material)?.channel || ''}`;

export const sameAlpha = (a, b) => a.texture === b.texture && a.channel === b.channel && a.opacity === b.opacity &&
  a.cutoff === b.cutoff && a.cutsOut === b.cutsOut && a.texels === b.texels && a.why === b.why && sameNumbers(a.texcoordTransform, b.texcoordTransform);

/** The texture on the GPU as a WebGLRenderer uses it for the next picture, or null. */
export function uploadedBy(renderer, texture) {
  const { image, version } = texture;
  const kept = renderer.properties.get(texture);
  const waits = version > 0 && kept.__version !== version && !texture.isRenderTargetTexture;
  if ((waits || texture.isVideoTexture) && image && image.complete !== false) renderer.initTexture(texture);
  return kept.__webglTexture ?? null;
}

export class AlphaTests {
  #uploaded;
  #reading;
  #otherwise;

  /**
   * `uploaded(texture)`: what is on the GPU of it for the next picture, or null; `reading`: a
   * TexelReading; `otherwise`: what meshes do whose texture it can't read, a verb with its object.
   */
  constructor(uploaded, reading, otherwise = 'casts nothing') {
    this.#uploaded = uploaded;
    this.#reading = reading;
    this.#otherwise = otherwise;
  }

  /**
   * A material's alpha, in the form of ShadowMasks.setAlpha(). `cutsOut`: whether lookups are to have
   * what it leaves, which they do once its texels are read; `why`: a clause if that isn't exact.
   */
  of(material, cutsOut) {
    const texture = textureOf(material);
    const alpha = { texture: null, channel: 'alpha', opacity: material.opacity, cutoff: material.alphaTest,
      texcoordTransform: [1, 0, 0, 0, 1, 0, 0, 0, 1], cutsOut, texels: null, why: '' };
    if (!texture) return alpha;
    const webGlTexture = this.#uploaded(texture);
    if (texture === material.alphaMap) {
      alpha.channel = 'green';
      if (!webGlTexture) alpha.opacity = 0; // fully transparent: three.js samples black for what
                                            // isn't loaded yet
    }
    if (!webGlTexture) return { ...alpha, cutsOut: false };
    if (texture.matrixAutoUpdate) texture.updateMatrix();
    return { ...alpha, texture: webGlTexture, texcoordTransform: [...texture.matrix.elements], ...(cutsOut && this.#texelsOf(material, texture, webGlTexture, alpha.channel)) };
  }

  #texelsOf({ alphaMap, map }, texture, webGlTexture, channel) {
    const { number, why } = this.#reading.of(texture, webGlTexture, channel);
    if (number === null || why) return { cutsOut: false, why: why && `${this.#otherwise}: ${why}` };
    const other = alphaMap && map && this.#uploaded(map);
    const mapped = other ? this.#reading.of(map, other, 'alpha') : { opaque: true };
    return { texels: number, why: mapped.opaque || mapped.number === null ? '' : "casts the shadow of its alphaMap alone, without its map's alpha" };
  }
}
