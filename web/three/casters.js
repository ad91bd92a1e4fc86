// Keeps the mask engine's meshes in step with three.js's scene.

import { BackSide, DoubleSide, Matrix4 } from 'three';
import { alphaTestedCasting, isAlphaTested, sameAlpha, texcoordsNameOf } from './alpha-tests.js';
import { unclipped } from './clippings.js';
import { isSeeThrough, requireTransparentCast, tintObstacleOf, tintOf } from './see-through.js';
import { isPosed, poseOf, sameNumbers, shapeOf, texcoordsOf, versionsOf } from './mesh-shape.js';

/** Up to this many triangles edges are found immediately, well within a frame. */
const fewTriangles = 500;

const materialsOf = (mesh) => [mesh.material].flat().filter(Boolean);
/** Whether masks can show a material. */
const isShown = (material) => material.visible && !isSeeThrough(material);

/** The materials that decide how a mesh casts: solid ones, or, without these, see-through ones. */
function castingMaterials(mesh) {
  const seen = materialsOf(mesh).filter(({ visible }) => visible), solid = seen.filter(isShown);
  return solid.length ? solid : seen;
}

const place = new Matrix4(), instance = new Matrix4();

/**
 * How the mask engine treats a mesh; null: not at all. With several materials, alpha tests count if
 * all of them have one.
 */
function roleOf(mesh, alphaTestedCast, transparentCast) {
  if (!mesh.geometry?.attributes?.position) return null;
  const { material } = mesh;
  if (!Array.isArray(material) && material && !isAlphaTested(material)) {
    // As below, without garbage.
    if (!material.visible || (!mesh.castShadow && !mesh.receiveShadow)) return null;
    if (isSeeThrough(material)) return mesh.castShadow ? seeThroughRoles[transparentCast](material.side, [material]) : null;
    return plainRole(Boolean(mesh.castShadow), material.side);
  }
  const materials = materialsOf(mesh);
  const shown = castingMaterials(mesh), solid = shown.length > 0 && isShown(shown[0]);
  if (shown.length === 0 || (!solid && !mesh.castShadow)) return null;
  const tested = shown.every(isAlphaTested) ? shown[0] : null;
  if (!solid && !tested) return seeThroughRoles[transparentCast](materials[0].side, shown);
  const casts = Boolean(mesh.castShadow && (alphaTestedCast.whole || !tested));
  const cutsOut = Boolean(mesh.castShadow && alphaTestedCast.cutsOut && tested);
  if (!casts && !cutsOut && !(mesh.receiveShadow && solid)) return null;
  const sides = new Set(materials.map(({ side }) => side));
  const why = casts && !tested && ((alphaTestedCast.cutsOut && shown.some(isAlphaTested) && 'casts whole triangles: only some of its materials are alpha-tested') ||
    (solid && materials.some((material) => material.visible && isSeeThrough(material)) && 'casts as if all of its materials were solid: only some are see-through'));
  return { ...made(casts, tested, materials[0].side, sides.size > 1, solid), cutsOut, why };
}

/** Why a mesh's alpha isn't cut out exactly, apart from its texture: a clause, or ''. */
function obstacleOf(mesh) {
  const shown = castingMaterials(mesh);
  const textures = ({ map, alphaMap, alphaTest, opacity }) => [map, alphaMap, alphaTest, opacity].map((value) => value?.uuid ?? value).join();
  if (shown.some((material) => textures(material) !== textures(shown[0]))) return 'is cut out as its first material: its materials have different alpha';
  if (shown[0].vertexColors && mesh.geometry.attributes.color?.itemSize === 4) return "casts as if its vertices' alpha were 1";
  return '';
}

/** A role and its key. */
function made(casts, tested, side, mixed, visible = true) {
  const texcoords = tested && texcoordsNameOf(tested), inward = side === BackSide, doubleSided = mixed || side === DoubleSide;
  return { casts, tested, texcoords, doubleSided, inward, visible, key: `${casts} ${doubleSided} ${inward} ${visible} ${texcoords}` };
}

/** Roles of see-through meshes that cast, by transparentCast. */
const seeThroughRoles = {
  none: () => null,
  opaque: (side) => made(true, null, side, false, false),
  tint: (side, materials) => ({ ...made(false, null, side, false, false), tinting: materials }),
};

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

export class Casters {
  #masks;
  #alphaTests;
  #clippings;
  #prepared = new Map(); // by key: {number or null while pending, users, promise; ahead: still to
                         // upload}
  #meshes = new Map();   // three.js's mesh: the engine's record of it
  #problems = [];
  #warnings;
  #cutsOut = false;
  #tints = false;

  constructor(masks, alphaTests, clippings, warnings) {
    this.#masks = masks;
    this.#warnings = warnings;
    this.#alphaTests = alphaTests;
    this.#clippings = clippings;
  }

