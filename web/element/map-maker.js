// Has primitive maps built in a worker, so that drawing continues meanwhile. The worker exists
// while it has a task, and for some seconds more: a light that was moved once is often moved again.

import { compiledModule } from './runtime.js';

const idleMilliseconds = 10_000;

export class MapMaker {
  #onMap;
  #onFailure;
  #scene = null; // a Blob, which the browser may keep out of memory
  #worker = null;
  #pending = null; // {ticket, task}, unanswered
  #ticket = 0;
  #idle = 0;

  /**
   * `onMap` gets the result of the latest task; `onFailure` is called if no worker will ever
   * answer.
   */
  constructor(onMap, onFailure) {
    this.#onMap = onMap;
    this.#onFailure = onFailure;
  }

  /** Sets the scene for later maps: the same bytes as the page's program gets. */
  show(bytes) {
    this.stop();
    this.#pending = null;
    this.#scene = new Blob([bytes]);
  }

  /** Requests a map; the bytes of the task are copied. Replaces the previous request. */
  ask(task) {
    this.#pending = { ticket: ++this.#ticket, task: task.slice() };
    this.resume();
  }

  giveUp() {
    this.#pending = null;
    this.#worker?.postMessage({ ticket: 0 });
    this.#rest();
  }

  /** Stops work until resume(). */
  stop() {
    clearTimeout(this.#idle);
    this.#worker?.terminate();
    this.#worker = null;
  }

  resume() {
    if (!this.#pending) return;
    clearTimeout(this.#idle);
    this.#worker ??= this.#start();
    this.#worker?.postMessage(this.#pending);
  }

  #rest() {
    clearTimeout(this.#idle);
    this.#idle = setTimeout(() => this.stop(), idleMilliseconds);
  }

  #start() {
    try {
      const worker = new Worker(new URL('./map-worker.js', import.meta.url), { type: 'module' });
      worker.onmessage = ({ data }) => {
        if (worker !== this.#worker) return;
        if (data.failed) return this.#fail();
        if (data.ticket !== this.#pending?.ticket) return;
        this.#pending = null;
        this.#rest();
        this.#onMap(data.map);
      };
      worker.onerror = (event) => {
        event.preventDefault();
        if (worker === this.#worker) this.#fail();
      };
      compiledModule().then((module) => worker.postMessage({ module, scene: this.#scene }));
      return worker;
    } catch {
      this.#fail();
      return null;
    }
  }

  #fail() {
    this.stop();
    this.#pending = null;
    this.#onFailure();
  }
}
