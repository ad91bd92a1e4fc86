// Hours of sun in three.js, by the page and by the native program.

import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { program } from './native.mjs';
import { pngOf } from './png.mjs';
import { openThree } from './three.mjs';

export const days = { place: [48.14, 11.57], date: '2026-03-21', step: 10, utcOffset: '+01:00' };
const typedDays = ['--place', '48.14,11.57', '--date', '2026-03-21', '--step', '10', '--utc-offset', '+01:00'];

/**
 * In the page: a square with a leaning tower, posts at four places and a canopy that casts nothing, whose
 * numbers are the same in floats and in the program. `meshesOf()` lists their triangles and places.
 */
export function tools() {
  const { three: THREE, ExactShadows, rendererOf, cameraOf } = window.page;
  const renderer = rendererOf({ width: 64, height: 48 });
  const camera = cameraOf({ from: [9, 8, 12], to: [0, 1, 0], fov: 50 }, 64 / 48);
  const square = () => {
    const scene = new THREE.Scene();
    const material = new THREE.MeshStandardMaterial();
    const add = (name, mesh, casts = true) => {
      Object.assign(mesh, { name, castShadow: casts, receiveShadow: true });
      scene.add(mesh);
      return mesh;
    };
    const ground = add('ground', new THREE.Mesh(new THREE.PlaneGeometry(8, 8, 9, 9).rotateX(-Math.PI / 2), material));
    const tower = add('tower', new THREE.Mesh(new THREE.BoxGeometry(1.5, 4, 1.25, 2, 4, 2).rotateY(0.4).rotateZ(0.15).translate(0.5, 2.25, -1.5), material));
    const posts = add('posts', new THREE.InstancedMesh(new THREE.BoxGeometry(0.375, 2, 0.25), material, 4));
    for (let i = 0; i < 4; ++i) posts.setMatrixAt(i, new THREE.Matrix4().makeTranslation(i - 2.25, 1.125, 1.75 - 0.5 * i));
    const canopy = add('canopy', new THREE.Mesh(new THREE.PlaneGeometry(3, 2, 2, 2).rotateX(-1.2).translate(-1.5, 2.5, 0.75), material), false);
    scene.add(Object.assign(new THREE.DirectionalLight(), { castShadow: true }));
    const shadows = new ExactShadows(renderer).add(scene);
    shadows.render(scene, camera);
    return { scene, ground, tower, posts, canopy, shadows };
  };
  const meshesOf = (scene) => {
    scene.updateMatrixWorld();
    return scene.children.filter(({ isMesh }) => isMesh).map((mesh) => ({
      name: mesh.name, casts: mesh.castShadow,
      positions: [...mesh.geometry.attributes.position.array], indices: [...mesh.geometry.index.array],
      places: mesh.isInstancedMesh ? [...mesh.instanceMatrix.array].filter((_, i) => i % 16 > 11 && i % 16 < 15) : mesh.position.toArray(),
    }));
  };
  /** Cells of a mesh, as cellLines() takes them, after another picture. */
  const measure = async (shadows, scene, mesh, options) => {
    shadows.render(scene, camera);
    const { cells, counts } = await shadows.sunHours(mesh, { ...options, grid: 0.5 });
    return { points: [...cells.points], counts: [...counts], leftOut: [...cells.leftOut] };
  };
  window.sunHours = { THREE, renderer, square, meshesOf, measure };
}

/**
 * A .gltf of meshesOf(); what doesn't cast is BLEND there. A mesh with `texcoords` is MASK with its `cutoff`, and the
 * alphas, a byte each, of `image`: {size, alphas}, of nearest texels if it `isNearest`.
 */
