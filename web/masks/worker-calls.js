// Calls to a worker, which answers each with {number, result} or {number, problem}.

export class WorkerCalls {
  #start;
  #does;
  #idleMilliseconds;
  #worker = null;
  #waiting = new Map(); // resolve and reject of each call's promise, by number
  #next = 1;
  #idle = 0;

  /**
   * `start()` returns a Worker; `does`: its work, for error sentences. The worker ends after this
   * long without calls.
   */
  constructor(start, does, idleMilliseconds = Infinity) {
    this.#start = start;
    this.#does = does;
    this.#idleMilliseconds = idleMilliseconds;
  }

  /**
   * Resolves with the result; throws a sentence. `signal` cancels the call in the worker, which
   * then resolves with null.
   */
  async ask(message, { transfer = [], signal } = {}) {
    clearTimeout(this.#idle);
    this.#worker ??= this.#started();
    const number = this.#next++;
    const leave = () => {
      this.#worker?.postMessage({ number });
      this.#settle(number, ({ resolve }) => resolve(null));
    };
    try {
      return await new Promise((resolve, reject) => {
        this.#waiting.set(number, { resolve, reject });
        signal?.addEventListener('abort', leave);
        if (signal?.aborted) leave();
        else this.#worker.postMessage({ number, ...message }, transfer);
      });
    } finally {
      signal?.removeEventListener('abort', leave);
    }
  }

  /** Starts the worker ahead of its first call, with a message that it doesn't answer. */
  start(message) {
    if (!this.#worker) {
      this.#worker = this.#started();
      this.#worker.postMessage(message);
    }
    this.#rest();
  }

  #started() {
    const worker = this.#start();
    worker.onmessage = ({ data: { number, result, problem } }) => this.#settle(number, ({ resolve, reject }) =>
      problem ? reject(new Error(problem)) : resolve(result));
    worker.onerror = (event) => {
      event.preventDefault();
      this.#end(new Error(`The browser stopped the worker that ${this.#does}${event.message ? ` (${event.message})` : ''}.`));
    };
    return worker;
  }

  #settle(number, by) {
    const waiting = this.#waiting.get(number);
    if (!waiting) return; // cancelled before
    this.#waiting.delete(number);
    by(waiting);
    this.#rest();
  }

  #rest() {
    clearTimeout(this.#idle);
    if (this.#waiting.size === 0 && this.#idleMilliseconds < Infinity)
      this.#idle = setTimeout(() => this.#end(), this.#idleMilliseconds);
  }

  #end(error) {
    clearTimeout(this.#idle);
    this.#worker?.terminate();
    this.#worker = null;
    for (const { reject } of this.#waiting.values()) reject(error);
    this.#waiting.clear();
  }

  dispose() {
    this.#end(new Error('The shadows were disposed of.'));
  }
}
