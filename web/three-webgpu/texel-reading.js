// Alpha and colours of three.js's textures, drawn as materials sample them, at level 0, and read back.

import { NearestFilter, WebGLCoordinateSystem } from 'three';
import { abs, Fn, float, int, ivec2, screenCoordinate, select, textureLoad, uint, uniform, vec2, vec4 } from 'three/tsl';
import { NodeMaterial, QuadMesh, RendererUtils, RenderTarget } from 'three/webgpu';
import { full, mostChanges, obstacleOf, patience, wrapOf } from '../three/texel-reading.js';
import { productAt } from './node-products.js';

/** A texel of a texture, or of a product of several: a node of four numbers. `place`: of its column and row. */
function texelAt(uploaded, place, size) {
  if (uploaded.isTexture) return textureLoad(uploaded, place, int(0));
  return productAt(uploaded, vec2(place).add(0.5).div(vec2(size)));
}

/** A number of a texel, by channel; `layer`: 0 to 2, red to blue, of a colour. */
function numberOf(texel, channel, layer) {
  if (channel === 'alpha') return texel.a;
  return channel === 'green' ? texel.r : select(layer.equal(int(0)), texel.r, select(layer.equal(int(1)), texel.g, texel.b));
}

/**
 * A material that writes two numbers a pixel, with two bytes each, into pictures of `columns`; layers of a colour
 * follow one another. `top`: the row that is read back first, counted from the top.
 */
function pairsOf({ width, height }, uploaded, channel, columns, top) {
  const [wide, high, across, first] = [width, height, columns, top].map((count) => uniform(count, 'int'));
  const numberAt = (index) => {
    const layer = channel === 'colour' ? index.div(wide.mul(high)).min(2).toVar() : int(0);
    const within = index.sub(layer.mul(wide).mul(high)).toVar(), row = within.div(wide).toVar();
    const texel = vec4(texelAt(uploaded, ivec2(within.sub(row.mul(wide)), row.min(high.sub(1))), ivec2(wide, high))).toVar();
    return uint(numberOf(texel, channel, layer).clamp(0, 1).mul(full).add(0.5)).toVar();
  };
  const material = new NodeMaterial();
  material.fragmentNode = Fn(() => {
    const pair = abs(int(screenCoordinate.y).sub(first)).mul(across).add(int(screenCoordinate.x)).mul(2).toVar();
    const [one, two] = [numberAt(pair), numberAt(pair.add(1))];
    return vec4(...[one, two].flatMap((number) => [number.bitAnd(uint(255)), number.shiftRight(uint(8))]).map((byte) => float(byte))).div(255);
  })();
  return material;
}

export class TexelReading {
  #renderer;
  #masks;
  #kept = { alpha: new Map(), green: new Map(), colour: new Map() }; // by texture or product: {version, asked, seen, changes, number, opaque, why, isRead}
  #frame = 0;
  #readIn = -1; // the last frame in which a reading began
  #ended = false;

  constructor(renderer, masks) {
    this.#renderer = renderer;
    this.#masks = masks;
  }

  /** Whether texels are still being read that the last frame asked for. */
  get waits() {
    return Object.values(this.#kept).some((kept) => [...kept.values()].some(({ version, asked, seen, why }) => !why && version !== asked && seen === this.#frame));
  }

  /**
   * The texels of a loaded texture, or of a product: what that of edgeshade/three returns. `channel`: as there, but
   * that a WebGPURenderer takes an alphaMap's red.
   */
  of(texture, uploaded, channel) {
    const kept = this.#kept[channel];
    if (!kept.has(uploaded)) kept.set(uploaded, { version: null, number: null, opaque: false, isRead: false, changes: 0 });
    const entry = kept.get(uploaded), asked = texture.version;
    entry.changes += entry.asked === asked ? 0 : 1;
    Object.assign(entry, { seen: this.#frame, asked, why: entry.failure ?? (obstacleOf(texture) || (entry.changes > mostChanges ? 'its texture changes too often' : '')) });
    const { number, version, opaque, why, isRead } = entry;
    if (!why && version !== asked && !isRead && this.#readIn !== this.#frame) {
      this.#readIn = this.#frame;
      this.#read(texture, uploaded, channel, entry);
    }
    return { number: version === asked ? number : null, opaque, why };
  }

  /** Call it once a frame: frees what nothing uses. */
  advance() {
    this.#frame += 1;
    for (const kept of Object.values(this.#kept))
      for (const [texture, entry] of kept) {
        if (this.#frame - entry.seen < patience || entry.isRead) continue;
        if (entry.number !== null) this.#masks.releaseTexels(entry.number);
        kept.delete(texture);
      }
  }

  /** Texels that arrive from now on are dropped. */
  dispose() {
    this.#ended = true;
  }

  async #read(texture, uploaded, channel, entry) {
    entry.isRead = true;
    const { version, image, image: { width, height }, wrapS, wrapT, magFilter } = texture;
    try {
      const alpha = await this.#numbersOf(image, uploaded, channel);
      if (this.#ended) return;
      if (entry.number !== null) this.#masks.releaseTexels(entry.number);
      const texels = { width, height, alpha, wrapS: wrapOf(wrapS), wrapT: wrapOf(wrapT), filter: magFilter === NearestFilter ? 'nearest' : 'linear' };
      Object.assign(entry, { version, opaque: alpha.every((value) => value === full), number: this.#masks.addTexels(texels) });
    } catch (error) {
      entry.failure = `its texture can't be read: ${error.message}`;
    } finally {
      entry.isRead = false;
    }
  }

  /** A texture's numbers, `full` for 1, rows as in the texture. */
  async #numbersOf({ width, height }, uploaded, channel) {
    const renderer = this.#renderer, count = (channel === 'colour' ? 3 : 1) * width * height;
    await renderer.init(); // and until no frame is being drawn
    const columns = Math.ceil(Math.sqrt(count / 2)), rows = Math.ceil(count / 2 / columns);
    const target = new RenderTarget(columns, rows, { depthBuffer: false });
    const material = pairsOf({ width, height }, uploaded, channel, columns, renderer.coordinateSystem === WebGLCoordinateSystem ? rows - 1 : 0);
    try {
      const before = RendererUtils.resetRendererState(renderer);
      try {
        renderer.setRenderTarget(target);
        new QuadMesh(material).render(renderer);
      } finally {
        RendererUtils.restoreRendererState(renderer, before);
      }
      const { buffer } = await renderer.readRenderTargetPixelsAsync(target, 0, 0, columns, rows);
      return new Uint16Array(buffer, 0, count);
    } finally {
      material.dispose();
      target.dispose();
    }
  }
}
