// Resting lights in three.js: looked up instead of masked, automatically, until something moves;
// with the shadows of `render --mask`.

import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { useBrowser } from './support/browser.mjs';
import { repository } from './support/server.mjs';
import { compareMasks, inNativeGl, nativeMask, size } from './support/three.mjs';

const shared = useBrowser({ sharesPages: true });

const inPage = (...of) => inNativeGl(shared, ...of);

function assertSame({ surfaces, dark, wrong, beyond }, most) {
  assert.ok(surfaces > 0.2 * size.width * size.height && dark > 200, `${surfaces} pixels of surfaces, ${dark} in shadow`);
  assert.ok(beyond <= 0.0002 * surfaces, `${beyond} of ${surfaces} pixels, beyond outlines`);
  assert.ok(wrong <= most * surfaces, `${wrong} of ${surfaces} pixels`);
}

const lights = [
  ['a sun', { kind: 'DirectionalLight', position: [-0.62, 0.62, -0.3] }, ['--sun', '-0.62,0.62,-0.30']],
  ['a lamp', { kind: 'PointLight', position: [1.5, 2.2, 2.0] }, ['--light', '1.5,2.2,2']],
];

test('the sample, a sun and a lamp at rest', async (context) => {
  const view = { from: [-2.6, 3.6, 10.2], to: [0.2, 1.3, -0.2], fov: 45 };
  const { page, told } = await inPage(context, async ({ three, ExactShadows, rendererOf, loaded, whiten, cameraOf, lampOf, rested, redTextOf }, { seen, of, wide }) => {
    const renderer = rendererOf(wide);
    const sample = await loaded('/assets/pavilion.glb');
    const camera = cameraOf(seen, wide.width / wide.height);
    const pictures = [];
    for (const lamp of of) {
      const scene = new three.Scene();
      scene.add(sample, ...lampOf(lamp));
      whiten(scene);
      const shadows = new ExactShadows(renderer).add(scene);
      const lookedUp = await rested(shadows, scene, camera);
      pictures.push({ lookedUp, red: redTextOf(renderer), cost: shadows.cost, whys: [...shadows.notLookedUp.values()] });
      shadows.dispose();
    }
    return pictures;
  }, { seen: view, of: lights.map(([, options]) => options), wide: size });
  if (!page) return;
  for (const [i, [name, , light]] of lights.entries()) {
    assert.equal(told[i].lookedUp, 1, `${name}: ${told[i].whys}`);
    assert.equal(told[i].cost.vertexRuns, 0, 'no mask is drawn');
    const compared = await compareMasks(page, told[i].red, nativeMask(join(repository, 'assets/pavilion.glb'), view, light));
    console.log(name, compared);
    assertSame(compared, 0.002);
  }
  await shared.check(page);
});

test('a light or a caster that moves is masked in that very frame, and looked up again once all rests', async (context) => {
  const view = { from: [5, 4, 6], to: [0, 0.6, 0], fov: 50 };
  const { page, told } = await inPage(context, async ({ yard, whiten, ExactShadows, cameraOf, drawn, rested, redOf }, { seen, wide }) => {
    const { renderer, scene, box, light } = yard(wide);
    whiten(scene);
    const camera = cameraOf(seen, wide.width / wide.height);
    const places = [[0.3, -0.3], [1.0, -0.3], [1.0, 0.4]]; // of the box, then of the light
    const pictures = async (shadows, draw) => {
      const all = [];
      for (const [x, z] of places) {
        box.position.x = x;
        light.position.z = z;
        shadows.render(scene, camera);
        const atOnce = { lookedUp: shadows.cost?.lookedUp ?? 0, red: redOf(renderer) };
        const lookedUp = await draw(shadows, scene, camera);
        all.push({ atOnce, lookedUp, red: redOf(renderer) });
      }
      shadows.dispose();
      return all;
    };
    const masked = await pictures(new ExactShadows(renderer, { lookups: 0 }).add(scene), drawn);
    const lookedUp = await pictures(new ExactShadows(renderer).add(scene), rested);
    const differ = (a, b) => a.filter((value, i) => Math.abs(value - b[i]) > 2).length;
    return lookedUp.map((of, i) => ({ lookedUp: of.lookedUp, wrong: differ(of.red, masked[i].red), atOnce: of.atOnce.lookedUp,
      wrongAtOnce: i > 0 ? differ(of.atOnce.red, masked[i].red) : 0, moved: i > 0 ? differ(masked[i].red, masked[i - 1].red) : 1000 }));
  }, { seen: view, wide: size });
  if (!page) return;
  for (const { lookedUp, wrong, wrongAtOnce, atOnce, moved } of told) {
    assert.equal(lookedUp, 1);
    assert.equal(atOnce, 0);
    assert.ok(moved > 200, `${moved} pixels changed`);
    assert.ok(wrong <= 20, `${wrong} pixels are others than the mask's`);
    assert.equal(wrongAtOnce, 0, 'pixels of the frame in which it moved');
  }
  await shared.check(page);
});

