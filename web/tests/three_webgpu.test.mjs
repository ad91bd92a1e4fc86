// edgeshade/three-webgpu: lights at rest in a WebGPURenderer are looked up as in a WebGLRenderer, pixel
// for pixel.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { requireFloats, requireRelease } from '../three-webgpu/requirements.js';
import { useBrowser } from './support/browser.mjs';
import { isLong } from './support/long.mjs';
import { blocksOf } from './support/readme.mjs';

const shared = useBrowser({ webGpu: true, sharesPages: true });

/** Runs `act(page, given)` with the tools of pages/three-webgpu.js in a page. Returns its result. */
async function inPage(act, given, allowed = []) {
  const page = await shared.open('/tests/three-webgpu.html', { scene: false, size: { width: 400, height: 300 }, haste: 3 });
  await page.waitForFunction(() => window.page);
  const told = await page.evaluate(async ([text, value]) => (0, eval)(`(${text})`)(await import('/tests/three-webgpu.js'), value), [act.toString(), given]);
  const { reports } = page;
  await shared.check(page, allowed);
  return allowed.length ? { told, reports } : told;
}

const sun = ['DirectionalLight', [0.5, 1, -0.3]];

/** Pictures of a scene by back ends beside the other adapter's. */
async function backendsDiffer(tools, { scene: name, lights, backends }) {
  const results = {};
  const { camera, scene, options, place = scene, tintOf } = await tools.sceneOf(name);
  for (const light of lights) place.add(...tools.lampOf(...light));
  const lamp = place.getObjectByProperty('isLight', true);
  const pictures = {};
  for (const backend of ['WebGLRenderer', ...backends]) {
    pictures[backend] = await tools.lookedUp(backend, scene, camera, { lights: lights.length, ...options });
    const { lookedUp, channels, methods } = pictures[backend];
    const { places, ...counts } = tools.compared(pictures.WebGLRenderer.channels, channels, options?.at);
    results[backend] = { lookedUp, methods, ...counts, unexplained: tools.onNoBorder(scene, camera, places).length,
      ...(tintOf && backend === 'WebGPU' && { rays: tools.comparedTints(channels, options.at, scene, camera, lamp, tintOf) }) };
  }
  return results;
}

/** Scenes that WebGPURenderer's back end of WebGL draws, too: both have their shaders from the same nodes. */
const withBoth = ['far yard'];

/**
 * Scenes, their lights, how many pixels may differ, and how many of these beyond edges: rounding of vertices and
 * depths moves outlines, and shows another one of coinciding surfaces.
 */
for (const [name, [lights, most, mostBeyond]] of Object.entries({
  'far yard': [[sun, ['PointLight', [0.4, 2.6, 0.7]]], 0, 0],
  pavilion: [[['DirectionalLight', [-0.62, 0.62, -0.3]]], 16, 2],
  instances: [[['PointLight', [1.5, 2.4, 1.2]]], 0, 0],
  ...(isLong && { yard: [[sun], 0, 0], panes: [[sun], 0, 0], leaves: [[sun], 0, 0], sheets: [[['DirectionalLight', [0.1, 1, 0.2]]], 0, 0] }), // the far yard and stained panes have all
  stained: [[['PointLight', [0.3, 3.6, 0.4]]], 0, 0],
  'soft yard': [[['PointLight', [0.4, 2.6, 0.7]]], 0, 0],
  lamps: [[['SpotLight', [0.5, 5, 1.5]], ['PointLight', [0.4, 1.6, 0.7]]], 0, 0],
}))
  test(`${name}: ${lights.map(([kind]) => kind)} looked up as by the other adapter`, async () => {
    const { WebGLRenderer, ...others } = await inPage(backendsDiffer, { scene: name, lights, backends: isLong || withBoth.includes(name) ? ['WebGL', 'WebGPU'] : ['WebGPU'] });
    console.log(name, { WebGLRenderer, ...others });
    assert.equal(WebGLRenderer.lookedUp, lights.length);
    const leastGrey = { panes: 2000, sheets: 800, stained: 400, 'soft yard': 100 }[name] ?? 0; // panes tint, and soft shadows have borders
    assert.ok(WebGLRenderer.grey >= leastGrey, `${WebGLRenderer.grey} pixels are grey`);
    assert.ok(WebGLRenderer.shadow > 1000 && WebGLRenderer.lit > 2000, 'the picture has light and shadow');
    for (const [backend, { lookedUp, differ, beyond, unexplained, rays }] of Object.entries(others)) {
      assert.equal(lookedUp, lights.length, backend);
      assert.ok(differ <= most, `${differ} pixels of ${backend} differ`);
      assert.ok(beyond <= mostBeyond, `${beyond} pixels of ${backend} differ that are on no edge`);
      assert.equal(unexplained, 0, `pixels of ${backend} that are on no border by rays either`);
      if (!rays) continue;
      assert.ok(rays.compared > 4000 && rays.tinted > 400, `${rays.compared} pixels, ${rays.tinted} of them tinted`);
      assert.ok(rays.beyond <= 2 && rays.wrong <= 0.04 * rays.compared, `${rays.wrong} of ${rays.compared} pixels are wrong by rays, ${rays.beyond} of them beyond outlines`);
    }
  });

