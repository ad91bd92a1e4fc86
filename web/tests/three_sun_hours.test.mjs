// Hours of sun in three.js: the counts of the program's own points and cells, and how calls end.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { useBrowser } from './support/browser.mjs';
import { byProgram, cellLines, days, programCells, tools, withTools } from './support/sun_hours.mjs';
import { openThree } from './support/three.mjs';

const shared = useBrowser();

test('vertices have the hours of sunhours --at', async () => {
  const told = await withTools(shared, async ({ THREE, square, meshesOf }, options) => {
    const { scene, shadows, ...objects } = square();
    const measured = {};
    for (const name of ['ground', 'tower', 'canopy']) {
      const mesh = objects[name], { position, normal } = mesh.geometry.attributes;
      const { hours, counts, positions, possible } = await shadows.sunHours(mesh, options);
      const placesOf = (attribute) => Array.from({ length: position.count }, (_, i) => new THREE.Vector3().fromBufferAttribute(attribute, i));
      const places = placesOf(position), normals = placesOf(normal);
      // On an edge --at's doubles can't tell on which side of the other face a point is: typed points are a hair off all edges.
      const points = places.map((place, i) => {
        const face = places.filter((_, other) => normals[other].equals(normals[i]));
        const middle = face.reduce((sum, one) => sum.add(one), new THREE.Vector3()).divideScalar(face.length);
        const typed = middle.sub(place).add(normals[i]).multiplyScalar(1e-6).add(place);
        return [...typed.toArray(), ...normals[i].toArray()];
      });
      measured[name] = { points, hours: [...hours.array], counts: [...counts], positions, possible, size: hours.itemSize };
    }
    shadows.dispose();
    return { meshes: meshesOf(scene), measured };
  }, days);
  for (const [name, { points, hours, counts, positions, possible, size }] of Object.entries(told.measured)) {
    const probes = byProgram(told.meshes, (path) => [path('out.png'), '--by', 'rays', '--size', '8x8', '--report', path('report.json'),
      ...points.flatMap((numbers) => ['--at', numbers.join()])], (path) => JSON.parse(readFileSync(path('report.json'), 'utf8')));
    assert.equal(size, 1);
    assert.equal(positions, probes.positions.length, name);
    assert.ok(Math.abs(possible - probes.possible_hours) < 1e-9);
    const others = probes.probes.filter((probe, i) => Math.round(probe.hours * 6) !== counts[i]);
    console.log(name, { points: points.length, lit: counts.reduce((sum, n) => sum + n, 0), others: others.length });
    assert.deepEqual(others, [], name);
    assert.ok(hours.every((value, i) => Math.abs(value - counts[i] / 6) < 1e-5));
    assert.ok(new Set(counts).size > (name === 'canopy' ? 0 : 10), `${name}: the hours differ`);
  }
});

test('cells have the hours of sunhours --surfaces', async () => {
  const told = await withTools(shared, async ({ square, meshesOf, THREE }, options) => {
    const { scene, shadows, ground, canopy, posts } = square();
    const measured = {};
    for (const [name, object] of Object.entries({ ground, canopy, posts })) {
      const { geometry, origin, cells, counts } = await shadows.sunHours(object, { ...options, grid: 0.5 });
      const { position, hours } = geometry.attributes, { index } = geometry;
      const corner = (i) => new THREE.Vector3().fromBufferAttribute(position, index.getX(i)).add(origin);
      let area = 0, weighted = 0;
      for (let i = 0; i < index.count; i += 3) {
        const piece = new THREE.Triangle(corner(i), corner(i + 1), corner(i + 2)).getArea();
        area += piece;
        weighted += piece * hours.getX(index.getX(i));
      }
      measured[name] = { area, weighted, points: [...cells.points], areas: [...cells.areas], hours: [...cells.hours], leftOut: [...cells.leftOut], counts: [...counts] };
    }
    shadows.dispose();
    return { meshes: meshesOf(scene), measured };
  }, days);
  for (const [name, { area, weighted, points, areas, hours, leftOut, counts }] of Object.entries(told.measured)) {
    const mine = cellLines(points, counts, leftOut), theirs = programCells(told.meshes, name);
    console.log(name, { cells: mine.length, others: mine.filter((line, i) => line !== theirs[i]).length });
    assert.deepEqual(mine, theirs, name);
    const sum = areas.reduce((total, one) => total + one, 0);
    assert.ok(Math.abs(area - sum) < 1e-4 * sum);
    assert.ok(Math.abs(weighted - areas.reduce((total, one, i) => total + one * hours[i], 0)) < 1e-3 * weighted);
  }
});

