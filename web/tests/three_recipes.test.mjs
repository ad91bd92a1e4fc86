// The README's recipes for three.js, run as they are written there, in one page: each has the effect
// that it promises.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { useBrowser } from './support/browser.mjs';
import { missing, modules } from './support/package.mjs';
import { recipes } from './support/readme.mjs';
import { inPlaceOf, openThree } from './support/three.mjs';

const shared = useBrowser();
const tested = [];
let page = null;

/**
 * In the page: what recipes and checks need. `begin()` makes a white court with a sun, a wall, a
 * chest and columns, and recipes' globals; `run(lines, names)` runs a recipe and returns those of its
 * names; `end(shadows)` lets go of all.
 */
function tools() {
  const { three, ExactShadows, rendererOf, court, comparedWithRays, redOf } = window.page;
  const renderer = rendererOf({ width: 160, height: 100 });
  const pause = (milliseconds) => new Promise((resolve) => { setTimeout(resolve, milliseconds); });
  /** Waits until something holds, for at most half a minute. */
  const until = async (holds) => {
    for (const since = performance.now(); !holds() && performance.now() - since < 30000;) await pause(60);
  };
  const begin = async ({ given = {}, makesOwn = false, ...options } = {}) => {
    const world = court(options);
    world.light.name = 'sun';
    const shadows = makesOwn ? null : new ExactShadows(renderer).add(world.scene);
    Object.assign(window, { THREE: three, renderer, scene: world.scene, camera: world.camera, sun: world.light, shadows, label: { textContent: '' }, ...given });
    const settled = async (methods = ['lookup', 'lookup and movers']) => {
      shadows.render(world.scene, world.camera);
      await shadows.ready();
      await until(() => {
        shadows.render(world.scene, world.camera);
        return shadows.lights.every(({ method }) => methods.includes(method));
      });
    };
    if (shadows) await settled();
    const right = () => comparedWithRays(redOf(renderer), renderer, world.scene, world.camera, world.light);
    return { ...world, shadows, settled, right, pause, until };
  };
  const run = (lines, names = []) => import(`data:text/javascript,${encodeURIComponent(`${lines}\nexport { ${names} };`)}`);
  const end = (shadows) => {
    renderer.setAnimationLoop(null);
    renderer.localClippingEnabled = false;
    shadows.dispose();
  };
  window.recipes = { renderer, begin, run, end };
}

/** Tests a recipe. */
function recipe(title, check, skip = false) {
  tested.push(title);
  test(title, { skip }, check);
}

/** The result of `act(window.page, window.recipes, lines, given)` with a recipe's lines. */
async function inRecipe(title, act, given) {
  if (!page) {
    page = await openThree(shared);
    await page.evaluate(tools);
  }
  return page.evaluate(([text, lines, value]) => (0, eval)(`(${text})`)(window.page, window.recipes, lines, value), [act.toString(), recipes.get(title), given]);
}

function assertRight({ surfaces, dark, wrong, beyond }, { most = 1 } = {}) {
  const told = `${wrong} of ${surfaces} pixels are wrong, ${beyond} of them beyond outlines, ${dark} in shadow`;
  assert.ok(surfaces > 5000 && dark > 400 && beyond <= most && wrong <= 0.02 * surfaces, told);
}

recipe('Composer', async () => {
  const told = await inRecipe('Composer', async (_, { begin, run, end }, lines) => {
    const { right, until } = await begin({ makesOwn: true });
    const { shadows, composer } = await run(lines, ['shadows', 'composer']);
    await shadows.ready();
    await until(() => shadows.cost?.lookedUp === 1);
    composer.render();
    const compared = right();
    end(shadows);
    return { compared, passes: composer.passes.length };
  });
  assert.equal(told.passes, 1);
  assertRight(told.compared);
});