test('signs of sums that all but cancel are exact in both back ends, though not in floats', async () => {
  const told = await inPage(async ({ rendererOf }) => {
    const { exactSigns } = await import('/tests/exact-signs.js');
    return { WebGL: await exactSigns(await rendererOf('WebGL')), WebGPU: await exactSigns(await rendererOf('WebGPU')) };
  });
  console.log(told);
  for (const { count, wrong, mirrored, inFloats } of Object.values(told)) {
    assert.deepEqual([wrong, mirrored], [0, 0]);
    assert.ok(inFloats > 0.02 * count, `${inFloats} of ${count} are wrong in floats`);
  }
});

test('movers have the shadows of three.js\'s own map, until another map holds them', async () => {
  const told = await inPage(async (tools) => {
    const results = {};
    for (const backend of ['WebGL', 'WebGPU']) {
      const renderer = await tools.rendererOf(backend);
      const { scene, camera } = await tools.sceneOf('yard');
      scene.add(...tools.lampOf('DirectionalLight', [2.5, 5, -1.5]));
      const shadows = tools.shadowsOf(renderer).add(scene);
      const methods = [shadows.lights.length];
      shadows.render(scene, camera);
      methods.push(shadows.lights[0].method);
      await tools.rested(shadows, scene, camera);
      methods.push(shadows.lights[0].method);
      const before = await tools.redOf(renderer, () => shadows.render(scene, camera));
      const ball = tools.meshOf(new tools.three.SphereGeometry(0.5, 16, 12), tools.white(), [-0.5, 1.2, 2.2]);
      ball.geometry.computeBoundingSphere();
      scene.add(ball);
      shadows.render(scene, camera);
      await shadows.ready();
      await tools.nextFrame();
      ball.position.x += 0.4; // it moves from now on
      const after = await tools.redOf(renderer, () => shadows.render(scene, camera));
      methods.push(shadows.lights[0].method);
      const { x, y } = new tools.three.Vector3(-0.1 - 0.5 * 1.2, 0, 2.2 + 0.3 * 1.2).project(camera); // below the ball, along the light
      const { width, height } = tools.size;
      const at = Math.floor((0.5 - 0.5 * y) * height) * width + Math.floor((0.5 + 0.5 * x) * width);
      results[backend] = { methods, before: before[at], after: after[at] };
      shadows.dispose();
    }
    return results;
  });
  console.log(told);
  for (const { methods, before, after } of Object.values(told)) {
    assert.deepEqual(methods, [0, 'map', 'lookup', 'lookup and movers']);
    assert.ok(before > 200 && after < 100, `${before}, then ${after} below the ball`);
  }
});