function gltfOf(meshes) {
  const bytes = [];
  const json = { asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: [] }], nodes: [], meshes: [], accessors: [], bufferViews: [],
    materials: [{ name: 'casts' }, { name: 'casts nothing', alphaMode: 'BLEND' }] };
  const accessor = (array, type, extra) => {
    const view = Buffer.from(array.buffer);
    json.bufferViews.push({ buffer: 0, byteOffset: bytes.reduce((sum, { length }) => sum + length, 0), byteLength: view.length });
    bytes.push(view);
    json.accessors.push({ bufferView: json.bufferViews.length - 1, componentType: type === 'SCALAR' ? 5125 : 5126,
      count: array.length / { SCALAR: 1, VEC2: 2, VEC3: 3 }[type], type, ...extra });
    return json.accessors.length - 1;
  };
  const maskOf = ({ cutoff, image: { size, alphas }, isNearest }) => {
    const index = json.materials.length;
    const png = pngOf(Buffer.from(alphas.flatMap((alpha) => [255, 255, 255, alpha])), size, size);
    Object.assign(json, { images: [...json.images ?? [], { uri: `data:image/png;base64,${png.toString('base64')}` }],
      samplers: [...json.samplers ?? [], { magFilter: isNearest ? 9728 : 9729, minFilter: 9729 }], textures: [...json.textures ?? [], { source: index - 2, sampler: index - 2 }] });
    json.materials.push({ alphaMode: 'MASK', alphaCutoff: cutoff, doubleSided: true, pbrMetallicRoughness: { baseColorTexture: { index: index - 2 } } });
    return index;
  };
  for (const mesh of meshes) {
    const { name, casts, positions, indices, places, texcoords } = mesh;
    const axes = [0, 1, 2].map((c) => positions.filter((_, i) => i % 3 === c));
    const bounds = { min: axes.map((of) => Math.min(...of)), max: axes.map((of) => Math.max(...of)) };
    const attributes = { POSITION: accessor(Float32Array.from(positions), 'VEC3', bounds) };
    if (texcoords) attributes.TEXCOORD_0 = accessor(Float32Array.from(texcoords), 'VEC2');
    json.meshes.push({ primitives: [{ attributes, indices: accessor(Uint32Array.from(indices), 'SCALAR'), material: texcoords ? maskOf(mesh) : casts ? 0 : 1 }] });
    for (let i = 0; i < places.length; i += 3) {
      json.scenes[0].nodes.push(json.nodes.length);
      json.nodes.push({ name, mesh: json.meshes.length - 1, translation: places.slice(i, i + 3) });
    }
  }
  const all = Buffer.concat(bytes);
  json.buffers = [{ byteLength: all.length, uri: `data:application/octet-stream;base64,${all.toString('base64')}` }];
  return JSON.stringify(json);
}

/** Runs `sunhours` on the meshes; `use(path)` reads its files. */
export function byProgram(meshes, words, use) {
  const folder = mkdtempSync(join(tmpdir(), 'edgeshade-'));
  const path = (name) => join(folder, name);
  try {
    writeFileSync(path('scene.gltf'), gltfOf(meshes));
    execFileSync(program, ['sunhours', path('scene.gltf'), ...words(path), ...typedDays], { stdio: 'pipe', timeout: 60000 });
    return use(path);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** Runs `act(tools, given)` in a page of three.js; returns its result. */
export async function withTools(shared, act, given) {
  const page = await openThree(shared);
  await page.evaluate(tools);
  const told = await page.evaluate(([text, value]) => (0, eval)(`(${text})`)(window.sunHours, value), [act.toString(), given]);
  await shared.check(page);
  return told;
}

/** A line for each cell: its sensor, count and reason to be left out; sorted, as places of one mesh are in another order elsewhere. */
export const cellLines = (points, counts, leftOut) =>
  counts.map((count, i) => [...points.slice(3 * i, 3 * i + 3).map((x) => Math.round(x * 1e4)), count, leftOut[i]].join(' ')).sort();

/** The same of a node of meshesOf() by `sunhours --surfaces`, in cells of 0.5. */
export function programCells(meshes, name, words = []) {
  const rows = byProgram(meshes, (path) => [path('cells.csv'), '--surfaces', '--grid', '0.5', '--nodes', name, ...words],
    (path) => readFileSync(path('cells.csv'), 'utf8').trim().split('\n').map((line) => line.split(',')));
  const heads = rows.shift(), column = (head) => rows.map((row) => row[heads.indexOf(head)]);
  const axes = ['x', 'y', 'z'].map(column);
  return cellLines(rows.flatMap((_, i) => axes.map((axis) => Number(axis[i]))), column('hours').map((hours) => Math.round(hours * 6)),
    column('left_out').map((why) => ['', 'inside', 'within'].indexOf(why)));
}