test('two lights at rest are looked up, a third one is masked, see-through surfaces take shadow', async (context) => {
  const { page, told } = await inPage(context, async ({ three, yard, ExactShadows, cameraOf, lampOf, rested, redAt }) => {
    const { renderer, scene, box, light } = yard({ width: 200, height: 120 });
    const camera = cameraOf({ from: [5, 4, 6], to: [0, 0.6, 0], fov: 50 }, 200 / 120);
    box.position.y = 2.2;
    light.position.set(0, 1, 0);
    // A pane below the box, which three.js blends, with black below it, so that only the pane's own
    // light shows.
    const pane = new three.Mesh(new three.PlaneGeometry(5, 5), new three.MeshLambertMaterial({ transparent: true, opacity: 0.9 }));
    pane.rotation.x = -Math.PI / 2;
    pane.position.y = 1;
    pane.receiveShadow = true;
    scene.add(pane);
    const shadows = new ExactShadows(renderer, { lookups: 2 }).add(scene);
    const masked = new ExactShadows(renderer, { lookups: 0 }).add(scene);
    await rested(masked, scene, camera, 0);
    const [below, beside] = [[0.3, 1, -0.2], [1.8, 1, 0.3]];
    const withMasks = [redAt(renderer, camera, below), redAt(renderer, camera, beside)];
    masked.dispose();
    const one = await rested(shadows, scene, camera, 1);
    const lookedUp = [redAt(renderer, camera, below), redAt(renderer, camera, beside)];
    scene.add(...lampOf({ kind: 'PointLight', position: [3, 3, 3] }), ...lampOf({ kind: 'SpotLight', position: [-3, 4, 2] }));
    const two = await rested(shadows, scene, camera, 2);
    const { vertexRuns } = shadows.cost;
    return { one, two, withMasks, lookedUp, vertexRuns };
  });
  if (!page) return;
  assert.deepEqual([told.one, told.two], [1, 2]);
  assert.ok(told.vertexRuns > 0, 'the third one is masked');
  assert.equal(told.withMasks[0], told.withMasks[1], 'masks have no see-through surfaces');
  assert.ok(told.lookedUp[0] < 0.5 * told.lookedUp[1], `${told.lookedUp}`);
  assert.equal(told.lookedUp[1], told.withMasks[1]);
  await shared.check(page);
});

test('surfaces that only receive, and shadow materials, take the shadows that masks show', async (context) => {
  const { page, told } = await inPage(context, async ({ three, yard, ExactShadows, cameraOf, rested, redOf }, { wide }) => {
    const { renderer, scene, ground, light } = yard(wide);
    const camera = cameraOf({ from: [5, 4, 6], to: [0, 0.6, 0], fov: 50 }, wide.width / wide.height);
    const floor = new three.Mesh(new three.PlaneGeometry(8, 8), new three.ShadowMaterial({ opacity: 1, color: 0xff0000 }));
    floor.rotation.x = -Math.PI / 2;
    const wall = new three.Mesh(new three.PlaneGeometry(3, 2), new three.MeshToonMaterial({ color: 0xffffff, side: three.DoubleSide }));
    wall.position.set(0, 1, -1.2);
    for (const receiver of [floor, wall]) receiver.receiveShadow = true;
    scene.remove(ground);
    scene.add(floor, wall);
    light.position.set(0.4, 1, 0.9);
    const shadows = new ExactShadows(renderer).add(scene);
    const masked = new ExactShadows(renderer, { lookups: 0 }).add(scene);
    await rested(masked, scene, camera, 0);
    const expected = redOf(renderer);
    masked.dispose();
    const lookedUp = await rested(shadows, scene, camera);
    const red = redOf(renderer);
    return { lookedUp, wrong: red.filter((value, i) => Math.abs(value - expected[i]) > 2).length, seen: expected.filter((value) => value > 0).length };
  }, { wide: size });
  if (!page) return;
  assert.equal(told.lookedUp, 1);
  assert.ok(told.seen > 3000 && told.wrong <= 20, `${told.wrong} pixels of ${told.seen}`);
  await shared.check(page);
});

