// Keeps the mask engine's meshes in step with three.js's scene.

import { BackSide, DoubleSide, Matrix4 } from 'three';
import { alphaTestedCasting, isAlphaTested, sameAlpha, texcoordsNameOf } from './alpha-tests.js';
import { unclipped } from './clippings.js';
import { canPlaceFar, nearOrigin } from './far-vertices.js';
import { MeshParts, whyNotInMasks } from './mesh-parts.js';
import { isPosed, poseOf, sameNumbers, shapeOf, texcoordsOf, versionsOf } from './mesh-shape.js';
import { isSeeThrough, requireTransparentCast, tintObstacleOf, tintOf } from './see-through.js';

/** Up to this many triangles edges are found immediately, well within a frame. */
const fewTriangles = 500;

/** A plane that clips everything. */
const nothingStays = [0, 0, 0, -1];

const place = new Matrix4(), instance = new Matrix4();

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
function made(casts, tested, side, visible = true) {
  const texcoords = tested && texcoordsNameOf(tested), inward = side === BackSide, doubleSided = side === DoubleSide;
  return { casts, tested, texcoords, doubleSided, inward, visible, key: `${casts} ${doubleSided} ${inward} ${visible} ${texcoords}` };
}

/** Roles of see-through meshes that cast, by transparentCast. */
const seeThroughRoles = {
  none: () => null,
  opaque: ({ side }) => made(true, null, side, false),
  tint: (material) => ({ ...made(false, null, material.side, false), tinting: material }),
};

const plainRoles = []; // by whether they cast, and side

/** The role of meshes with one material without alpha test. */
function plainRole(casts, side) {
  return (plainRoles[2 * side + casts] ??= made(casts, null, side));
}

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

export class Casters {
  #masks;
  #alphaTests;
  #clippings;
  #prepared = new Map(); // by key: {number or null while pending, users, promise, origin of its
                         // positions; ahead: still to upload}
  #meshes = new Map();   // three.js's mesh: the engine's record of it
  #problems = [];
  #parts;
  #warnings;
  #cutsOut = false;
  #tints = false;

  constructor(masks, alphaTests, clippings, warnings) {
    this.#masks = masks;
    this.#warnings = warnings;
    this.#alphaTests = alphaTests;
    this.#clippings = clippings;
    this.#parts = new MeshParts(clippings);
  }

  /** Number of meshes whose edges aren't found yet, or that aren't uploaded. */
  get pending() {
    return [...this.#prepared.values()].filter(({ number, ahead }) => number === null || ahead).length;
  }

  /**
   * Whether a followed mesh casts with all of its triangles, and has been as it is since `since`: so
   * that maps begun later hold it, as lookups may assume.
   */
  casts(mesh, since) {
    return (this.#parts.last(mesh) ?? [mesh]).every((part) => {
      const had = this.#meshes.get(part);
      return Boolean(had?.casts || had?.alphas[0]?.cutsOut) && had.changed < since;
    });
  }

  /** Whether some meshes cast what their alpha leaves, where a light is looked up. */
  get cutsOut() {
    return this.#cutsOut;
  }

  /** Whether some meshes tint the light, where it is looked up. */
  get tints() {
    return this.#tints;
  }

