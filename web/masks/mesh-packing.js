// Has meshes' edges found in a worker, one mesh after another.

import { WorkerCalls } from './worker-calls.js';

export class MeshPacking {
  #module;
  #calls = new WorkerCalls(() => new Worker(new URL('./mesh-worker.js', import.meta.url), { type: 'module' }), 'finds edges');

  constructor(module) {
    this.#module = module;
  }

  /** `mesh`: from meshNumbers(). Resolves with the bytes for Masks.take(). Throws a sentence. */
  pack(mesh) {
    return this.#calls.ask({ module: this.#module, mesh });
  }

  dispose() {
    this.#calls.dispose();
  }
}
