// A page that draws only when the shadows ask for it: it ends exact, with as many frames as it needs.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { useBrowser } from './support/browser.mjs';
import { openThree } from './support/three.mjs';

const shared = useBrowser();

/** Runs `act(world)` in a page that draws on demand; returns what it returns. */
async function onDemand(act, options = {}) {
  const page = await openThree(shared);
  const told = await page.evaluate(async ([text, settings]) => {
    const { three, yard, ExactShadows, cameraOf, redOf, comparedWithRays, whiten } = window.page;
    const { building } = await import('/tests/building.js'); // before the shadows start: acts draw their first frame without them
    const world = yard({ width: 160, height: 90 });
    const { renderer, scene, light } = world;
    whiten(scene);
    const camera = cameraOf({ from: [5, 4, 6], to: [0, 0.6, 0], fov: 50 }, 16 / 9);
    const shadows = new ExactShadows(renderer, settings).add(scene);
    const frames = [];
    let asked = 0;
    const draw = () => {
      asked = 0;
      shadows.render(scene, camera);
      frames.push({ lookedUp: shadows.cost?.lookedUp ?? 0, pending: shadows.cost?.pending ?? -1, hash: window.page.hash(redOf(renderer)) });
    };
    shadows.addEventListener('change', () => { asked ||= requestAnimationFrame(draw); });
    const settled = async () => {
      await shadows.settled;
      return { count: frames.splice(0).map(({ lookedUp, pending }) => `${pending} pending, ${lookedUp} looked up`), needsUpdate: shadows.needsUpdate,
        right: comparedWithRays(redOf(renderer), renderer, scene, camera, light) };
    };
    return (0, eval)(`(${text})`)({ ...world, three, camera, shadows, draw, settled, frames, building });
  }, [act.toString(), options]);
  await shared.check(page);
  return told;
}

const isRight = ({ surfaces, dark, beyond, wrong }) => surfaces > 4000 && dark > 100 && beyond <= 1 && wrong <= 0.02 * surfaces;

test('a page at rest draws a frame without shadows, one with masks and one that looks up', async () => {
  const told = await onDemand(async ({ draw, settled, shadows, box, frames }) => {
    const needed = shadows.needsUpdate;
    draw();
    const first = await settled();
    box.position.x += 0.7;
    draw();
    const moved = await settled();
    draw();
    const again = await settled();
    await new Promise((resolve) => { setTimeout(resolve, 900); });
    return { needed, first, moved, again, later: frames.length };
  });
  assert.ok(told.needed);
  assert.deepEqual(told.first.count, ['-1 pending, 0 looked up', '0 pending, 0 looked up', '0 pending, 1 looked up']);
  // It leaves the map, is counted on top of another, and is in a third after a long rest.
  assert.deepEqual(told.moved.count, ['0 pending, 0 looked up', '0 pending, 1 looked up', '0 pending, 1 looked up']);
  assert.deepEqual(told.again.count, ['0 pending, 1 looked up'], 'a frame that the page draws itself');
  for (const { needsUpdate, right } of [told.first, told.moved, told.again]) {
    assert.equal(needsUpdate, false);
    assert.ok(isRight(right), JSON.stringify(right));
  }
  assert.equal(told.later, 0, 'no frame is asked for');
});

test('without lookups two frames are enough, and many meshes take one more when all are ready', async () => {
  const told = await onDemand(async ({ draw, settled, scene, ground, building, shadows, camera, three }) => {
    draw();
    const first = await settled();
    const model = building(60, { width: 6 });
    model.traverse((object) => { if (object.isMesh) object.material = ground.material; });
    scene.add(model);
    camera.position.set(9, 8, 10);
    draw();
    const many = await settled();
    scene.remove(model);
    draw();
    const gone = await settled();
    scene.add(building(300, { width: 8 }));
    draw();
    const ready = shadows.ready();
    await new Promise((resolve) => { setTimeout(resolve); });
    shadows.dispose();
    const sentence = await ready.catch(({ message }) => message);
    await shadows.settled;
    return { first, many, gone, sentence };
  }, { lookups: 0 });
  const { sentence, ...frames } = told;
  assert.equal(sentence, 'The shadows were disposed of.');
  assert.equal(told.first.count.length, 2);
  assert.deepEqual(told.many.count, ['60 pending, 0 looked up', '0 pending, 0 looked up']);
  assert.deepEqual(told.gone.count, ['0 pending, 0 looked up']);
  for (const { right } of Object.values(frames)) assert.ok(right.beyond <= 1 && right.dark > 50, JSON.stringify(right));
});

