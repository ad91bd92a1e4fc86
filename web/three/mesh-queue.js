// New meshes on their way into the mask engine. A worker finds their edges and merges small
// neighbours; the page's thread reads and takes over meshes in steps of a few milliseconds.

/** Milliseconds of steps in a frame; a step that has begun is finished. */
const frameMilliseconds = 8;

/** Milliseconds that ready meshes wait for others while the GPU is busy: masks are drawn again once some are added. */
const patience = 2000;

/** Triangles from which on the worker gets what was read so far. */
const trianglesAtOnce = 16384;

export class MeshQueue {
  #masks;
  #report;
  #isPrepared;
  #isBusy;
  #waiting = [];
  #next = 0; // of those waiting
  #steps = [];
  #held = []; // steps that add meshes
  #heldSince = 0;
  #adding = 0; // of the steps, those that add meshes
  #taking = 0; // and those that take over what a worker has prepared
  #batch = null; // read, and not yet sent
  #grows = false; // whether a mesh has come since the last advance()
  #calls = new Set();

  /**
   * `report(sentence)` is called for failures; `isPrepared()`: whether draws of the meshes that were taken over wait
   * for no programs; until then they aren't added. `isBusy()`: whether the GPU has still to draw earlier frames.
   */
  constructor(masks, report, isPrepared, isBusy) {
    this.#masks = masks;
    this.#isBusy = isBusy;
    this.#isPrepared = isPrepared;
    this.#report = report;
  }

  /**
   * `job`: {entry, merges, shape(), matrix(), isWanted(), placed(id, matrix), done()}. `entry`:
   * {number}, the prepared mesh, null until it is known, negative if it can't be prepared. Jobs
   * with `merges` may be placed, merged with others, by the time done() is called.
   */
  add(job) {
    this.#waiting.push(job);
    this.#grows = true;
  }