  /** Number of meshes whose edges aren't found yet, or that aren't uploaded. */
  get pending() {
    return [...this.#prepared.values()].filter(({ number, ahead }) => number === null || ahead).length;
  }

  /** Whether a followed mesh casts with all of its triangles, as lookups may assume. */
  casts(mesh) {
    const had = this.#meshes.get(mesh);
    return Boolean(had?.casts || had?.alphas[0]?.cutsOut);
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
   * are still being found. `alphaTestedCast`, `transparentCast`: as in
   * ExactShadows. */
  follow(meshes, alphaTestedCast, transparentCast) {
    requireTransparentCast(transparentCast);
    const seen = new Set(), casting = alphaTestedCasting(alphaTestedCast);
    this.#cutsOut = this.#tints = false;
    for (const mesh of meshes) {
      const role = roleOf(mesh, casting, transparentCast);
      if (!role) continue;
      seen.add(mesh);
      this.#cutsOut ||= Boolean(role.cutsOut);
      this.#tints ||= Boolean(role.tinting);
      this.#followOne(mesh, role);
    }
    for (const mesh of [...this.#meshes.keys()]) if (!seen.has(mesh)) this.#drop(mesh);
    this.#uploadOne();
  }

  /** Uploads a large mesh in one frame, and adds it in the next. */
  #uploadOne() {
    const entry = [...this.#prepared.values()].find(({ number, ahead }) => ahead && number !== null);
    if (!entry) return;
    entry.ahead = false;
    if (entry.number >= 0) this.#masks.upload(entry.number);
  }

  /** Called when the engine has lost everything added to it. */
  forget() {
    for (const had of this.#meshes.values()) Object.assign(had, { ids: [], places: [], alphas: [], tints: [], shown: null });
  }

  clear() {
    for (const mesh of [...this.#meshes.keys()]) this.#drop(mesh);
  }

  #followOne(mesh, role) {
    let had = this.#meshes.get(mesh);
    if (!had) this.#meshes.set(mesh, had = { key: null, ids: [], places: [], alphas: [], tints: [], shown: null, clippings: unclipped });
    had.casts = role.casts;
    had.cutsOut = Boolean(role.cutsOut);
    if (role.why) this.#warn(mesh, `Mesh '${mesh.name}' ${role.why}.`);
    if (isPosed(mesh)) this.#pose(mesh, role, had);
    else this.#followShape(mesh, role, had);
    const { number: found = null, ahead } = this.#prepared.get(had.key) ?? {};
    if (found === null || ahead) return;
    this.#clip(mesh, had);
    this.#place(mesh, found, had);
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
    const entry = { number: null, users: 1, promise: null };
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
    const entry = { number: null, users: 1, promise: null };
    this.#prepared.set(had.key, entry);
    this.#prepareNow({ ...this.#shapeOf(mesh, role), bends: true }, entry);
  }

  #shapeOf(mesh, { casts, tested, texcoords, doubleSided, inward, visible }) {
    const shape = { ...shapeOf(mesh), casts, doubleSided, visible };
    if (inward) shape.indices.reverse();
    return tested ? { ...shape, alphaTested: true, texcoords: texcoordsOf(mesh, texcoords) } : shape;
  }

  #place(mesh, number, had) {
    if (!mesh.isInstancedMesh && had.shown === number && had.ids.length === 1 && sameNumbers(had.places[0], mesh.matrixWorld.elements)) return;
    const places = number < 0 ? [] : placesOf(mesh).filter(Boolean);
    const ids = had.ids;
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
    const { material } = mesh;
    const clippings = Array.isArray(material) ? this.#clippingsOfAll(mesh) : this.#clippings.of(material);
    if (had.clippings === clippings) return;
    had.clippings = clippings;
    for (const id of had.ids) this.#clipOne(id, clippings);
  }

  #clippingsOfAll(mesh) {
    const [first, ...others] = castingMaterials(mesh).map((material) => this.#clippings.of(material));
    if (others.some((other) => JSON.stringify(other) !== JSON.stringify(first)))
      this.#warn(mesh, `The shadows of mesh '${mesh.name}' are clipped as its first material: its materials have different clipping planes.`);
    return first;
  }

  #clipOne(id, clippings) {
    try {
      this.#masks.setClippings(id, clippings);
    } catch (error) {
      this.#problems.push(error.message);
    }
  }

  /** Sets the alpha of all instances, if it has changed. */
  #setAlpha(mesh, material, { ids, alphas, cutsOut }) {
    const alpha = this.#alphaTests.of(material, cutsOut);
    const why = cutsOut && !(alphas[0] && sameAlpha(alphas[0], alpha)) && (alpha.why || obstacleOf(mesh));
    if (why) this.#warn(mesh, `Alpha-tested mesh '${mesh.name}' ${why}.`);
    for (const [i, id] of ids.entries()) {
      if (alphas[i] && sameAlpha(alphas[i], alpha)) continue;
      this.#masks.setAlpha(id, alpha);
      alphas[i] = alpha;
    }
  }

  /** Sets the tint of all instances, if it has changed. `materials`: see-through ones, or none. */
  #setTint(mesh, materials, { ids, tints }) {
    const tint = materials ? tintOf(materials[0]) : null;
    for (const [i, id] of ids.entries()) {
      if (tint ? tints[i] && sameNumbers(tints[i], tint) : !tints[i]) continue;
      this.#masks.setTint(id, tint);
      tints[i] = tint;
    }
    const why = materials && tintObstacleOf(mesh, materials);
    if (why) this.#warn(mesh, `See-through mesh '${mesh.name}' ${why}.`);
  }

  #warn(mesh, sentence) {
    this.#warnings.warn(mesh, sentence);
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
