// Loading 150,000 triangles doesn't block the page: a worker finds the edges, and uploading and the
// first masks have frames of their own.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { useBrowser } from './support/browser.mjs';
import { openThree, releases } from './support/three.mjs';

const shared = useBrowser();

test('the shadows of 150,000 triangles come without long tasks', async () => {
  const page = await openThree(shared);
  const told = await page.evaluate(async () => {
    const { three, yard, ExactShadows, cameraOf, drawn } = window.page;
    const { renderer, scene, mesh, box } = yard({ width: 320, height: 180 });
    const camera = cameraOf({ from: [5, 4, 6], to: [0, 0.6, 0], fov: 50 }, 320 / 180);
    const knot = new three.TorusKnotGeometry(0.8, 0.3, 1500, 50);
    const shadows = new ExactShadows(renderer).add(scene);
    await drawn(shadows, scene, camera); // compiles the programs
    const tasks = [];
    const observer = new PerformanceObserver((list) => tasks.push(...list.getEntries().map(({ duration }) => duration)));
    observer.observe({ entryTypes: ['longtask'] });
    const frame = () => new Promise((resolve) => { requestAnimationFrame(resolve); });
    const calls = [];
    const render = () => {
      const since = performance.now();
      shadows.render(scene, camera);
      calls.push(performance.now() - since);
    };
    scene.remove(box);
    const big = mesh(knot);
    big.position.y = 1.4;
    scene.add(big);
    let frames = 0, without = 0;
    do {
      await frame();
      render();
      frames += 1;
      without += shadows.cost.vertexRuns < 1000;
    } while (shadows.cost.pending > 0);
    const first = calls.length;
    for (let i = 0; i < 5; ++i) {
      await frame();
      render();
    }
    await frame();
    observer.takeRecords().forEach(({ duration }) => tasks.push(duration));
    return { triangles: knot.index.count / 3, tasks, frames, without, longest: Math.max(...calls), calls: calls.slice(first - 1), cost: shadows.cost };
  });
  console.log(`tasks above 50 ms: ${told.tasks.join(', ') || 'none'}; the longest render(): ${told.longest.toFixed(0)} ms`, told.calls.map(Math.round));
  assert.ok(told.triangles >= 150000 && told.frames > 1, `${told.triangles} triangles, ${told.frames} frames`);
  assert.ok(told.without >= told.frames - 1, 'until then pictures come without them');
  assert.equal(told.cost.buildMs, 0, 'no edges are found in a frame');
  assert.equal(told.cost.pending, 0);
  await shared.check(page);
});

test('meshes and lookups come without questions to the GL that wait for pending draws', async () => {
  const page = await openThree(shared);
  const told = await page.evaluate(async () => {
    const { yard, ExactShadows, cameraOf, rested } = window.page;
    const { building } = await import('/tests/building.js');
    const { renderer, scene, box } = yard({ width: 80, height: 60 });
    const camera = cameraOf({ from: [9, 8, 10], to: [0, 0.6, 0], fov: 50 }, 4 / 3);
    const shadows = new ExactShadows(renderer).add(scene);
    await rested(shadows, scene, camera);
    const { ShadowMasks } = await import('/masks/shadow-masks.js'), { lookupState } = ShadowMasks.prototype;
    const compared = [0, 0];
    for (const [i, move] of [0, 1].entries()) {
      ShadowMasks.prototype.lookupState = function (...given) {
        compared[i] += 1;
        return lookupState.apply(this, given);
      };
      box.position.y += move;
      for (let frames = 0; frames < 5; ++frames) shadows.render(scene, camera);
    }
    ShadowMasks.prototype.lookupState = lookupState;
    const gl = renderer.getContext(), clip = gl.getExtension('EXT_clip_control');
    const asked = new Set();
    const { getParameter, readPixels } = gl;
    let read = 0;
    gl.getParameter = (name) => {
      asked.add(name);
      return getParameter.call(gl, name);
    };
    gl.readPixels = (...given) => {
      read += 1;
      readPixels.apply(gl, given);
    };
    scene.add(building(60, { width: 6 }));
    const lookedUp = await rested(shadows, scene, camera);
    delete gl.getParameter;
    delete gl.readPixels;
    const waits = { ...Object.fromEntries(['BLEND_SRC_RGB', 'STENCIL_FUNC', 'CULL_FACE_MODE', 'DEPTH_FUNC', 'SCISSOR_BOX'].map((name) => [name, gl[name]])),
      CLIP_ORIGIN_EXT: clip?.CLIP_ORIGIN_EXT, CLIP_DEPTH_MODE_EXT: clip?.CLIP_DEPTH_MODE_EXT };
    return { lookedUp, compared, read, asked: asked.size, waiting: Object.keys(waits).filter((name) => asked.has(waits[name])) };
  });
  assert.equal(told.lookedUp, 1);
  assert.ok(told.asked > 5, `${told.asked} names`);
  assert.deepEqual([told.waiting, told.read], [[], 0]);
  assert.ok(told.compared[0] === 0 && told.compared[1] > 0, `casters are compared with a map's only if they change: ${told.compared}`);
  await shared.check(page);
});

