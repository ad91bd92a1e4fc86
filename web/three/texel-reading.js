// Alpha and colours of three.js's textures, read back from the GPU as materials sample it: decoded, flipped, and
// at level 0.

import { ClampToEdgeWrapping, MirroredRepeatWrapping, NearestFilter } from 'three';
import { bindOn, drawOver, programOver } from './drawing-over.js';

/** Limits of ShadowMasks.addTexels(). */
export const full = 4080;
const mostTexels = 2 ** 24;

/** Frames for which texels are kept that nothing uses. */
export const patience = 300;

/** Changes of a texture after which it isn't read any more. */
export const mostChanges = 20;

/** Two numbers a pixel, with two bytes each; colours follow one another. */
const fragmentShader = `#version 300 es
precision highp float;
precision highp int;
uniform highp sampler2D source;
uniform int channel; // 0 to 3, or 4: red, then green, then blue
uniform int columns;
out vec4 bytes;
int numberAt( int index ) {
	ivec2 size = textureSize( source, 0 );
	int layer = channel < 4 ? 0 : min( index / ( size.x * size.y ), 2 );
	index -= layer * size.x * size.y;
	vec4 texel = texelFetch( source, min( ivec2( index % size.x, index / size.x ), size - 1 ), 0 );
	return int( clamp( texel[ channel < 4 ? channel : layer ], 0.0, 1.0 ) * ${full}.0 + 0.5 );
}
void main() {
	int pair = 2 * ( int( gl_FragCoord.y ) * columns + int( gl_FragCoord.x ) );
	ivec2 two = ivec2( numberAt( pair ), numberAt( pair + 1 ) );
	bytes = vec4( two.x & 255, two.x >> 8, two.y & 255, two.y >> 8 ) / 255.0;
}`;

const channels = { alpha: 3, green: 1, colour: 4 };

export const wrapOf = (mode) => (mode === ClampToEdgeWrapping ? 'clamp' : mode === MirroredRepeatWrapping ? 'mirror' : 'repeat');

/** Why a texture can't be read, a clause; or ''. */
export function obstacleOf(texture) {
  if (texture.isVideoTexture || texture.isRenderTargetTexture || texture.isFramebufferTexture) return 'its texture may change in every frame';
  const { width, height } = texture.image ?? {};
  return width * height <= mostTexels ? '' : 'its texture is larger than 4096 x 4096 texels';
}

export class TexelReading {
  #renderer;
  #masks;
  #kept = { alpha: new Map(), green: new Map(), colour: new Map() }; // by WebGLTexture: {version, seen, number, opaque, why, reading}
  #frame = 0;
  #readIn = -1; // the last frame in which a reading began
  #program = null;
  #touched;

  /** `touched()` is called when the context's state may have changed. */
  constructor(renderer, masks, touched) {
    this.#renderer = renderer;
    this.#masks = masks;
    this.#touched = touched;
  }

  get #entries() {
    return Object.values(this.#kept).flatMap((kept) => [...kept.values()]);
  }

  /** Whether texels are still being read that the last frame asked for. */
  get waits() {
    return this.#entries.some(({ version, asked, seen, why }) => !why && version !== asked && seen === this.#frame);
  }

