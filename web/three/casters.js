// Keeps the mask engine's meshes in step with three.js's scene.

import { BackSide, DoubleSide, Matrix4 } from 'three';
import { alphaTestedCasting, isAlphaTested, sameAlpha, sameTint, texcoordsNameOf } from './alpha-tests.js';
import { unclipped } from './clippings.js';
import { MeshParts, whyNotInMasks } from './mesh-parts.js';
import { MeshQueue } from './mesh-queue.js';
import { isPosed, poseOf, sameNumbers, shapeOf, texcoordsOf, trianglesOf, versionsOf } from './mesh-shape.js';
import { canPlaceFar, nearOrigin } from './near-origin.js';
import { isSeeThrough, requireTransparentCast, tintTextureOf } from './see-through.js';
import { texcoordsOfTexture } from './texture-products.js';

/** Only meshes of up to this many triangles are prepared within a frame, or merged (in the engine). */
const fewTriangles = 500, mostMerged = 1024;

/** New meshes of up to this many triangles in all are prepared within a frame, and within 60 frames. */
const mostInFrame = 2000, mostInFrames = 16000;

/** New meshes of a step that are followed whatever it takes, and milliseconds of a step that follows more. */
const fewNew = 200, stepMilliseconds = 8;

/** Steps after which masks are drawn though they aren't all planned: a light that keeps moving takes new plans. */
const mostPlanSteps = 32;

/** A plane that clips everything. */
const nothingStays = [0, 0, 0, -1];

const place = new Matrix4(), instance = new Matrix4();

/** Whether a mesh with this record is new, and may be merged. */
const mayMerge = (mesh, { shown }) => shown === null && !mesh.isInstancedMesh && trianglesOf(mesh) <= mostMerged;

/**
 * How the mask engine treats a mesh with one material; null: not at all. `alphaTested`: of
 * alphaTestedCasting().
 */
function roleOf({ geometry, material, castShadow, receiveShadow }, alphaTested, transparentCast) {
  if (!geometry?.attributes?.position || !material?.visible) return null;
  const seeThrough = isSeeThrough(material); // masks show what is behind it
  if (!isAlphaTested(material)) {
    if (seeThrough) return castShadow ? seeThroughRoles[transparentCast](material) : null;
    return castShadow || receiveShadow ? plainRole(Boolean(castShadow), material.side) : null;
  }
  const casts = Boolean(castShadow && alphaTested.whole), cutsOut = Boolean(castShadow && alphaTested.cutsOut);
  if (!casts && !cutsOut && !(receiveShadow && !seeThrough)) return null;
  return { ...made(casts, material, material.side, !seeThrough), cutsOut };
}

/** A role and its key. */
function made(casts, tested, side, visible = true, texcoords = tested && texcoordsNameOf(tested)) {
  const inward = side === BackSide, doubleSided = side === DoubleSide;
  return { casts, tested, texcoords, doubleSided, inward, visible, key: `${casts} ${doubleSided} ${inward} ${visible} ${texcoords}` };
}

/** Roles of see-through meshes that cast, by transparentCast. */
const seeThroughRoles = {
  none: () => null,
  opaque: ({ side }) => made(true, null, side, false),
  tint(material) {
    const texture = tintTextureOf(material);
    return { ...made(false, null, material.side, false, texture && texcoordsOfTexture(texture)), tinting: material };
  },
};

const plainRoles = []; // by whether they cast, and side

/** The role of meshes with one material without alpha test. */
function plainRole(casts, side) {
  return (plainRoles[2 * side + casts] ??= made(casts, null, side));
}

/** Whether masks lack the shadow of a role. */
const isLacked = ({ casts, cutsOut, tinting }) => Boolean((cutsOut && !casts) || tinting);

/** Why a mesh's alpha isn't cut out exactly, apart from its texture: a clause, or ''. */
function obstacleOf({ geometry, material }) {
  return material.vertexColors && geometry.attributes.color?.itemSize === 4 ? "casts as if its vertices' alpha were 1" : '';
}

/** The engine's matrix for a place and an origin of positions, or null if it flattens the mesh. */
function numbersOf(matrix, [x, y, z]) {
  const numbers = [...matrix.elements];
  for (let i = 0; i < 3; ++i) numbers[12 + i] += numbers[i] * x + numbers[4 + i] * y + numbers[8 + i] * z;
  [numbers[3], numbers[7], numbers[11], numbers[15]] = [0, 0, 0, 1];
  return matrix.determinant() === 0 || !numbers.every(Number.isFinite) ? null : numbers;
}

