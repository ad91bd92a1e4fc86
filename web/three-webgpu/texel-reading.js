// Alpha and colours of three.js's textures, drawn as materials sample them, at level 0, and read back.

import { WebGLCoordinateSystem } from 'three';
import { abs, Fn, float, int, ivec2, screenCoordinate, select, textureLoad, uint, uniform, vec2, vec4 } from 'three/tsl';
import { NodeMaterial, QuadMesh, RendererUtils, RenderTarget } from 'three/webgpu';
import { full, TexelBooks } from '../three/texel-books.js';
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

export class TexelReading extends TexelBooks {
  #renderer;

  constructor(renderer, masks) {
    super(masks);
    this.#renderer = renderer;
  }

  versionOf({ version }) {
    return version;
  }

  /** `uploaded`: the texture, or a product of nodeProducts. */
  async read({ image }, uploaded, channel, received) {
    try {
      received(await this.#numbersOf(image, uploaded, channel));
    } catch (error) {
      received(null, `its texture can't be read: ${error.message}`);
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
