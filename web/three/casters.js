// Keeps the mask engine's meshes in step with three.js's scene.

import { BackSide, DoubleSide, Matrix4 } from 'three';
import { isAlphaTested, sameAlpha, texcoordsNameOf } from './alpha-tests.js';
import { unclipped } from './clippings.js';
import { MeshQueue } from './mesh-queue.js';
import { isPosed, poseOf, sameNumbers, shapeOf, texcoordsOf, trianglesOf, versionsOf } from './mesh-shape.js';

/** Only meshes of up to this many triangles are prepared within a frame, or merged (in the engine). */
const fewTriangles = 500, mostMerged = 1024;

/** New meshes of up to this many triangles in all are prepared within a frame, and within 60 frames. */
const mostInFrame = 2000, mostInFrames = 16000;

const materialsOf = (mesh) => [mesh.material].flat().filter(Boolean);
/**
 * Whether masks can show a material: behind see-through and dithered surfaces others are visible.
 */
const isShown = (material) => material.visible && !material.alphaHash && (!material.transparent || material.isShadowMaterial);

/** Whether a mesh with this record is new, and may be merged. */
const mayMerge = (mesh, { shown }) => shown === null && !mesh.isInstancedMesh && trianglesOf(mesh) <= mostMerged;

const place = new Matrix4(), instance = new Matrix4();

/**
 * How the mask engine treats a mesh; null: not at all. With several materials, alpha tests count if
 * all of them have one.
 */
function roleOf(mesh, alphaTestedCast) {
  if (!mesh.geometry?.attributes?.position) return null;
  const { material } = mesh;
  if (!Array.isArray(material) && material && !isAlphaTested(material)) {
    // As below, without garbage.
    if (!isShown(material) || (!mesh.castShadow && !mesh.receiveShadow)) return null;
    return plainRole(Boolean(mesh.castShadow), material.side);
  }
  const materials = materialsOf(mesh);
  const shown = materials.filter(isShown);
  if (shown.length === 0) return null;
  const tested = shown.every(isAlphaTested) ? shown[0] : null;
  const casts = Boolean(mesh.castShadow && (alphaTestedCast || !tested));
  if (!casts && !mesh.receiveShadow) return null;
  const sides = new Set(materials.map(({ side }) => side));
  return made(casts, tested, materials[0].side, sides.size > 1);
}

/** A role and its key. */
function made(casts, tested, side, mixed) {
  const texcoords = tested && texcoordsNameOf(tested), inward = side === BackSide, doubleSided = mixed || side === DoubleSide;
  return { casts, tested, texcoords, doubleSided, inward, key: `${casts} ${doubleSided} ${inward} ${texcoords}` };
}

const plainRoles = []; // by whether they cast, and side

/** The role of meshes with one material without alpha test. */
function plainRole(casts, side) {
  return (plainRoles[2 * side + casts] ??= made(casts, null, side));
}

/** The engine's matrix for a place, or null if it flattens the mesh. */
function numbersOf(matrix) {
  const numbers = [...matrix.elements];
  [numbers[3], numbers[7], numbers[11], numbers[15]] = [0, 0, 0, 1];
  return matrix.determinant() === 0 || !numbers.every(Number.isFinite) ? null : numbers;
}

/** The places of a mesh, several if it is instanced. */
function placesOf(mesh) {
  if (!mesh.isInstancedMesh) return [numbersOf(mesh.matrixWorld)];
  return Array.from({ length: mesh.count }, (_, i) => {
    mesh.getMatrixAt(i, instance);
    return numbersOf(place.multiplyMatrices(mesh.matrixWorld, instance));
  });
}

/** The engine's record of one of three.js's meshes. */
const recordOf = (mesh) => ({ mesh, key: null, entry: null, ids: [], places: [], alphas: [], shown: null, clippings: unclipped,
  queued: false, round: 0 });