test('above a resting light three.js draws the mover alone, and lights say what they have, and why', async () => {
  const told = await inPage(async (tools) => {
    const { three } = tools, at = { width: 160, height: 120 };
    const { scene, box } = tools.yard(), camera = tools.cameraOf(tools.yardView), renderer = await tools.rendererOf('WebGL', at);
    const pane = tools.meshOf(new three.PlaneGeometry(1, 1), new three.MeshLambertMaterial({ transparent: true, opacity: 0.5, colorWrite: false, depthWrite: false }), [1.5, 2, 1.5]);
    pane.rotation.x = -1.5;
    const [light, target] = tools.lampOf('DirectionalLight', [2.5, 5, -1.5]);
    scene.add(pane, light, target);
    const shadows = tools.shadowsOf(renderer, { transparentCast: 'tint' }).add(scene), ways = {};
    /** Draws while act() changes things, for some of the page's milliseconds or until a light has this reason. */
    const draws = async (step, wanted, act = () => {}) => {
      const had = ways[step] = new Set();
      for (const since = Date.now(); Date.now() - since < 60000 && !had.has(wanted);) {
        act();
        shadows.render(scene, camera);
        const [{ method, reason }] = shadows.lights;
        had.add(`${method}: ${reason}`);
        await new Promise((resolve) => { setTimeout(resolve, 100); });
      }
      await tools.nextFrame(); // the last one's map may be of all casters
      return tools.redOf(renderer, () => shadows.render(scene, camera));
    };
    const whole = 'lookup: it rests, and so do all casters', untinted = 'see-through casters that tint nothing meanwhile: 1';
    await draws('start', whole);
    await new Promise((resolve) => { setTimeout(resolve, 5000); }); // a map after one that ended leaves out what has rested for less
    const moving = await draws('box moves', "lookup and movers: three.js's own map has the casters that came or moved lately: 1", () => { box.position.x += 0.01; });
    const exact = await draws('box rests', whole);
    await draws('pane moves', `lookup and movers: it rests, and other casters, too; ${untinted}`, () => { pane.position.x += 0.01; });
    await draws('pane rests', whole);
    await draws('light moves', `map: it has moved within half a second; ${untinted}`, () => { light.position.x += 0.01; });
    // The mover's shadow is three.js's; others are exact.
    const ray = new three.Raycaster(), beam = new three.Ray(), told = { near: 0, far: 0 };
    beam.direction.set(2.5, 5, -1.5).normalize();
    for (const [i, red] of exact.entries()) {
      if (Math.abs(red - moving[i]) <= 2) continue;
      ray.setFromCamera(new three.Vector2(2 * (i % at.width + 0.5) / at.width - 1, 1 - 2 * (Math.floor(i / at.width) + 0.5) / at.height), camera);
      const [hit] = ray.intersectObjects(scene.children.filter((mesh) => mesh.isMesh && mesh !== pane), false);
      beam.origin.copy(hit.point);
      told[beam.distanceToPoint(box.position) < 1.2 ? 'near' : 'far'] += 1;
    }
    shadows.dispose();
    return { ...told, ways: Object.fromEntries(Object.entries(ways).map(([step, had]) => [step, [...had]])) };
  });
  console.log(told);
  assert.equal(told.far, 0, 'pixels that differ from exact ones away from the mover');
  assert.ok(told.near > 0, "the mover's shadow is three.js's");
  assert.ok(!told.ways['box moves'].some((way) => /lately: (?!1$)/.test(way)), 'no other caster has it');
  const last = Object.fromEntries(Object.entries(told.ways).map(([step, had]) => [step, had.at(-1)]));
  const whole = 'lookup: it rests, and so do all casters', untinted = 'see-through casters that tint nothing meanwhile: 1';
  assert.deepEqual(last, { start: whole, 'box moves': "lookup and movers: three.js's own map has the casters that came or moved lately: 1", 'box rests': whole,
    'pane moves': `lookup and movers: it rests, and other casters, too; ${untinted}`, 'pane rests': whole, 'light moves': `map: it has moved within half a second; ${untinted}` });
  assert.ok(told.ways['box moves'].includes(`map: casters have come, gone or started to move within half a second; ${untinted}`));
});

test('views of an ArrayCamera are looked up as by cameras of their own', async () => {
  const told = await inPage(async (tools) => {
    const { three } = tools, half = { width: 100, height: 120 };
    const cameras = [tools.cameraOf(tools.yardView, half), tools.cameraOf({ from: [-5, 3, 4], to: [0, 0.5, 0] }, half)];
    const counts = {};
    for (const backend of ['WebGL', 'WebGPU']) {
      const drawn = async (camera, at) => {
        const { scene } = tools.yard();
        scene.add(...tools.lampOf('DirectionalLight', [0.5, 1, -0.3]));
        return (await tools.lookedUp(backend, scene, camera, { at })).channels[0];
      };
      const single = [await drawn(cameras[0], half), await drawn(cameras[1], half)];
      for (const [i, camera] of cameras.entries()) camera.viewport = new three.Vector4(100 * i, 0, 100, 120);
      const both = await drawn(new three.ArrayCamera(cameras), { width: 200, height: 120 });
      for (const camera of cameras) delete camera.viewport;
      counts[backend] = single.map((red, view) => ({ dark: red.filter((value) => value < 20).length,
        differ: red.filter((value, i) => Math.abs(value - both[Math.floor(i / 100) * 200 + 100 * view + i % 100]) > 2).length }));
    }
    return counts;
  });
  console.log(told);
  for (const views of Object.values(told))
    for (const { dark, differ } of views) assert.ok(dark > 1000 && dark < 11000 && differ <= 2, `${differ} pixels differ, ${dark} are dark`);
});

