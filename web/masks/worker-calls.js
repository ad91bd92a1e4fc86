// What is asked of a worker that answers: {number, result} or {number, problem}.

export class WorkerCalls {
  #start;
  #does;
  #idleMilliseconds;
  #worker = null;
  #waiting = new Map(); // by number: what settles a promise
  #next = 1;
  #idle = 0;

  /** `start()` gives a Worker; `does`: what it does, for sentences; it goes when nothing was asked of it for so long. */
  constructor(start, does, idleMilliseconds = Infinity) {
    this.#start = start;
    this.#does = does;
    this.#idleMilliseconds = idleMilliseconds;
  }

  /** Resolves with the result; throws a sentence. With `signal` it is told to leave it, and null comes of it. */
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
    this.#waiting.delete(number);
    if (waiting) by(waiting);
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