test('a map is uploaded in steps of some milliseconds, with few bytes under way at a time', async () => {
  const page = await openThree(shared);
  const told = await page.evaluate(async () => {
    const { three } = window.page;
    const { ShadowMasks } = await import('/masks/shadow-masks.js');
    const gl = document.createElement('canvas').getContext('webgl2');
    const masks = await ShadowMasks.create(gl);
    const { index, attributes } = new three.TorusKnotGeometry(1, 0.4, 600, 80);
    masks.add(await masks.prepare({ positions: attributes.position.array, indices: index.array }), new three.Matrix4().elements);
    const ids = [];
    for (const direction of [[0.2, -1, 0.1], [0.3, -1, 0.1], [-1, -1, 0]]) ids.push(await masks.buildLookup({ direction }, { restMs: 0, mostBytes: 2 ** 28 }));
    const pieces = [];
    let slow = 0, busy = true, late = 0;
    performance.now = () => late; // only pieces take time
    gl.texSubImage2D = (...given) => {
      pieces.push(16 * given[4] * given[5]);
      late += slow;
      WebGL2RenderingContext.prototype.texSubImage2D.apply(gl, given);
    };
    gl.getSyncParameter = () => (busy ? gl.UNSIGNALED : gl.SIGNALED);
    const step = (id) => {
      const before = pieces.length, whole = masks.uploadLookupStep(id);
      return { pieces: pieces.length - before, whole };
    };
    const { bytes } = masks.lookup(ids[0]);
    slow = 3;
    const first = step(ids[0]);
    slow = 30;
    const second = step(ids[0]);
    slow = 0;
    busy = false;
    for (let i = 0; i < 1000 && !step(ids[0]).whole; ++i);
    // The next two, while the GPU is busy.
    slow = 8;
    step(ids[1]);
    [slow, busy] = [0, true];
    late += 600;
    const since = pieces.length, { uploaded } = masks.lookup(ids[0]);
    for (let i = 0; i < 1000 && !step(ids[1]).whole; ++i);
    const stopped = Array.from({ length: 100 }, () => step(ids[2])).at(-1);
    const under = pieces.slice(since).reduce((sum, piece) => sum + piece, 0);
    late += 600;
    const waiting = step(ids[2]).pieces;
    for (let frames = 0; frames < 5; ++frames) await window.page.frame();
    const later = step(ids[2]).pieces;
    return { bytes, first, second, uploaded, under, stopped, waiting, later, largest: Math.max(...pieces), error: gl.getError() };
  });
  console.log(told);
  assert.ok(told.largest <= 2 ** 19, `pieces of ${told.largest} bytes`);
  assert.ok(told.bytes > 2 ** 23);
  assert.deepEqual([told.first.pieces, told.second.pieces, told.uploaded, told.error], [3, 1, true, 0], 'steps end after 8 ms');
  assert.deepEqual(told.stopped, { pieces: 0, whole: false });
  assert.ok(told.under > 2 ** 23 && told.under <= 2 ** 24 + 2 ** 19, `${told.under} bytes are under way`);
  assert.equal(told.waiting, 0, 'a browser that shows no frames takes none');
  assert.ok(told.later > 0, 'it has taken them after some frames and half a second');
  await shared.check(page);
});