recipe('On demand', async () => {
  const told = await inRecipe('On demand', async ({ ExactShadows }, { renderer, begin, run, end }, lines) => {
    const { scene, right, pause } = await begin({ makesOwn: true });
    const shadows = new ExactShadows(renderer).add(scene);
    let frames = 0;
    const { render } = shadows;
    shadows.render = (...of) => {
      frames += 1;
      return render.apply(shadows, of);
    };
    window.shadows = shadows;
    await run(lines);
    await shadows.settled;
    const needed = frames, compared = right(), { lookedUp } = shadows.cost;
    await pause(300);
    end(shadows);
    return { needed, later: frames - needed, lookedUp, compared };
  });
  assert.ok(told.needed === 2 || told.needed === 3, `${told.needed} frames`); // masks may be ready at once
  assert.deepEqual([told.later, told.lookedUp], [0, 1]);
  assertRight(told.compared);
});

recipe('Foliage', async () => {
  const told = await inRecipe('Foliage', async ({ redOf }, { renderer, begin, run, end }, lines) => {
    const { leafAtlas, cardOf } = await import('/tests/foliage.js');
    const cards = cardOf(1, 3, 3).rotateX(-1.2).translate(1, 2.6, 1.2);
    const { scene, camera, light, settled, shadows, right } = await begin({ given: { leaves: leafAtlas(), cards } });
    const { tree } = await run(lines, ['tree']);
    const { map, alphaTest, side } = tree.material;
    tree.material = Object.assign(scene.children[0].material.clone(), { map, alphaTest, side }); // white, for rays
    await settled(['lookup']);
    const leaves = right();
    light.position.x += 0.01;
    shadows.render(scene, camera);
    const whole = leaves.surfaces - redOf(renderer).filter((red) => red > 127).length;
    tree.castShadow = false;
    await settled();
    const bare = right();
    end(shadows);
    return { leaves, whole, bare };
  });
  assertRight(told.leaves, { most: 3 });
  assert.ok(told.leaves.dark > told.bare.dark + 100, 'leaves cast');
  assert.ok(told.whole > told.leaves.dark + 100, `whole cards cast while the sun moves: ${told.whole} pixels`);
});

recipe('Glass', async () => {
  const told = await inRecipe('Glass', async ({ three }, { renderer, begin, run, end }, lines) => {
    const { scene, camera, light, settled, shadows } = await begin();
    const { pane } = await run(lines, ['pane']);
    await settled(['lookup']);
    const gl = renderer.getContext();
    const colourAt = (point) => {
      const at = point.clone().project(camera), rgba = new Uint8Array(4);
      gl.readPixels(Math.floor(80 + 80 * at.x), Math.floor(50 + 50 * at.y), 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, rgba);
      return [...rgba.subarray(0, 3)];
    };
    const towards = light.position, below = pane.position.clone().addScaledVector(towards, -pane.position.y / towards.y);
    const told = { below: colourAt(below), beside: colourAt(below.clone().add(new three.Vector3(0, 0, 0.75))) };
    pane.castShadow = false;
    await settled();
    told.without = colourAt(below);
    end(shadows);
    return told;
  });
  const [red, green, blue] = told.below;
  assert.deepEqual(told.beside, [255, 255, 255]);
  assert.deepEqual(told.without, [255, 255, 255]);
  // 0xcc2233 times white.
  assert.ok(Math.abs(red - 0xcc) <= 3 && Math.abs(green - 0x22) <= 3 && Math.abs(blue - 0x33) <= 3, `${told.below}`);
});

recipe('Section', async () => {
  const told = await inRecipe('Section', async ({ three }, { begin, run, end }, lines) => {
    const { settled, shadows, right } = await begin({ side: three.DoubleSide });
    const whole = right();
    const { plane } = await run(lines, ['plane']);
    await settled();
    const cut = right();
    end(shadows);
    return { whole, cut, height: plane.constant };
  });
  assert.equal(told.height, 1.2);
  assertRight(told.whole);
  assertRight(told.cut);
  assert.ok(told.whole.dark > 1.1 * told.cut.dark, `the cut walls cast less: ${told.whole.dark} pixels, then ${told.cut.dark}`);
});

