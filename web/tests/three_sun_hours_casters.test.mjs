// Hours of sun in three.js under casters that are cut out, clipped or see-through: the program's counts.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { useBrowser } from './support/browser.mjs';
import { cellLines, days, programCells, withTools } from './support/sun_hours.mjs';

const shared = useBrowser();

/** Compares the page's cells of the ground with the program's, and says so. */
function requireSame(name, { points, counts, leftOut }, theirs) {
  const mine = cellLines(points, counts, leftOut);
  console.log(name, { cells: mine.length, others: mine.filter((line, i) => line !== theirs[i]).length });
  assert.deepEqual(mine, theirs, name);
}

test('leaves cast what their alpha leaves, by their own textures', async () => {
  const { meshes, alphas, texcoords, told } = await withTools(shared, async ({ THREE, square, meshesOf, measure }, options) => {
    const { scene, ground, canopy, shadows } = square();
    let seed = 7;
    const alphas = Array.from({ length: 64 }, () => (seed = (16807 * seed) % 2147483647) % 256);
    const map = Object.assign(new THREE.DataTexture(Uint8Array.from(alphas.flatMap((alpha) => [255, 255, 255, alpha])), 8, 8),
      { magFilter: THREE.LinearFilter, minFilter: THREE.LinearFilter, wrapS: THREE.RepeatWrapping, wrapT: THREE.RepeatWrapping, needsUpdate: true });
    map.repeat.set(1.5, 0.5);
    map.offset.set(0.25, 0.75);
    const told = {}, counted = async (name, material) => {
      canopy.castShadow = true;
      canopy.material = new THREE.MeshStandardMaterial({ side: THREE.DoubleSide, ...material });
      told[name] = await measure(shadows, scene, ground, options);
    };
    await counted('whole', {});
    await counted('linear', { map, alphaTest: 0.5 });
    // alphaMap's green, and opacity, with other filtering.
    const alphaMap = Object.assign(new THREE.DataTexture(Uint8Array.from(alphas.flatMap((alpha) => [0, alpha, 0, 255])), 8, 8),
      { magFilter: THREE.NearestFilter, minFilter: THREE.NearestFilter, wrapS: THREE.RepeatWrapping, wrapT: THREE.RepeatWrapping, needsUpdate: true });
    alphaMap.repeat.copy(map.repeat);
    alphaMap.offset.copy(map.offset);
    await counted('nearest', { alphaMap, opacity: 0.5, alphaTest: 0.25 });
    shadows.alphaTestedCast = 'none';
    await counted('none', { map, alphaTest: 0.5 });
    shadows.alphaTestedCast = 'whole';
    await counted('as if whole', { map, alphaTest: 0.5 });
    const meshes = meshesOf(scene);
    const texcoords = [...canopy.geometry.attributes.uv.array];
    shadows.dispose();
    return { meshes, alphas, texcoords, told };
  }, days);
  const leaves = { ...meshes.find(({ name }) => name === 'canopy'), cutoff: 0.5, image: { size: 8, alphas },
    texcoords: texcoords.map((x, i) => (i % 2 ? 0.5 * x + 0.75 : 1.5 * x + 0.25)) };
  const scene = (canopy) => [...meshes.filter(({ name }) => name !== 'canopy'), canopy];
  const whole = programCells(scene({ ...leaves, texcoords: null }), 'ground');
  const none = programCells(scene({ ...leaves, texcoords: null, casts: false }), 'ground');
  assert.notDeepEqual(whole, none);
  for (const isNearest of [false, true]) {
    const cut = programCells(scene({ ...leaves, isNearest }), 'ground', ['--cast-cutouts']);
    assert.notDeepEqual(cut, whole);
    assert.notDeepEqual(cut, none);
    requireSame(isNearest ? 'nearest' : 'linear', told[isNearest ? 'nearest' : 'linear'], cut);
  }
  requireSame('whole', told.whole, whole);
  requireSame('as if whole', told['as if whole'], whole);
  requireSame('none', told.none, none);
});

test('clipped casters cast what clipShadows leaves of them', async () => {
  const { meshes, told } = await withTools(shared, async ({ THREE, renderer, square, meshesOf, measure }, options) => {
    const { scene, ground, canopy, shadows } = square();
    canopy.geometry = new THREE.BoxGeometry(2, 3, 0.5, 2, 3, 1); // cut along its triangles' edges
    canopy.position.set(-1, 1.75, 1);
    canopy.castShadow = true;
    const above = new THREE.Plane(new THREE.Vector3(0, -1, 0), 2.25), right = new THREE.Plane(new THREE.Vector3(-1, 0, 0), -1);
    const told = {}, counted = async (name, material) => {
      canopy.material = new THREE.MeshStandardMaterial(material);
      told[name] = await measure(shadows, scene, ground, options);
    };
    renderer.localClippingEnabled = true;
    const planes = [above, right];
    await counted('seen', { clippingPlanes: planes });
    await counted('any', { clippingPlanes: planes, clipShadows: true });
    await counted('all', { clippingPlanes: planes, clipShadows: true, clipIntersection: true });
    renderer.localClippingEnabled = false;
    await counted('off', { clippingPlanes: planes, clipShadows: true });
    renderer.clippingPlanes = [above];
    await counted('everywhere', {});
    renderer.clippingPlanes = [];
    const meshes = meshesOf(scene);
    shadows.dispose();
    return { meshes, told };
  }, days);
  const box = meshes.find(({ name }) => name === 'canopy');
  /** Cells under the triangles whose middle, in the mesh, `stays(x, y)`. */
  const cellsWith = (stays) => {
    const middle = (i, axis) => [0, 1, 2].reduce((sum, j) => sum + box.positions[3 * box.indices[i + j] + axis] / 3, 0);
    const indices = box.indices.filter((_, i) => stays(middle(i - i % 3, 0), middle(i - i % 3, 1)));
    return programCells([...meshes.filter((mesh) => mesh !== box), { ...box, indices }], 'ground');
  };
  const whole = cellsWith(() => true);
  const expected = { seen: whole, off: whole, everywhere: whole, any: cellsWith((x, y) => x < 0 && y < 0.5), all: cellsWith((x, y) => x < 0 || y < 0.5) };
  assert.equal(new Set(Object.values(expected).map((lines) => lines.join())).size, 3);
  for (const [name, lines] of Object.entries(expected)) requireSame(name, told[name], lines);
});

test('see-through casters shade if transparentCast is opaque, and tints let the sun through', async () => {
  const { meshes, told } = await withTools(shared, async ({ THREE, square, meshesOf, measure }, options) => {
    const { scene, ground, canopy, shadows } = square();
    canopy.material = new THREE.MeshStandardMaterial({ side: THREE.DoubleSide, transparent: true, opacity: 0.5, color: 0xff8800 });
    canopy.castShadow = true;
    const told = {};
    for (const choice of ['none', 'opaque', 'tint']) {
      shadows.transparentCast = choice;
      told[choice] = await measure(shadows, scene, ground, options);
    }
    const meshes = meshesOf(scene);
    shadows.dispose();
    return { meshes, told };
  }, days);
  const cells = (casts) => programCells(meshes.map((mesh) => (mesh.name === 'canopy' ? { ...mesh, casts } : mesh)), 'ground');
  const [free, shaded] = [cells(false), cells(true)];
  assert.notDeepEqual(free, shaded);
  for (const [choice, lines] of Object.entries({ none: free, opaque: shaded, tint: free })) requireSame(choice, told[choice], lines);
});