test('displaced casters shade where they are drawn, and only a grid measures them', async () => {
  const told = await withTools(shared, async ({ THREE, square }, options) => {
    const { scene, ground, canopy, shadows } = square();
    const camera = window.page.cameraOf({ from: [9, 8, 12], to: [0, 1, 0], fov: 50 }, 4 / 3);
    const white = new THREE.DataTexture(new Uint8Array(4).fill(255), 1, 1);
    white.needsUpdate = true;
    const sheet = (material) => {
      canopy.geometry = new THREE.PlaneGeometry(3, 2, 2, 2).rotateX(-Math.PI / 2);
      canopy.material = material;
      canopy.castShadow = true;
    };
    const countsAt = async (height, more) => {
      sheet(new THREE.MeshStandardMaterial({ side: THREE.DoubleSide, ...more }));
      canopy.position.set(0, height, 0);
      shadows.render(scene, camera);
      return [...(await shadows.sunHours(ground, { ...options, step: 60, grid: 0.4 })).counts];
    };
    const low = await countsAt(0.5), moved = await countsAt(2);
    const displaced = await countsAt(0.5, { displacementMap: white, displacementScale: 1, displacementBias: 0.5 });
    const refused = await shadows.sunHours(canopy, options).then(() => '', ({ message }) => message);
    shadows.dispose();
    return { low, moved, displaced, refused };
  }, days);
  assert.deepEqual(told.displaced, told.moved);
  assert.notDeepEqual(told.low, told.moved);
  assert.match(told.refused, /'canopy' is skinned, morphed or displaced/);
});

