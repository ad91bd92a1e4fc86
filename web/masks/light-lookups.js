// Maps of lights at rest: built in a worker, uploaded piece by piece, looked up by hosts' own shaders.

import { putBytes } from '../element/memory.js';
import { WorkerCalls } from './worker-calls.js';

/** Milliseconds for which the worker waits for another light that comes to rest. */
const idle = 10_000;

const mostBytesAsked = 64 * 2 ** 20;

export class LightLookups {
  #module;
  #engine; // {program, masks, inContext, withLight, require, textureOf}
  #calls = new WorkerCalls(() => new Worker(new URL('./lookup-worker.js', import.meta.url), { type: 'module' }),
    'builds the maps of lights', idle);

  constructor(module, engine) {
    this.#module = module;
    this.#engine = engine;
  }

  async build(light, { size = 512, mostBytes = mostBytesAsked, signal } = {}) {
    const { program, masks, inContext, withLight, require } = this.#engine;
    const task = withLight(light, (address) => masks.lookupTask(address, size, mostBytes)).slice();
    require(task.length > 0);
    const bytes = await this.#calls.ask({ module: this.#module, task }, { transfer: [task.buffer], signal });
    if (!bytes) return null;
    const [address, length] = putBytes(program, bytes);
    const id = inContext(() => masks.addLookup(address, length));
    require(id >= 0);
    return id;
  }

  upload(id, mostBytes = 2 ** 31) {
    const { masks, inContext, require } = this.#engine;
    require(inContext(() => masks.uploadLookup(id, mostBytes)));
    return this.of(id).uploaded || this.of(id).why !== '';
  }

  of(id) {
    const { masks, textureOf } = this.#engine;
    const why = masks.lookupWhy(id);
    const [uploaded, texture, ...numbers] = masks.lookupNumbers(id);
    const [size, kind, bytes, longestList, buildMs] = numbers.slice(5, 10);
    return { why, uploaded: uploaded === 1, texture: why ? null : textureOf(texture), tableSize: numbers.slice(0, 3),
      begins: numbers.slice(3, 5), size, kind, bytes, longestList, buildMs, mapFromWorld: numbers.slice(10) };
  }

  isCurrent(id, light) {
    return this.#engine.withLight(light, (address) => this.#engine.masks.isCurrent(id, address));
  }

  remove(id) {
    const { masks, inContext, require } = this.#engine;
    require(inContext(() => masks.removeLookup(id)));
  }

  dispose() {
    this.#calls.dispose();
  }
}