recipe('Character', async () => {
  await page.route('**/figure.glb', (route) => route.continue({ url: new URL('/models/walking-figure.glb', page.url()).href }));
  const told = await inRecipe('Character', async ({ whiten, frame }, { begin, run, end }, lines) => {
    const { shadows, right, until } = await begin();
    const { figure } = await run(lines, ['figure']);
    whiten(figure);
    await until(() => shadows.lights[0].method === 'lookup and movers');
    const methods = new Set(), poses = [];
    for (let i = 0; i < 2; ++i) {
      await frame();
      await frame();
      methods.add(shadows.lights[0].method);
      figure.traverse((object) => object.computeBoundingSphere?.()); // for rays
      poses.push(right());
    }
    end(shadows);
    return { methods: [...methods], poses };
  });
  assert.deepEqual(told.methods, ['lookup and movers']);
  for (const pose of told.poses) assertRight(pose, { most: 3 });
});

recipe('BIM', async () => {
  const base64 = await page.evaluate(async () => {
    const { GLTFExporter } = await import('three/addons/exporters/GLTFExporter.js');
    const { building } = await import('/tests/building.js');
    return window.page.base64Of(new Uint8Array(await new GLTFExporter().parseAsync(building(250, { width: 5 }), { binary: true })));
  });
  await page.route('**/building.glb', (route) => route.fulfill({ body: Buffer.from(base64, 'base64') }));
  const told = await inRecipe('BIM', async ({ whiten, frame }, { begin, run, end }, lines) => {
    const texts = [];
    const label = { set textContent(text) { texts.push(text); } };
    const { camera, shadows, settled, right } = await begin({ given: { label } });
    camera.position.multiplyScalar(1.3);
    const { model } = await run(lines, ['model']);
    whiten(model);
    await shadows.ready();
    await frame();
    await frame();
    const said = [...new Set(texts)];
    await settled();
    const compared = right();
    end(shadows);
    return { said, compared };
  });
  assert.match(told.said.find(Boolean), /^25\d meshes have no shadows yet$/);
  assert.equal(told.said.at(-1), '');
  assertRight(told.compared, { most: 3 });
});

recipe('React', async () => {
  const contents = `${recipes.get('React')}
export { createElement, StrictMode } from 'react';
export { createRoot } from 'react-dom/client';
export { Canvas } from '@react-three/fiber';`;
  const { build } = await import('esbuild');
  const { outputFiles: [{ text }] } = await build({ stdin: { contents, resolveDir: modules }, bundle: true, write: false, format: 'esm',
    external: ['three', 'edgeshade/three'], define: { 'process.env.NODE_ENV': '"development"' } });
  const told = await inRecipe('React', async ({ court, comparedWithRays, redOf }, _, lines, bundle) => {
    const { Shadows, createElement, StrictMode, createRoot, Canvas } = await import(URL.createObjectURL(new Blob([bundle], { type: 'text/javascript' })));
    const { scene: model, camera, light, material } = court();
    const box = document.body.appendChild(document.createElement('div'));
    box.style.cssText = 'width: 160px; height: 100px';
    const root = createRoot(box);
    const made = await new Promise((resolve) => {
      const settings = { dpr: 1, flat: true, camera, gl: { preserveDrawingBuffer: true, antialias: false }, onCreated: resolve };
      root.render(createElement(StrictMode, null, createElement(Canvas, settings, createElement(Shadows), createElement('primitive', { object: model }))));
    });
    let compared = null;
    for (const since = performance.now(); performance.now() - since < 20000;) {
      await new Promise((resolve) => { setTimeout(resolve, 300); });
      compared = comparedWithRays(redOf(made.gl), made.gl, made.scene, camera, light);
      if (compared.wrong < 0.02 * compared.surfaces) break;
    }
    const patched = Object.hasOwn(material, 'customProgramCacheKey');
    root.unmount();
    await new Promise((resolve) => { setTimeout(resolve, 600); });
    return { compared, patched, restored: !Object.hasOwn(material, 'customProgramCacheKey') };
  }, text);
  assertRight(told.compared);
  assert.ok(told.patched && told.restored, 'it lets go of the materials when it is unmounted');
}, missing('esbuild', 'react', 'react-dom', '@react-three/fiber'));

