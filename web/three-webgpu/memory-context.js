// A WebGL 2 context without a GPU: it draws nothing, and its float textures are arrays in the page's
// memory. The mask engine follows casters and builds lights' maps in it, for renderers that have no
// WebGL.

/** Largest texture that every WebGL 2 and WebGPU device has, in texels along an edge. */
const largestTexture = 2048;

/** Values of getParameter() by name; others are 0. */
const parameters = {
  VERSION: 'WebGL 2.0 (in memory)', SHADING_LANGUAGE_VERSION: 'WebGL GLSL ES 3.00', VENDOR: 'edgeshade', RENDERER: 'memory',
  MAX_TEXTURE_SIZE: largestTexture, MAX_TEXTURE_IMAGE_UNITS: 16, MAX_COMBINED_TEXTURE_IMAGE_UNITS: 32, MAX_VERTEX_ATTRIBS: 16,
  MAX_VARYING_VECTORS: 15, MAX_VERTEX_UNIFORM_VECTORS: 256, MAX_FRAGMENT_UNIFORM_VECTORS: 224, SUBPIXEL_BITS: 8,
  DEPTH_BITS: 24, STENCIL_BITS: 8, VIEWPORT: [0, 0, 1, 1],
};

/** Functions with an answer that the engine depends on. */
const answers = {
  getSupportedExtensions: () => [],
  getContextAttributes: () => ({}),
  getShaderPrecisionFormat: () => ({ rangeMin: 127, rangeMax: 127, precision: 23 }),
  checkFramebufferStatus() {
    return this.FRAMEBUFFER_COMPLETE;
  },
  getShaderParameter(shader, name) {
    return name === this.COMPILE_STATUS;
  },
  getProgramParameter(program, name) {
    return name === this.LINK_STATUS ? true : 0;
  },
  getError: () => 0,
  isContextLost: () => false,
};

/** Calls that fill textures: those of four floats a texel get {width, height, pixels: Float32Array}. */
function textureCalls() {
  let bound = null;
  return {
    bindTexture(target, texture) {
      bound = texture;
    },
    texImage2D(target, level, internalFormat, width, height) {
      if (internalFormat === this.RGBA32F && level === 0) Object.assign(bound, { width, height, pixels: new Float32Array(4 * width * height) });
    },
    /** `texels`: whole rows, from `offset` on. */
    texSubImage2D(target, level, x, y, width, height, format, type, texels, offset = 0) {
      if (!bound?.pixels) return;
      for (let row = 0; row < height; ++row) {
        const begin = offset + 4 * width * row;
        bound.pixels.set(texels.subarray(begin, begin + 4 * width), 4 * ((y + row) * bound.width + x));
      }
    },
  };
}

/** Throws a sentence where the browser has no WebGL 2, whose interface it has. */
export function memoryContext() {
  if (typeof WebGL2RenderingContext === 'undefined') throw new Error('ExactShadows needs a browser that knows WebGL 2.');
  const { prototype } = WebGL2RenderingContext;
  const context = Object.create(prototype), calls = {};
  for (const [name, { value }] of Object.entries(Object.getOwnPropertyDescriptors(prototype))) {
    if (typeof value === 'number') continue;
    calls[name] = typeof value !== 'function' ? undefined : name.startsWith('create') ? () => ({}) : () => null;
  }
  const values = new Map(Object.entries(parameters).map(([name, value]) => [prototype[name], value]));
  Object.assign(calls, answers, textureCalls(), { getParameter: (name) => values.get(name) ?? 0 });
  for (const [name, value] of Object.entries(calls)) Object.defineProperty(context, name, { value });
  return context;
}