test('masks of a still view are drawn a few times while many meshes are added step by step, and the GPU is busy', async () => {
  const page = await openThree(shared);
  const told = await page.evaluate(async () => {
    const { yard, ExactShadows, cameraOf, frame, rested } = window.page;
    const { building } = await import('/tests/building.js');
    const { ShadowMasks } = await import('/masks/shadow-masks.js'), { draw, add, addMerged, planAhead, buildLookup } = ShadowMasks.prototype;
    const { renderer, scene, box } = yard({ width: 80, height: 60 });
    const camera = cameraOf({ from: [9, 8, 10], to: [0, 0.6, 0], fov: 50 }, 4 / 3);
    const shadows = new ExactShadows(renderer).add(scene);
    await rested(shadows, scene, camera);
    ShadowMasks.prototype.buildLookup = () => new Promise(() => {}); // on a busy machine meshes come for long, and another map would do
    const gl = renderer.getContext();
    gl.getSyncParameter = () => gl.UNSIGNALED;
    let late = 0, draws = 0, groups = 0, lacks = false, moved = null, early = 0, waits = 0, both = 0, plans = 0;
    const { now } = Performance.prototype;
    Performance.prototype.now = function () { return now.call(this) + late; };
    const instead = (name, act, before) => { ShadowMasks.prototype[name] = function (...given) {
      before();
      return act.apply(this, given);
    }; };
    const note = () => {
      late += 10; // a step adds no more than one
      groups += 1;
      lacks = true;
    };
    instead('addMerged', addMerged, note);
    instead('add', add, note);
    instead('draw', draw, () => {
      draws += 1;
      lacks = false;
    });
    ShadowMasks.prototype.planAhead = function (...given) {
      const isDone = planAhead.apply(this, given);
      late += 10;
      plans += !isDone;
      return isDone;
    };
    const { setTimeout: original } = window, { data } = Object.getOwnPropertyDescriptors(MessageEvent.prototype);
    let answers = 0;
    Object.defineProperty(MessageEvent.prototype, 'data', { ...data, get() {
      answers += 1;
      return data.get.call(this);
    } });
    window.setTimeout = (act, wait, ...given) => {
      const asFrames = groups > 0 && shadows.cost.pending > 0 && wait >= 16 && wait < 1000, had = answers; // a worker's end takes longer
      return original(() => {
        waits += asFrames && answers === had; // or it was a worker that was waited for
        act();
      }, wait, ...given);
    };
    scene.add(building(900, { width: 6 }));
    let frames = 0;
    do {
      if (frames < 4) early = draws;
      const before = groups;
      await frame();
      const added = groups, planned = plans, drawn = draws;
      shadows.render(scene, camera);
      both += (groups > added || plans > planned) && draws > drawn;
      frames += groups > before;
      if (frames !== 4 || moved !== null) continue;
      const since = draws;
      box.position.y += 0.2;
      shadows.render(scene, camera);
      moved = draws - since;
    } while (shadows.cost.pending > 0);
    window.setTimeout = original;
    Object.defineProperty(MessageEvent.prototype, 'data', data);
    const told = { draws, groups, frames, moved, lacks, early, waits, both, plans };
    Object.assign(ShadowMasks.prototype, { draw, add, addMerged, planAhead, buildLookup });
    Performance.prototype.now = now;
    return told;
  });
  console.log(told);
  assert.ok(told.frames >= 8, `groups are added in ${told.frames} frames`);
  assert.ok(told.draws <= told.frames / 2, `${told.draws} draws of masks`);
  assert.equal(told.early, 0, 'the light is looked up until all of them are there');
  assert.ok(told.waits <= told.groups / 4, `${told.waits} of ${told.groups} steps wait for a frame`);
  assert.equal(told.moved, 1, 'what moves meanwhile is drawn in that very frame');
  assert.ok(!told.lacks, 'the last masks have them all');
  assert.ok(told.plans >= 2, `masks are planned in ${told.plans} steps`);
  assert.equal(told.both, 0, 'no frame that adds meshes or plans their masks for 8 ms draws these');
  await shared.check(page);
});