/** The places of a mesh, several if it is instanced. */
function placesOf(mesh, origin) {
  if (!mesh.isInstancedMesh) return [numbersOf(mesh.matrixWorld, origin)];
  return Array.from({ length: mesh.count }, (_, i) => {
    mesh.getMatrixAt(i, instance);
    return numbersOf(place.multiplyMatrices(mesh.matrixWorld, instance), origin);
  });
}

/** The engine's record of a part, which stands for the `whole` mesh. */
const recordOf = (whole) => ({ whole, key: null, entry: null, ids: [], places: [], alphas: [], tints: [], shown: null, clippings: unclipped,
  queued: false, round: 0,
  changed: Infinity, moves: false }); // when it became what it is in the engine, and whether it was elsewhere or of another shape before

const otherwiseUnmasked = (casts) => `${casts ? 'casts no shadow, and ' : ''}receives only shadows of lights that are looked up`;

/** Whether a map holds what has such a record: see castingOf(). */
const isHeld = ({ changed, moves }, held) => changed < (moves ? held?.moved : held?.changed);

/** A step that follows meshes: {fresh, unread: as Casters.#unread, count: of those followed, until}. */
const stepOf = () => ({ fresh: [], unread: new Map(), count: 0, until: performance.now() + stepMilliseconds });

export class Casters {
  #masks;
  #alphaTests;
  #clippings;
  #touched;
  #displacements;
  #failed;
  #queue;
  #isPlanned;
  #prepared = new Map(); // by key: {number or null while pending, users, origin of its positions, isFar: whether that isn't 0}
  #meshes = new Map();   // by part: the engine's record of it
  #pending = 0;          // records in the queue
  #unread = new Map();   // by new part without a record yet: its whole mesh
  #alphaTested = null;   // of the last follow()
  #transparentCast = '';
  #round = 0;            // number of follow()'s calls
  #revision = 0;
  #added = false;        // whether #revision doesn't tell yet what the queue has added
  #hasAdvanced = false;  // since the last follow()
  #planSteps = 0;        // steps in which the engine has planned masks of them
  #atOnce = { since: 0, triangles: 0 }; // of new meshes that were prepared within frames
  #versions = [];        // of the mesh that is compared
  #problems = [];
  #parts;
  #warnings;
  #otherwise;
  #cutsOut = false;
  #tints = false;
  #lacked = false;
  #cutoutsMoved = -Infinity;

  /**
   * `touched()` is called when the context's state has changed, `failed(sentence)` when a mesh can't
   * take part. `displacements`: Displacements, or null for none; `otherwise(casts)`: what becomes of meshes that the
   * engine can't have, a verb with its object; `isPrepared()`, `isBusy()` as in MeshQueue; `isPlanned()`: goes on
   * planning masks of all that has been added, and returns whether that is done.
   */
  constructor(masks, alphaTests, clippings, warnings, { displacements = null, touched, failed, otherwise = otherwiseUnmasked, isPrepared = () => true, isBusy = () => true, isPlanned = () => true }) {
    this.#masks = masks;
    this.#displacements = displacements;
    this.#otherwise = otherwise;
    this.#warnings = warnings;
    this.#touched = touched;
    this.#failed = failed;
    this.#isPlanned = isPlanned;
    this.#queue = new MeshQueue(masks, (sentence) => this.#report(sentence), isPrepared, isBusy);
    this.#alphaTests = alphaTests;
    this.#clippings = clippings;
    this.#parts = new MeshParts(clippings);
  }

  /** Changes whenever masks of the same view may. */
  get revision() {
    return this.#revision;
  }

  /** Whether meshes have been added that the revision doesn't tell yet. */
  get isAdding() {
    return this.#added;
  }

  /** Whether advance() has something to do at once. */
  get hasSteps() {
    return this.#unread.size > 0 || this.#planSteps > 0 || this.#queue.hasSteps;
  }

  /** Number of meshes that the engine doesn't have yet as they are, at least one while masks don't show all it has. */
  get pending() {
    return this.#pending + this.#unread.size + Number(this.#planSteps > 0);
  }

