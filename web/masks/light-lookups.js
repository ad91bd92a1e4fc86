// Primitive maps of resting lights: built in a worker, uploaded piece by piece, looked up by hosts'
// own shaders.

import { putBytes } from '../element/memory.js';
import { WorkerCalls } from './worker-calls.js';

/** Milliseconds that the worker waits for another light to come to rest. */
const idle = 10_000;

const mostBytesAsked = 64 * 2 ** 20;

/** Bytes of a snapshot's part, and milliseconds of parts in a step. */
const partBytes = 2 ** 18, stepMilliseconds = 8;

const nextTask = () => new Promise((resolve) => { setTimeout(resolve); });

/** Bytes of a map's piece, and of pieces under way: a browser holds as many for its GPU process without waiting. */
const pieceBytes = 2 ** 19, mostUnderWay = 2 ** 24;

/**
 * Milliseconds, and the page's frames, after which that process has most likely taken a piece, though the GPU still draws
 * what came before. While that process waits for the GPU it shows no frames, and a further piece would hold the page.
 */
const longestWay = 500, framesOnWay = 4;

export class LightLookups {
  #module;
  #texels = new Map(); // texels left to upload, by id: {texels, next}
  #sent = []; // pieces under way, a step's together, oldest first: {sync behind them or null, bytes, since, frame}
  #frame = 0; // number of the page's frames while pieces are under way
  #nextFrame = 0; // requestAnimationFrame()'s number, or 0
  #isDisposed = false;
  #engine; // {gl, program, masks, inContext, withLight, require, textureOf}
  #calls = new WorkerCalls(() => new Worker(new URL('./lookup-worker.js', import.meta.url), { type: 'module' }),
    'builds the maps of lights', idle);

  constructor(module, engine) {
    this.#module = module;
    this.#engine = engine;
  }

  /** Starts the worker ahead of build(). */
  start() {
    this.#calls.start({ module: this.#module });
  }

  async build(light, { size = 512, mostBytes = mostBytesAsked, restMs = 500, cutouts = false, tints = false, lightSamples = 64, signal } = {}) {
    const { program, masks, inContext, withLight, require } = this.#engine;
    const since = performance.now();
    const number = withLight(light, (address) => masks.beginLookupTask(address, size, mostBytes, restMs, cutouts, tints, lightSamples));
    require(number >= 0);
    const task = await this.#taken(number, since, signal);
    const result = task && await this.#calls.ask({ module: this.#module, task }, { transfer: task.map(({ buffer }) => buffer), signal });
    if (!result) return null;
    const [address, length] = putBytes(program, result.bytes);
    const id = inContext(() => masks.addLookup(address, length));
    require(id >= 0);
    this.#texels.set(id, { texels: result.texels, next: 0 });
    return id;
  }

  /** Copies a snapshot in steps; resolves with its parts, or null once `signal` cancels it. `since`: when this step began. */
  async #taken(number, since, signal) {
    const { masks, require } = this.#engine, parts = [];
    try {
      for (let until = since + stepMilliseconds; ; until = performance.now() + stepMilliseconds) {
        do {
          const part = masks.lookupTaskPart(number, partBytes).slice();
          require(part.length > 0 || masks.lastProblem() === '');
          if (part.length > 0) parts.push(part);
          if (part.length < partBytes) return parts;
        } while (performance.now() < until);
        await nextTask();
        if (this.#isDisposed) throw new Error('The shadows were disposed of.');
        if (signal?.aborted) return null;
      }
    } finally {
      if (!this.#isDisposed) masks.endLookupTask(number);
    }
  }

  /** Builds and uploads a map of cutouts and tinted meshes alone within the call. */
  buildCutouts(light, mostTriangles) {
    const { masks, inContext, withLight, require } = this.#engine;
    const id = withLight(light, (address) => inContext(() => masks.lookupCutouts(address, mostTriangles)));
    require(id >= 0);
    return id;
  }

  /** Uploads from the worker's memory, so that the program's needn't grow. */
  upload(id, mostBytes = Infinity) {
    const { gl, masks, inContext, require } = this.#engine;
    const left = this.#texels.get(id);
    const { texture, tableSize: [columns] } = this.of(id);
    if (!left || !texture) return true;
    const row = 4 * columns; // numbers
    inContext(() => {
      require(masks.prepareUpload(id));
      gl.bindTexture(gl.TEXTURE_2D, texture);
      const whole = Math.floor((left.texels.length - left.next) / row);
      const rows = Math.min(whole, Math.max(1, Math.floor(mostBytes / (4 * row))));
      const [width, height] = rows > 0 ? [columns, rows] : [(left.texels.length - left.next) / 4, 1];
      const part = left.texels.subarray(left.next, left.next + 4 * width * height);
      gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, left.next / row, width, height, gl.RGBA, gl.FLOAT, part);
      gl.bindTexture(gl.TEXTURE_2D, null);
      left.next += part.length;
    });
    if (left.next < left.texels.length) return mostBytes === Infinity ? this.upload(id) : false;
    this.#texels.delete(id);
    return true;
  }

  /** Uploads pieces for some milliseconds, as long as few bytes are under way. */
  uploadStep(id) {
    const { gl } = this.#engine, since = performance.now();
    const isTaken = (sent) => (since - sent.since > longestWay && this.#frame - sent.frame >= framesOnWay) ||
      (sent.sync && gl.getSyncParameter(sent.sync, gl.SYNC_STATUS) === gl.SIGNALED);
    while (this.#sent[0] && isTaken(this.#sent[0])) this.#endSyncs(1);
    let bytes = 0, whole = false;
    for (const room = this.#sent.reduce((left, sent) => left - sent.bytes, mostUnderWay); !whole && bytes < room && performance.now() < since + stepMilliseconds; bytes += pieceBytes)
      whole = this.upload(id, pieceBytes);
    if (bytes > 0) {
      this.#sent.push({ sync: gl.fenceSync?.(gl.SYNC_GPU_COMMANDS_COMPLETE, 0), bytes, since, frame: this.#frame });
      gl.flush();
      this.#countFrames();
    }
    return whole;
  }

  /** While pieces are under way. */
  #countFrames() {
    this.#nextFrame ||= requestAnimationFrame(() => {
      this.#nextFrame = 0;
      this.#frame += 1;
      if (this.#sent.length > 0) this.#countFrames();
    });
  }

  #endSyncs(count = this.#sent.length) {
    for (const { sync } of this.#sent.splice(0, count)) if (sync) this.#engine.gl.deleteSync(sync);
  }

  of(id) {
    const { masks, textureOf } = this.#engine;
    const why = masks.lookupWhy(id);
    const [texture, ...numbers] = masks.lookupNumbers(id);
    const [size, kind, bytes, longestList, buildMs] = numbers.slice(5, 10);
    return { why, uploaded: why === '' && !this.#texels.has(id), texture: why ? null : textureOf(texture),
      tableSize: numbers.slice(0, 3), begins: numbers.slice(3, 5), size, kind, bytes, longestList, buildMs,
      mapFromWorld: numbers.slice(10, 26), places: numbers.slice(26) };
  }

  state(id, light, restMs) {
    const [movers, rested] = this.#engine.withLight(light, (address) => this.#engine.masks.lookupState(id, address, restMs));
    return { holds: movers !== undefined, movers: movers ?? 0, rested: rested ?? 0 };
  }

  remove(id) {
    this.#texels.delete(id);
    const { masks, inContext, require } = this.#engine;
    require(inContext(() => masks.removeLookup(id)));
  }

  /** Called when the context is lost with everything in it. */
  forget() {
    this.#texels.clear();
    this.#sent = [];
  }

  dispose() {
    this.#isDisposed = true;
    this.#endSyncs();
    this.#calls.dispose();
  }
}
