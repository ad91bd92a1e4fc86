// Building models of many small meshes start in small steps: a worker finds edges and merges, the
// first masks take few draws, and the light is looked up soon after. Shadows are judged by rays.
// EDGESHADE_MESHES sets the number of meshes, 400 otherwise. The test prints times, which never fail.

import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { useBrowser } from './support/browser.mjs';
import { isLong } from './support/long.mjs';
import { repository } from './support/server.mjs';
import { openThree } from './support/three.mjs';

const shared = useBrowser();
const count = Number(process.env.EDGESHADE_MESHES ?? 400);

/** Adds a model to a page that runs, and draws until it is looked up. */
async function start({ count: meshes, file }) {
  const { three, loaded, whiten, rendererOf, lampOf, ExactShadows, drawn, frame } = window.page;
  const { building, viewOf } = await import('/tests/building.js');
  const model = file ? await loaded(file) : building(meshes);
  const renderer = rendererOf({ width: 160, height: 90 });
  const scene = new three.Scene();
  const [light, target] = lampOf({ kind: 'DirectionalLight', position: [0.5, 1, -0.3] });
  const { camera, bounds, size } = viewOf(model);
  const before = new three.Mesh(new three.BoxGeometry(size / 9, size / 9, size / 9), new three.MeshStandardMaterial());
  before.castShadow = before.receiveShadow = true;
  before.position.copy(bounds.max);
  scene.add(light, target, before);
  whiten(scene);
  const shadows = new ExactShadows(renderer).add(scene);
  await drawn(shadows, scene, camera); // compiles the programs
  const told = { meshes: 0, triangles: 0, tasks: [], frames: [], size };
  model.traverse((object) => {
    if (!object.isMesh) return;
    told.meshes += 1;
    told.triangles += (object.geometry.index ?? object.geometry.attributes.position).count / 3;
  });
  const observer = new PerformanceObserver((list) => told.tasks.push(...list.getEntries().map(({ duration }) => duration)));
  observer.observe({ entryTypes: ['longtask'] });
  model.traverse((object) => { if (object.isMesh) object.material = before.material; });
  scene.add(model);
  const since = performance.now();
  const render = () => {
    const began = performance.now();
    const masks = shadows.beginMasks(scene, camera);
    const milliseconds = performance.now() - began;
    renderer.render(scene, camera);
    shadows.endMasks();
    const { pending, lookedUp, buildMs, batches } = shadows.cost;
    told.frames.push({ masks, milliseconds, pending, lookedUp, buildMs, batches, at: performance.now() - since });
    return told.frames.at(-1);
  };
  while (performance.now() - since < 100000) {
    await frame();
    const { lookedUp, pending } = render();
    if (lookedUp === 1 && pending === 0) break; // lights are looked up while meshes are pending, too, if that takes long
  }
  told.lookedUpMs = performance.now() - since;
  const atRest = [];
  for (let i = 0; i < 9; ++i) {
    await frame();
    atRest.push(render().milliseconds);
  }
  observer.takeRecords().forEach(({ duration }) => told.tasks.push(duration));
  told.atRestMs = atRest.sort((a, b) => a - b)[4];
  // The GPU is waited for before each call, so that it doesn't wait itself.
  const moving = [], pixel = new Uint8Array(4), gl = renderer.getContext(), { x } = light.position;
  for (let i = 0; i < 5; ++i) {
    light.position.x = x + 0.001 * i;
    await frame();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    moving.push(render().milliseconds);
  }
  light.position.x = x;
  told.movingMs = moving.slice(1).sort((a, b) => a - b)[2];
  while (render().lookedUp === 0) await new Promise((resolve) => { setTimeout(resolve, 100); });
  return { told, renderer, scene, camera, light, shadows, model };
}

