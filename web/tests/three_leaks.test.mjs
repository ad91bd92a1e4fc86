// Materials that three.js's pages throw away are let go, and leave no errors of the GL.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { useBrowser } from './support/browser.mjs';
import { times } from './support/long.mjs';
import { openThree } from './support/three.mjs';

const shared = useBrowser({ angle: 'swiftshader' }); // counts depend on when a GL is ready, and are known for this one

test('disposed materials are collected, and a deleted program is not used', async () => {
  const page = await openThree(shared);
  const told = await page.evaluate(async () => {
    const { three, yard, ExactShadows, cameraOf, drawn } = window.page;
    const { renderer, scene, box } = yard({ width: 80, height: 60 });
    const camera = cameraOf({ from: [5, 4, 6], to: [0, 0.6, 0], fov: 50 }, 80 / 60);
    const shadows = new ExactShadows(renderer, { lookups: 0 }).add(scene);
    const gl = renderer.getContext();
    const references = [], errors = [];
    const kinds = [three.MeshPhongMaterial, three.MeshLambertMaterial, three.MeshToonMaterial];
    await drawn(shadows, scene, camera);
    for (let i = 0; i < 24; ++i) {
      box.material = new kinds[i % 3]({ color: i });
      references.push(new WeakRef(box.material));
      shadows.render(scene, camera);
      box.material.dispose(); // the last one of its program
      if (i % 2) box.material = new three.MeshBasicMaterial();
      shadows.render(scene, camera);
      errors.push(gl.getError());
      if (i % 2) box.material.dispose();
    }
    box.material = scene.children[0].material;
    for (let i = 0; i < 4; ++i) {
      shadows.render(scene, camera);
      await new Promise((resolve) => { setTimeout(resolve, 30); });
      window.gc();
    }
    const alive = references.filter((reference) => reference.deref()).length;
    // Those in use are still restored.
    shadows.dispose();
    return { alive, errors: errors.filter(Boolean), restored: !Object.hasOwn(box.material, 'customProgramCacheKey') };
  });
  assert.deepEqual(told.errors, []);
  assert.ok(told.alive <= 1, `${told.alive} of 24 are alive`);
  assert.ok(told.restored);
  await shared.check(page);
});

test('a program that the host has deleted while in use stays deleted', async () => {
  const page = await openThree(shared);
  const errors = await page.evaluate(async () => {
    const { three, rendererOf } = window.page;
    const { ShadowMasks } = await import('/masks/shadow-masks.js');
    const renderer = rendererOf({ width: 40, height: 30 });
    const gl = renderer.getContext();
    const masks = await ShadowMasks.create(gl);
    const material = new three.MeshBasicMaterial();
    const scene = new three.Scene().add(new three.Mesh(new three.PlaneGeometry(), material));
    renderer.render(scene, new three.PerspectiveCamera());
    const program = gl.getParameter(gl.CURRENT_PROGRAM);
    gl.deleteProgram(program);
    const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
    masks.draw({ viewFromWorld: identity, clipFromView: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, -1, 0, 0, -0.2, 0], width: 8, height: 8 }, [{}]);
    return [Boolean(program), gl.getError(), gl.getParameter(gl.CURRENT_PROGRAM) === null];
  });
  assert.deepEqual(errors, [true, 0, true]);
  await shared.check(page);
});

/** Cycles of adding and removing 100 meshes. */
const cycles = times(12, 200);

