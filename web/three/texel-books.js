// Texels of textures that the mask engine has, and those to be read: for the adapters of both renderers.

import { ClampToEdgeWrapping, MirroredRepeatWrapping, NearestFilter } from 'three';

/** Limits of ShadowMasks.addTexels(). */
export const full = 4080;
const mostTexels = 2 ** 24;

/** Frames for which texels are kept that nothing uses. */
const patience = 300;

/** Changes of a texture after which it isn't read any more. */
const mostChanges = 20;

const wrapOf = (mode) => (mode === ClampToEdgeWrapping ? 'clamp' : mode === MirroredRepeatWrapping ? 'mirror' : 'repeat');

/** Why a texture can't be read, a clause; or ''. */
function obstacleOf(texture) {
  if (texture.isVideoTexture || texture.isRenderTargetTexture || texture.isFramebufferTexture) return 'its texture may change in every frame';
  const { width, height } = texture.image ?? {};
  return width * height <= mostTexels ? '' : 'its texture is larger than 4096 x 4096 texels';
}

/**
 * Derived classes read. They have versionOf(texture), of its texels on the GPU, and read(texture, uploaded, channel,
 * received), which calls received(numbers) later: those of a channel, `full` for 1, rows as in the texture, a
 * colour's red, green and blue one after another; or received(null, problem), a clause.
 */
export class TexelBooks {
  #masks;
  #kept = { alpha: new Map(), green: new Map(), colour: new Map() }; // by what is on the GPU: see of()
  #frame = 0;
  #readIn = -1; // the last frame in which a reading began
  #count = 0;

  constructor(masks) {
    this.#masks = masks;
  }

  get #entries() {
    return Object.values(this.#kept).flatMap((kept) => [...kept.values()]);
  }

  /** Whether texels are still to be read that the last frame asked for. */
  get waits() {
    return this.#entries.some(({ version, asked, seen, why }) => !why && version !== asked && seen === this.#frame);
  }

  /** Number of readings that have ended. Each frame begins one at most, so while it waits it needs another frame then. */
  get count() {
    return this.#count;
  }

  /**
   * The texels of a texture, `uploaded` on the GPU: {number, or null while they are read; opaque: whether all of them
   * are 1; why: a clause if they can't be read, or ''}. `channel`: 'alpha', 'green' or 'colour'.
   */
  of(texture, uploaded, channel) {
    const kept = this.#kept[channel];
    let entry = kept.get(uploaded);
    // `version`: of the texels of that `number`; `asked`: the texture's when it was last `seen`, a frame.
    if (!entry) kept.set(uploaded, entry = { version: null, number: null, opaque: false, isRead: false, changes: 0, problem: '' });
    const asked = this.versionOf(texture);
    entry.changes += entry.asked === asked ? 0 : 1;
    Object.assign(entry, { seen: this.#frame, asked, why: entry.problem || obstacleOf(texture) || (entry.changes > mostChanges ? 'its texture changes too often' : '') });
    const { number, version, opaque, why, isRead } = entry;
    if (!why && version !== asked && !isRead && this.#readIn !== this.#frame) {
      this.#readIn = this.#frame;
      entry.isRead = true;
      this.read(texture, uploaded, channel, this.#receiving(entry, texture, () => kept.get(uploaded) === entry));
    }
    return { number: version === asked ? number : null, opaque, why };
  }

  /** Receives a reading's numbers, of the texture as it is now. */
  #receiving(entry, { image: { width, height }, wrapS, wrapT, magFilter }, isKept) {
    const { asked: version } = entry;
    const sampling = { width, height, wrapS: wrapOf(wrapS), wrapT: wrapOf(wrapT), filter: magFilter === NearestFilter ? 'nearest' : 'linear' };
    return (alpha, problem = '') => {
      if (!isKept()) return;
      this.#count += 1;
      Object.assign(entry, { isRead: false, problem });
      if (!alpha) return;
      this.#release(entry);
      Object.assign(entry, { version, opaque: alpha.every((value) => value === full), number: this.#masks.addTexels({ ...sampling, alpha }) });
    };
  }

  #release({ number }) {
    if (number !== null) this.#masks.releaseTexels(number);
  }

  /** Call it once a frame: frees what nothing uses. */
  advance() {
    this.#frame += 1;
    for (const kept of Object.values(this.#kept))
      for (const [uploaded, entry] of kept) {
        if (this.#frame - entry.seen < patience || entry.isRead) continue;
        this.#release(entry);
        kept.delete(uploaded);
      }
  }

  /** Frees everything; texels that arrive from now on are dropped. */
  forget() {
    for (const entry of this.#entries) this.#release(entry);
    for (const kept of Object.values(this.#kept)) kept.clear();
  }
}