function assertStarted({ meshes, frames }) {
  const pending = frames.map((frame) => frame.pending);
  assert.ok(Math.max(...pending) > meshes / 2, `${Math.max(...pending)} of ${meshes} meshes were pending`);
  assert.equal(pending.at(-1), 0);
  assert.equal(frames.at(-1).lookedUp, 1);
  assert.ok(frames.every(({ buildMs }) => buildMs === 0), 'no edges are found in a frame');
  const most = Math.max(...frames.map(({ batches }) => batches));
  assert.ok(most < 2 + meshes / 8, `${most} draws`);
}

const tell = (name, { meshes, triangles, tasks, frames, lookedUpMs, atRestMs, movingMs }) => {
  const first = frames.find(({ pending }) => pending === 0);
  console.log(`${name}, ${meshes} meshes, ${triangles} triangles: all there after ${first.at.toFixed(0)} ms, looked up after ${lookedUpMs.toFixed(0)} ms and ${frames.length} frames; beginMasks() took at most ${Math.max(...frames.map(({ milliseconds }) => milliseconds)).toFixed(0)} ms, at rest ${atRestMs.toFixed(1)} ms, while the light moves ${movingMs.toFixed(1)} ms in ${Math.max(...frames.map(({ batches }) => batches))} draws; tasks above 50 ms: ${tasks.map(Math.round).join(', ') || 'none'}`);
};

test('a building of many meshes starts in small steps, and is right', async () => {
  const page = await openThree(shared);
  const { told, right } = await page.evaluate(async ([text, numbers]) => {
    const { three, comparedWithRays, redOf } = window.page;
    const { told: measured, renderer, scene, camera, light, shadows, model } = await (0, eval)(`(${text})`)(numbers);
    const judged = {};
    const judge = (name) => {
      shadows.render(scene, camera);
      judged[name] = comparedWithRays(redOf(renderer), renderer, scene, camera, light);
      judged[name].lookedUp = shadows.cost.lookedUp;
      judged[name].batches = shadows.cost.batches;
    };
    judge('looked up');
    light.position.x += 0.02;
    judge('masks');
    model.children[7].position.y += 0.4;
    judge('one moved');
    model.remove(model.children[11]);
    model.children[20].castShadow = false;
    judge('one gone, one that casts nothing');
    for (let i = 0; i < 40; ++i) model.add(new three.Mesh(model.children[i].geometry, model.children[i].material));
    await shadows.ready();
    return { told: measured, right: judged };
  }, [start.toString(), { count }]);
  tell('building', told);
  console.log(right);
  assertStarted(told);
  for (const [name, { surfaces, dark, wrong, beyond }] of Object.entries(right)) {
    if (name.includes('casts nothing')) continue; // rays don't know of castShadow
    assert.ok(surfaces > 2000 && dark > 500, `${name}: ${surfaces} pixels of surfaces, ${dark} in shadow`);
    assert.ok(beyond <= 2 && wrong <= 0.05 * surfaces, `${name}: ${wrong} of ${surfaces} pixels are wrong, ${beyond} of them beyond outlines`);
  }
  assert.equal(right['looked up'].lookedUp, 1);
  assert.equal(right.masks.lookedUp, 0);
  await shared.check(page);
});