test('a CubeCamera is updated with shadows in all of its sides', async () => {
  const told = await inPage(async (tools) => {
    const { three } = tools, at = { width: 48, height: 48 }, sides = {};
    for (const backend of ['WebGL', 'WebGPU']) {
      const renderer = await tools.rendererOf(backend, at), target = new tools.CubeRenderTarget(48), cube = new three.CubeCamera(0.1, 50, target);
      const { scene } = tools.yard();
      const [light, sunTarget] = tools.lampOf('DirectionalLight', [2.5, 5, -1.5]);
      cube.position.set(-0.4, 2.2, 1.2);
      scene.add(cube, light, sunTarget);
      const shadows = tools.shadowsOf(renderer).add(scene);
      await tools.rested(shadows, scene, cube);
      shadows.render(scene, cube);
      const darkOf = (rgba) => rgba.reduce((sum, value, i) => sum + (i % 4 === 0 && value < 20), 0);
      const sideOf = async (i) => darkOf(await renderer.readRenderTargetPixelsAsync(target, 0, 0, 48, 48, 0, i));
      sides[backend] = [];
      for (const [i, camera] of cube.children.entries()) {
        const cubeSide = await sideOf(i);
        renderer.setRenderTarget(new tools.RenderTarget(48, 48));
        shadows.render(scene, camera);
        const alone = darkOf(await renderer.readRenderTargetPixelsAsync(renderer.getRenderTarget(), 0, 0, 48, 48));
        sides[backend].push([cubeSide, alone]);
      }
      sides[backend].method = shadows.lights[0].method;
      shadows.dispose();
      light.castShadow = false;
      cube.update(renderer, scene);
      for (const [i, side] of sides[backend].entries()) side.push(await sideOf(i));
    }
    return { sides, methods: Object.values(sides).map(({ method }) => method) };
  });
  console.log(JSON.stringify(told));
  assert.deepEqual(told.methods, ['lookup', 'lookup']);
  for (const [backend, all] of Object.entries(told.sides)) {
    assert.equal(all.length, 6);
    for (const [cubeSide, alone] of all) assert.ok(Math.abs(cubeSide - alone) <= 4, `${backend}: ${cubeSide} and ${alone} pixels are dark`);
    assert.ok(all.some(([cubeSide, , unshadowed]) => cubeSide > unshadowed + 100), 'a side has shadows');
  }
});

test("the README's lines draw exact shadows, with a RenderPipeline, too", async () => {
  const [lines, pipelineLines] = blocksOf('`edgeshade/three-webgpu`', 'js');
  const { told } = await inPage(async (tools, { plain, piped }) => {
    navigator.gpu.requestAdapter = () => Promise.resolve(null); // Chromium has no canvas for SwiftShader's WebGPU
    const at = { width: 160, height: 120 }, { scene } = tools.yard(), camera = tools.cameraOf(tools.yardView, at);
    const [light, target] = tools.lampOf('DirectionalLight', [2.5, 5, -1.5]);
    scene.add(light, target);
    Object.assign(window, { scene, camera });
    const run = (text, names) => import(`data:text/javascript,${encodeURIComponent(`${text}\nexport { ${names} };`)}`);
    const { renderer, shadows } = await run(plain, 'renderer, shadows');
    renderer.setPixelRatio(1);
    renderer.setSize(at.width, at.height);
    await tools.rested(shadows, scene, camera);
    renderer.setAnimationLoop(null);
    const alone = await tools.redOf(renderer, () => shadows.render(scene, camera));
    Object.assign(window, { renderer, shadows });
    const { pipeline } = await run(piped, 'pipeline');
    await new Promise((resolve) => { setTimeout(resolve, 1000); }); // the loop draws
    renderer.setAnimationLoop(null);
    const followed = await tools.redOf(renderer, () => { shadows.update(scene, camera); pipeline.render(); });
    const rays = { localClippingEnabled: false, clippingPlanes: [], getContext: () => ({ drawingBufferWidth: at.width, drawingBufferHeight: at.height }) };
    const [{ method }] = shadows.lights;
    const judged = [alone, followed].map((red) => tools.comparedWithRays(red, rays, scene, camera, light));
    shadows.dispose();
    delete navigator.gpu.requestAdapter;
    return { method, judged };
  }, { plain: lines, piped: pipelineLines }, [/WebGPU is not available/]);
  console.log(told);
  assert.equal(told.method, 'lookup');
  for (const { surfaces, dark, beyond, wrong } of told.judged)
    assert.ok(surfaces > 8000 && dark > 1000 && beyond <= 1 && wrong <= 0.02 * surfaces, `${wrong} of ${surfaces} pixels are wrong, ${beyond} beyond outlines`);
});

