// Products of several textures of one material, baked into one that masks and lookups sample: how finely, and which
// are kept.

import { ClampToEdgeWrapping, LinearFilter, Matrix3, NearestFilter, Vector3 } from 'three';
import { sameNumbers } from './mesh-shape.js';

/**
 * Texels of a product along one of the finest texture, and the most that the product then has in all. An odd
 * number keeps all centres of equally fine textures, between which they are linear.
 */
const finenesses = [[31, 2 ** 18], [7, 2 ** 20], [3, 2 ** 22], [1, 2 ** 24]];

/** Most texels along an edge, of all layers as they are read, and those beside what the mesh shows. */
const longest = 4096, margin = 2;

/** Most that coordinates of one channel may differ from an affine function of another's. */
const tolerance = 1e-4;

/** Frames for which a product is kept that nothing uses. */
const patience = 300;

const versionOf = (attribute) => attribute.data?.version ?? attribute.version;

const identity = new Matrix3();

/**
 * The matrix that takes one attribute's coordinates to another's at every vertex, or null if there is none: by
 * least squares.
 */
function affineBetween(from, to) {
  const squares = new Array(9).fill(0), products = [new Vector3(), new Vector3()], p = new Vector3();
  const at = (i) => p.set(from.getX(i), from.getY(i), 1);
  for (let i = 0; i < from.count; ++i) {
    const one = at(i).toArray();
    one.forEach((a, j) => one.forEach((b, k) => { squares[3 * j + k] += a * b; }));
    products[0].addScaledVector(p, to.getX(i));
    products[1].addScaledVector(p, to.getY(i));
  }
  const inverse = new Matrix3().fromArray(squares).invert();
  const [u, v] = products.map((product) => product.applyMatrix3(inverse));
  for (let i = 0; i < from.count; ++i)
    if (!(Math.abs(u.dot(at(i)) - to.getX(i)) < tolerance && Math.abs(v.dot(p) - to.getY(i)) < tolerance)) return null;
  return new Matrix3().set(...u.toArray(), ...v.toArray(), 0, 0, 1);
}

/** The box of an attribute's coordinates: [low u, low v, width, height]. */
function boxOf(attribute) {
  const low = [Infinity, Infinity], high = [-Infinity, -Infinity];
  for (let i = 0; i < attribute.count; ++i)
    for (const [j, value] of [attribute.getX(i), attribute.getY(i)].entries()) {
      low[j] = Math.min(low[j], value);
      high[j] = Math.max(high[j], value);
    }
  return [...low, ...[0, 1].map((j) => Math.max(high[j] - low[j], 1e-6))];
}

/** Texels of a product whose coordinates 0..1 the matrices take to those of textures, or null. */
function sizeOf(textures, matrices, layers) {
  const dense = [0, 3].map((column) => Math.max(...textures.map((texture, i) => texture &&
    Math.max(Math.abs(matrices[i].elements[column]) * texture.image.width, Math.abs(matrices[i].elements[column + 1]) * texture.image.height))));
  for (const [fineness, most] of finenesses) {
    const size = dense.map((texels) => Math.max(1, Math.ceil(fineness * texels - 1e-3)));
    if (Math.max(size[0], layers * size[1]) + 2 * layers * margin <= longest && layers * size[0] * size[1] <= most) return size;
  }
  return null;
}

const isFixed = ({ image, isVideoTexture, isRenderTargetTexture, isFramebufferTexture }) =>
  image?.width > 0 && !isVideoTexture && !isRenderTargetTexture && !isFramebufferTexture;

/** three.js's name of a texture's coordinates. */
export const texcoordsOfTexture = (texture) => `uv${texture?.channel || ''}`;

export class TextureProducts {
  #drawing;
  #kept = new Map(); // by key: {uploaded, texture: as TexelReading takes it, drawn: numbers, seen}
  #attributes = new WeakMap(); // {version, box or null, affine: {version, matrix} by other attribute}
  #frame = 0;

  /**
   * `drawing`: {versionOf(texture): of its texels; begun(): a product without texels, on the GPU; draw(it,
   * plan), {texture: the product's, as TexelReading takes it, and the new `version` of its texels, and what
   * #drawn() takes}; freed(it)}, and for forget() and dispose() such functions.
   */
  constructor(drawing) {
    this.#drawing = drawing;
  }