test('calls report progress, can be cancelled, and refuse what they cannot measure', async () => {
  const told = await withTools(shared, async ({ THREE, square, renderer }, options) => {
    const { shadows, ground, posts, tower, scene } = square();
    const told = { shares: [], refused: {} };
    await shadows.sunHours(ground, { ...options, grid: 0.05, onProgress: (share) => told.shares.push(share) });
    const leaving = new AbortController();
    const since = performance.now();
    told.aborted = await shadows.sunHours(ground, { ...options, grid: 0.02, signal: leaving.signal, onProgress: () => leaving.abort() }).catch(({ name }) => name);
    told.abortMs = performance.now() - since;
    told.abortedBefore = await shadows.sunHours(ground, { ...options, signal: AbortSignal.abort() }).catch(({ name }) => name);
    const refuse = async (name, object, more) => {
      told.refused[name] = await shadows.sunHours(object, { ...options, ...more }).then(() => '', ({ message }) => message);
    };
    await refuse('place', ground, { place: [91, 0] });
    await refuse('date', ground, { date: undefined });
    await refuse('day', ground, { date: '2026-02-30' });
    await refuse('step', ground, { step: 7 });
    await refuse('hours', ground, { hours: [9, 9] });
    await refuse('grid', ground, { grid: 0 });
    await refuse('cells', ground, { grid: 1e-4 });
    await refuse('instances', posts);
    await refuse('group', scene);
    await refuse('normals', new THREE.Mesh(new THREE.BufferGeometry().setAttribute('position', new THREE.BufferAttribute(new Float32Array(9), 3))));
    await refuse('nothing', new THREE.Group(), { grid: 1 });
    tower.scale.set(0, 0, 0); // it is no longer in the way, and nowhere else either
    shadows.render(scene, window.page.cameraOf({ from: [9, 8, 12], to: [0, 1, 0], fov: 50 }, 4 / 3));
    await refuse('flat', tower);
    const broken = ground.clone();
    broken.geometry = ground.geometry.clone();
    const { position, normal } = broken.geometry.attributes;
    position.setX(0, NaN);
    normal.setXYZ(1, 0, 0, 0);
    normal.setY(2, Infinity);
    scene.remove(posts);
    shadows.render(scene, window.page.cameraOf({ from: [9, 8, 12], to: [0, 1, 0], fov: 50 }, 4 / 3));
    const free = await shadows.sunHours(broken, options);
    told.free = { dark: [...free.counts].flatMap((count, i) => (count === 0 ? [i] : [])), others: [...free.counts].filter((count) => count !== 0 && count !== free.positions).length };
    tower.scale.set(1, 1, 1);
    scene.add(posts);
    shadows.render(scene, window.page.cameraOf({ from: [9, 8, 12], to: [0, 1, 0], fov: 50 }, 4 / 3));
    const noon = await shadows.sunHours(tower, { ...options, date: undefined, times: [new Date('2026-03-21T12:00+01:00'), new Date('2026-03-21T23:00+01:00')] });
    told.noon = { positions: noon.positions, lit: Math.max(...noon.counts), dark: Math.min(...noon.counts) };
    const three = await shadows.sunHours(ground, { ...options, date: ['2026-03-20', '2026-03-22'], hours: [11, 13] });
    told.three = { positions: three.positions, possible: three.possible };
    const night = await shadows.sunHours(tower, { ...options, hours: [0, 2] });
    told.night = { positions: night.positions, most: Math.max(...night.hours.array) };
    shadows.dispose();
    const { ExactShadows } = window.page;
    const idle = new ExactShadows(renderer).add(scene);
    told.refused.unrendered = await idle.sunHours(ground, options).catch(({ message }) => message);
    idle.dispose();
    return told;
  }, days);
  console.log(told);
  assert.ok(told.shares.length > 2 && told.shares.every((share, i) => share > 0 && share <= 1 && share >= (told.shares[i - 1] ?? 0)));
  assert.equal(told.aborted, 'AbortError');
  assert.equal(told.abortedBefore, 'AbortError');
  assert.deepEqual(told.free, { dark: [0, 1, 2], others: 0 });
  assert.deepEqual(told.noon, { positions: 1, lit: 1, dark: 0 });
  assert.deepEqual(told.three, { positions: 36, possible: 6 });
  assert.deepEqual(told.night, { positions: 0, most: 0 });
  const said = { place: /latitude/, date: /date must be/, day: /^sunHours\(\): '2026-02-30'.*\.$/, step: /divide/, hours: /clock hours/, grid: /grid must be above 0/,
    cells: /^sunHours\(\): grid: .*10000000/, instances: /'posts' stands at several places/, group: /no mesh/, nothing: /no visible mesh/, flat: /scaled to nothing/, normals: /no normals/, unrendered: /needs a render/ };
  for (const [name, words] of Object.entries(said)) assert.match(told.refused[name], words, name);
});

test('a page that asks for no hours loads nothing of them', async () => {
  const page = await openThree(shared);
  const asked = [];
  page.on('request', (request) => asked.push(new URL(request.url()).pathname));
  await page.evaluate(tools);
  const used = await page.evaluate(async (options) => {
    const { ground, shadows } = window.sunHours.square();
    await shadows.ready();
    const before = performance.getEntriesByType('resource').map(({ name }) => name);
    await shadows.sunHours(ground, options);
    const after = performance.getEntriesByType('resource').map(({ name }) => name);
    shadows.dispose();
    return { before, after };
  }, days);
  assert.ok(!used.before.some((name) => /hours/.test(name)), used.before.join());
  assert.ok(used.after.some((name) => /three\/sun-hours\.js/.test(name)));
  assert.ok(asked.some((name) => /edgeshade-hours\.wasm/.test(name)));
  await shared.check(page);
});