test('a radius softens shadows until it is 0 again, and is three.js\'s own map while casters move', async () => {
  const told = await inPage(async (tools) => {
    const { scene, box } = tools.yard(), camera = tools.cameraOf(tools.yardView);
    const [light, target] = tools.lampOf('DirectionalLight', [2.5, 5, -1.5]);
    scene.add(light, target);
    const renderer = await tools.rendererOf('WebGL', { width: 80, height: 60 }), shadows = tools.shadowsOf(renderer, { lightSamples: 8 }).add(scene);
    const grey = async () => {
      await tools.rested(shadows, scene, camera);
      return (await tools.redOf(renderer, () => shadows.render(scene, camera))).reduce((sum, red) => sum + (red > 20 && red < 240), 0);
    };
    const steps = [];
    for (const radius of [0, 0.2, 0, 0.2]) {
      shadows.setRadius(light, radius);
      steps.push(await grey());
    }
    for (const since = performance.now(); performance.now() - since < 700;) { // after half a second a map may be begun
      box.position.x += 0.01;
      shadows.render(scene, camera);
      await shadows.ready();
    }
    const [{ method, reason }] = shadows.lights;
    shadows.dispose();
    return { steps, way: `${method}: ${reason}` };
  });
  console.log(told);
  const [none, some, again, last] = told.steps;
  assert.deepEqual([none, again, last], [0, 0, some]);
  assert.ok(some > 40, `${some} pixels are grey`);
  assert.equal(told.way, 'map: it has a radius, and casters have moved within half a second');
});

for (const backend of ['WebGL', 'WebGPU'])
  test(`a house that clipping groups cut open, looked up with ${backend}, as by rays`, async () => {
    const told = await inPage(async (tools, of) => {
      const { three } = tools, at = { width: 160, height: 100 };
      const { scene, outer, inner, material } = tools.house();
      const camera = tools.cameraOf({ from: [4.3, 6.1, 5.2], to: [0, 0.4, 0], fov: 50 }, at);
      const [light, target] = tools.lampOf('DirectionalLight', [2.7, 6, 2.22]);
      scene.add(light, target);
      const renderer = await tools.rendererOf(of, at);
      const told = {};
      const roofOff = new three.Plane(new three.Vector3(0.1, -1, 0.05).normalize(), 1.37), front = new three.Plane(new three.Vector3(-0.8, 0, -0.6), 1.1);
      inner.clippingPlanes = [front];
      outer.clippingPlanes = [roofOff];
      // Rays follow the material's planes, which a WebGPURenderer doesn't.
      const rays = { localClippingEnabled: true, clippingPlanes: [], getContext: () => ({ drawingBufferWidth: at.width, drawingBufferHeight: at.height }) };
      const judged = async (shadows, planes, settings) => {
        Object.assign(material, { clippingPlanes: planes, clipIntersection: outer.clipIntersection, clipShadows: inner.clipShadows }, settings);
        const red = await tools.redOf(renderer, () => shadows.render(scene, camera));
        return { ...tools.comparedWithRays(red, rays, scene, camera, light), method: shadows.lights[0].method };
      };
      const judge = async (name, planes, settings) => {
        const shadows = tools.shadowsOf(renderer).add(scene);
        await tools.rested(shadows, scene, camera);
        told[name] = await judged(shadows, planes, settings);
        return shadows;
      };
      (await judge('whole', [roofOff, front])).dispose();
      outer.clipShadows = inner.clipShadows = true;
      (await judge('cut', [roofOff, front])).dispose();
      outer.clipIntersection = inner.clipIntersection = true;
      (await judge('intersection', [roofOff, front])).dispose();
      outer.enabled = false;
      const shadows = await judge('inner alone', [front], { clipIntersection: false });
      front.constant -= 0.3; // a map of the other casters follows, and three.js's own of these
      for (const since = Date.now(); Date.now() - since < 60000 && shadows.lights[0].method !== 'lookup and movers';) {
        await new Promise((resolve) => { setTimeout(resolve, 100); });
        shadows.render(scene, camera);
      }
      await tools.nextFrame();
      told.moving = await judged(shadows, [front], { clipIntersection: false });
      shadows.dispose();
      return told;
    }, backend);
    console.log(told);
    const { moving, ...others } = told;
    for (const [name, { surfaces, dark, wrong, beyond, method }] of Object.entries(others)) {
      assert.equal(method, 'lookup', name);
      assert.ok(surfaces > 4000 && dark > 50, `${name}: ${surfaces} pixels of surfaces, ${dark} in shadow`);
      assert.ok(beyond <= 1 && wrong <= 0.02 * surfaces, `${name}: ${wrong} of ${surfaces} pixels are wrong, ${beyond} of them beyond outlines`);
    }
    assert.ok(Math.abs(told.cut.dark - told.whole.dark) > 300, 'cut casters let light in');
    assert.equal(moving.method, 'lookup and movers');
    assert.ok(moving.dark > 300 && moving.wrong < 0.3 * moving.dark, `${moving.wrong} pixels are wrong of ${moving.dark} in the shadow of what moves`);
  });

