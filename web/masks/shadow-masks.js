// Exact shadows in a host's WebGL context: textures that tell which pixels each light reaches.

import { putBytes } from '../element/memory.js';
import { HostState } from './host-state.js';
import { HostTextures } from './host-textures.js';
import { LightLookups } from './light-lookups.js';
import { MeshPacking } from './mesh-packing.js';
import { meshNumbers, withCopies, withMesh } from './numbers.js';
import { compiledModule, instantiate } from './runtime.js';

export { version } from '../element/version.js';
export { lookupSource } from './lookup-source.js';

const kinds = ['directional', 'point', 'spot'];

/** As ShadowMasks::longRestMs. */
export const longRestMs = 5000;
const channels = ['alpha', 'green'], wraps = ['repeat', 'mirror', 'clamp'], identity = [1, 0, 0, 0, 1, 0, 0, 0, 1];

/** Where the head of a prepared mesh's bytes begins, after its size. */
const headAt = 4;

/** Bytes of a prepared mesh that are copied at once. */
const bytesAtOnce = 1 << 20;

/** Runs a generator to its end. Returns its result. */
function resultOf(generator) {
  for (;;) {
    const { done, value } = generator.next();
    if (done) return value;
  }
}

/** Most lights in one draw(). */
export const mostLights = 32;

function numbersOf({ kind = 'directional', position = [0, 0, 0], direction = [0, -1, 0], range = Infinity,
  outerAngle = Math.PI / 4, radius = 0 }, index) {
  const number = kinds.indexOf(kind);
  if (number < 0) throw new Error(`Light ${index} has the kind '${kind}', which is not one of ${kinds.join(', ')}.`);
  return [number, ...position, ...direction, range, outerAngle, radius];
}

/** Everything that the sizes of draw()'s pictures depend on. */
const needsOf = ({ width, height, nearness = true }, { length }) => `${width} ${height} ${length} ${nearness}`;

export class ShadowMasks {
  #gl;
  #program;
  #handle;
  #masks;
  #state;
  #textures; // the host's, by mesh
  #packing;
  #lookups;
  #allocatedFor = ''; // sizes for which draw() has pictures
  #preparedFor = ''; // sizes of the last prepareToDraw()
  #hasDrawn = false; // since restore()
  #hostError = 0; // since the last draw()
  #lastHostError = 0; // before it

  #keepsState;
  #clips;

  /** Resolves when it can draw in the context. `keepsState`, `clips`: see HostState. */
  static async create(gl, { keepsState = true, clips = true } = {}) {
    const module = await compiledModule();
    return new ShadowMasks(gl, await instantiate(module), module, keepsState, clips);
  }