recipe('Soft sun', async () => {
  const told = await inRecipe('Soft sun', async ({ three, redOf }, { renderer, begin, run, end }, lines) => {
    const { scene, camera, light, placed, settled, shadows } = await begin();
    const far = placed(new three.BoxGeometry(2.5, 0.1, 2.5), light.position.clone().setLength(60).toArray());
    await settled();
    const shades = () => {
      shadows.render(scene, camera);
      const red = redOf(renderer);
      return { grey: red.filter((value) => value > 20 && value < 235).length, different: new Set(red).size };
    };
    const hard = shades();
    await run(lines);
    const soft = shades(), { lightSamples } = shadows;
    far.removeFromParent();
    const near = shades();
    end(shadows);
    return { hard, soft, near, lightSamples };
  });
  assert.equal(told.lightSamples, 256);
  assert.ok(told.soft.grey > told.hard.grey + 200 && told.soft.different > told.hard.different + 30);
});

recipe('Hours of sun', async () => {
  const told = await inRecipe('Hours of sun', async ({ three }, { begin, run, end }, lines) => {
    const { scene, shadows } = await begin();
    const ground = new three.Mesh(new three.PlaneGeometry(8, 8, 8, 8).rotateX(-Math.PI / 2).translate(0, 0.01, 0), new three.MeshStandardMaterial());
    scene.add(ground);
    window.ground = ground;
    const { hours, possible } = await run(lines, ['hours', 'possible']);
    const { color } = ground.geometry.attributes;
    end(shadows);
    return { possible, hours: [...hours.array], red: [...hours.array].map((_, i) => color.getX(i)), material: ground.material.type };
  });
  assert.ok(told.possible > 11.5 && told.possible < 12.5, `${told.possible} h on the equinox`);
  assert.equal(told.hours.length, 81);
  assert.ok(Math.max(...told.hours) > Math.min(...told.hours) + 2, 'walls shade some of the ground');
  assert.equal(told.material, 'MeshBasicMaterial');
  const darkest = told.hours.indexOf(Math.min(...told.hours)), lightest = told.hours.indexOf(Math.max(...told.hours));
  assert.ok(told.red[darkest] < told.red[lightest]);
});

recipe('Reading costs', async () => {
  const told = await inRecipe('Reading costs', async (_, { begin, run, end }, lines) => {
    const { settled, shadows } = await begin();
    await settled();
    const { table, log } = console, shown = [];
    Object.assign(console, { table: (rows) => shown.push(...rows), log: (line) => shown.push(line) });
    const costs = await run(lines, ['drawMs', 'bytes', 'pending', 'lookedUp']);
    Object.assign(console, { table, log });
    end(shadows);
    return { costs: { ...costs }, shown };
  });
  const { drawMs, bytes, pending, lookedUp } = told.costs;
  assert.ok(drawMs >= 0 && drawMs < 1000 && bytes > 1e5, JSON.stringify(told.costs));
  assert.deepEqual([pending, lookedUp], [0, 1]);
  assert.deepEqual(told.shown, [`${drawMs} ms, ${bytes} bytes on the GPU, 0 meshes to come, 1 lights looked up`,
    { light: 'sun', method: 'lookup', reason: 'it rests, and so do all casters' }]);
});

test('there are eleven recipes of at most ten lines, each has a test, and the console stays empty', async () => {
  assert.equal(recipes.size, 11);
  for (const [title, lines] of recipes) assert.ok(lines.split('\n').filter(Boolean).length <= 10, title);
  assert.deepEqual(tested, [...recipes.keys()]);
  const clock = /THREE\.Clock/; // that of @react-three/fiber
  const pane = /Feedback loop/; // r152 draws the back of a transmissive pane into the texture that it reads
  await shared.check(page, inPlaceOf('three') === 'three-0.152' ? [clock, pane] : [clock]);
});