test('alpha is read back texel by texel: a map\'s alpha, and the red of an alphaMap, as a WebGPURenderer takes it', async () => {
  const wrong = await inPage(async (tools) => {
    const { TexelReading } = await import('/three-webgpu/texel-reading.js');
    const wrong = {};
    for (const backend of ['WebGL', 'WebGPU']) {
      const renderer = await tools.rendererOf(backend);
      for (const [width, height] of [[11, 7], [64, 48]])
        for (const [channel, place] of [['alpha', 3], ['green', 0]]) {
          const data = Uint8Array.from({ length: 4 * width * height }, (_, i) => (i * i * 31 + 7 * i) % 251);
          const texture = new tools.three.DataTexture(data, width, height);
          texture.needsUpdate = true;
          const alpha = await new Promise((resolve) => {
            new TexelReading(renderer, { addTexels: (texels) => resolve(texels.alpha) }).of(texture, texture, channel);
            setTimeout(() => resolve([]), 10000);
          });
          wrong[`${backend} ${width} ${channel}`] = alpha.filter((value, i) => value !== 16 * data[4 * i + place]).length + Math.abs(alpha.length - width * height);
        }
    }
    return wrong;
  });
  for (const [name, count] of Object.entries(wrong)) assert.equal(count, 0, name);
});

test('a page that draws on demand reads all textures, and is settled then', async () => {
  const told = await inPage(async (tools) => {
    const scene = tools.sheets(tools.casterOf), camera = tools.cameraOf(tools.yardView), renderer = await tools.rendererOf('WebGL', { width: 80, height: 60 });
    scene.add(...tools.lampOf('DirectionalLight', [0.1, 1, 0.2]));
    const shadows = tools.shadowsOf(renderer, { transparentCast: 'tint' }).add(scene);
    let asked = 0, frames = 0;
    const draw = () => {
      asked = 0;
      frames += 1;
      shadows.render(scene, camera);
    };
    shadows.addEventListener('change', () => { asked ||= requestAnimationFrame(draw); });
    draw();
    const settled = await Promise.race([shadows.settled.then(() => true), new Promise((resolve) => { setTimeout(resolve, 60000, false); })]);
    const [{ method }] = shadows.lights;
    shadows.dispose();
    return { settled, method, frames };
  });
  console.log(told);
  assert.deepEqual([told.settled, told.method], [true, 'lookup']);
  assert.ok(told.frames < 12, `${told.frames} frames`);
});

test('products of textures are read back texel by texel, and again when one of them changes', async () => {
  const wrong = await inPage(async (tools) => {
    const { TexelReading } = await import('/three-webgpu/texel-reading.js'), { nodeProducts } = await import('/three-webgpu/node-products.js');
    const { TextureProducts } = await import('/three/texture-products.js');
    const textureOf = (width, height, seed) => {
      const texture = new tools.three.DataTexture(Uint8Array.from({ length: 4 * width * height }, (_, i) => (i * i * seed + 7 * i) % 251), width, height);
      texture.needsUpdate = true; // it samples nearest texels
      return texture;
    };
    const wrong = {};
    for (const backend of ['WebGL', 'WebGPU']) {
      let received;
      const products = new TextureProducts(nodeProducts), reading = new TexelReading(await tools.rendererOf(backend), { addTexels: (texels) => received(texels.alpha), releaseTexels() {} });
      const textures = [[11, 7, 31], [22, 7, 17], [11, 14, 5]].map((of) => textureOf(...of)); // alphaMap, map, transmissionMap
      const geometry = new tools.three.PlaneGeometry();
      const judge = async (name, tints, expected) => {
        const { texture, uploaded } = products.of(textures, geometry, tints);
        const numbers = await new Promise((resolve) => {
          received = resolve;
          reading.advance();
          reading.of(texture, uploaded, tints ? 'colour' : 'green');
          setTimeout(() => resolve([]), 10000);
        });
        const { width, height } = texture.image;
        wrong[`${backend} ${name}`] = Math.abs(numbers.length - (tints ? 3 : 1) * width * height);
        for (const [i, number] of numbers.entries()) {
          const layer = Math.floor(i / width / height), row = Math.floor(i / width) % height, column = i % width;
          const at = ({ image }, k) => image.data[4 * (Math.floor((row + 0.5) / height * image.height) * image.width + Math.floor((column + 0.5) / width * image.width)) + k] / 255;
          wrong[`${backend} ${name}`] += Math.abs(number - 4080 * expected(textures.map((one) => (k) => at(one, k)), layer)) > 0.6;
        }
      };
      const through = ([alpha, map, transmission], layer) => map(layer) * (1 - 0.8 * alpha(0) * map(3) * (1 - 0.9 * transmission(0)));
      await judge('alpha', null, ([alpha, map]) => alpha(0) * map(3));
      await judge('colour', { opacity: 0.8, transmission: 0.9 }, through);
      await judge('opaque', { opacity: -1, transmission: 0.6 }, ([, map, transmission], layer) => map(layer) * 0.6 * transmission(0));
      textures[1].image.data.fill(90);
      textures[1].needsUpdate = true;
      await judge('changed', { opacity: 0.8, transmission: 0.9 }, through);
    }
    return wrong;
  });
  assert.equal(Object.keys(wrong).length, 8);
  for (const [name, count] of Object.entries(wrong)) assert.equal(count, 0, name);
});