test('the worker of maps starts while meshes are prepared', async () => {
  const page = await openThree(shared);
  const told = await page.evaluate(async () => {
    const { yard, ExactShadows, cameraOf, frame } = window.page;
    const { building } = await import('/tests/building.js');
    const { renderer, scene } = yard({ width: 80, height: 60 });
    const camera = cameraOf({ from: [9, 8, 10], to: [0, 0.6, 0], fov: 50 }, 4 / 3);
    scene.add(building(300, { width: 6 }));
    const shadows = new ExactShadows(renderer).add(scene), sent = [], { postMessage } = Worker.prototype;
    Worker.prototype.postMessage = function (message, ...given) {
      if (!message.meshes) sent.push({ task: Boolean(message.task), pending: shadows.cost.pending > 0 });
      return postMessage.call(this, message, ...given);
    };
    while (!sent.some(({ task }) => task)) {
      await frame();
      shadows.render(scene, camera);
    }
    Worker.prototype.postMessage = postMessage;
    return sent;
  });
  assert.deepEqual(told, [{ task: false, pending: true }, { task: true, pending: false }]);
  await shared.check(page);
});

test("programs of masks are taken over once the GPU's compiler and its draws are done, and all of them before the first masks", async () => {
  const page = await openThree(shared);
  const told = await page.evaluate(async () => {
    const { yard, ExactShadows, cameraOf, drawn, frame } = window.page;
    const { building } = await import('/tests/building.js');
    const { renderer, scene } = yard({ width: 80, height: 60 });
    const camera = cameraOf({ from: [9, 8, 10], to: [0, 0.6, 0], fov: 50 }, 4 / 3);
    const gl = renderer.getContext(), extension = 'KHR_parallel_shader_compile', COMPLETION_STATUS_KHR = 0x91B1;
    renderer.render(scene, camera); // three.js's own programs
    const programs = new Map(), early = [];
    let compiles = true, draws = true, looks = 0;
    const instead = (name, act) => { gl[name] = (...given) => act(() => WebGL2RenderingContext.prototype[name].apply(gl, given), ...given); };
    const isOurs = (program) => gl.getAttachedShaders(program).some((shader) => gl.getShaderSource(shader).startsWith('#version 100'));
    instead('linkProgram', (link, program) => {
      if (isOurs(program)) programs.set(program, { isCompleted: false });
      link();
    });
    // The extension is this page's own: software renderers lack it.
    instead('getSupportedExtensions', (ask) => [...new Set([...ask(), extension])]);
    instead('getExtension', (ask, name) => (name === extension ? { COMPLETION_STATUS_KHR } : ask()));
    for (const name of ['getProgramParameter', 'getActiveUniform', 'getUniformLocation']) {
      instead(name, (ask, program, parameter) => {
        const of = programs.get(program);
        if (!of) return ask();
        if (name !== 'getProgramParameter' || parameter !== COMPLETION_STATUS_KHR) {
          if (!of.isCompleted || draws) early.push(name);
          return ask();
        }
        looks += 1;
        of.isCompleted = !compiles;
        return of.isCompleted;
      });
    }
    instead('getSyncParameter', (ask) => (draws ? gl.UNSIGNALED : ask()));
    const shadows = new ExactShadows(renderer, { lookups: 0 }).add(scene);
    const stages = [];
    const stage = async (frames) => {
      for (let i = 0; i < frames; ++i) {
        await frame();
        shadows.render(scene, camera);
      }
      stages.push({ programs: programs.size, looks, early: early.length, masks: (shadows.cost?.vertexRuns ?? 0) > 0 });
    };
    while (!shadows.cost) await frame();
    await stage(5);
    draws = false;
    await stage(5);
    compiles = false;
    await drawn(shadows, scene, camera);
    await stage(1);
    scene.add(building(60, { width: 6 }));
    await drawn(shadows, scene, camera);
    await stage(1);
    return { stages, error: gl.getError() };
  });
  const [drawing, compiling, ready, more] = told.stages;
  assert.ok(drawing.programs > 10 && !drawing.masks, 'all are begun at once, while pictures come without masks');
  assert.ok(compiling.looks > drawing.looks && !compiling.masks, `${compiling.looks} looks at their completion`);
  assert.ok(ready.masks && more.masks);
  assert.deepEqual([compiling.early, ready.early, more.early], [0, 0, 0], 'nothing is asked of a program before');
  assert.equal(ready.programs, drawing.programs, 'the first masks compile no others');
  assert.equal(more.programs, drawing.programs, 'closed meshes take no others');
  assert.equal(told.error, 0);
  await shared.check(page);
});

