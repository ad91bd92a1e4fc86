// How building models start in a page of three.js: tasks above 50 ms, and when all meshes have their
// shadows, and when the light is looked up, with edgeshade, with three.js's own map, and without
// shadows, in turns. Each run has a page of its own. Prints JSON. Needs build/web and `npm ci`. With
// edgeshade it also tells edgeshade's own share of each task, and its longest steps, by the clock and by the processor
// time of the page's thread: a busy machine takes the processor away within steps. On Linux it tells the processor time of
// that thread and of each worker, oldest first.
//
//   node compare/starts.mjs [--turns 3] [--opens] [--draws-nothing] [--only edgeshade] [MODEL...]
//
// A MODEL is an address below the served folders, as /shared/hospital-electrical.glb, or a number of
// meshes to draw in code. `--opens`: the page opens with the model; otherwise a page that runs gets it.
// `--draws-nothing`: the GL's drawing calls do nothing, so that the page's thread and the workers are measured as on a
// graphics card that keeps up; else all is drawn in software.

import { readdirSync, readFileSync } from 'node:fs';
import { loadavg } from 'node:os';
import { parseArgs } from 'node:util';
import { launchChromium } from '../tests/support/chromium.mjs';
import { serve } from '../tests/support/server.mjs';

/** Models of `../shared/scenes`, and one drawn in code. */
const models = ['/shared/hospital-electrical.glb', '3000', '/shared/city.draco.glb'];

/**
 * In the page: adds the model, and draws until its light is looked up, at most 60 s, or for 3 s with the
 * other methods. Times are milliseconds since then; `tasks`: those above 50 ms, as browsers report them.
 */
async function measured({ name, method, opens, drawsNothing }) {
  const { three, loaded, whiten, rendererOf, lampOf, ExactShadows, rested, frame, rendererName } = window.page;
  const { building, viewOf } = await import('/tests/building.js');
  const { watchSteps } = await import('/tests/own-steps.js');
  const { steps, map, follow } = watchSteps();
  const model = name.startsWith('/') ? await loaded(name) : building(Number(name));
  const renderer = rendererOf({ width: 320, height: 180 });
  if (drawsNothing) (await import('/tests/null-gl.js')).drawNothing(renderer.getContext());
  renderer.shadowMap.enabled = method === 'map';
  const scene = new three.Scene();
  const [light, target] = lampOf({ kind: 'DirectionalLight', position: [0.5, 1, -0.3] });
  const { camera, bounds, middle, size } = viewOf(model);
  const sun = light.position.clone().setLength(size);
  light.position.copy(middle).add(sun);
  target.position.copy(middle);
  Object.assign(light.shadow.camera, { left: -size, right: size, bottom: -size, top: size, far: 3 * size });
  light.shadow.mapSize.set(1024, 1024);
  const box = new three.Mesh(new three.BoxGeometry(size / 9, size / 9, size / 9), new three.MeshStandardMaterial());
  box.castShadow = box.receiveShadow = true;
  box.position.copy(bounds.max);
  scene.add(light, target, box);
  whiten(scene);
  let meshes = 0;
  model.traverse((object) => {
    if (!object.isMesh) return;
    meshes += 1;
    object.material = box.material;
  });
  const isOurs = method === 'edgeshade';
  const open = () => (isOurs ? follow(new ExactShadows(renderer).add(scene)) : { render: () => renderer.render(scene, camera) });
  let shadows = null;
  if (!opens) {
    shadows = open();
    if (isOurs) await rested(shadows, scene, camera);
    else for (let i = 0; i < 5; ++i, await frame()) shadows.render(scene, camera);
    await new Promise((resolve) => { setTimeout(resolve, 1000); });
  }
  const tasks = [];
  const observer = new PerformanceObserver((list) => tasks.push(...list.getEntries()));
  observer.observe({ entryTypes: ['longtask'] });
  await frame();
  const since = performance.now();
  scene.add(model);
  shadows ??= open();
  let thereMs = null, lookedUpMs = null, frames = 0;
  for (let now = 0; isOurs ? lookedUpMs === null && now < 60000 : now < 3000;) {
    await frame();
    shadows.render(scene, camera);
    frames += 1;
    now = performance.now() - since;
    const { pending } = shadows.cost ?? { pending: 1 };
    if (pending === 0) thereMs ??= now;
    if (pending === 0 && shadows.lights[0]?.method === 'lookup') lookedUpMs = now;
  }
  await frame();
  tasks.push(...observer.takeRecords());
  const later = tasks.filter(({ startTime, duration }) => startTime + duration > since);
  const mine = steps.map((step, index) => ({ ...step, index })).filter(({ at }) => at >= since);
  const ownIn = (from, to) => steps.reduce((sum, { at, ms }) => sum + Math.max(0, Math.min(at + ms, to) - Math.max(at, from)), 0);
  return { renderer: rendererName(), meshes, frames, thereMs, mapAskedMs: map.askedAt && map.askedAt - since,
    mapCameMs: map.cameAt && map.cameAt - since, lookedUpMs, ownMs: mine.reduce((sum, { ms }) => sum + ms, 0),
    steps: mine.map(({ at, ...step }) => ({ ...step, at: at - since })),
    tasks: later.map(({ startTime, duration }) => ({ at: Math.round(startTime - since), ms: Math.round(duration),
      own: Math.round(ownIn(startTime, startTime + duration)) })) };
}