  /**
   * 1: a followed mesh casts with all of its triangles; 2: a map holds it, too; 0: neither. `held`: of
   * RestingLights.heldBy().
   */
  castingOf(mesh, held) {
    const parts = this.#parts.last(mesh);
    if (!parts) return this.#castingOfPart(mesh, held);
    let casting = 2;
    for (const part of parts) casting = Math.min(casting, this.#castingOfPart(part, held));
    return casting;
  }

  #castingOfPart(part, held) {
    const had = this.#meshes.get(part);
    if (!had && this.#unread.has(part)) return part.castShadow ? 1 : 0;
    if (!had?.casts && !had?.alphas[0]?.cutsOut) return 0;
    return isHeld(had, held) ? 2 : 1;
  }

  /** Whether some of a mesh is to tint the light, and a map doesn't hold it; `held`: as above. */
  lacksTint(mesh, held) {
    return (this.#parts.last(mesh) ?? [mesh]).some((part) => {
      const had = this.#meshes.get(part);
      return Boolean(had?.lacked && !had.cutsOut && !isHeld(had, held));
    });
  }

  /** {positions, indices, first} of the drawn part of a mesh, in its own space: see shapeOf(). Displaced, if it can be. */
  shapeOf(mesh) {
    const isMoved = mesh.material.displacementMap && this.#displacements?.obstacleOf(mesh) === '';
    return shapeOf(mesh, (positions) => (isMoved ? this.#displacements.moved(mesh, positions) : positions));
  }

  /** Whether the engine has a mesh, with all of its parts. */
  has(mesh) {
    return (this.#parts.last(mesh) ?? [mesh]).every((part) => this.#meshes.get(part)?.ids.length > 0);
  }

  /**
   * {part, whole, places, alpha, clippings} of the meshes that cast and don't tint: a part, the mesh that it is of, the
   * elements of its matrices, null where it is flat, what cuts it out, as AlphaTests.of(), or null, and what clips it.
   */
  get casting() {
    return [...this.#meshes].filter(([, { casts, alphas }]) => casts || alphas[0]?.cutsOut).map(([part, { whole, alphas, clippings }]) =>
      ({ part, whole, places: placesOf(part, [0, 0, 0]), alpha: alphas[0]?.cutsOut ? alphas[0] : null, clippings: clippings.filter(({ planes, casts }) => planes.length && !casts) }));
  }

  /** A copy of the texels of such an alpha, as ShadowMasks.addTexels() takes them. */
  texelsOf = (number) => this.#masks.texelsOf(number);

  /** Whether some meshes cast what their alpha leaves, where a light is looked up. */
  get cutsOut() {
    return this.#cutsOut;
  }

  /** Whether some meshes tint the light, where it is looked up. */
  get tints() {
    return this.#tints;
  }

  /** Whether some meshes cast in lookups, and not in masks. */
  get lackedByMasks() {
    return this.#lacked;
  }

  /** When one of these last moved, as of performance.now(). */
  get cutoutsMoved() {
    return this.#cutoutsMoved;
  }

  /** Resolves when no worker is busy; throws any error since the last call. */
  async settled() {
    while (this.#queue.calls.length) await Promise.all(this.#queue.calls);
    if (this.#problems.length) throw new Error(this.#problems.splice(0).join(' '));
  }

  /** Works for some milliseconds on pending meshes. */
  advance() {
    this.#hasAdvanced = true;
    if (this.#unread.size) this.#readOn();
    else this.#takeSteps();
  }

  /** While meshes are added step by step, masks are still those of before, unless they are drawn for another reason. */
  #takeSteps() {
    const until = performance.now() + stepMilliseconds;
    if (this.#planSteps > 0) {
      this.#planOn(until);
      return;
    }
    const before = this.#revision;
    if (this.#queue.advance()) this.#touched();
    this.#added ||= this.#revision !== before;
    this.#revision = before;
    if (!this.#added || (this.#queue.isAdding && this.#pending > 0)) return;
    this.#planSteps = 1;
    if (performance.now() < until) this.#planOn(until);
  }

  /** Plans masks of what was added, and tells of it; if adding and planning take long, each has a frame of its own. */
  #planOn(until) {
    while (this.#planSteps < mostPlanSteps) {
      this.#planSteps = this.#isPlanned() ? mostPlanSteps : this.#planSteps + 1;
      if (performance.now() >= until) return;
    }
    this.#added = false;
    this.#planSteps = 0;
    this.#revision += 1;
  }

  /** Goes on with the new meshes of the last follow(). */
  #readOn() {
    const step = stepOf();
    for (const [part, mesh] of this.#unread) this.#followPart(part, mesh, step);
    this.#end(step);
  }

  /** Makes the engine have exactly these meshes in their current state, except those that are
   * pending. `alphaTestedCast`, `transparentCast`: as in ExactShadows. */
  follow(meshes, alphaTestedCast, transparentCast) {
    requireTransparentCast(transparentCast);
    this.#alphaTested = alphaTestedCasting(alphaTestedCast);
    this.#transparentCast = transparentCast;
    if (!this.#unread.size && !this.#hasAdvanced) this.advance(); // else frames stay short
    this.#hasAdvanced = false;
    this.#round += 1;
    this.#cutsOut = this.#tints = this.#lacked = false;
    const step = stepOf();
    for (const mesh of meshes) {
      const parts = this.#parts.of(mesh);
      if (!parts) this.#followPart(mesh, mesh, step);
      else for (const part of parts) this.#followPart(part, mesh, step);
    }
    if (step.count < this.#meshes.size) for (const [part, had] of this.#meshes) if (had.round !== this.#round) this.#drop(part);
    this.#end(step);
  }

  #followPart(part, mesh, step) {
    if (step.fresh.length >= fewNew && !this.#meshes.has(part) && performance.now() > step.until) {
      step.unread.set(part, mesh);
      return;
    }
    const role = roleOf(part, this.#alphaTested, this.#transparentCast);
    if (!role || this.#isLeftOut(part, role, mesh)) return;
    step.count += 1;
    this.#cutsOut ||= Boolean(role.cutsOut);
    this.#tints ||= Boolean(role.tinting);
    this.#followOne(part, role, mesh, step.fresh);
    const { lacked, alphas, tints } = this.#meshes.get(part);
    this.#lacked ||= lacked && Boolean(alphas[0]?.cutsOut || tints[0]);
  }

  #end({ fresh, unread }) {
    const isPart = this.#unread.size + unread.size > 0;
    this.#unread = unread;
    this.#admit(fresh, isPart);
  }

  /** Whether masks can't show a mesh; warns once of what it lacks. */
  #isLeftOut(part, { casts }, mesh) {
    const why = whyNotInMasks(part) || (part.material.displacementMap ?
      this.#displacements?.obstacleOf(part) ?? "its material's displacementMap moves vertices in the shader" : '');
    if (why) this.#warn(mesh, `${this.#otherwise(casts)}: ${why}`);
    return why !== '';
  }

  #warn(mesh, what) {
    this.#warnings.warn(mesh, `Mesh '${mesh.name}' ${what}.`);
  }

  /**
   * Calls draw() as another camera shows the meshes: those that are not in `shown`, a Set, and what
   * `plane` (null for none) clips, are invisible and still cast.
   */
  asSeen(shown, plane, draw) {
    const changed = [];
    try {
      for (const had of this.#meshes.values()) {
        if (shown.has(had.whole) && !plane) continue;
        changed.push(had);
        const further = { planes: [shown.has(had.whole) ? plane : nothingStays], casts: true };
        for (const id of had.ids) this.#masks.setClippings(id, [...had.clippings, further]);
      }
      return draw();
    } finally {
      for (const { ids, clippings } of changed) for (const id of ids) this.#masks.setClippings(id, clippings);
    }
  }

  /** Called when the engine has lost everything added to it. */
  forget() {
    for (const had of this.#meshes.values()) Object.assign(had, { ids: [], places: [], alphas: [], tints: [], shown: null });
  }

  /** Follows a part of a mesh, or adds it to the `fresh` ones, which may have to wait. */
  #followOne(mesh, role, whole, fresh) {
    let had = this.#meshes.get(mesh);
    if (!had) this.#meshes.set(mesh, had = recordOf(whole));
    had.casts = role.casts;
    had.cutsOut = Boolean(role.cutsOut);
    had.lacked = isLacked(role);
    had.round = this.#round;
    const posed = isPosed(mesh);
    if (posed) this.#pose(mesh, role, had);
    else this.#followShape(mesh, role, had);
    if (had.queued && !posed) return;
    if (had.entry.number === null || (had.shown === null && !posed)) fresh.push({ mesh, role, had });
    else this.#finish(mesh, role, had);
  }

  /** Brings a mesh that is prepared up to date. */
  #finish(mesh, role, had) {
    const { number, origin, isFar } = had.entry;
    if (isFar && !canPlaceFar(mesh)) this.#warn(had.whole, "has imprecise shadows: its instances or bones move vertices that are far from its origin");
    this.#clip(mesh, had);
    this.#place(mesh, number, origin, had);
    if (role.tinting || had.tints.length) this.#setTint(mesh, role.tinting, had);
    if (!role.tested) return;
    this.#revision += 1; // the texture may show something else in each frame
    this.#setAlpha(mesh, role.tested, had);
  }

  /**
   * Prepares a few small meshes immediately, and others by and by. Small ones whose shape has changed
   * don't wait, as it may change in each frame. `isPart`: there are more fresh ones.
   */
  #admit(fresh, isPart) {
    let triangles = 0;
    for (const { mesh, had } of fresh) triangles += mayMerge(mesh, had) ? trianglesOf(mesh) : 0;
    if (this.#round - this.#atOnce.since >= 60) this.#atOnce = { since: this.#round, triangles: 0 };
    const many = isPart || triangles > mostInFrame || this.#atOnce.triangles + triangles > mostInFrames;
    this.#atOnce.triangles += many ? 0 : triangles;
    for (const { mesh, role, had } of fresh) {
      const { entry } = had, merges = mayMerge(mesh, had);
      if ((many && merges) || (entry.number === null && trianglesOf(mesh) > fewTriangles)) {
        this.#enqueue(mesh, role, had, merges);
        continue;
      }
      if (entry.number === null) this.#prepareNow(this.#shapeOf(mesh, role, entry), entry);
      this.#finish(mesh, role, had);
    }
  }

  #enqueue(mesh, role, had, merges) {
    const { entry } = had;
    had.queued = true;
    this.#pending += 1;
    let open = true;
    const close = () => {
      if (open && had.queued) this.#pending -= 1;
      if (open) had.queued = false;
      open = false;
    };
    const isWanted = () => this.#meshes.get(mesh) === had && had.entry === entry && (had.shown === null || !merges);
    this.#queue.add({
      entry,
      merges,
      shape: () => this.#shapeOf(mesh, role, entry),
      matrix: () => numbersOf(mesh.matrixWorld, entry.origin),
      isWanted,
      placed: (id, at) => {
        this.#revision += 1;
        Object.assign(had, { ids: [id], places: [at], alphas: [], tints: [], shown: entry.number, clippings: unclipped, changed: performance.now() });
        close();
      },
      done: () => {
        if (isWanted() && entry.number !== null) this.#finish(mesh, role, had);
        close();
      },
    });
  }

  #followShape(mesh, role, had) {
    const { geometry } = mesh;
    const versions = versionsOf(mesh, role.texcoords, this.#versions);
    versions[8] = mesh.material.displacementMap ? this.#displacements.versionOf(mesh) : '';
    if (had.geometry === geometry && had.roleKey === role.key && sameNumbers(had.versions, versions)) return;
    Object.assign(had, { geometry, roleKey: role.key, versions: [...versions] });
    this.#use(`${geometry.uuid} ${versions} ${role.key}`, had);
  }

  /** Finds or makes the entry of a geometry that several meshes may share. */
  #use(key, had) {
    if (had.key === key) return;
    const known = this.#prepared.get(key) ?? { number: null, users: 0, origin: [0, 0, 0] };
    this.#prepared.set(key, known);
    known.users += 1;
    this.#release(had);
    Object.assign(had, { key, entry: known });
  }

  #prepareNow(shape, entry) {
    try {
      entry.number = this.#masks.prepareNow(shape);
    } catch (error) {
      entry.number = -1;
      this.#report(error.message);
    }
  }

  /** Prepares a bent mesh, synchronously, so that shadow and picture have the same pose. */
  #pose(mesh, role, had) {
    const pose = poseOf(mesh);
    const version = `${versionsOf(mesh, role.texcoords)} ${role.key}`;
    had.geometry = null;
    if (had.key === mesh.uuid && had.version === version && sameNumbers(had.pose, pose)) return;
    this.#release(had);
    const entry = { number: null, users: 1, origin: [0, 0, 0] };
    Object.assign(had, { key: mesh.uuid, entry, version, pose });
    this.#prepared.set(had.key, entry);
    this.#prepareNow({ ...this.#shapeOf(mesh, role, entry), bends: true }, entry);
  }