  /**
   * The product of a material's alphaMap, map and transmissionMap, null for those it lacks, all uploaded: {texture,
   * uploaded, texcoordTransform of the first one's coordinates}. `tints`: null for alpha, which is in green
   * then, or {opacity, -1 if alpha is ignored; transmission}: for what it lets through, as red, green and blue.
   * Null if there is none: a texture may change in every frame, they have unlike coordinates, or the product
   * would be too large.
   */
  of(textures, geometry, tints = null) {
    const present = textures.filter(Boolean), first = present[0];
    const base = geometry.attributes[texcoordsOfTexture(first)];
    if (!base || !present.every(isFixed)) return null;
    const affine = textures.map((texture) => texture && this.#affineOf(base, geometry.attributes[texcoordsOfTexture(texture)]));
    if (affine.some((matrix, i) => textures[i] && !matrix)) return null;
    for (const texture of present) if (texture.matrixAutoUpdate) texture.updateMatrix();
    const layers = tints ? 3 : 1;
    let matrices = textures.map((texture, i) => (texture ? texture.matrix.clone().multiply(affine[i]) : identity));
    const repeats = present.every((texture) => texture.wrapS === first.wrapS && texture.wrapT === first.wrapT &&
      sameNumbers(matrices[textures.indexOf(texture)].elements, first.matrix.elements));
    let transform = first.matrix, size, wraps = [first.wrapS, first.wrapT];
    if (repeats) {
      matrices = textures.map(() => identity);
      size = sizeOf(textures, matrices, layers);
    } else {
      const box = this.#boxOf(base);
      const within = ([u, v, width, height]) => new Matrix3().set(width, 0, u, 0, height, v, 0, 0, 1);
      const placed = (all) => matrices.map((matrix) => matrix.clone().multiply(all));
      size = sizeOf(textures, placed(within(box)), layers);
      const [du, dv] = (size ?? [1, 1]).map((texels, i) => margin * box[2 + i] / texels);
      const outer = within([box[0] - du, box[1] - dv, box[2] + 2 * du, box[3] + 2 * dv]);
      matrices = placed(outer);
      transform = outer.invert();
      size = size?.map((texels) => texels + 2 * margin);
      wraps = [ClampToEdgeWrapping, ClampToEdgeWrapping];
    }
    if (!size) return null;
    const key = `${textures.map((texture) => texture?.id)} ${tints ? 'tint' : ''} ${repeats ? '' : geometry.uuid}`;
    const { texture, uploaded } = this.#drawn(key, { textures, matrices, size, wraps, seeThrough: [tints?.opacity ?? 1, tints?.transmission ?? 0, tints ? 1 : 0] });
    return { texture, uploaded, texcoordTransform: [...transform.elements] };
  }

  #followed(attribute) {
    const known = this.#attributes.get(attribute);
    if (known?.version === versionOf(attribute)) return known;
    const fresh = { version: versionOf(attribute), box: null, affine: new Map() };
    this.#attributes.set(attribute, fresh);
    return fresh;
  }

  #boxOf(attribute) {
    return (this.#followed(attribute).box ??= boxOf(attribute));
  }

  #affineOf(from, to) {
    if (from === to) return identity;
    if (!to) return null;
    const { affine } = this.#followed(from), known = affine.get(to);
    if (known?.version !== versionOf(to)) affine.set(to, { version: versionOf(to), matrix: affineBetween(from, to) });
    return affine.get(to).matrix;
  }

  /**
   * The product of a plan, drawn if it has changed. `matrices` take its coordinates, 0..1, to those of each texture;
   * `seeThrough`: opacity, -1 if alpha is ignored, transmission, and 1 for a tint.
   */
  #drawn(key, { textures, matrices, size: [width, height], wraps: [wrapS, wrapT], seeThrough }) {
    let entry = this.#kept.get(key);
    if (!entry) this.#kept.set(key, entry = { uploaded: this.#drawing.begun(), texture: { source: {} }, drawn: [], version: 0 });
    entry.seen = this.#frame;
    const drawn = [width, height, wrapS, wrapT, ...seeThrough, ...textures.flatMap((texture, i) => (texture ?
      [this.#drawing.versionOf(texture), texture.wrapS, texture.wrapT, texture.magFilter, ...matrices[i].elements] : []))];
    if (sameNumbers(entry.drawn, drawn)) return entry;
    const present = textures.filter(Boolean);
    const isNearest = present.every(({ magFilter }) => magFilter === NearestFilter);
    const hasMipmaps = present.some(({ minFilter }) => minFilter !== NearestFilter && minFilter !== LinearFilter);
    const { uploaded, texture, version } = Object.assign(entry, { drawn, version: entry.version + 1 });
    Object.assign(texture, { image: { width, height }, wrapS, wrapT, magFilter: isNearest ? NearestFilter : LinearFilter });
    this.#drawing.draw(uploaded, { texture, version, textures, matrices, seeThrough, hasMipmaps });
    return entry;
  }

  /** Call it once a frame: frees what nothing uses. */
  advance() {
    this.#frame += 1;
    for (const [key, { seen, uploaded }] of this.#kept) {
      if (this.#frame - seen < patience) continue;
      this.#drawing.freed(uploaded);
      this.#kept.delete(key);
    }
  }

  /** Called when the context is lost. */
  forget() {
    this.#kept.clear();
    this.#drawing.forget();
  }

  dispose() {
    for (const { uploaded } of this.#kept.values()) this.#drawing.freed(uploaded);
    this.#kept.clear();
    this.#drawing.dispose();
  }
}