/** Calls act(), and returns {result, processorMs: of the page's thread in each step of watchSteps(), by index}. */
async function traced(browser, act) {
  const session = await browser.newBrowserCDPSession(), events = [];
  session.on('Tracing.dataCollected', ({ value }) => events.push(...value));
  await session.send('Tracing.start', { transferMode: 'ReportEvents', traceConfig: { includedCategories: ['blink.user_timing'] } });
  const result = await act();
  const ended = new Promise((resolve) => { session.once('Tracing.tracingComplete', resolve); });
  await session.send('Tracing.end');
  await ended;
  await session.detach();
  const at = new Map(events.map(({ name, tts }) => [name, tts])), processorMs = [];
  for (let i = 0; at.has(`end ${i}`); ++i) processorMs.push((at.get(`end ${i}`) - at.get(`begin ${i}`)) / 1000);
  return { result, processorMs };
}

/** The longest of some steps, for people. */
const longestOf = (steps, by) => steps.toSorted((a, b) => b[by] - a[by]).slice(0, 6)
  .map((step) => `${step.what} ${Math.round(step.at)}: ${step[by].toFixed(1)}`);

/** Ticks of the processor in a second, as Linux counts them in /proc. */
const ticksPerSecond = 100;

/** Seconds of processor time so far of the page's thread and its workers, oldest first: {name, seconds} by thread. */
async function threadsOf(browser) {
  const session = await browser.newBrowserCDPSession();
  const { processInfo } = await session.send('SystemInfo.getProcessInfo');
  await session.detach();
  const threads = new Map();
  for (const { id } of processInfo.filter(({ type }) => type === 'renderer'))
    for (const thread of readdirSync(`/proc/${id}/task`)) {
      const [, name, numbers] = readFileSync(`/proc/${id}/task/${thread}/stat`, 'utf8').match(/\((.*)\) (.*)/);
      const [user, system] = numbers.split(' ').slice(11, 13);
      if (name.startsWith('Dedicated') || thread === String(id))
        threads.set(thread, { name: name.startsWith('Dedicated') ? 'worker' : 'page', seconds: (Number(user) + Number(system)) / ticksPerSecond });
    }
  return threads;
}

const { values: options, positionals } = parseArgs({ allowPositionals: true, options: {
  turns: { type: 'string', default: '3' },
  opens: { type: 'boolean', default: false },
  'draws-nothing': { type: 'boolean', default: false },
  only: { type: 'string' },
} });
const methods = options.only ? [options.only] : ['edgeshade', 'map', 'none'];
const { opens, 'draws-nothing': drawsNothing } = options;
const server = await serve(), browser = await launchChromium({ composites: !drawsNothing });
const runs = [];
try {
  for (let turn = 0; turn < Number(options.turns); ++turn)
    for (const name of positionals.length ? positionals : models)
      for (const method of methods) {
        const page = await browser.newPage();
        await page.goto(`${server.address}/tests/three.html?three=three`);
        await page.waitForFunction(() => window.page);
        const before = await threadsOf(browser);
        const { result: { tasks, steps, ...others }, processorMs } =
          await traced(browser, () => page.evaluate(measured, { name, method, opens, drawsNothing }));
        const timed = steps.map((step) => ({ ...step, processorMs: processorMs[step.index] ?? 0 }));
        const processorSeconds = [...await threadsOf(browser)].map(([thread, { name: of, seconds }]) =>
          `${of} ${(seconds - (before.get(thread)?.seconds ?? 0)).toFixed(2)}`);
        const longestSteps = longestOf(timed, 'ms'), longestByProcessor = longestOf(timed, 'processorMs');
        const durations = tasks.map(({ ms }) => ms);
        runs.push({ model: name, method, load: loadavg()[0], ...others, longestSteps, longestByProcessor, processorSeconds, above50: tasks.length, longest: Math.max(0, ...durations),
          ownAbove50: tasks.filter(({ own }) => own > 50).length, longestOwn: Math.max(0, ...tasks.map(({ own }) => own)),
          tasks: tasks.map(({ at, ms, own }) => `${at}: ${ms} (${own})`).join(', ') });
        await page.close();
      }
} finally {
  await browser.close();
  await server.close();
}
console.log(JSON.stringify({ opens, drawsNothing, runs }, null, 2));