test('lights stay looked up while meshes load, which may move and go meanwhile', async () => {
  const page = await openThree(shared);
  const told = await page.evaluate(async () => {
    const { three, yard, whiten, ExactShadows, cameraOf, rested, frame, redOf, comparedWithRays } = window.page;
    const { building } = await import('/tests/building.js');
    const { renderer, scene, light, ground } = yard({ width: 160, height: 90 });
    whiten(scene);
    const camera = cameraOf({ from: [9, 8, 10], to: [0, 0.6, 0], fov: 50 }, 16 / 9);
    const shadows = new ExactShadows(renderer).add(scene);
    const gl = renderer.getContext(), frames = [], errors = [];
    await rested(shadows, scene, camera);
    const model = building(90, { width: 7 });
    model.traverse((object) => { if (object.isMesh) object.material = ground.material; });
    scene.add(model);
    const parts = [...model.children];
    const other = new three.PerspectiveCamera();
    for (let i = 0; i < 2 || shadows.cost.pending > 0; ++i) {
      if (i === 1) {
        parts[40].position.y += 0.3;
        model.remove(parts[41]);
        parts[42].geometry = new three.BoxGeometry(0.5, 0.5, 0.5);
        parts[43].geometry = new three.SphereGeometry(0.3, 40, 30); // large
      }
      await frame();
      renderer.render(scene, other); // the host's own, without shadows
      errors.push(gl.getError());
      shadows.render(scene, camera);
      frames.push({ pending: shadows.cost.pending, lookedUp: shadows.cost.lookedUp });
    }
    const right = {};
    for (const lookedUp of [0, 1]) {
      if (lookedUp) await rested(shadows, scene, camera);
      else shadows.render(scene, camera);
      right[shadows.cost.lookedUp ? 'looked up' : 'masks'] = comparedWithRays(redOf(renderer), renderer, scene, camera, light);
    }
    return { frames, errors: errors.filter(Boolean), right };
  });
  assert.deepEqual(told.errors, []);
  assert.deepEqual(told.frames[0], { pending: 90, lookedUp: 1 });
  assert.equal(told.frames.at(-1).pending, 0);
  for (const [name, { surfaces, dark, wrong, beyond }] of Object.entries(told.right)) {
    assert.ok(surfaces > 1000 && dark > 50, `${name}: ${surfaces} pixels of surfaces, ${dark} in shadow`);
    assert.ok(beyond <= 1 && wrong <= 0.05 * surfaces, `${name}: ${wrong} of ${surfaces} pixels are wrong, ${beyond} of them beyond outlines`);
  }
  assert.ok(told.right['looked up']);
  await shared.check(page);
});

test('while meshes keep coming, light is looked up where they are there, and the others are counted', async () => {
  const page = await openThree(shared, 'three', { haste: 5 });
  const told = await page.evaluate(async () => {
    const { three, yard, whiten, ExactShadows, cameraOf, frame, redOf, comparedWithRays } = window.page;
    const { renderer, scene, light, ground, box } = yard({ width: 160, height: 90 });
    whiten(scene);
    const camera = cameraOf({ from: [9, 8, 10], to: [0, 0.6, 0], fov: 50 }, 16 / 9);
    const shadows = new ExactShadows(renderer).add(scene), began = performance.now();
    const add = (i) => {
      const mesh = new three.Mesh(new three.BoxGeometry(0.3, 0.2 + 0.01 * (i % 50), 0.3), ground.material);
      mesh.position.set(0.5 * (i % 12) - 3, 0.4 + 0.3 * Math.floor(i / 144), 0.5 * (Math.floor(i / 12) % 12) - 3);
      mesh.castShadow = mesh.receiveShadow = true;
      scene.add(mesh);
    };
    box.visible = false;
    const methods = new Set();
    let meshes = 0, isSeen = 0;
    while (performance.now() - began < 60000 && isSeen < 4) {
      add(meshes++);
      await frame();
      shadows.render(scene, camera);
      const method = shadows.lights[0]?.method;
      methods.add(method);
      isSeen += method === 'lookup and movers';
    }
    for (let now = performance.now(); shadows.cost.pending > 0 && performance.now() - now < 20000; await frame()) shadows.render(scene, camera);
    const right = [comparedWithRays(redOf(renderer), renderer, scene, camera, light)], seconds = (performance.now() - began) / 1000;
    const method = shadows.lights[0].method;
    for (let now = performance.now(); shadows.lights[0].method !== 'lookup' && performance.now() - now < 60000; await frame()) shadows.render(scene, camera);
    right.push(comparedWithRays(redOf(renderer), renderer, scene, camera, light));
    return { wasMasked: methods.has('mask'), meshes, method, last: shadows.lights[0].method, right, seconds };
  });
  console.log(told);
  assert.deepEqual([told.wasMasked, told.method, told.last], [true, 'lookup and movers', 'lookup']);
  for (const { surfaces, dark, wrong, beyond } of told.right) {
    assert.ok(surfaces > 1000 && dark > 50, `${surfaces} pixels of surfaces, ${dark} in shadow`);
    assert.ok(beyond <= 1 && wrong <= 0.05 * surfaces, `${wrong} of ${surfaces} pixels are wrong, ${beyond} of them beyond outlines`);
  }
  await shared.check(page);
});

