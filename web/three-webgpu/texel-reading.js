// Alpha of three.js's textures, drawn as materials sample it, at level 0, and read back.

import { NearestFilter, WebGLCoordinateSystem } from 'three';
import { abs, Fn, float, int, ivec2, screenCoordinate, textureLoad, uint, uniform, vec4 } from 'three/tsl';
import { NodeMaterial, QuadMesh, RendererUtils, RenderTarget } from 'three/webgpu';
import { full, mostChanges, obstacleOf, patience, wrapOf } from '../three/texel-reading.js';

/**
 * A material that writes two alphas a pixel, with two bytes each, into pictures of `columns`. `top`: the row that
 * is read back first, counted from the top.
 */
function pairsOf(texture, channel, columns, top) {
  const { width, height } = texture.image;
  const [wide, high, across, first] = [width, height, columns, top].map((count) => uniform(count, 'int'));
  const alphaAt = (index) => {
    const row = index.div(wide);
    const texel = textureLoad(texture, ivec2(index.sub(row.mul(wide)), row.min(high.sub(1))), int(0));
    return uint(texel[channel === 'green' ? 'r' : 'a'].clamp(0, 1).mul(full).add(0.5)).toVar();
  };
  const material = new NodeMaterial();
  material.fragmentNode = Fn(() => {
    const pair = abs(int(screenCoordinate.y).sub(first)).mul(across).add(int(screenCoordinate.x)).mul(2).toVar();
    const [one, two] = [alphaAt(pair), alphaAt(pair.add(1))];
    return vec4(...[one, two].flatMap((alpha) => [alpha.bitAnd(uint(255)), alpha.shiftRight(uint(8))]).map((byte) => float(byte))).div(255);
  })();
  return material;
}

export class TexelReading {
  #renderer;
  #masks;
  #kept = { alpha: new Map(), green: new Map() }; // by texture: {version, asked, seen, changes, number, opaque, why, isRead}
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
   * The texels of a loaded texture: what that of edgeshade/three returns. `channel`: as in setAlpha(), but
   * that a WebGPURenderer takes an alphaMap's red.
   */
  of(texture, _, channel) {
    const kept = this.#kept[channel];
    if (!kept.has(texture)) kept.set(texture, { version: null, number: null, opaque: false, isRead: false, changes: 0 });
    const entry = kept.get(texture), asked = texture.version;
    entry.changes += entry.asked === asked ? 0 : 1;
    Object.assign(entry, { seen: this.#frame, asked, why: entry.failure ?? (obstacleOf(texture) || (entry.changes > mostChanges ? 'its texture changes too often' : '')) });
    const { number, version, opaque, why, isRead } = entry;
    if (!why && version !== asked && !isRead && this.#readIn !== this.#frame) {
      this.#readIn = this.#frame;
      this.#read(texture, channel, entry);
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

  async #read(texture, channel, entry) {
    entry.isRead = true;
    const { version, image: { width, height }, wrapS, wrapT, magFilter } = texture;
    try {
      const alpha = await this.#alphaOf(texture, channel, width * height);
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

  /** A texture's alphas, `full` for 1, rows as in the texture. */
  async #alphaOf(texture, channel, count) {
    const renderer = this.#renderer;
    await renderer.init(); // and until no frame is being drawn
    const columns = Math.ceil(Math.sqrt(count / 2)), rows = Math.ceil(count / 2 / columns);
    const target = new RenderTarget(columns, rows, { depthBuffer: false });
    const material = pairsOf(texture, channel, columns, renderer.coordinateSystem === WebGLCoordinateSystem ? rows - 1 : 0);
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
