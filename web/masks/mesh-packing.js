// Finds meshes' edges in a worker, one after the other.

import { WorkerCalls } from './worker-calls.js';

export class MeshPacking {
  #module;
  #calls = new WorkerCalls(() => new Worker(new URL('./mesh-worker.js', import.meta.url), { type: 'module' }), 'finds edges');

  constructor(module) {
    this.#module = module;
  }

  /** `mesh`: meshNumbers(). Resolves with the bytes that Masks.take() takes. Throws a sentence. */
  pack(mesh) {
    return this.#calls.ask({ module: this.#module, mesh });
  }

  dispose() {
    this.#calls.dispose();
  }
}