test('meshes that come frame by frame are merged, too', async () => {
  const page = await openThree(shared);
  const told = await page.evaluate(async () => {
    const { yard, ExactShadows, cameraOf, drawn, frame } = window.page;
    const { building } = await import('/tests/building.js');
    const { renderer, scene } = yard({ width: 80, height: 60 });
    const camera = cameraOf({ from: [9, 8, 10], to: [0, 0.6, 0], fov: 50 }, 4 / 3);
    const shadows = new ExactShadows(renderer, { lookups: 0 }).add(scene);
    await drawn(shadows, scene, camera);
    const parts = [...building(600).children];
    let frames = 0;
    for (; parts.length > 0; ++frames) {
      scene.add(...parts.splice(0, 24));
      await frame();
      shadows.render(scene, camera);
    }
    await shadows.ready();
    shadows.render(scene, camera);
    return { frames, ...shadows.cost };
  });
  assert.equal(told.frames, 25, 'too few for the engine to merge what rests');
  assert.equal(told.pending, 0);
  // 16,000 triangles are prepared within frames, the rest in the worker.
  assert.ok(told.batches < 300, `${told.batches} draws`);
  await shared.check(page);
});

test('one mesh among many that is not finite is reported, and the others cast', async () => {
  const page = await openThree(shared);
  const told = await page.evaluate(async () => {
    const { three, yard, ExactShadows, cameraOf, drawn } = window.page;
    const { building } = await import('/tests/building.js');
    const { renderer, scene } = yard({ width: 80, height: 60 });
    const camera = cameraOf({ from: [9, 8, 10], to: [0, 0.6, 0], fov: 50 }, 4 / 3);
    const shadows = new ExactShadows(renderer, { lookups: 0 }).add(scene);
    const reported = [], thrown = [];
    shadows.addEventListener('error', ({ message }) => reported.push(message));
    await drawn(shadows, scene, camera);
    const model = building(60), broken = model.children[30].geometry;
    broken.attributes.position.setX(3, NaN);
    broken.boundingSphere = new three.Sphere();
    scene.add(model);
    for (let i = 0; i < 2; ++i) await drawn(shadows, scene, camera).catch(({ message }) => thrown.push(message));
    shadows.render(scene, camera);
    const { pending, vertexRuns } = shadows.cost;
    return { reported, thrown, pending, vertexRuns };
  });
  assert.equal(told.thrown.length, 1);
  assert.match(told.thrown[0], /not finite/);
  assert.deepEqual(told.reported, told.thrown);
  assert.equal(told.pending, 0);
  assert.ok(told.vertexRuns > 1000, `${told.vertexRuns} runs of vertex shaders`);
  await shared.check(page);
});

const hospital = '/shared/hospital-electrical.glb';
const isThere = existsSync(join(repository, '..', 'shared/scenes/hospital-electrical.glb'));
const skip = !isLong ? 'only ./test --long starts it' : !isThere && 'the model is not here';

test("the hospital's electrical model starts in small steps", { skip }, async () => {
  const page = await openThree(shared);
  const told = await page.evaluate(async ([text, file]) => (await (0, eval)(`(${text})`)({ file })).told, [start.toString(), hospital]);
  tell('hospital', told);
  assertStarted(told);
  await shared.check(page);
});
