// Finds meshes' edges in a worker, one after the other.

export class MeshPacking {
  #module;
  #worker = null;
  #waiting = new Map(); // by number: what settles a promise
  #next = 0;

  constructor(module) {
    this.#module = module;
  }

  /** `mesh`: meshNumbers(). Resolves with the bytes that Masks.take() takes. Throws a sentence. */
  async pack(mesh) {
    this.#worker ??= this.#start();
    return new Promise((resolve, reject) => {
      const number = this.#next++;
      this.#waiting.set(number, { resolve, reject });
      this.#worker.postMessage({ number, module: this.#module, mesh });
    });
  }

  #start() {
    const worker = new Worker(new URL('./mesh-worker.js', import.meta.url), { type: 'module' });
    worker.onmessage = ({ data: { number, bytes, problem } }) => {
      const { resolve, reject } = this.#waiting.get(number);
      this.#waiting.delete(number);
      problem ? reject(new Error(problem)) : resolve(bytes);
    };
    worker.onerror = (event) => {
      event.preventDefault();
      this.#end(new Error(`The browser stopped the worker that finds edges${event.message ? ` (${event.message})` : ''}.`));
    };
    return worker;
  }

  #end(error) {
    this.#worker?.terminate();
    this.#worker = null;
    for (const { reject } of this.#waiting.values()) reject(error);
    this.#waiting.clear();
  }

  dispose() {
    this.#end(new Error('The shadows were disposed of.'));
  }
}