test('without KHR_parallel_shader_compile masks come as well', async () => {
  const page = await openThree(shared);
  const told = await page.evaluate(async () => {
    const { yard, ExactShadows, cameraOf, drawn } = window.page;
    const { renderer, scene } = yard({ width: 80, height: 60 });
    const gl = renderer.getContext(), lacking = 'KHR_parallel_shader_compile';
    gl.getSupportedExtensions = () => WebGL2RenderingContext.prototype.getSupportedExtensions.call(gl).filter((name) => name !== lacking);
    gl.getExtension = (name) => (name === lacking ? null : WebGL2RenderingContext.prototype.getExtension.call(gl, name));
    const shadows = new ExactShadows(renderer).add(scene);
    await drawn(shadows, scene, cameraOf({ from: [9, 8, 10], to: [0, 0.6, 0], fov: 50 }, 4 / 3));
    return { runs: shadows.cost.vertexRuns, error: gl.getError() };
  });
  assert.ok(told.runs > 0);
  assert.equal(told.error, 0);
  await shared.check(page);
});

for (const release of releases)
  test(`${release}: the first frame compiles nothing after compileAsync() and ready()`, async () => {
    const page = await openThree(shared, release);
    const told = await page.evaluate(async () => {
      const { yard, three, ExactShadows, cameraOf } = window.page;
      const { renderer, scene, mesh } = yard({ width: 80, height: 60 });
      const camera = cameraOf({ from: [9, 8, 10], to: [0, 0.6, 0], fov: 50 }, 4 / 3);
      const behind = mesh(new three.BoxGeometry()); // no frame draws it
      behind.material = new three.MeshPhongMaterial();
      behind.receiveShadow = true;
      behind.position.set(40, 30, 50);
      scene.add(behind);
      const gl = renderer.getContext(), { linkProgram } = gl, linked = [];
      gl.linkProgram = (program) => {
        linked.push(gl.getAttachedShaders(program).map((shader) => gl.getShaderSource(shader)).join(''));
        linkProgram.call(gl, program);
      };
      // A compiler that tells when it is done, after two questions for each program.
      const { getExtension, getProgramParameter } = gl, asked = new Map(), status = 0x91B1; // COMPLETION_STATUS_KHR
      gl.getExtension = (name) => (name === 'KHR_parallel_shader_compile' ? { COMPLETION_STATUS_KHR: status } : getExtension.call(gl, name));
      gl.getProgramParameter = (program, name) => {
        if (name !== status) return getProgramParameter.call(gl, program, name);
        asked.set(program, (asked.get(program) ?? 0) + 1);
        return asked.get(program) > 2;
      };
      const shadows = new ExactShadows(renderer).add(scene);
      await shadows.compileAsync(scene, camera);
      const awaited = [...asked.values()].filter((count) => count > 2).length;
      const patched = linked.filter((source) => source.includes('edgeshade')).length;
      await shadows.ready();
      const ahead = linked.length;
      shadows.render(scene, camera);
      const first = linked.splice(0), { vertexRuns } = shadows.cost;
      // A new material that only later frames would draw: ready() compiles it, too.
      const later = mesh(new three.BoxGeometry());
      later.material = new three.MeshToonMaterial();
      later.receiveShadow = true;
      later.position.set(40, 30, 50);
      scene.add(later);
      shadows.render(scene, camera);
      const drawn = linked.length;
      await shadows.ready();
      const ready = linked.length;
      later.position.set(1, 0.5, 1);
      shadows.render(scene, camera);
      return { patched, awaited, ahead, first: first.length, vertexRuns, drawn, ready, after: linked.length, error: gl.getError() };
    });
    console.log(told);
    assert.ok(told.patched >= 2, 'materials are compiled with their shadows, those out of sight, too');
    assert.ok(told.awaited >= (release === 'three-0.152' ? 0 : 2), 'compileAsync() waits for them where three.js can');
    assert.equal(told.first, told.ahead, 'the first frame compiles nothing');
    assert.ok(told.vertexRuns > 0, 'and has its shadows');
    assert.deepEqual([told.ready - told.drawn, told.after - told.ready, told.error], [1, 0, 0]);
    await shared.check(page);
  });

