// Products of several textures of one material, baked into one that masks and lookups sample.

import { ClampToEdgeWrapping, LinearFilter, Matrix3, MirroredRepeatWrapping, NearestFilter, Vector3 } from 'three';
import { bindOn, drawOver, programOver } from './drawing-over.js';
import { sameNumbers } from './mesh-shape.js';

/**
 * Texels of a product along one of the finest texture, and the most that the product then has in all. An odd
 * number keeps all centres of equally fine textures, between which they are linear.
 */
const finenesses = [[31, 2 ** 18], [7, 2 ** 20], [3, 2 ** 22], [1, 2 ** 24]];

/** Most texels along an edge, and those beside what the mesh shows. */
const longest = 4096, margin = 2;

/** Most that coordinates of one channel may differ from an affine function of another's. */
const tolerance = 1e-4;

/** Frames for which a product is kept that nothing uses. */
const patience = 300;

const fragmentShader = `#version 300 es
precision highp float;
uniform sampler2D maps[ 2 ];
uniform mat3 placing[ 2 ];
uniform vec2 size;
out vec4 product;
void main() {
	vec3 at = vec3( gl_FragCoord.xy / size, 1.0 );
	product = vec4( textureLod( maps[ 0 ], ( placing[ 0 ] * at ).xy, 0.0 ).g * textureLod( maps[ 1 ], ( placing[ 1 ] * at ).xy, 0.0 ).a );
}`;

const versionOf = (attribute) => attribute.data?.version ?? attribute.version;

const identity = new Matrix3();

/**
 * The matrix that takes one attribute's coordinates to another's at every vertex, or null if there is none: by
 * least squares.
 */