test('a context that comes back asks for a frame, and what fails is thrown', async () => {
  const told = await onDemand(async ({ draw, settled, renderer, scene, mesh, shadows, three }) => {
    draw();
    await settled();
    const extension = renderer.getContext().getExtension('WEBGL_lose_context');
    extension.loseContext();
    await new Promise((resolve) => { setTimeout(resolve, 200); });
    const whileLost = shadows.needsUpdate;
    extension.restoreContext();
    await new Promise((resolve) => { shadows.addEventListener('change', resolve, { once: true }); });
    const restored = await settled();
    const broken = new three.BoxGeometry();
    broken.attributes.position.setX(3, NaN);
    broken.boundingSphere = new three.Sphere();
    scene.add(mesh(broken));
    draw();
    const sentence = await settled().catch(({ message }) => message);
    return { whileLost, restored, sentence };
  });
  assert.match(told.sentence, /not finite/);
  assert.equal(told.restored.count.at(-1), '0 pending, 1 looked up');
  assert.ok(isRight(told.restored.right), JSON.stringify(told.restored.right));
});

test('textures are read one after another until leaves cast, and those that nothing asks for any more hold up nothing', async () => {
  const { told, left } = await onDemand(async ({ draw, settled, scene, three, shadows }) => {
    const { blobs, white } = await import('/tests/foliage.js');
    const sheet = (x, settings) => {
      const mesh = new three.Mesh(new three.PlaneGeometry(0.5, 0.5), white({ alphaTest: 0.5, ...settings }));
      mesh.position.set(x, 0.7, 1.6);
      mesh.rotation.x = -1.4;
      mesh.castShadow = mesh.receiveShadow = true;
      scene.add(mesh);
      return mesh;
    };
    const added = [0, 1].map((i) => sheet(-1.5 + i, { map: blobs(6, 5, { seed: i }) }));
    added.push(sheet(0.5, { map: blobs(5, 4), alphaMap: blobs(4, 6, { green: true }) })); // its alphaMap alone isn't needed
    const within = (ms, promise) => Promise.race([promise, new Promise((resolve) => { setTimeout(resolve, ms, null); })]);
    draw();
    const told = await within(20000, settled());
    added.push(...[2, 3, 4].map((i) => sheet(-3.5 + i, { map: blobs(6, 5, { seed: i }) })));
    draw();
    scene.remove(...added);
    draw(); // their textures haven't all been read
    const left = await within(20000, settled());
    shadows.dispose();
    return { told, left };
  });
  console.log(told, left);
  assert.equal(told?.needsUpdate, false, 'it is settled');
  assert.ok(told.count.length < 12 && told.count.at(-1) === '0 pending, 1 looked up', told.count.join('; '));
  assert.ok(isRight(left.right), JSON.stringify(left?.right));
});

test('a leaf that comes to a settled page is cut out once its texture is there', async () => {
  const told = await onDemand(async ({ draw, settled, scene, three, shadows }) => {
    const { blobs, white } = await import('/tests/foliage.js');
    const leaf = (at, turned) => {
      const mesh = new three.Mesh(new three.PlaneGeometry(1.4, 1.4), white({ alphaTest: 0.5, map: blobs(4, 4, { seed: 3 }) }));
      mesh.position.set(...at);
      mesh.rotation.x = turned;
      mesh.castShadow = mesh.receiveShadow = true;
      scene.add(mesh);
    };
    draw();
    await settled();
    leaf([1.2, 0.9, 1.4], -1.4);
    draw();
    const onDraw = await settled();
    leaf([-1.3, 0.8, 1.6], 1.6);
    draw();
    await shadows.ready();
    draw();
    const methods = shadows.lights.map(({ method }) => method);
    const onReady = await settled();
    return { onDraw, onReady, methods };
  });
  console.log(told);
  assert.deepEqual(told.methods, ['lookup and movers'], 'ready() has waited for the texture');
  for (const { needsUpdate, right } of [told.onDraw, told.onReady]) {
    assert.equal(needsUpdate, false);
    assert.ok(isRight(right), JSON.stringify(right));
  }
});

test('a canvas without pixels settles, and has its shadows once it has some', async () => {
  const told = await onDemand(async ({ draw, settled, renderer, shadows }) => {
    renderer.setSize(0, 0);
    draw();
    await shadows.settled;
    renderer.setSize(160, 90);
    draw();
    return settled();
  }, { lookups: 0 });
  assert.ok(isRight(told.right), JSON.stringify(told.right));
});