  /** The shape of a mesh; its origin becomes the entry's. */
  #shapeOf(mesh, { casts, tested, texcoords, doubleSided, inward, visible }, entry) {
    const drawn = this.shapeOf(mesh);
    const shape = { ...drawn, ...nearOrigin(drawn.positions), casts, doubleSided, visible };
    entry.origin = shape.origin;
    entry.isFar = shape.origin.some((at) => at !== 0);
    if (inward) shape.indices.reverse();
    const { first, positions: { length } } = shape;
    return texcoords ? { ...shape, alphaTested: Boolean(tested), texcoords: texcoordsOf(mesh, texcoords).subarray(2 * first, 2 * first + length / 1.5) } : shape;
  }

  #place(mesh, number, origin, had) {
    if (!mesh.isInstancedMesh && had.shown === number && had.ids.length === 1 && sameNumbers(had.places[0], mesh.matrixWorld.elements)) return;
    const places = number < 0 ? [] : placesOf(mesh, origin).filter(Boolean);
    const ids = had.ids;
    const stays = had.shown === number && ids.length === places.length && places.every((matrix, i) => sameNumbers(had.places[i], matrix));
    if (stays) return;
    had.changed = performance.now();
    had.moves ||= had.shown !== null;
    if (had.lacked && had.shown !== null) this.#cutoutsMoved = had.changed;
    this.#revision += 1;
    while (ids.length > places.length) this.#masks.remove(ids.pop());
    for (const of of [had.alphas, had.tints]) of.length = Math.min(of.length, ids.length);
    for (const [i, matrix] of places.entries()) {
      if (i >= ids.length) {
        ids.push(this.#masks.add(number, matrix));
        if (had.clippings.length) this.#clipOne(ids[i], had.clippings);
        continue;
      }
      if (had.shown !== number) {
        this.#masks.change(ids[i], number);
        had.alphas[i] = null;
      }
      if (!sameNumbers(had.places[i], matrix)) this.#masks.move(ids[i], matrix);
    }
    Object.assign(had, { places, shown: number });
  }

  /** Sets the planes of all instances, if they have changed. */
  #clip(mesh, had) {
    const clippings = this.#clippings.of(mesh.material, mesh);
    if (had.clippings === clippings) return;
    if ([...had.clippings, ...clippings].some(({ planes, casts }) => planes.length > 0 && !casts)) Object.assign(had, { changed: performance.now(), moves: true });
    had.clippings = clippings;
    for (const id of had.ids) this.#clipOne(id, clippings);
  }

  #clipOne(id, clippings) {
    this.#revision += 1;
    try {
      this.#masks.setClippings(id, clippings);
    } catch (error) {
      this.#report(error.message);
    }
  }

  /** Sets the alpha of all instances, if it has changed. */
  #setAlpha(mesh, material, had) {
    const { ids, alphas, cutsOut, whole } = had;
    const alpha = this.#alphaTests.of(material, cutsOut, mesh.geometry);
    const why = cutsOut && !(alphas[0] && sameAlpha(alphas[0], alpha)) && (alpha.why || obstacleOf(mesh));
    if (why) this.#warnings.warn(whole, `Alpha-tested mesh '${whole.name}' ${why}.`);
    for (const [i, id] of ids.entries()) {
      if (alphas[i] && sameAlpha(alphas[i], alpha)) continue;
      this.#masks.setAlpha(id, alpha);
      if (cutsOut || alphas[i]?.cutsOut) had.changed = performance.now();
      alphas[i] = alpha;
    }
  }

  /** Sets the tint of all instances, if it has changed. `material`: a see-through one, or none. */
  #setTint(mesh, material, had) {
    const { ids, tints, whole } = had;
    const tint = material ? this.#alphaTests.tintOf(mesh) : null;
    for (const [i, id] of ids.entries()) {
      if (tint ? tints[i] && sameTint(tints[i], tint) : !tints[i]) continue;
      this.#masks.setTint(id, tint?.tint ?? null, tint ?? {});
      this.#revision += 1;
      had.changed = performance.now();
      tints[i] = tint;
    }
    if (tint?.why) this.#warnings.warn(whole, `See-through mesh '${whole.name}' ${tint.why}.`);
  }

  #drop(mesh) {
    const had = this.#meshes.get(mesh);
    this.#meshes.delete(mesh);
    for (const id of had.ids) this.#masks.remove(id);
    this.#revision += 1;
    this.#release(had);
    if (had.queued) this.#pending -= 1;
    had.queued = false;
  }

  #report(sentence) {
    this.#problems.push(sentence);
    this.#failed(sentence);
  }

  #release({ key, entry }) {
    if (!entry || (entry.users -= 1) > 0) return;
    if (this.#prepared.get(key) === entry) this.#prepared.delete(key);
    if (entry.number >= 0 && entry.number !== null) this.#masks.release(entry.number);
  }
}
