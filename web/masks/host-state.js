// The state of a context as its owner has it. Only the page can name what is bound in WebGL.

const switches = ['BLEND', 'CULL_FACE', 'DEPTH_TEST', 'DITHER', 'SCISSOR_TEST', 'STENCIL_TEST', 'SAMPLE_COVERAGE',
  'SAMPLE_ALPHA_TO_COVERAGE', 'POLYGON_OFFSET_FILL'];
const storage = ['PACK_ALIGNMENT', 'UNPACK_ALIGNMENT'];
const pageStorage = ['UNPACK_FLIP_Y_WEBGL', 'UNPACK_PREMULTIPLY_ALPHA_WEBGL', 'UNPACK_COLORSPACE_CONVERSION_WEBGL'];
const storage2 = ['UNPACK_ROW_LENGTH', 'UNPACK_SKIP_ROWS', 'UNPACK_SKIP_PIXELS', 'UNPACK_IMAGE_HEIGHT',
  'UNPACK_SKIP_IMAGES', 'PACK_ROW_LENGTH', 'PACK_SKIP_ROWS', 'PACK_SKIP_PIXELS'];
const faces = { FRONT: 'STENCIL_', BACK: 'STENCIL_BACK_' };

/** Attributes, where there are no vertex array objects; they are switched off. */
function keepAttributes(gl, instancing) {
  const all = [];
  const elements = gl.getParameter(gl.ELEMENT_ARRAY_BUFFER_BINDING);
  const divisorName = instancing?.VERTEX_ATTRIB_ARRAY_DIVISOR_ANGLE;
  for (let i = 0; i < gl.getParameter(gl.MAX_VERTEX_ATTRIBS); ++i) {
    const of = (name) => gl.getVertexAttrib(i, name);
    all.push({ enabled: of(gl.VERTEX_ATTRIB_ARRAY_ENABLED), size: of(gl.VERTEX_ATTRIB_ARRAY_SIZE),
      type: of(gl.VERTEX_ATTRIB_ARRAY_TYPE), normalized: of(gl.VERTEX_ATTRIB_ARRAY_NORMALIZED),
      stride: of(gl.VERTEX_ATTRIB_ARRAY_STRIDE), buffer: of(gl.VERTEX_ATTRIB_ARRAY_BUFFER_BINDING),
      offset: gl.getVertexAttribOffset(i, gl.VERTEX_ATTRIB_ARRAY_POINTER), divisor: instancing ? of(divisorName) : 0 });
    gl.disableVertexAttribArray(i);
    instancing?.vertexAttribDivisorANGLE(i, 0);
  }
  return () => {
    for (const [i, { enabled, size, type, normalized, stride, buffer, offset, divisor }] of all.entries()) {
      if (buffer) {
        gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
        gl.vertexAttribPointer(i, size, type, normalized, stride, offset);
      }
      instancing?.vertexAttribDivisorANGLE(i, divisor);
      if (enabled) gl.enableVertexAttribArray(i);
      else gl.disableVertexAttribArray(i);
    }
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, elements);
  };
}

export class HostState {
  #gl;
  #webGl2;
  #arrays; // bind(), binding and a vertex array of our own, where the context has them
  #instancing;
  #units;
  #isGone;

  /** `isGone(texture)`: whether drawing has deleted it, so that it can't be bound again. */
  constructor(gl, isGone = () => false) {
    this.#gl = gl;
    this.#isGone = isGone;
    this.#webGl2 = typeof WebGL2RenderingContext !== 'undefined' && gl instanceof WebGL2RenderingContext;
    const extension = this.#webGl2 ? null : gl.getExtension('OES_vertex_array_object');
    if (this.#webGl2)
      this.#arrays = { bind: (array) => gl.bindVertexArray(array), binding: gl.VERTEX_ARRAY_BINDING, own: gl.createVertexArray() };
    else if (extension)
      this.#arrays = { bind: (array) => extension.bindVertexArrayOES(array), binding: extension.VERTEX_ARRAY_BINDING_OES,
        own: extension.createVertexArrayOES() };
    this.#instancing = this.#webGl2 ? null : gl.getExtension('ANGLE_instanced_arrays');
    this.#units = gl.getParameter(gl.MAX_TEXTURE_IMAGE_UNITS);
  }

  /** Draws with the state kept: what `draw` sets is as it was after it, but for attributes' current values and
   * what is not set in drawing (line width, hints, cube textures, uniform buffers). */
  keptWhile(draw) {
    const restore = this.#keep();
    try {
      return draw();
    } finally {
      restore();
    }
  }