/** Makes the page's clock go on by this many milliseconds at each look at it. */
const slowClock = (milliseconds) => {
  let late = 0;
  const { now } = Performance.prototype;
  Performance.prototype.now = function () { return now.call(this) + (late += milliseconds); };
};

test("a map's casters are copied in steps, and stay those of the first one", async () => {
  const page = await openThree(shared);
  const told = await page.evaluate(async (slow) => {
    const { three } = window.page;
    const { ShadowMasks } = await import('/masks/shadow-masks.js');
    const masks = await ShadowMasks.create(document.createElement('canvas').getContext('webgl2'));
    const { index, attributes } = new three.TorusKnotGeometry(1, 0.4, 600, 80);
    const knot = await masks.prepare({ positions: attributes.position.array, indices: index.array });
    const { elements } = new three.Matrix4();
    const [first] = [masks.add(knot, elements), masks.add(knot, elements)];
    const light = { direction: [0.2, -1, 0.1] }, options = { restMs: 0 };
    const likeness = (id) => {
      const { bytes, longestList, begins } = masks.lookup(id);
      return [bytes, longestList, ...begins];
    };
    const whole = likeness(await masks.buildLookup(light, options));
    const parts = [], { postMessage } = Worker.prototype, { setTimeout: original } = window;
    let steps = 1;
    Worker.prototype.postMessage = function (message, ...given) {
      if (message.task) parts.push(...message.task.map(({ byteLength }) => byteLength));
      return postMessage.call(this, message, ...given);
    };
    window.setTimeout = (...given) => {
      steps += parts.length === 0;
      return original(...given);
    };
    (0, eval)(`(${slow})`)(5);
    const cancelled = new AbortController(), none = masks.buildLookup(light, { ...options, signal: cancelled.signal });
    cancelled.abort();
    const stopped = await none === null && parts.length === 0;
    steps = 1;
    const building = masks.buildLookup(light, options);
    masks.remove(first);
    const id = await building, { holds } = masks.lookupState(id, light);
    return { parts, steps, whole, meanwhile: likeness(id), holds, stopped };
  }, slowClock.toString());
  console.log(told);
  assert.ok(told.parts.length > 8 && told.parts.every((bytes) => bytes <= 2 ** 18), `${told.parts}`);
  assert.ok(told.steps >= told.parts.length / 3, `${told.steps} steps of ${told.parts.length} parts`);
  assert.deepEqual(told.meanwhile, told.whole);
  assert.ok(!told.holds && told.stopped);
  await shared.check(page);
});