/** Keeps the memories of the page's programs in `memories`, and the objects of its contexts in `objects`. */
function keepMemories() {
  window.memories = [];
  window.objects = new Set();
  const context = WebGL2RenderingContext.prototype;
  for (const kind of ['Buffer', 'Framebuffer', 'Program', 'Query', 'Renderbuffer', 'Sampler', 'Shader', 'Sync', 'Texture', 'TransformFeedback', 'VertexArray']) {
    const making = kind === 'Sync' ? 'fenceSync' : `create${kind}`, deleting = `delete${kind}`;
    const { [making]: make, [deleting]: drop } = context;
    context[making] = function (...given) {
      const made = make.apply(this, given);
      window.objects.add(made);
      return made;
    };
    context[deleting] = function (object) {
      window.objects.delete(object);
      drop.call(this, object);
    };
  }
  const { instantiate } = WebAssembly;
  WebAssembly.instantiate = async (...given) => {
    const made = await instantiate.apply(WebAssembly, given);
    window.memories.push(...Object.values((made.instance ?? made).exports).filter((value) => value instanceof WebAssembly.Memory));
    return made;
  };
}

test(`${cycles} cycles of adding and removing 100 meshes leave nothing behind`, async () => {
  const page = await openThree(shared, 'three', { init: keepMemories });
  const told = await page.evaluate(async (count) => {
    const { yard, ExactShadows, cameraOf, drawn } = window.page;
    const { building } = await import('/tests/building.js');
    const { renderer, scene } = yard({ width: 80, height: 60 });
    const camera = cameraOf({ from: [5, 4, 6], to: [0, 0.6, 0], fov: 50 }, 80 / 60);
    const shadows = new ExactShadows(renderer, { lookups: 0 }).add(scene);
    await drawn(shadows, scene, camera);
    const heaps = [], pending = [], batches = [], bytes = [], memory = [], objects = [];
    for (let i = 0; i < count; ++i) {
      const model = building(100, { seed: i % 3 + 1 }); // the same three: objects of the GL depend on their shapes
      scene.add(model);
      shadows.render(scene, camera);
      if (i % 3 === 0) await shadows.ready(); // otherwise they go while they are pending
      shadows.render(scene, camera);
      scene.remove(model);
      model.traverse((object) => object.geometry?.dispose());
      shadows.render(scene, camera);
      await shadows.ready();
      shadows.render(scene, camera);
      pending.push(shadows.cost.pending);
      batches.push(shadows.cost.batches);
      bytes.push(shadows.cost.bytes);
      const kinds = {};
      for (const { constructor: { name } } of window.objects) kinds[name] = (kinds[name] ?? 0) + 1;
      objects.push(kinds);
      memory.push(window.memories.reduce((sum, { buffer }) => sum + buffer.byteLength, 0));
      await new Promise((resolve) => { setTimeout(resolve, 20); });
      window.gc();
      heaps.push(performance.memory.usedJSHeapSize);
    }
    return { heaps, pending, batches, bytes, memory, objects };
  }, cycles);
  const median = (list) => [...list].sort((a, b) => a - b)[list.length >> 1];
  const third = Math.floor(cycles / 3);
  const begin = median(told.heaps.slice(2, 2 + third)), end = median(told.heaps.slice(-third));
  console.log(`heap of JavaScript: ${(begin / 1e6).toFixed(2)} MB, then ${(end / 1e6).toFixed(2)} MB; of the program ${told.memory[2]}, then ${told.memory.at(-1)} bytes; on the GPU ${told.bytes.at(2)}, then ${told.bytes.at(-1)} bytes; objects of the GL`, told.objects.at(2), told.objects.at(-1));
  assert.ok(told.pending.every((number) => number === 0));
  assert.deepEqual([...new Set(told.batches)], [2], 'the ground and the box');
  assert.equal(told.bytes.at(-1), told.bytes.at(2));
  // Meshes that go while they are pending leave a few objects until the next cycle, depending on how far they came.
  // In the first cycle programs are still compiled.
  const [first, ...others] = told.objects.filter((_, cycle) => cycle % 3 === 0).slice(1);
  assert.ok(first.WebGLBuffer > 20 && others.length > 1);
  for (const objects of others) assert.deepEqual(objects, first);
  assert.ok(told.memory[2] > 1e6 && told.memory.at(-1) <= told.memory[third], 'the memory of the program does not grow');
  assert.ok(end < begin + 2e6, `${begin} bytes, then ${end}`);
  await shared.check(page);
});