  /** Internal: use create(). */
  constructor(gl, program, module, keepsState, clips) {
    this.#gl = gl;
    this.#program = program;
    this.#packing = new MeshPacking(module);
    this.#keepsState = keepsState;
    this.#clips = clips;
    this.#masks = new program.Masks();
    this.#lookups = new LightLookups(module, {
      gl,
      program,
      masks: this.#masks,
      inContext: (act) => this.#inContext(act),
      withLight: (light, use) => withCopies(program, [Float64Array.from(numbersOf(light, 0))], ([address]) => use(address)),
      require: (done) => this.#require(done),
      textureOf: (name) => this.#textureOf(name),
    });
    this.restore();
  }

  /**
   * Call it when the context is lost: nothing can be added or drawn until restore(). Meshes stay
   * prepared.
   */
  forget() {
    this.#lookups.forget();
    this.#masks.forget();
  }

  /** Call it when the context is back: starts again without casters. */
  restore() {
    const webGl2 = typeof WebGL2RenderingContext !== 'undefined' && this.#gl instanceof WebGL2RenderingContext;
    if (!webGl2) this.#gl.getExtension('ANGLE_instanced_arrays');
    this.#gl.getExtension('KHR_parallel_shader_compile');
    if (this.#handle !== undefined) this.#program.GL.deleteContext(this.#handle);
    this.#handle = this.#program.GL.registerContext(this.#gl, { majorVersion: webGl2 ? 2 : 1, minorVersion: 0,
      enableExtensionsByDefault: !webGl2 });
    this.#textures = new HostTextures(this.#program.GL);
    // Emscripten numbers the program's objects, and takes the number from deleted ones.
    this.#state = new HostState(this.#gl, (texture) => texture.name === 0, this.#clips);
    this.#allocatedFor = this.#preparedFor = '';
    this.#hasDrawn = false;
    this.#takeHostError();
    this.#require(this.#inContext(() => this.#masks.start()));
  }

  /** Finds a mesh's edges in a worker. Resolves with its number. */
  async prepare(mesh) {
    return this.take(await this.#packing.pack(meshNumbers(mesh)));
  }

  /**
   * Finds the edges of many meshes in a worker, and merges small neighbours among places: {mesh:
   * index, matrix}. Resolves with {meshes, merged}: what take() takes of each mesh; {members:
   * indices of places, bytes} for takeMerged() and addMerged().
   */
  prepareTogether(meshes, places) {
    return this.#packing.packTogether(meshes.map(meshNumbers), places.map(({ mesh }) => mesh), places.flatMap(({ matrix }) => [...matrix]));
  }

  /** Takes over a mesh that prepareTogether() prepared. Returns its number. */
  take(bytes) {
    return resultOf(this.taking(bytes));
  }

  /** take() in steps: a generator that returns the number. */
  *taking(bytes) {
    if (typeof bytes === 'string') throw new Error(bytes);
    return yield* this.#takingBy((...head) => this.#masks.take(...head), bytes);
  }

  /** Takes over merged neighbours that prepareTogether() prepared. Returns their number. */
  takeMerged(bytes) {
    return resultOf(this.takingMerged(bytes));
  }

  /** takeMerged() in steps. */
  takingMerged(bytes) {
    return this.#takingBy((...head) => this.#masks.takeMerged(...head), bytes);
  }

  /** `begin(address, size)` takes over the head of the bytes, and returns the mesh's number; the rest follows in pieces. */
  *#takingBy(begin, bytes) {
    let from = headAt + new DataView(bytes.buffer, bytes.byteOffset).getUint32(0, true);
    const number = this.#numberOf(begin(...putBytes(this.#program, bytes.subarray(headAt, from))));
    try {
      for (;;) {
        const array = this.#masks.nextArray(number);
        this.#require(array);
        const { byteOffset: address, length } = array; // memory may move to another buffer between steps
        if (length === 0) return number;
        for (const end = from + length; from < end;) {
          yield;
          const piece = bytes.subarray(from, Math.min(from + bytesAtOnce, end));
          this.#program.HEAPU8.set(piece, address + length - (end - from));
          from += piece.length;
        }
      }
    } catch (error) {
      this.release(number);
      throw error;
    }
  }

  /**
   * Adds merged neighbours: their number, or bytes, which are taken over and uploaded, and their meshes' numbers and
   * places. Returns their ids.
   */
  addMerged(merged, meshes, matrices) {
    if (typeof merged !== 'number') return this.#addBytes(merged, meshes, matrices);
    const numbers = Int32Array.from(meshes), places = Float64Array.from(matrices.flatMap((matrix) => [...matrix]));
    return withCopies(this.#program, [numbers, places], ([first, second]) => {
      this.#require(this.#masks.addMerged(merged, first, second, numbers.length));
      return [...new Int32Array(this.#program.HEAPU8.buffer, first, numbers.length)];
    });
  }

  #addBytes(bytes, meshes, matrices) {
    const merged = this.takeMerged(bytes);
    try {
      this.upload(merged);
      return this.addMerged(merged, meshes, matrices);
    } finally {
      this.release(merged);
    }
  }

  /** The same, synchronously. */
  prepareNow(mesh) {
    return withMesh(this.#program, meshNumbers(mesh), (...numbers) => this.#numberOf(this.#masks.prepare(...numbers)));
  }

  /** Uploads a prepared mesh ahead of add(), so that no draw() takes long. */
  upload(mesh) {
    while (!this.uploadStep(mesh)) { /* takes the next */ }
  }

  /** Takes one step of upload(). Returns whether all is there. */
  uploadStep(mesh) {
    return this.#truthOf(this.#inContext(() => this.#masks.uploadStep(mesh)));
  }

  release(mesh) {
    this.#masks.release(mesh);
  }

  add(mesh, matrix) {
    return this.#withMatrices(matrix, (address) => this.#numberOf(this.#masks.add(mesh, address)));
  }

  change(id, mesh) {
    this.#require(this.#masks.change(id, mesh));
    this.#textures.drop(id);
  }

  /** Copies a texture's alpha for setAlpha(), or its red, green and blue for setTint(). Returns its number, which releaseTexels() frees. */
  addTexels({ width, height, alpha, wrapS = 'repeat', wrapT = 'repeat', filter = 'linear' }) {
    const numbers = Int32Array.from([width, height, wraps.indexOf(wrapS), wraps.indexOf(wrapT), filter === 'linear' ? 1 : 0, alpha.length]);
    if (numbers.includes(-1) || !['linear', 'nearest'].includes(filter)) throw new Error(`An alpha has the wraps '${wrapS}' and '${wrapT}' and the filter '${filter}': they are repeat, mirror or clamp, and linear or nearest.`);
    if (!(width > 0 && height > 0 && [1, 3].includes(alpha.length / (width * height)))) throw new Error(`An alpha of ${width}x${height} texels has ${alpha.length} numbers.`);
    return withCopies(this.#program, [alpha instanceof Uint16Array ? alpha : Uint16Array.from(alpha), numbers], (addresses) => this.#numberOf(this.#masks.addTexels(...addresses)));
  }

  /** A copy of what addTexels() took, as its options. */
  texelsOf(number) {
    const [width, height, wrapS, wrapT, isLinear] = [0, 1, 2, 3, 4].map((i) => this.#masks.texelNumber(number, i));
    return { width, height, alpha: this.#masks.texelAlpha(number).slice(), wrapS: wraps[wrapS], wrapT: wraps[wrapT], filter: isLinear ? 'linear' : 'nearest' };
  }

  releaseTexels(number) {
    this.#masks.releaseTexels(number);
  }

  /** Sets the alpha of an alpha-tested mesh. */
  setAlpha(id, { texture = null, channel = 'alpha', opacity = 1, cutoff = 0.5, texcoordTransform = identity, cutsOut = false, texels = null }) {
    if (!channels.includes(channel)) throw new Error(`Alpha has the channel '${channel}', which is not one of ${channels.join(', ')}.`);
    const numbers = Float32Array.from([opacity, cutoff, ...texcoordTransform]);
    if (numbers.length !== 11) throw new Error('A texture coordinate transform must have 9 numbers.');
    this.#textures.use(id, texture, (name) => withCopies(this.#program, [numbers], ([address]) =>
      this.#require(this.#masks.setAlpha(id, name, channel === 'green', address, cutsOut, texels ?? -1))));
  }

  /** Makes a mesh tint the light in lookups: [red, green, blue] that it lets through; null: none. */
  setTint(id, tint, { texels = null, texcoordTransform = identity } = {}) {
    const numbers = Float32Array.from([...(tint ?? [-1, 0, 0]), ...texcoordTransform]);
    if (numbers.length !== 12) throw new Error('A tint must have 3 numbers, and its texture coordinate transform 9.');
    withCopies(this.#program, [numbers], ([address]) => this.#require(this.#masks.setTint(id, address, texels ?? -1)));
  }

  move(id, matrix) {
    this.#withMatrices(matrix, (address) => this.#require(this.#masks.move(id, address)));
  }

  /** Clips a mesh by planes in the world, in place of those before. */
  setClippings(id, clippings) {
    const numbers = clippings.flatMap(({ planes, intersection, casts }) => {
      if (planes.some(({ length }) => length !== 4)) throw new Error('A clipping plane must have 4 numbers.');
      return [planes.length, intersection ? 1 : 0, casts ? 1 : 0, ...planes.flat()];
    });
    withCopies(this.#program, [Float64Array.from(numbers)], ([address]) =>
      this.#require(this.#masks.setClippings(id, address, clippings.length)));
  }

  remove(id) {
    this.#require(this.#masks.remove(id));
    this.#textures.drop(id);
  }

  /** Begins to make what draw() takes: see the declaration. */
  prepareToDraw(view, lights) {
    const needs = needsOf(view, lights);
    // The first call creates no pictures, nor does any after the first masks: the question for errors waits for all pending draws.
    if (this.#preparedFor === needs && !this.#hasDrawn) this.#takeHostError();
    this.#preparedFor = needs;
    const isReady = this.#truthOf(this.#forDrawing(view, lights, [], (...numbers) => this.#masks.prepareToDraw(...numbers)));
    if (isReady) this.#allocatedFor ||= needs;
    return isReady;
  }

  /** Whether prepareToDraw() has made what the meshes that were prepared take: see the declaration. */
  get isPrepared() {
    return this.#masks.isPrepared();
  }

  /** Calls use(), of the engine, with the numbers of a view and its lights. */
  #forDrawing({ viewFromWorld, clipFromView, width, height, lightSamples = 64, nearness = true }, lights, lookups, use) {
    const numbers = Float64Array.from(lights.flatMap((light, i) => [...numbersOf(light, i), lookups[i] ?? -1]));
    return withCopies(this.#program, [Float64Array.from([...viewFromWorld, ...clipFromView]), numbers], ([matrices, all]) =>
      this.#inContext(() => use(width, height, matrices, all, lights.length, lightSamples, nearness)));
  }

  /** Takes a step of what draw() of the same takes first: see the declaration. */
  planAhead(view, lights, lookups = []) {
    return this.#truthOf(this.#forDrawing(view, lights, lookups, (...numbers) => this.#masks.planAhead(...numbers)));
  }

  draw(view, lights, lookups = []) {
    const { nearness = true } = view, needs = needsOf(view, lights);
    if (this.#allocatedFor !== needs) this.#takeHostError();
    this.#allocatedFor = needs;
    this.#hasDrawn = true;
    this.#lastHostError = this.#hostError;
    this.#hostError = 0;
    this.#require(this.#forDrawing(view, lights, lookups, (...numbers) => this.#masks.draw(...numbers)));
    const textures = [];
    for (let i = 0; 4 * i < lights.length; ++i) textures.push(this.#textureOf(this.#masks.texture(i)));
    return {
      textures,
      nearness: nearness ? { texture: this.#textureOf(this.#masks.nearnessTexture()),
        scale: this.#masks.nearnessScale(), offset: this.#masks.nearnessOffset() } : null,
      region: [...this.#masks.region()],
    };
  }

  /** Sets a box around receivers that aren't added: see the declaration. */
  setReceivers(low, high) {
    this.#masks.setReceivers(...low, ...high);
  }

  /** Starts the worker of buildLookup() ahead of it. */
  startLookups() {
    this.#lookups.start();
  }

  /** Has a worker build the map of a resting light, for the current casters. Resolves with the
   * lookup's id, or null if `signal` cancelled it. */
  buildLookup(light, options) {
    return this.#lookups.build(light, options);
  }

  /** The map of cutouts and tinted meshes alone, at once: see the declaration. */
  buildCutouts(light, mostTriangles = 2 ** 31) {
    return this.#lookups.buildCutouts(light, mostTriangles);
  }

  /** Uploads up to this many bytes of it. Returns whether all is uploaded. */
  uploadLookup(id, mostBytes) {
    return this.#lookups.upload(id, mostBytes);
  }

  /** Uploads a piece of it, as the declaration says. Returns whether all is uploaded. */
  uploadLookupStep(id) {
    return this.#lookups.uploadStep(id);
  }

  /** The uniforms of its lookup, by the names of lookupSource(), or why there is none. */
  lookup(id) {
    return this.#lookups.of(id);
  }

  /** Compares a lookup's casters with the present ones. */
  lookupState(id, light, restMs = longRestMs) {
    return this.#lookups.state(id, light, restMs);
  }

  /** Whether a lookup needs no mask. */
  isCurrent(id, light) {
    const { holds, movers } = this.lookupState(id, light);
    return holds && movers === 0;
  }

  removeLookup(id) {
    this.#lookups.remove(id);
  }

  /** Changes whenever a caster changes or moves. */
  get casterState() {
    return this.#masks.casterState();
  }

  /** Changes when resting casters do: see the declaration. */
  get restingState() {
    return this.#masks.restingState();
  }

  get cost() {
    return { buildMs: this.#masks.buildMs(), drawMs: this.#masks.drawMs(), vertexRuns: this.#masks.vertexRuns(),
      batches: this.#masks.batches(), bytes: this.#masks.bytes(), hostError: this.#lastHostError };
  }

  dispose() {
    this.#packing.dispose();
    this.#lookups.dispose();
    this.#inContext(() => this.#masks.delete());
    this.#program.GL.deleteContext(this.#handle);
  }

  /** Clears earlier errors before pictures are created, since errors are queried there. */
  #takeHostError() {
    for (let i = 0; i < 16; ++i) { // a lost context never runs out of errors
      const error = this.#gl.getError();
      if (error === this.#gl.NO_ERROR) return;
      this.#hostError ||= error;
    }
  }

  /** Runs the host's own GL calls, and leaves the context's state as draw() does. */
  keptWhile(act) {
    return this.#state.keptWhile(act, this.#keepsState);
  }

  #inContext(act) {
    return this.#state.keptWhile(() => {
      this.#program.GL.makeContextCurrent(this.#handle);
      return act();
    }, this.#keepsState);
  }

  #withMatrices(matrix, use) {
    return withCopies(this.#program, [Float64Array.from(matrix)], ([address]) => use(address));
  }

  #textureOf(name) {
    return this.#program.GL.textures[name];
  }

  #numberOf(number) {
    this.#require(number >= 0);
    return number;
  }

  /** `number`: 1, 0, or below if the call failed. */
  #truthOf(number) {
    this.#require(number >= 0);
    return number > 0;
  }

  #require(done) {
    if (!done) throw new Error(this.#masks.lastProblem());
  }
}