  #keep() {
    const gl = this.#gl;
    const ask = (name) => gl.getParameter(gl[name]);
    const on = switches.map((name) => gl.isEnabled(gl[name]));
    const discards = this.#webGl2 && gl.isEnabled(gl.RASTERIZER_DISCARD);
    const stored = [...storage, ...(this.#webGl2 ? storage2 : []), ...pageStorage].map((name) => [gl[name], ask(name)]);
    const bound = {
      framebuffer: ask('FRAMEBUFFER_BINDING'),
      read: this.#webGl2 ? ask('READ_FRAMEBUFFER_BINDING') : null,
      renderbuffer: ask('RENDERBUFFER_BINDING'),
      program: ask('CURRENT_PROGRAM'),
      buffer: ask('ARRAY_BUFFER_BINDING'),
      pack: this.#webGl2 ? ask('PIXEL_PACK_BUFFER_BINDING') : null,
      unpack: this.#webGl2 ? ask('PIXEL_UNPACK_BUFFER_BINDING') : null,
      unit: ask('ACTIVE_TEXTURE'),
    };
    const units = [];
    for (let i = 0; i < this.#units; ++i) {
      gl.activeTexture(gl.TEXTURE0 + i);
      units.push([ask('TEXTURE_BINDING_2D'), this.#webGl2 ? ask('SAMPLER_BINDING') : null]);
    }
    const blend = ['BLEND_SRC_RGB', 'BLEND_DST_RGB', 'BLEND_SRC_ALPHA', 'BLEND_DST_ALPHA'].map(ask);
    const equations = ['BLEND_EQUATION_RGB', 'BLEND_EQUATION_ALPHA'].map(ask);
    const stencil = Object.entries(faces).map(([face, prefix]) => [gl[face],
      ['FUNC', 'REF', 'VALUE_MASK'].map((name) => ask(prefix + name)),
      ['FAIL', 'PASS_DEPTH_FAIL', 'PASS_DEPTH_PASS'].map((name) => ask(prefix + name)), ask(`${prefix}WRITEMASK`)]);
    const [cull, front, depthFunction, stencilClear, depthClear] =
      ['CULL_FACE_MODE', 'FRONT_FACE', 'DEPTH_FUNC', 'STENCIL_CLEAR_VALUE', 'DEPTH_CLEAR_VALUE'].map(ask);
    const [viewport, scissor, colors, clear, range] =
      ['VIEWPORT', 'SCISSOR_BOX', 'COLOR_WRITEMASK', 'COLOR_CLEAR_VALUE', 'DEPTH_RANGE'].map(ask);
    const depthWrites = ask('DEPTH_WRITEMASK');
    const offset = ['POLYGON_OFFSET_FACTOR', 'POLYGON_OFFSET_UNITS'].map(ask);
    const restoreArrays = this.#keepArrays();
    for (const name of pageStorage) gl.pixelStorei(gl[name], 0);

    return () => {
      restoreArrays();
      switches.forEach((name, i) => (on[i] ? gl.enable(gl[name]) : gl.disable(gl[name])));
      if (discards) gl.enable(gl.RASTERIZER_DISCARD);
      for (const [name, value] of stored) gl.pixelStorei(name, value);
      if (this.#webGl2) {
        gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, bound.framebuffer);
        gl.bindFramebuffer(gl.READ_FRAMEBUFFER, bound.read);
        gl.bindBuffer(gl.PIXEL_PACK_BUFFER, bound.pack);
        gl.bindBuffer(gl.PIXEL_UNPACK_BUFFER, bound.unpack);
      } else {
        gl.bindFramebuffer(gl.FRAMEBUFFER, bound.framebuffer);
      }
      gl.bindRenderbuffer(gl.RENDERBUFFER, bound.renderbuffer);
      gl.useProgram(bound.program);
      gl.bindBuffer(gl.ARRAY_BUFFER, bound.buffer);
      for (const [i, [texture, sampler]] of units.entries()) {
        gl.activeTexture(gl.TEXTURE0 + i);
        gl.bindTexture(gl.TEXTURE_2D, texture && this.#isGone(texture) ? null : texture);
        if (this.#webGl2) gl.bindSampler(i, sampler);
      }
      gl.activeTexture(bound.unit);
      gl.blendFuncSeparate(...blend);
      gl.blendEquationSeparate(...equations);
      gl.cullFace(cull);
      gl.frontFace(front);
      gl.depthFunc(depthFunction);
      gl.clearStencil(stencilClear);
      gl.clearDepth(depthClear);
      for (const [face, compare, actions, writes] of stencil) {
        gl.stencilFuncSeparate(face, ...compare);
        gl.stencilOpSeparate(face, ...actions);
        gl.stencilMaskSeparate(face, writes);
      }
      gl.viewport(...viewport);
      gl.scissor(...scissor);
      gl.colorMask(...colors);
      gl.depthMask(depthWrites);
      gl.clearColor(...clear);
      gl.depthRange(...range);
      gl.polygonOffset(...offset);
    };
  }

  #keepArrays() {
    if (!this.#arrays) return keepAttributes(this.#gl, this.#instancing);
    const { bind, binding, own } = this.#arrays;
    const before = this.#gl.getParameter(binding);
    bind(own);
    return () => bind(before);
  }
}
