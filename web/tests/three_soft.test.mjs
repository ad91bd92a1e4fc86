// Lights with a radius in three.js are looked up at rest: judged by rays to each of their points.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { useBrowser } from './support/browser.mjs';
import { pointsOfLight } from './support/native.mjs';
import { inFoliage, inPlaceOf } from './support/three.mjs';

const shared = useBrowser({ sharesPages: true });

const samples = 16;

const kinds = [
  ['three-0.152', 'DirectionalLight', [0.4, 1, 0.3], 0.15, ['--sun', '0.4,1,0.3', '--sun-angle', `${0.3 * 180 / Math.PI}`]],
  ['three', 'PointLight', [0.5, 3.4, 0.4], 0.4, ['--light', '0.5,3.4,0.4', '--light-radius', '0.4']],
];

for (const [release, kind, position, radius, light] of kinds)
  test(`boxes, sheets and a receiver that masks lack, ${kind} in ${inPlaceOf(release)}`, async () => {
    const { told } = await inFoliage(shared, async ({ three, ExactShadows, rested }, { floorOf, white, comparedShares }, given) => {
      const { renderer, scene, light: lamp, camera } = floorOf(window.page, { ...given, width: 150, height: 100 });
      const added = (geometry, settings, at, turned = [0, 0, 0]) => {
        const mesh = new three.Mesh(geometry, white(settings));
        mesh.position.set(...at);
        mesh.rotation.set(...turned);
        mesh.castShadow = mesh.receiveShadow = true;
        scene.add(mesh);
        return mesh;
      };
      added(new three.BoxGeometry(1, 0.2, 0.6), { side: three.FrontSide }, [0.4, 1.2, -0.2], [0.2, 0.5, 0.1]);
      added(new three.PlaneGeometry(1.4, 1), {}, [-0.9, 1, -0.4], [-1.2, 0.2, 0]);
      // Behind the floor as the light sees it, and in front of it for the camera.
      added(new three.PlaneGeometry(1.2, 1.2), { transparent: true, side: three.DoubleSide }, [-0.4, 0.5, 1.4], [-1.5, 0, 0.3]).castShadow = false;
      const shadows = new ExactShadows(renderer, { lightSamples: given.samples }).add(scene).setRadius(lamp, given.radius);
      const lookedUp = await rested(shadows, scene, camera);
      return { lookedUp, ways: shadows.lights.map(({ method, reason }) => [method, reason]), drawn: shadows.cost.vertexRuns,
        ...comparedShares(renderer, scene, camera, given.points), error: renderer.getContext().getError() };
    }, { release, given: { kind, position, radius, samples, points: pointsOfLight(light, samples) } });
    console.log(told);
    assert.deepEqual(told.ways, [['lookup', 'it rests, and so do all casters']]);
    assert.equal(told.drawn, 0, 'no mask is drawn');
    assert.equal(told.error, 0);
    assert.ok(told.compared > 6000 && told.grey > 200, `${told.compared} pixels, ${told.grey} of them grey`);
    assert.ok(told.beyond <= 0.0002 * told.compared && told.wrong <= 0.04 * told.compared, `${told.wrong} wrong, ${told.beyond} beyond outlines`);
  });

test('whatever moves is masked and told; other radii and samples make another map; cutouts and receivers out of reach', async () => {
  const { told } = await inFoliage(shared, async ({ three, ExactShadows, rested, drawn, redOf }, { floorOf, white, blobs }) => {
    const { renderer, scene, light, floor, camera } = floorOf(window.page, { width: 120, height: 80 });
    const box = scene.children[1];
    const shadows = new ExactShadows(renderer, { lightSamples: 8 }).add(scene).setRadius(light, 0.05);
    const steps = {};
    const noted = async (name, isLookedUp) => {
      if (isLookedUp) await rested(shadows, scene, camera);
      else await drawn(shadows, scene, camera);
      const [{ method, reason }] = shadows.lights;
      steps[name] = { method, reason, red: redOf(renderer) };
    };
    await noted('rests', true);
    for (const since = performance.now(); performance.now() - since < 700;) {
      box.position.x += 0.01;
      await drawn(shadows, scene, camera);
    }
    await noted('moves');
    await noted('rests again', true);
    shadows.setRadius(light, 0.3);
    await noted('another radius');
    await noted('another radius, at rest', true);
    shadows.lightSamples = 16;
    await noted('more samples');
    await noted('more samples, at rest', true);
    const leaf = new three.Mesh(new three.PlaneGeometry(1, 1), white({ map: blobs(4, 4), alphaTest: 0.5 }));
    leaf.position.y = 1;
    leaf.castShadow = true;
    scene.add(leaf);
    await noted('leaf');
    for (const since = Date.now(); !shadows.notLookedUp.size && Date.now() - since < 60000;) {
      await new Promise((resolve) => { setTimeout(resolve, 150); });
      shadows.render(scene, camera);
    }
    await noted('leaf, at rest');
    scene.remove(leaf);
    await noted('no leaf', true);
    const pane = new three.Mesh(new three.PlaneGeometry(1, 1), white({ transparent: true }));
    pane.receiveShadow = true;
    pane.position.set(0, -20, 0);
    scene.add(pane);
    await noted('far pane');
    await noted('far pane, at rest', true);
    const differ = (a, b) => steps[a].red.filter((value, i) => Math.abs(value - steps[b].red[i]) > 12).length;
    return { moved: differ('moves', 'rests again'), radius: differ('another radius', 'another radius, at rest'),
      samples: differ('more samples', 'more samples, at rest'), changed: differ('rests', 'another radius'), floor: floor.castShadow,
      ways: Object.fromEntries(Object.entries(steps).map(([name, { method, reason }]) => [name, `${method}: ${reason}`])) };
  }, { allowed: [/^Light '/] });
  console.log(told);
  const rests = 'lookup: it rests, and so do all casters';
  for (const name of ['rests', 'rests again', 'another radius, at rest', 'more samples, at rest', 'no leaf', 'far pane, at rest']) assert.equal(told.ways[name], rests, name);
  assert.equal(told.ways.moves, 'mask: it has a radius, and casters have moved within half a second');
  for (const name of ['another radius', 'more samples']) assert.equal(told.ways[name], 'mask: it has moved within half a second', name);
  assert.equal(told.ways['leaf, at rest'], 'mask: it has a radius, and cutouts or tints cast');
  assert.match(told.ways['far pane'], /^mask: /);
  assert.ok(told.changed > 30);
  for (const name of ['moved', 'radius', 'samples']) assert.ok(told[name] <= 12, `${told[name]} pixels of ${name} differ from the mask's`);
});