  /**
   * The texels of an uploaded texture: {number, or null while they are read; opaque: whether all
   * alpha is 1; why: a clause if they can't be read, or ''}. `channel`: of channels.
   */
  of(texture, webGlTexture, channel) {
    const kept = this.#kept[channel];
    let entry = kept.get(webGlTexture);
    if (!entry) kept.set(webGlTexture, entry = { version: null, number: null, opaque: false, reading: null, changes: 0 });
    const asked = this.#renderer.properties.get(texture.source).__version; // of the last upload
    entry.changes += entry.asked === asked ? 0 : 1;
    Object.assign(entry, { seen: this.#frame, asked, why: obstacleOf(texture) || (entry.changes > mostChanges ? 'its texture changes too often' : '') });
    const { number, version, opaque, why, reading } = entry;
    if (!why && version !== asked && !reading && this.#readIn !== this.#frame) {
      this.#readIn = this.#frame;
      entry.reading = { ...this.#begin(texture, webGlTexture, channel), version: asked };
    }
    return { number: version === asked ? number : null, opaque, why };
  }

  /** Takes what the GPU has finished. */
  take() {
    const gl = this.#renderer.getContext();
    const done = this.#entries.find(({ reading }) => reading && gl.getSyncParameter(reading.sync, gl.SYNC_STATUS) === gl.SIGNALED);
    if (done) this.#finish(gl, done);
  }

  /** Call it once a frame: takes what the GPU has finished, and frees what nothing uses. */
  advance() {
    this.#frame += 1;
    this.take();
    for (const kept of Object.values(this.#kept))
      for (const [texture, entry] of kept) {
        if (this.#frame - entry.seen < patience || entry.reading) continue;
        if (entry.number !== null) this.#masks.releaseTexels(entry.number);
        kept.delete(texture);
      }
  }

  /** Has the GPU copy the texels into a buffer, which the page doesn't wait for. */
  #begin(texture, webGlTexture, channel) {
    const { image: { width, height }, wrapS, wrapT, magFilter } = texture;
    const all = (channel === 'colour' ? 3 : 1) * height; // rows of texels
    const columns = width % 2 ? width : width / 2, rows = width % 2 ? Math.ceil(all / 2) : all;
    const gl = this.#renderer.getContext();
    const buffer = gl.createBuffer();
    this.#masks.keptWhile(() => this.#draw(gl, webGlTexture, channel, columns, rows, buffer));
    this.#touched();
    const sync = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    return { sync, buffer, padded: 2 * columns * rows, count: width * all,
      texels: { width, height, wrapS: wrapOf(wrapS), wrapT: wrapOf(wrapT), filter: magFilter === NearestFilter ? 'nearest' : 'linear' } };
  }

  /** Draws a texture's numbers, and copies the pixels into a buffer. */
  #draw(gl, webGlTexture, channel, columns, rows, buffer) {
    const program = this.#program ??= programOver(gl, fragmentShader); // its texture is on unit 0
    const target = gl.createTexture();
    bindOn(gl, 0, target);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA8, columns, rows);
    drawOver(gl, program, target, [columns, rows], (at) => {
      bindOn(gl, 0, webGlTexture);
      gl.uniform1i(at('channel'), channels[channel]);
      gl.uniform1i(at('columns'), columns);
    }, () => {
      gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
      gl.bufferData(gl.PIXEL_PACK_BUFFER, 4 * columns * rows, gl.STREAM_READ);
      gl.readPixels(0, 0, columns, rows, gl.RGBA, gl.UNSIGNED_BYTE, 0);
    });
    gl.deleteTexture(target);
  }

  #finish(gl, entry) {
    const { sync, buffer, version, padded, count, texels } = entry.reading;
    const alpha = new Uint16Array(padded);
    const bound = gl.getParameter(gl.PIXEL_PACK_BUFFER_BINDING);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
    gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, 0, alpha);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, bound);
    gl.deleteBuffer(buffer);
    gl.deleteSync(sync);
    if (entry.number !== null) this.#masks.releaseTexels(entry.number);
    const whole = alpha.subarray(0, count);
    Object.assign(entry, { version, reading: null, opaque: whole.every((value) => value === full), number: this.#masks.addTexels({ ...texels, alpha: whole }) });
  }

  /** Called when the context is lost. */
  forget() {
    for (const { number } of this.#entries) if (number !== null) this.#masks.releaseTexels(number);
    for (const kept of Object.values(this.#kept)) kept.clear();
    this.#program = null;
  }

  dispose() {
    if (this.#program) this.#renderer.getContext().deleteProgram(this.#program);
    this.forget();
  }
}