export class Casters {
  #masks;
  #alphaTests;
  #clippings;
  #touched;
  #failed;
  #queue;
  #prepared = new Map(); // by key: {number or null while pending, users}
  #meshes = new Map();   // three.js's mesh: the engine's record of it
  #pending = 0;          // records in the queue
  #round = 0;            // number of follow()'s calls
  #revision = 0;
  #atOnce = { since: 0, triangles: 0 }; // of new meshes that were prepared within frames
  #versions = [];        // of the mesh that is compared
  #problems = [];
  #told = new WeakSet(); // meshes that were warned of

  /**
   * `touched()` is called when the context's state has changed, `failed(sentence)` when a mesh can't
   * take part.
   */
  constructor(masks, alphaTests, clippings, { touched, failed }) {
    this.#masks = masks;
    this.#alphaTests = alphaTests;
    this.#clippings = clippings;
    this.#touched = touched;
    this.#failed = failed;
    this.#queue = new MeshQueue(masks, (sentence) => this.#report(sentence));
  }

  /** Changes whenever masks of the same view may. */
  get revision() {
    return this.#revision;
  }

  /** Number of meshes that the engine doesn't have yet as they are. */
  get pending() {
    return this.#pending;
  }

  /**
   * Whether a followed mesh casts with all of its triangles, as lookups may assume. Clipped ones show
   * their insides, which lookups must not take for the lit outsides beside them.
   */
  casts(mesh) {
    const had = this.#meshes.get(mesh);
    return Boolean(had?.casts) && had.clippings === unclipped;
  }