test('maps of lights come and go with the state of the context as it was', async (context) => {
  const { page, told } = await inPage(context, async ({ yard, ExactShadows, cameraOf, rested, stateOf, frame }) => {
    const { renderer, scene, box } = yard({ width: 200, height: 120 });
    const gl = renderer.getContext();
    const camera = cameraOf({ from: [5, 4, 6], to: [0, 0.6, 0], fov: 50 }, 200 / 120);
    const shadows = new ExactShadows(renderer, { keepsState: true }).add(scene);
    await rested(shadows, scene, camera);
    const errors = [];
    const changes = [];
    for (const moved of [1, 0]) {
      box.position.x += 0.5 * moved;
      for (let i = 0; i < 60 && !(shadows.cost.lookedUp && i > 1); ++i) {
        gl.enable(gl.SAMPLE_ALPHA_TO_COVERAGE);
        gl.pixelStorei(gl.UNPACK_ROW_LENGTH, 7);
        gl.depthRange(0.25, 0.75);
        const before = stateOf(gl);
        shadows.beginMasks(scene, camera);
        shadows.endMasks();
        await frame();
        await new Promise((resolve) => { setTimeout(resolve, 30); });
        const after = stateOf(gl);
        for (const name in before) {
          const gone = name.startsWith('TEXTURE_BINDING') && after[name] === null; // the map of a
                                                                                   // light or
                                                                                   // caster that
                                                                                   // has moved
          if (!gone && `${after[name]}` !== `${before[name]}`) changes.push(`${name}: ${before[name]}, then ${after[name]}`);
        }
      }
    }
    return { lookedUp: shadows.cost.lookedUp, changes, errors };
  });
  if (!page) return;
  assert.equal(told.lookedUp, 1);
  assert.deepEqual(told.changes, []);
  await shared.check(page, [/invalid parameter name/, /too many errors/]);
});

test('backs of open sheets under other sheets are dark, mirrored or drawn from their backs, too', async (context) => {
  const { page, told } = await inPage(context, async ({ three, ExactShadows, rendererOf, cameraOf, lampOf, rested, redOf, comparedWithRays }) => {
    const renderer = rendererOf({ width: 160, height: 100 });
    const gradientMap = new three.DataTexture(new Uint8Array(8).fill(255), 2, 1);
    gradientMap.needsUpdate = true;
    const white = (side) => new three.MeshToonMaterial({ color: 0xffffff, side, gradientMap });
    const camera = cameraOf({ from: [6, 0.95, 0.3], to: [0, 0.85, 0], fov: 50 }, 1.6);
    const compared = {};
    for (const [name, side, turn, mirror] of [['front', three.DoubleSide, -1, 1], ['back', three.DoubleSide, 1, 1],
      ['mirrored front', three.DoubleSide, -1, -1], ['mirrored back', three.DoubleSide, 1, -1], ['drawn from its back', three.BackSide, 1, 1]]) {
      const scene = new three.Scene();
      for (const [height, material, turned] of [[1, white(three.DoubleSide), -1], [0.8, white(side), turn]]) {
        const sheet = new three.Mesh(new three.PlaneGeometry(8, 8), material);
        sheet.rotation.x = turned * Math.PI / 2;
        sheet.scale.x = height < 1 ? mirror : 1;
        sheet.position.y = height;
        sheet.castShadow = sheet.receiveShadow = true;
        scene.add(sheet);
      }
      const [light, target] = lampOf({ kind: 'DirectionalLight', position: [0.9, 0.35, 0.1] });
      scene.add(light, target);
      const shadows = new ExactShadows(renderer).add(scene);
      const lookedUp = await rested(shadows, scene, camera);
      compared[name] = { lookedUp, ...comparedWithRays(redOf(renderer), renderer, scene, camera, light) };
      shadows.dispose();
    }
    return compared;
  });
  if (!page) return;
  console.log(told);
  for (const [name, { lookedUp, dark, beyond }] of Object.entries(told)) {
    assert.equal(lookedUp, 1, name);
    assert.ok(dark > 200 && beyond === 0, `${name}: ${beyond} wrong pixels beside ${dark} dark ones`);
  }
  await shared.check(page);
});
