// A light's map as nodes of TSL: its table as a texture of floats, and its numbers as uniforms. These are
// in the group that three.js updates in every render.

import { DataTexture, FloatType, Matrix4, RGBAFormat, Vector4 } from 'three';
import { int, ivec2, nodeObject, renderGroup, select, textureLoad, uint, uniform, vec2 } from 'three/tsl';
import { TextureNode } from 'three/webgpu';

/** Entries of the longest list, or more. */
export const longest = 3072;

const shared = (...given) => uniform(...given).setGroup(renderGroup);

/** A table for lights without a map. */
const emptyTable = () => new DataTexture(new Float32Array(4), 1, 1, RGBAFormat, FloatType);

/** `memory`: a texture of a memoryContext(). */
function tableOf({ pixels, width, height }) {
  const table = new DataTexture(pixels, width, height, RGBAFormat, FloatType);
  table.needsUpdate = true;
  return table;
}

/** A texture that is never flipped: three.js branches at each texel for others, where it uses WebGL. */
class TableNode extends TextureNode {
  static get type() {
    return 'EdgeshadeTableNode';
  }

  setupUV(builder, place) {
    return place;
  }
}

export class MapNodes {
  #table = nodeObject(new TableNode(emptyTable()));
  #columnBits = shared(0, 'uint'); // the table's columns are a power of 2
  #entries = shared(0, 'uint');    // texels at which entries begin
  #records = shared(0, 'uint');
  #places = shared(0, 'uint');  // and the places of a light with a radius

  /** 1: there is a map; 0: there is none. */
  present = shared(0, 'int');
  /** Sixteens of the points of a light with a radius. */
  sixteens = shared(0, 'int');
  /** Texels along a tile's edge. */
  size = shared(1);
  /** 1: a point light with six tiles. */
  sixTiles = shared(0, 'int');
  #mapFromWorld = new Matrix4();
  #fromWorld = shared(this.#mapFromWorld);
  /** In doubles, so that worlds may be large. */
  #fromView = shared(new Matrix4()).onRenderUpdate(({ camera: { matrixWorld } }, self) => { self.value.multiplyMatrices(this.#mapFromWorld, matrixWorld); });
  /** The camera in map space, homogeneous: a direction for parallel projections. */
  eye = shared(new Vector4()).onRenderUpdate(({ camera: { matrixWorld, projectionMatrix } }, self) => {
    const isParallel = projectionMatrix.elements[15] !== 0;
    const begin = isParallel ? 8 : 12;
    const [x, y, z] = matrixWorld.elements.slice(begin, begin + 3);
    self.value.set(x, y, z, isParallel ? 0 : 1).applyMatrix4(this.#mapFromWorld);
  });

  /** Map space from the world, or from the space of the render's camera. */
  mapFrom(isWorld) {
    return isWorld ? this.#fromWorld : this.#fromView;
  }

  /** `map`: of RestingLights, or null. Returns whether the table is another texture now. */
  show(map) {
    this.present.value = map ? 1 : 0;
    const replaced = this.#replaceTable(map?.texture);
    if (!map) return replaced;
    this.#columnBits.value = Math.log2(map.tableSize[0]);
    [this.#entries.value, this.#records.value] = map.begins;
    [this.#places.value, this.sixteens.value] = map.places;
    this.size.value = map.size;
    this.sixTiles.value = map.kind === 2 ? 1 : 0;
    this.#mapFromWorld.fromArray(map.mapFromWorld);
    return replaced;
  }

  dispose() {
    this.#table.value.dispose();
  }

  /** The header of a texel, a uint: (depth, list). */
  header(texel) {
    return this.#pair(uint(0), texel);
  }

  /** An entry of a list, a uint: (record, nearest depth). */
  entry(index) {
    return this.#pair(this.#entries, index);
  }

  /** Four numbers of a record; `index`, a uint, counts fours. */
  record(index) {
    return this.#texel(this.#records.add(index));
  }

  /** Four numbers of the places of a light with a radius; `index`, a uint, counts fours. */
  place(index) {
    return this.#texel(this.#places.add(index));
  }

  #replaceTable(memory) {
    const before = this.#table.value;
    if (memory ? before.image.data === memory.pixels : before.image.width === 1) return false;
    before.dispose();
    this.#table.value = memory ? tableOf(memory) : emptyTable();
    return true;
  }

  #texel(index) {
    const row = index.shiftRight(this.#columnBits);
    return textureLoad(this.#table, ivec2(int(index.sub(row.shiftLeft(this.#columnBits))), int(row)), int(0));
  }

  /** Two pairs are in a texel. */
  #pair(begin, index) {
    const two = this.#texel(begin.add(index.shiftRight(uint(1)))).toVar();
    return select(index.bitAnd(uint(1)).equal(uint(0)), vec2(two.x, two.y), vec2(two.z, two.w));
  }
}