  /** Resolves when no worker is busy; throws any error since the last call. */
  async settled() {
    while (this.#queue.calls.length) await Promise.all(this.#queue.calls);
    if (this.#problems.length) throw new Error(this.#problems.splice(0).join(' '));
  }

  /** Works for some milliseconds on pending meshes. */
  advance() {
    if (this.#queue.advance()) this.#touched();
  }

  /** Makes the engine have exactly these meshes in their current state, except those that are
   * pending. `alphaTestedCast`: whether alpha-tested meshes keep their castShadow. */
  follow(meshes, alphaTestedCast) {
    this.advance();
    this.#round += 1;
    const fresh = [];
    let count = 0;
    for (const mesh of meshes) {
      const role = roleOf(mesh, alphaTestedCast);
      if (!role) continue;
      count += 1;
      this.#followOne(mesh, role, fresh);
    }
    if (count < this.#meshes.size) for (const [mesh, had] of this.#meshes) if (had.round !== this.#round) this.#drop(mesh);
    this.#admit(fresh);
  }

  /** Called when the engine has lost everything added to it. */
  forget() {
    for (const had of this.#meshes.values()) Object.assign(had, { ids: [], places: [], alphas: [], shown: null });
  }

  clear() {
    for (const mesh of [...this.#meshes.keys()]) this.#drop(mesh);
  }

  /** Follows a mesh, or adds it to the `fresh` ones, which may have to wait. */
  #followOne(mesh, role, fresh) {
    let had = this.#meshes.get(mesh);
    if (!had) this.#meshes.set(mesh, had = recordOf(mesh));
    had.round = this.#round;
    had.casts = role.casts;
    const posed = isPosed(mesh);
    if (posed) this.#pose(mesh, role, had);
    else this.#followShape(mesh, role, had);
    if (had.queued && !posed) return;
    if (had.entry.number === null || (had.shown === null && !posed)) fresh.push({ mesh, role, had });
    else this.#finish(mesh, role, had);
  }

  #finish(mesh, role, had) {
    this.#clip(mesh, had);
    this.#place(mesh, had.entry.number, had);
    if (!role.tested) return;
    this.#revision += 1; // the texture may show something else in each frame
    this.#setAlpha(role.tested, had);
  }

  /**
   * Prepares a few small meshes immediately, and others by and by. Small ones whose shape has changed
   * don't wait, as it may change in each frame.
   */
  #admit(fresh) {
    let triangles = 0;
    for (const { mesh, had } of fresh) triangles += mayMerge(mesh, had) ? trianglesOf(mesh) : 0;
    if (this.#round - this.#atOnce.since >= 60) this.#atOnce = { since: this.#round, triangles: 0 };
    const many = triangles > mostInFrame || this.#atOnce.triangles + triangles > mostInFrames;
    this.#atOnce.triangles += many ? 0 : triangles;
    for (const { mesh, role, had } of fresh) {
      const { entry } = had, merges = mayMerge(mesh, had);
      if ((many && merges) || (entry.number === null && trianglesOf(mesh) > fewTriangles)) {
        this.#enqueue(mesh, role, had, merges);
        continue;
      }
      if (entry.number === null) this.#prepareNow(this.#shapeOf(mesh, role), entry);
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
      shape: () => this.#shapeOf(mesh, role),
      matrix: () => numbersOf(mesh.matrixWorld),
      isWanted,
      placed: (id, at) => {
        this.#revision += 1;
        Object.assign(had, { ids: [id], places: [at], alphas: [], shown: entry.number, clippings: unclipped });
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
    if (had.geometry === geometry && had.roleKey === role.key && sameNumbers(had.versions, versions)) return;
    Object.assign(had, { geometry, roleKey: role.key, versions: [...versions] });
    this.#use(`${geometry.uuid} ${versions} ${role.key}`, had);
  }

  /** Finds or makes the entry of a geometry that several meshes may share. */
  #use(key, had) {
    if (had.key === key) return;
    const known = this.#prepared.get(key) ?? { number: null, users: 0 };
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
    const entry = { number: null, users: 1 };
    Object.assign(had, { key: mesh.uuid, entry, version, pose });
    this.#prepared.set(had.key, entry);
    this.#prepareNow({ ...this.#shapeOf(mesh, role), bends: true }, entry);
  }

  #shapeOf(mesh, { casts, tested, texcoords, doubleSided, inward }) {
    const shape = { ...shapeOf(mesh), casts, doubleSided };
    if (inward) shape.indices.reverse();
    return tested ? { ...shape, alphaTested: true, texcoords: texcoordsOf(mesh, texcoords) } : shape;
  }

  #place(mesh, number, had) {
    if (!mesh.isInstancedMesh && had.shown === number && had.ids.length === 1 && sameNumbers(had.places[0], mesh.matrixWorld.elements)) return;
    const places = number < 0 ? [] : placesOf(mesh).filter(Boolean);
    const ids = had.ids;
    this.#revision += had.shown !== number || ids.length !== places.length ? 1 : 0;
    while (ids.length > places.length) this.#masks.remove(ids.pop());
    had.alphas.length = Math.min(had.alphas.length, ids.length);
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
      if (sameNumbers(had.places[i], matrix)) continue;
      this.#revision += 1;
      this.#masks.move(ids[i], matrix);
    }
    Object.assign(had, { places, shown: number });
  }

  /** Sets the planes of all instances, if they have changed. */
  #clip(mesh, had) {
    const { material } = mesh;
    const clippings = Array.isArray(material) ? this.#clippingsOfAll(mesh) : this.#clippings.of(material);
    if (had.clippings === clippings) return;
    had.clippings = clippings;
    for (const id of had.ids) this.#clipOne(id, clippings);
  }

  #clippingsOfAll(mesh) {
    const [first, ...others] = materialsOf(mesh).filter(isShown).map((material) => this.#clippings.of(material));
    if (!this.#told.has(mesh) && others.some((other) => JSON.stringify(other) !== JSON.stringify(first))) {
      this.#told.add(mesh);
      console.warn(`The shadows of mesh '${mesh.name}' are clipped as its first material: its materials have different clipping planes.`);
    }
    return first;
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
  #setAlpha(material, { ids, alphas }) {
    const alpha = this.#alphaTests.of(material);
    for (const [i, id] of ids.entries()) {
      if (alphas[i] && sameAlpha(alphas[i], alpha)) continue;
      this.#masks.setAlpha(id, alpha);
      alphas[i] = alpha;
    }
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