test('many new meshes are read in steps, and those that go meanwhile are gone', async () => {
  const page = await openThree(shared);
  const told = await page.evaluate(async (slow) => {
    const { yard, ExactShadows, cameraOf, drawn, frame } = window.page;
    const { building } = await import('/tests/building.js');
    const { renderer, scene } = yard({ width: 80, height: 60 });
    const camera = cameraOf({ from: [9, 8, 10], to: [0, 0.6, 0], fov: 50 }, 4 / 3);
    const shadows = new ExactShadows(renderer, { lookups: 0 }).add(scene);
    await drawn(shadows, scene, camera);
    const model = building(1200), read = new Set(), steps = [];
    for (const { geometry } of model.children) {
      const { drawRange } = geometry;
      Object.defineProperty(geometry, 'drawRange', { get: () => read.add(geometry) && drawRange });
    }
    scene.add(model);
    (0, eval)(`(${slow})`)(0.1);
    for (let before = 0; before < 1190 && steps.length < 100; before = read.size) {
      shadows.beginMasks(scene, camera);
      shadows.endMasks();
      steps.push(read.size - before);
      if (steps.length === 1) {
        steps.pending = shadows.cost.pending;
        model.remove(...model.children.slice(-10));
      }
      await frame();
    }
    shadows.render(scene, camera);
    await shadows.ready();
    return { steps: [...steps], first: steps.pending, pending: shadows.cost.pending };
  }, slowClock.toString());
  console.log(told);
  assert.ok(Math.max(...told.steps) <= 400, `${told.steps} meshes in steps`);
  assert.ok(told.steps.length > 1);
  assert.deepEqual([told.first, told.pending], [1200, 0]);
  await shared.check(page);
});

test('open meshes are added once the programs of their masks are there', async () => {
  const page = await openThree(shared);
  const told = await page.evaluate(async () => {
    const { three, yard, ExactShadows, cameraOf, rested, frame } = window.page;
    const { renderer, scene, ground } = yard({ width: 80, height: 60 });
    const camera = cameraOf({ from: [9, 8, 10], to: [0, 0.6, 0], fov: 50 }, 4 / 3);
    const shadows = new ExactShadows(renderer).add(scene);
    await rested(shadows, scene, camera);
    const { ShadowMasks } = await import('/masks/shadow-masks.js'), { draw } = ShadowMasks.prototype;
    const gl = renderer.getContext(), { getProgramParameter } = gl;
    let drawing = false, asked = 0, masked = 0, errors = 0;
    gl.getError = () => {
      errors += 1;
      return gl.NO_ERROR;
    };
    ShadowMasks.prototype.draw = function (...given) {
      drawing = true;
      masked += 1;
      try {
        return draw.apply(this, given);
      } finally {
        drawing = false;
      }
    };
    gl.getProgramParameter = (...given) => {
      asked += drawing && given[1] !== gl.DELETE_STATUS; // which the browser knows itself
      return getProgramParameter.apply(gl, given);
    };
    for (let i = 0; i < 400; ++i) {
      const sheet = new three.Mesh(new three.PlaneGeometry(0.3, 0.3, 2, 2), ground.material);
      sheet.position.set(0.4 * (i % 20) - 4, 1 + 0.05 * Math.floor(i / 20), 0.4 * Math.floor(i / 20) - 4);
      sheet.rotation.x = -1;
      sheet.castShadow = sheet.receiveShadow = true;
      scene.add(sheet);
    }
    const had = [];
    for (let i = 0; i < 2 || shadows.cost.pending > 0; ++i) {
      await frame();
      shadows.render(scene, camera);
      had.push(shadows.cost.lookedUp);
    }
    const questions = errors;
    for (let i = 0; i < 3; ++i) shadows.render(scene, camera);
    const isLookedUp = await rested(shadows, scene, camera);
    return { asked, masked, had, isLookedUp, questions };
  });
  console.log(told);
  assert.ok(told.masked > 0);
  assert.equal(told.asked, 0, 'no masks wait for a program');
  assert.equal(told.questions, 0, 'nor does anything wait for pending draws to tell their errors');
  assert.ok(told.had.every((count) => count === 1), 'shadows stay meanwhile');
  await shared.check(page);
});
