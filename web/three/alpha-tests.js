// Alpha-tested materials of three.js in the mask engine's form.

import { sameNumbers } from './mesh-shape.js';
import { blends, colourOf, tintObstacleOf, tintOf, tintTexturesOf } from './see-through.js';
import { texcoordsOfTexture } from './texture-products.js';

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

/** The texture by whose coordinates its alpha is sampled: alphaMap, with alpha in green, or map. */
const textureOf = ({ alphaMap, map }) => alphaMap ?? map ?? null;

/** three.js's name of that texture's coordinates. */
export const texcoordsNameOf = (material) => texcoordsOfTexture(textureOf(material));

export const sameAlpha = (a, b) => a.texture === b.texture && a.channel === b.channel && a.opacity === b.opacity &&
  a.cutoff === b.cutoff && a.cutsOut === b.cutsOut && a.texels === b.texels && a.why === b.why && sameNumbers(a.texcoordTransform, b.texcoordTransform);

export const sameTint = (a, b) => a.texels === b.texels && sameNumbers(a.tint, b.tint) && sameNumbers(a.texcoordTransform, b.texcoordTransform);

export class AlphaTests {
  #uploaded;
  #reading;
  #products;
  #otherwise;

  /**
   * `uploaded(texture)`: what is on the GPU of it for the next picture, or null; `reading`: a
   * TexelReading; `products`: TextureProducts; `otherwise`: what meshes do whose texture it can't
   * read, a verb with its object.
   */
  constructor(uploaded, reading, products, otherwise = 'casts nothing') {
    this.#uploaded = uploaded;
    this.#reading = reading;
    this.#products = products;
    this.#otherwise = otherwise;
  }

  /**
   * The alpha of a geometry's material, in the form of ShadowMasks.setAlpha(). `cutsOut`: whether lookups are
   * to have what it leaves, which they do once its texels are read; `why`: a clause if that isn't exact.
   */
  of(material, cutsOut, geometry) {
    const texture = textureOf(material);
    const alpha = { texture: null, channel: 'alpha', opacity: material.opacity, cutoff: material.alphaTest,
      texcoordTransform: [1, 0, 0, 0, 1, 0, 0, 0, 1], cutsOut, texels: null, why: '' };
    if (!texture) return alpha;
    const uploaded = this.#uploaded(texture);
    if (texture === material.alphaMap) {
      alpha.channel = 'green';
      if (!uploaded) alpha.opacity = 0; // fully transparent: three.js samples black for what
                                            // isn't loaded yet
    }
    if (!uploaded) return { ...alpha, cutsOut: false };
    if (texture.matrixAutoUpdate) texture.updateMatrix();
    const single = { texture, uploaded, texcoordTransform: [...texture.matrix.elements] };
    const { waits, product, without } = this.#productOf(material, geometry);
    const { texture: sampled, ...used } = product ?? single;
    Object.assign(alpha, { texture: used.uploaded, texcoordTransform: used.texcoordTransform });
    if (!cutsOut) return alpha;
    const { number, why } = this.#reading.of(sampled, used.uploaded, alpha.channel);
    if (number === null || why || waits) return { ...alpha, cutsOut: false, why: why && `${this.#otherwise}: ${why}` };
    return { ...alpha, texels: number, why: without ? "casts the shadow of its alphaMap alone, without its map's alpha" : '' };
  }

  /** {product: of alphaMap and map, if both have alpha; waits: that isn't known yet; without: there can be none}. */
  #productOf({ alphaMap, map }, geometry) {
    const uploaded = alphaMap && map && this.#uploaded(map);
    if (!uploaded) return {};
    const { number, opaque, why } = this.#reading.of(map, uploaded, 'alpha');
    if (number !== null && opaque) return {};
    const product = number === null ? null : this.#products.of([alphaMap, map, null], geometry);
    return { product, waits: number === null && !why, without: !product };
  }

  /**
   * What a mesh's see-through material lets through: {tint, texels, texcoordTransform} as in ShadowMasks.setTint(),
   * without its textures until they are read; `why`: a clause if that isn't exact.
   */
  tintOf({ geometry, material }) {
    const plain = { tint: tintOf(material), texels: null, texcoordTransform: [1, 0, 0, 0, 1, 0, 0, 0, 1], why: tintObstacleOf(geometry, material) };
    const textures = tintTexturesOf(material), present = textures.filter(Boolean);
    if (present.length === 0 || !present.every((texture) => this.#uploaded(texture))) return plain;
    const { opacity, transmission = 0 } = material;
    const product = this.#products.of(textures, geometry, { opacity: blends(material) ? opacity : -1, transmission });
    const read = product && this.#reading.of(product.texture, product.uploaded, 'colour');
    if (!product || read.why) return { ...plain, why: tintObstacleOf(geometry, material, textures) };
    if (read.number === null) return plain;
    return { ...plain, tint: colourOf(material), texels: read.number, texcoordTransform: product.texcoordTransform };
  }
}