function affineBetween(from, to) {
  if (from === to) return identity;
  if (!from || !to) return null;
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
function sizeOf(textures, matrices) {
  const dense = [0, 3].map((column) => Math.max(...textures.map(({ image }, i) =>
    Math.max(Math.abs(matrices[i].elements[column]) * image.width, Math.abs(matrices[i].elements[column + 1]) * image.height))));
  for (const [fineness, most] of finenesses) {
    const size = dense.map((texels) => Math.max(1, Math.ceil(fineness * texels - 1e-3)));
    if (Math.max(...size) + 2 * margin <= longest && size[0] * size[1] <= most) return size;
  }
  return null;
}

const isFixed = ({ image, isVideoTexture, isRenderTargetTexture, isFramebufferTexture }) =>
  image?.width > 0 && !isVideoTexture && !isRenderTargetTexture && !isFramebufferTexture;

/** The WebGLTexture that a renderer uses for the next picture, or null. */
export function uploadedIn(renderer, texture) {
  const { image, version } = texture;
  const kept = renderer.properties.get(texture);
  const waits = version > 0 && kept.__version !== version && !texture.isRenderTargetTexture;
  if ((waits || texture.isVideoTexture) && image && image.complete !== false) renderer.initTexture(texture);
  return kept.__webglTexture ?? null;
}

/** three.js's name of a texture's coordinates. */
export const texcoordsOfTexture = (texture) => `uv${texture?.channel || ''}`;

export class TextureProducts {
  #renderer;
  #masks;
  #touched;
  #kept = new Map(); // by key: {webGlTexture, texture: as TexelReading takes it, drawn: numbers, seen}
  #boxes = new WeakMap(); // by attribute: {version, others, box, affine}
  #frame = 0;
  #program = null;

  /** `touched()` is called when the context's state may have changed. */
  constructor(renderer, masks, touched) {
    this.#renderer = renderer;
    this.#masks = masks;
    this.#touched = touched;
  }

  /**
   * An alphaMap's green times a map's alpha, both uploaded: {texture, webGlTexture, texcoordTransform of the
   * alphaMap's coordinates}, with the product in green. Null if there is none: a texture may change in every
   * frame, they have unlike coordinates, or the product would be too large.
   */
  of(alphaMap, map, geometry) {
    const textures = [alphaMap, map], [base, other] = textures.map((texture) => geometry.attributes[texcoordsOfTexture(texture)]);
    if (!base || !textures.every(isFixed)) return null;
    const { box, affine } = this.#shapeOf(base, other);
    if (!affine) return null;
    for (const texture of textures) if (texture.matrixAutoUpdate) texture.updateMatrix();
    let matrices = [alphaMap.matrix, map.matrix.clone().multiply(affine)], transform = alphaMap.matrix, size, wraps = [alphaMap.wrapS, alphaMap.wrapT];
    const repeats = sameNumbers(matrices[0].elements, matrices[1].elements) && sameNumbers(wraps, [map.wrapS, map.wrapT]);
    if (repeats) {
      matrices = [identity, identity];
      size = sizeOf(textures, matrices);
    } else {
      const within = ([u, v, width, height]) => new Matrix3().set(width, 0, u, 0, height, v, 0, 0, 1);
      const placed = (all) => matrices.map((matrix) => matrix.clone().multiply(all));
      const inner = sizeOf(textures, placed(within(box)));
      if (!inner) return null;
      const [du, dv] = inner.map((texels, i) => margin * box[2 + i] / texels);
      const outer = within([box[0] - du, box[1] - dv, box[2] + 2 * du, box[3] + 2 * dv]);
      matrices = placed(outer);
      transform = outer.invert();
      size = inner.map((texels) => texels + 2 * margin);
      wraps = [ClampToEdgeWrapping, ClampToEdgeWrapping];
    }
    if (!size) return null;
    const key = `${alphaMap.id} ${map.id} ${repeats ? '' : geometry.uuid}`;
    return { ...this.#drawn(key, textures, matrices, size, wraps), texcoordTransform: [...transform.elements] };
  }

  /** The box of coordinates, and how others follow from them. */
  #shapeOf(base, other) {
    const versions = [versionOf(base), other && versionOf(other)];
    const known = this.#boxes.get(base);
    if (known?.other === other && sameNumbers(known.versions, versions)) return known;
    const found = { other, versions, box: boxOf(base), affine: affineBetween(base, other) };
    this.#boxes.set(base, found);
    return found;
  }

  #drawn(key, textures, matrices, [width, height], [wrapS, wrapT]) {
    const { properties } = this.#renderer;
    const gl = this.#renderer.getContext();
    let entry = this.#kept.get(key);
    if (!entry) this.#kept.set(key, entry = { webGlTexture: gl.createTexture(), texture: { source: {} }, drawn: [], version: 0 });
    entry.seen = this.#frame;
    const drawn = [width, height, wrapS, wrapT, ...textures.flatMap((texture, i) =>
      [properties.get(texture.source).__version, texture.wrapS, texture.wrapT, texture.magFilter, ...matrices[i].elements])];
    if (sameNumbers(entry.drawn, drawn)) return entry;
    const isNearest = textures.every(({ magFilter }) => magFilter === NearestFilter);
    const hasMipmaps = textures.some(({ minFilter }) => minFilter !== NearestFilter && minFilter !== LinearFilter);
    Object.assign(entry, { drawn, version: entry.version + 1 });
    Object.assign(entry.texture, { image: { width, height }, wrapS, wrapT, magFilter: isNearest ? NearestFilter : LinearFilter });
    properties.get(entry.texture.source).__version = entry.version;
    this.#masks.keptWhile(() => this.#draw(gl, entry, textures, matrices, hasMipmaps));
    this.#touched();
    return entry;
  }

  #draw(gl, { webGlTexture, texture: { image: { width, height }, wrapS, wrapT, magFilter } }, textures, matrices, hasMipmaps) {
    const program = this.#program ??= programOver(gl, fragmentShader);
    const wrapOf = (mode) => (mode === ClampToEdgeWrapping ? gl.CLAMP_TO_EDGE : mode === MirroredRepeatWrapping ? gl.MIRRORED_REPEAT : gl.REPEAT);
    bindOn(gl, 0, webGlTexture);
    gl.bindBuffer(gl.PIXEL_UNPACK_BUFFER, null);
    const format = gl.getExtension('EXT_color_buffer_float') ? ['RG16F', 'RG', 'HALF_FLOAT'] : ['RGBA8', 'RGBA', 'UNSIGNED_BYTE']; // 11 bits, or 8
    const [inner, outer, type] = format.map((name) => gl[name]);
    gl.texImage2D(gl.TEXTURE_2D, 0, inner, width, height, 0, outer, type, null);
    const filter = magFilter === NearestFilter ? gl.NEAREST : gl.LINEAR;
    for (const [name, value] of [['MAG_FILTER', filter], ['MIN_FILTER', hasMipmaps ? gl.LINEAR_MIPMAP_LINEAR : filter], ['WRAP_S', wrapOf(wrapS)], ['WRAP_T', wrapOf(wrapT)]])
      gl.texParameteri(gl.TEXTURE_2D, gl[`TEXTURE_${name}`], value);
    drawOver(gl, program, webGlTexture, [width, height], (at) => {
      gl.uniform2f(at('size'), width, height);
      gl.uniform1iv(at('maps'), [0, 1]);
      gl.uniformMatrix3fv(at('placing'), false, matrices.flatMap(({ elements }) => elements));
      for (const [unit, texture] of textures.entries()) bindOn(gl, unit, this.#renderer.properties.get(texture).__webglTexture);
    });
    bindOn(gl, 0, webGlTexture);
    if (hasMipmaps) gl.generateMipmap(gl.TEXTURE_2D);
  }

  /** Call it once a frame: frees what nothing uses. */
  advance() {
    this.#frame += 1;
    for (const [key, { seen, webGlTexture }] of this.#kept) {
      if (this.#frame - seen < patience) continue;
      this.#renderer.getContext().deleteTexture(webGlTexture);
      this.#kept.delete(key);
    }
  }

  /** Called when the context is lost. */
  forget() {
    this.#kept.clear();
    this.#program = null;
  }

  dispose() {
    const gl = this.#renderer.getContext();
    if (this.#program) gl.deleteProgram(this.#program);
    for (const { webGlTexture } of this.#kept.values()) gl.deleteTexture(webGlTexture);
    this.forget();
  }
}
