// Loads scenes in a worker, one at a time: a newer load stops the previous one.

import { compiledModule } from './runtime.js';

/** Thrown if a newer load took over; the user needn't know. */
export class Superseded extends Error {}

export class SceneLoader {
  #worker = null;
  #stop = null;

  /**
   * `source`: {url} or {name, files: [{path, blob}]}. `variant`: one of its variants of materials,
   * '' for the file's own. `onProgress` gets a stage and a fraction of it. Resolves with {name,
   * bytes, triangles, warnings, variants, cameras, milliseconds}.
   */
  async load(source, variant, onProgress) {
    this.cancel();
    const stopped = new Promise((_, reject) => {
      this.#stop = () => reject(new Superseded());
    });
    stopped.catch(() => {});
    const module = await Promise.race([compiledModule(), stopped]);
    const worker = new Worker(new URL('./scene-worker.js', import.meta.url), { type: 'module' });
    this.#worker = worker;
    const answer = new Promise((resolve, reject) => {
      worker.onmessage = ({ data }) => {
        if (data.progress) onProgress(data.progress.stage, data.progress.fraction);
        else if (data.problem) reject(new Error(data.problem));
        else resolve(data.scene);
      };
      worker.onerror = (event) => {
        event.preventDefault();
        reject(new Error('The scene could not be read: the browser stopped the worker that read it' +
          `${event.message ? ` (${event.message})` : ''}.`));
      };
    });
    worker.postMessage({ module, source, variant });
    try {
      return await Promise.race([answer, stopped]);
    } finally {
      worker.terminate();
      if (this.#worker === worker) this.#worker = null;
    }
  }

  /** Stops the current load. */
  cancel() {
    this.#stop?.();
    this.#worker?.terminate();
    this.#worker = null;
  }
}