test('leaves that move, and those whose alpha is not known, have the shadows of three.js\'s own map', async () => {
  const { told, reports } = await inPage(async (tools) => {
    const { scene, camera } = await tools.sceneOf('leaves');
    scene.add(...tools.lampOf('DirectionalLight', [2.5, 5, -1.5]));
    const renderer = await tools.rendererOf('WebGL'), shadows = tools.shadowsOf(renderer).add(scene);
    const dark = async () => (await tools.redOf(renderer, () => shadows.render(scene, camera))).reduce((sum, red) => sum + (red < 128), 0);
    const told = {};
    for (const choice of ['none', 'whole', 'exact']) {
      shadows.alphaTestedCast = choice;
      await tools.rested(shadows, scene, camera);
      told[choice] = await dark();
    }
    scene.children[2].position.x += 0.2; // all leaves
    shadows.render(scene, camera);
    await tools.nextFrame();
    told.moving = await dark();
    told.methods = [shadows.lights[0].method];
    const card = (name, material) => {
      const mesh = tools.meshOf(new tools.three.PlaneGeometry(0.4, 0.4), Object.assign(material, { alphaTest: 0.5 }), [-2, 1, 2]);
      mesh.name = name;
      scene.add(mesh);
    };
    card('wire', tools.white({ wireframe: true }));
    card('target', tools.white({ map: new tools.RenderTarget(4, 4).texture }));
    card('nodes', Object.assign(new tools.MeshBasicNodeMaterial(), { opacityNode: tools.float(0.8) }));
    const pane = tools.meshOf(new tools.three.PlaneGeometry(0.4, 0.4), Object.assign(new tools.MeshBasicNodeMaterial(), { transparent: true, colorNode: tools.float(0.8) }), [-2, 1.4, 2]);
    pane.name = 'pane';
    scene.add(pane);
    shadows.transparentCast = 'tint';
    for (const since = Date.now(); Date.now() - since < 60000 && shadows.lights[0].method !== 'lookup and movers';) {
      await new Promise((resolve) => { setTimeout(resolve, 100); });
      shadows.render(scene, camera);
    }
    told.methods.push(shadows.lights[0].method);
    shadows.dispose();
    return told;
  }, null, [/^(Alpha-tested m|See-through m|M)esh/]);
  console.log(told, reports);
  const { none, whole, exact, moving } = told;
  assert.ok(none + 300 < exact && exact + 300 < whole, 'leaves and their holes are many pixels');
  assert.ok(none + 300 < moving && moving + 300 < whole, `${moving} pixels are dark where leaves move`);
  assert.deepEqual(told.methods, ['map', 'lookup and movers']);
  assert.deepEqual([...reports].filter((text) => /[Mm]esh '/.test(text)).sort(), [
    "Alpha-tested mesh 'nodes' has the shadow of three.js's own map: nodes compute its alpha.",
    "Alpha-tested mesh 'target' has the shadow of three.js's own map: its texture may change in every frame.",
    "Mesh 'wire' has the shadow of three.js's own map: its material is a wireframe.",
    "See-through mesh 'pane' tints without what nodes compute of it."]);
});

test('a light that other ExactShadows have is told, and either may go first', async () => {
  for (const order of [[0, 1], [1, 0]]) {
    const { told, reports } = await inPage(async (tools, given) => {
      const renderer = await tools.rendererOf('WebGL'), { scene, camera } = await tools.sceneOf('yard');
      const [light, target] = tools.lampOf('DirectionalLight', [0.5, 1, -0.3]);
      scene.add(light, target);
      const all = [tools.shadowsOf(renderer).add(scene), tools.shadowsOf(renderer).add(scene)];
      for (const shadows of all) shadows.render(scene, camera);
      const had = [];
      for (const i of given) {
        all[i].dispose();
        had.push(Boolean(light.shadow.shadowNode));
      }
      renderer.render(scene, camera);
      return had;
    }, order, [/other ExactShadows/]);
    assert.deepEqual(told, [true, false]);
    assert.deepEqual([...reports].filter((text) => /other/.test(text)), ["Light '' has the shadows of other ExactShadows: dispose() of those first."]);
  }
});

