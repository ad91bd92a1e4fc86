// Has meshes' edges found in a worker, one list of meshes after another.

import { WorkerCalls } from './worker-calls.js';

/** meshNumbers() in memory of their own, which can be passed on: the host keeps its arrays. */
const ownNumbers = ({ positions, indices, texcoords, flags }) =>
  ({ positions: positions.slice(), indices: indices.slice(), texcoords: texcoords.slice(), flags });

export class MeshPacking {
  #module;
  #calls = new WorkerCalls(() => new Worker(new URL('./mesh-worker.js', import.meta.url), { type: 'module' }), 'finds edges');

  constructor(module) {
    this.#module = module;
  }

  /** `mesh`: from meshNumbers(). Resolves with the bytes for Masks.take(). Throws a sentence. */
  async pack(mesh) {
    const { meshes: [bytes] } = await this.packTogether([mesh], [], []);
    if (typeof bytes === 'string') throw new Error(bytes);
    return bytes;
  }

  /**
   * `placed`: meshes' indices; `matrices`: 16 numbers for each of them. Resolves with {meshes,
   * merged}: the bytes for Masks.take() or a sentence of each mesh; {members, bytes} of merged
   * neighbours, with indices into `placed` and the bytes for Masks.takeMerged().
   */
  packTogether(meshes, placed, matrices) {
    const own = meshes.map(ownNumbers);
    return this.#calls.ask({ module: this.#module, meshes: own, placed: Int32Array.from(placed), matrices: Float64Array.from(matrices) },
      { transfer: own.flatMap(({ positions, indices, texcoords }) => [positions.buffer, indices.buffer, texcoords.buffer]) });
  }

  dispose() {
    this.#calls.dispose();
  }
}
