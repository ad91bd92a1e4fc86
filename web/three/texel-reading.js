// Alpha and colours of three.js's textures, read back from the GPU as materials sample it: decoded, flipped, and
// at level 0.

import { bindOn, drawOver, programOver } from './drawing-over.js';
import { full, TexelBooks } from './texel-books.js';

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

export class TexelReading extends TexelBooks {
  #renderer;
  #masks;
  #readings = []; // {sync, buffer, padded, count, received} that the GPU works on
  #program = null;
  #touched;

  /** `touched()` is called when the context's state may have changed. */
  constructor(renderer, masks, touched) {
    super(masks);
    this.#renderer = renderer;
    this.#masks = masks;
    this.#touched = touched;
  }

  versionOf({ source }) {
    return this.#renderer.properties.get(source).__version; // of the last upload
  }

  /** Has the GPU copy the texels into a buffer, which the page doesn't wait for. */
  read({ image: { width, height } }, webGlTexture, channel, received) {
    const all = (channel === 'colour' ? 3 : 1) * height; // rows of texels
    const columns = width % 2 ? width : width / 2, rows = width % 2 ? Math.ceil(all / 2) : all;
    const gl = this.#renderer.getContext();
    const buffer = gl.createBuffer();
    this.#masks.keptWhile(() => this.#draw(gl, webGlTexture, channel, columns, rows, buffer));
    this.#touched();
    const sync = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    this.#readings.push({ sync, buffer, padded: 2 * columns * rows, count: width * all, received });
  }

  /** Takes what the GPU has finished. */
  take() {
    const gl = this.#renderer.getContext();
    const done = this.#readings.findIndex(({ sync }) => gl.getSyncParameter(sync, gl.SYNC_STATUS) === gl.SIGNALED);
    if (done >= 0) this.#finish(gl, this.#readings.splice(done, 1)[0]);
  }

  /** Call it once a frame: takes what the GPU has finished, and frees what nothing uses. */
  advance() {
    this.take();
    super.advance();
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

  #finish(gl, { sync, buffer, padded, count, received }) {
    const numbers = new Uint16Array(padded);
    const bound = gl.getParameter(gl.PIXEL_PACK_BUFFER_BINDING);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
    gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, 0, numbers);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, bound);
    gl.deleteBuffer(buffer);
    gl.deleteSync(sync);
    received(numbers.subarray(0, count));
  }

  /** Called when the context is lost. */
  forget() {
    super.forget();
    this.#readings = [];
    this.#program = null;
  }

  dispose() {
    if (this.#program) this.#renderer.getContext().deleteProgram(this.#program);
    this.forget();
  }
}