  /** Promises of the worker's answers that are still to come. */
  get calls() {
    return [...this.#calls];
  }

  /** Whether some of the meshes that may be added have been, and some haven't. */
  get isAdding() {
    return this.#adding > 0;
  }

  /** Whether advance() has something to do at once, with no answer of a worker. */
  get hasSteps() {
    return this.#steps.length > 0 || this.#waiting.length > 0;
  }

  /** Takes steps for a few milliseconds. Returns whether the GL's state has changed. */
  advance() {
    const until = performance.now() + frameMilliseconds;
    let changed = false;
    this.#release();
    do {
      if (this.#steps.length) changed = this.#goOn() || changed;
      else if (!this.#read()) break;
    } while (performance.now() < until);
    // While meshes keep coming, more of them are merged together.
    if (this.#batch && this.#next === this.#waiting.length && !this.#grows) this.#send();
    this.#grows = false;
    return changed;
  }

  /** Goes on with the first step. Returns whether the GL's state has changed. */
  #goOn() {
    const { done, value } = this.#steps[0].next();
    if (done) this.#steps.shift();
    return Boolean(value);
  }

  /**
   * Lets meshes be added once all are ready, the GPU rests, or others take long. Meshes that are taken over may ask for
   * further programs.
   */
  #release() {
    if (this.#taking > 0 || this.#held.length === 0) return;
    const comesMore = this.#batch || this.#waiting.length + this.#steps.length + this.#calls.size > 0;
    if (comesMore && performance.now() - this.#heldSince < patience && this.#isBusy()) return;
    if (!this.#isPrepared()) return;
    const steps = this.#held.splice(0);
    this.#adding += steps.length;
    this.#steps.push(...steps.map((step) => this.#add(step)));
  }

  *#add(step) {
    this.#adding -= 1;
    step();
  }

  #hold(step) {
    if (this.#held.length === 0) this.#heldSince = performance.now();
    this.#held.push(step);
  }

  /** Reads one mesh. Returns whether there was any. */
  #read() {
    if (this.#next === this.#waiting.length) return false;
    const job = this.#waiting[this.#next++];
    if (this.#next === this.#waiting.length) [this.#waiting, this.#next] = [[], 0];
    if (!job.isWanted() || (!job.merges && job.entry.number !== null)) job.done();
    else if (job.merges) this.#readMember(job);
    else this.#readAlone(job);
    if (this.#batch?.triangles >= trianglesAtOnce) this.#send();
    return true;
  }

  #readMember(job) {
    const batch = (this.#batch ??= { entries: [], shapes: [], jobs: [], indices: new Map(), triangles: 0 });
    const mesh = batch.indices.get(job.entry) ?? batch.entries.length;
    if (mesh === batch.entries.length) {
      batch.indices.set(job.entry, mesh);
      batch.entries.push(job.entry);
      batch.shapes.push(job.shape());
    }
    batch.triangles += batch.shapes[mesh].indices.length / 3;
    batch.jobs.push({ ...job, mesh, at: job.matrix() });
  }

  /** A mesh that is not merged has a batch of its own. */
  #readAlone(job) {
    const { entry } = job;
    entry.batch?.jobs.push(job);
    if (entry.batch) return;
    entry.batch = { entries: [entry], shapes: [job.shape()], jobs: [job], uploads: true };
    this.#ask(entry.batch);
  }

  #send() {
    const batch = this.#batch;
    this.#batch = null;
    this.#ask(batch);
  }

  #ask(batch) {
    const placed = batch.jobs.filter(({ at }) => at);
    const call = this.#masks.prepareTogether(batch.shapes, placed.map(({ mesh, at }) => ({ mesh, matrix: at }))).then(
      ({ meshes, merged }) => {
        this.#taking += meshes.length + merged.length;
        for (const [i, bytes] of meshes.entries()) this.#steps.push(this.#takeOver(batch.entries[i], () => this.#masks.taking(bytes)));
        if (batch.uploads) this.#steps.push(this.#upload(batch.entries[0]));
        for (const { members, bytes } of merged) {
          const group = { number: null, users: 1, jobs: members.map((member) => placed[member]) };
          this.#steps.push(this.#takeOver(group, () => this.#masks.takingMerged(bytes)), this.#upload(group));
          this.#hold(() => this.#addMerged(group));
        }
      },
      ({ message }) => {
        this.#report(message);
        for (const entry of batch.entries) entry.number ??= -1;
      }).then(() => {
      this.#calls.delete(call);
      this.#hold(() => {
        if (batch.uploads) delete batch.entries[0].batch;
        for (const job of batch.jobs) job.done();
      });
    });
    this.#calls.add(call);
  }

  /**
   * `entry`: {number, users}, of a mesh or a merged group; its number becomes what the generator `taking()` returns, -1
   * if that fails.
   */
  *#takeOver(entry, taking) {
    try {
      if (entry.number !== null || entry.users === 0) return;
      const number = yield* taking();
      if (entry.number === null && entry.users > 0) entry.number = number;
      else this.#masks.release(number); // prepared otherwise, or not used any more, in the meantime
    } catch ({ message }) {
      entry.number = -1;
      this.#report(message);
    } finally {
      this.#taking -= 1;
    }
  }

  /** Yields whether the GL's state has changed. */
  *#upload(entry) {
    while (entry.users > 0 && entry.number >= 0) {
      if (this.#masks.uploadStep(entry.number)) return true;
      yield true;
    }
    return false;
  }

  #addMerged({ number, jobs }) {
    const isWanted = number >= 0 && jobs.every((job) => job.isWanted() && job.entry.number >= 0); // otherwise they are added one by one
    const ids = isWanted ? this.#masks.addMerged(number, jobs.map(({ entry }) => entry.number), jobs.map(({ at }) => at)) : [];
    this.#masks.release(number);
    for (const [i, id] of ids.entries()) jobs[i].placed(id, jobs[i].at);
  }
}