test('lights have their own shadow nodes and maps\' sizes again afterwards, and bad choices are refused', async () => {
  const told = await inPage(async (tools) => {
    const renderer = await tools.rendererOf('WebGL');
    const { scene, camera } = await tools.sceneOf('yard');
    const [light, target] = tools.lampOf('DirectionalLight', [0.5, 1, -0.3]);
    scene.add(light, target);
    const shadows = tools.shadowsOf(renderer).add(scene);
    await tools.rested(shadows, scene, camera);
    const during = [Boolean(light.shadow.shadowNode), renderer.shadowMap.enabled];
    shadows.dispose();
    const after = [Boolean(light.shadow.shadowNode), renderer.shadowMap.enabled, ...light.shadow.mapSize.toArray()];
    const refused = [() => new tools.NodeShadows({ isWebGLRenderer: true }), () => tools.shadowsOf(renderer, { alphaTestedCast: 'exact-or-whole' }),
      () => tools.shadowsOf(renderer, { transparentCast: 'half' }), () => shadows.render(scene, camera)];
    return { during, after, sentences: refused.map((act) => {
      try {
        act();
        return '';
      } catch ({ message }) {
        return message;
      }
    }) };
  });
  assert.deepEqual([told.during, told.after], [[true, true], [false, false, 512, 512]]);
  assert.deepEqual(told.sentences, ['ExactShadows of edgeshade/three-webgpu needs a WebGPURenderer of three.js.',
    "alphaTestedCast is 'exact-or-whole', which is not one of exact, whole, none in edgeshade/three-webgpu.",
    "transparentCast is 'half', which is not one of none, opaque, tint in edgeshade/three-webgpu.", 'These ExactShadows were disposed of.']);
});

test('releases of three.js that bind no textures again are refused', () => {
  for (const revision of ['187', '188dev', '200']) requireRelease(revision);
  assert.throws(() => requireRelease('186'), { message: 'ExactShadows of edgeshade/three-webgpu needs r187 of three.js or later, not r186.' });
});

test('devices whose fragment shaders have no 32-bit numbers are refused', () => {
  const backendOf = (floats, integers) => ({ isWebGLBackend: true,
    gl: { FRAGMENT_SHADER: 1, HIGH_FLOAT: 2, HIGH_INT: 3, getShaderPrecisionFormat: (stage, kind) => (kind === 2 ? floats : integers) } });
  const full = { precision: 23, rangeMin: 127, rangeMax: 127 }, whole = { precision: 0, rangeMin: 31, rangeMax: 30 };
  requireFloats(backendOf(full, whole));
  requireFloats({ isWebGPUBackend: true });
  assert.throws(() => requireFloats(backendOf({ precision: 16, rangeMin: 62, rangeMax: 62 }, whole)),
    { message: "ExactShadows needs fragment shaders with 32-bit floats: this device's have 16 binary digits, and exponents from -62 to 62." });
  assert.throws(() => requireFloats(backendOf(full, { rangeMax: 15 })), { message: "ExactShadows needs fragment shaders with 32-bit integers: this device's have 16 bits." });
});

if (isLong)
  test('worlds that change at random are looked up as rays find them', async () => {
    let judged = 0;
    for (let seed = 1; seed <= 12; ++seed) {
      const told = await inPage(async (tools, given) => {
        const { randomWorld } = await import('/tests/random-world.js');
        const size = { width: 120, height: 80 }, view = { getContext: () => ({ drawingBufferWidth: size.width, drawingBufferHeight: size.height }), clippingPlanes: [] };
        const renderer = await tools.rendererOf('WebGL', size), world = randomWorld(given, size), { scene, lights, unit } = world;
        renderer.highPrecision = scene.children[0].position.x !== 0; // far off
        const shadows = tools.shadowsOf(renderer, { lookups: lights.length }).add(scene);
        const pictures = [];
        for (let i = 0, after = 'start'; i < 6; ++i, after = world.step()) {
          await tools.rested(shadows, scene, world.camera, lights.length);
          await tools.nextFrame();
          const channels = await tools.channelsOf(renderer, () => shadows.render(scene, world.camera));
          for (const [channel, light] of lights.entries()) {
            if (shadows.lights.find((one) => one.light === light).method === 'lookup')
              pictures.push({ after, light: light.type, ...tools.comparedWithRays(channels[channel], view, scene, world.camera, light, { unit }) });
          }
        }
        shadows.dispose();
        return pictures;
      }, seed);
      for (const [i, { after, light, surfaces, wrong, beyond }] of told.entries())
        assert.ok(beyond === 0 && wrong <= 0.02 * surfaces, `${wrong} of ${surfaces} pixels are wrong, ${beyond} beyond outlines: seed ${seed}, picture ${i}, ${light} after ${after}`);
      judged += told.length;
    }
    console.log(`${judged} pictures`);
    assert.ok(judged > 60, `${judged} pictures are looked up`);
  });