  /** Resolves when nothing is pending; throws any error since the last call. */
  async settled() {
    while (this.#waiting.length) await Promise.allSettled(this.#waiting.map(({ promise }) => promise));
    if (this.#problems.length) throw new Error(this.#problems.splice(0).join(' '));
  }

  get #waiting() {
    return [...this.#prepared.values()].filter(({ number }) => number === null);
  }

  /** Makes the engine have exactly these meshes in their current state, except those whose edges
   * are still being found. `alphaTestedCast`, `transparentCast`: as in ExactShadows. */
  follow(meshes, alphaTestedCast, transparentCast) {
    requireTransparentCast(transparentCast);
    const seen = new Set(), alphaTested = alphaTestedCasting(alphaTestedCast);
    this.#cutsOut = this.#tints = false;
    for (const mesh of meshes) {
      for (const part of this.#parts.of(mesh) ?? [mesh]) {
        const role = roleOf(part, alphaTested, transparentCast);
        if (!role || this.#isLeftOut(part, role, mesh)) continue;
        seen.add(part);
        this.#cutsOut ||= Boolean(role.cutsOut);
        this.#tints ||= Boolean(role.tinting);
        this.#followOne(part, role, mesh);
      }
    }
    for (const mesh of [...this.#meshes.keys()]) if (!seen.has(mesh)) this.#drop(mesh);
    this.#uploadOne();
  }

  /** Whether masks can't show a mesh; warns once of what it lacks. */
  #isLeftOut(part, { casts }, mesh) {
    const why = whyNotInMasks(part);
    if (why) this.#warn(mesh, `${casts ? 'casts no shadow, and ' : ''}receives only shadows of lights that are looked up: ${why}`);
    return why !== '';
  }

  #warn(mesh, what) {
    this.#warnings.warn(mesh, `Mesh '${mesh.name}' ${what}.`);
  }

  /** Uploads a large mesh in one frame, and adds it in the next. */
  #uploadOne() {
    const entry = [...this.#prepared.values()].find(({ number, ahead }) => ahead && number !== null);
    if (!entry) return;
    entry.ahead = false;
    if (entry.number >= 0) this.#masks.upload(entry.number);
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

  clear() {
    for (const mesh of [...this.#meshes.keys()]) this.#drop(mesh);
  }

  /** `whole`: the mesh that a part stands for. */
  #followOne(mesh, role, whole) {
    let had = this.#meshes.get(mesh);
    if (!had) this.#meshes.set(mesh, had = { key: null, ids: [], places: [], alphas: [], tints: [], shown: null, clippings: unclipped });
    Object.assign(had, { casts: role.casts, cutsOut: Boolean(role.cutsOut), whole });
    if (isPosed(mesh)) this.#pose(mesh, role, had);
    else this.#followShape(mesh, role, had);
    const { number: found = null, ahead, origin } = this.#prepared.get(had.key) ?? {};
    if (found === null || ahead) return;
    const isFar = origin.some((number) => number !== 0);
    if (isFar && !canPlaceFar(mesh)) this.#warn(had.whole, "has imprecise shadows: its instances or bones move vertices that are far from its origin");
    this.#clip(mesh, had);
    this.#place(mesh, found, origin, had);
    if (role.tinting || had.tints.length) this.#setTint(mesh, role.tinting, had);
    if (role.tested) this.#setAlpha(mesh, role.tested, had);
  }

  #followShape(mesh, role, had) {
    const { geometry } = mesh;
    const versions = versionsOf(mesh, role.texcoords);
    if (had.geometry === geometry && had.roleKey === role.key && sameNumbers(had.versions, versions)) return;
    Object.assign(had, { geometry, roleKey: role.key, versions });
    this.#prepare(mesh, role, `${geometry.uuid} ${versions} ${role.key}`, had);
  }

  /** Prepares a geometry that several meshes may share. */
  #prepare(mesh, role, key, had) {
    if (had.key === key) return;
    this.#release(had.key);
    had.key = key;
    const known = this.#prepared.get(key);
    if (known) {
      known.users += 1;
      return;
    }
    const shape = this.#shapeOf(mesh, role);
    const entry = { number: null, users: 1, promise: null, origin: shape.origin };
    this.#prepared.set(key, entry);
    if (shape.indices.length <= 3 * fewTriangles) {
      this.#prepareNow(shape, entry);
      return;
    }
    entry.ahead = true;
    entry.promise = this.#masks.prepare(shape).then(
      (number) => {
        if (this.#prepared.get(key) === entry) entry.number = number;
        else this.#masks.release(number); // nobody uses it any more
      },
      (error) => {
        entry.number = -1;
        this.#problems.push(error.message);
      });
  }

  #prepareNow(shape, entry) {
    try {
      entry.number = this.#masks.prepareNow(shape);
    } catch (error) {
      entry.number = -1;
      this.#problems.push(error.message);
    }
  }

  /** Prepares a bent mesh, synchronously, so that shadow and picture have the same pose. */
  #pose(mesh, role, had) {
    const pose = poseOf(mesh);
    const version = `${versionsOf(mesh, role.texcoords)} ${role.key}`;
    had.geometry = null;
    if (had.key === mesh.uuid && had.version === version && sameNumbers(had.pose, pose)) return;
    this.#release(had.key);
    Object.assign(had, { key: mesh.uuid, version, pose });
    const shape = this.#shapeOf(mesh, role);
    const entry = { number: null, users: 1, promise: null, origin: shape.origin };
    this.#prepared.set(had.key, entry);
    this.#prepareNow({ ...shape, bends: true }, entry);
  }

  #shapeOf(mesh, { casts, tested, texcoords, doubleSided, inward, visible }) {
    const drawn = shapeOf(mesh);
    const shape = { ...drawn, ...nearOrigin(drawn.positions), casts, doubleSided, visible };
    if (inward) shape.indices.reverse();
    const { first, positions: { length } } = shape;
    return tested ? { ...shape, alphaTested: true, texcoords: texcoordsOf(mesh, texcoords).subarray(2 * first, 2 * first + length / 1.5) } : shape;
  }

  #place(mesh, number, origin, had) {
    if (!mesh.isInstancedMesh && had.shown === number && had.ids.length === 1 && sameNumbers(had.places[0], mesh.matrixWorld.elements)) return;
    const places = number < 0 ? [] : placesOf(mesh, origin).filter(Boolean);
    const ids = had.ids;
    const stays = had.shown === number && ids.length === places.length && places.every((matrix, i) => sameNumbers(had.places[i], matrix));
    if (!stays) had.changed = performance.now();
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
    const clippings = this.#clippings.of(mesh.material);
    if (had.clippings === clippings) return;
    had.clippings = clippings;
    for (const id of had.ids) this.#clipOne(id, clippings);
  }

  #clipOne(id, clippings) {
    try {
      this.#masks.setClippings(id, clippings);
    } catch (error) {
      this.#problems.push(error.message);
    }
  }

  /** Sets the alpha of all instances, if it has changed. */
  #setAlpha(mesh, material, had) {
    const { ids, alphas, cutsOut, whole } = had;
    const alpha = this.#alphaTests.of(material, cutsOut);
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
  #setTint(mesh, material, { ids, tints, whole }) {
    const tint = material ? tintOf(material) : null;
    for (const [i, id] of ids.entries()) {
      if (tint ? tints[i] && sameNumbers(tints[i], tint) : !tints[i]) continue;
      this.#masks.setTint(id, tint);
      tints[i] = tint;
    }
    const why = material && tintObstacleOf(mesh);
    if (why) this.#warnings.warn(whole, `See-through mesh '${whole.name}' ${why}.`);
  }

  #drop(mesh) {
    const had = this.#meshes.get(mesh);
    this.#meshes.delete(mesh);
    for (const id of had.ids) this.#masks.remove(id);
    this.#release(had.key);
  }

  #release(key) {
    const entry = this.#prepared.get(key);
    if (!entry || (entry.users -= 1) > 0) return;
    this.#prepared.delete(key);
    if (entry.number >= 0 && entry.number !== null) this.#masks.release(entry.number);
  }
}
