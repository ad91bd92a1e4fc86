// Leaves and glass of three.js cast while they or a light move: by a map of these alone, beside a mask
// of the others. Judged by rays.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { useBrowser } from './support/browser.mjs';
import { inFoliage, inPlaceOf } from './support/three.mjs';

const shared = useBrowser({ sharesPages: true });

const inMotion = async ({ three, ExactShadows, redOf, comparedWithRays }, { floorOf, treeOf, leafAtlas, white, wholly, comparedTints }, { kind, position, glass }) => {
  const { renderer, scene, light, camera } = floorOf(window.page, { kind, position, width: 150, height: 100 });
  const box = scene.children[1];
  const panes = [[1.6, 1.2, 0.2, 1.2], [1, 1.4, -0.3, 0.8]].map(([width, height, x, y]) => {
    const pane = new three.Mesh(new three.PlaneGeometry(width, height), white({ transparent: true, opacity: 0.5 }));
    pane.position.set(x, y, 0);
    pane.rotation.set(-1.3, 0.2, 0);
    pane.castShadow = true;
    return pane;
  });
  const moving = glass ? new three.Group().add(...panes) : treeOf(white({ map: leafAtlas(), alphaTest: 0.4 }));
  scene.add(moving);
  const shadows = new ExactShadows(renderer, { transparentCast: 'tint' }).add(scene);
  await wholly(window.page, shadows, scene, camera);
  const told = {};
  const judge = (name) => {
    shadows.render(scene, camera);
    told[name] = { ...(glass ? comparedTints(renderer, scene, camera, light, (mesh) => (panes.includes(mesh) ? [0.5, 0.5, 0.5] : null))
      : comparedWithRays(redOf(renderer), renderer, scene, camera, light)), method: shadows.lights[0].method };
  };
  judge('rests');
  light.position.x += 0.4;
  judge('light');
  moving.position.x += 0.3;
  moving.rotation.y = 0.4;
  judge('leaves');
  box.position.z -= 0.45;
  judge('box');
  for (const since = performance.now(); performance.now() - since < 1500;) { // the light rests, the leaves don't
    moving.position.z += 0.01;
    shadows.render(scene, camera);
    await new Promise((resolve) => { setTimeout(resolve, 100); });
  }
  judge('leaves alone');
  return { told, error: renderer.getContext().getError() };
};

for (const [release, kind, position, glass] of [['three-0.152', 'DirectionalLight', [0.4, 1, 0.3], false], ['three', 'PointLight', [0.3, 3.4, 0.6], true]])
  test(`${glass ? 'panes' : 'leaves'}, ${kind}, in ${inPlaceOf(release)}`, async () => {
    const { told: { told, error } } = await inFoliage(shared, inMotion, { release, given: { kind, position, glass } });
    console.log(told);
    assert.equal(error, 0);
    assert.equal(told.rests.method, 'lookup');
    for (const [name, { method, surfaces, compared = surfaces, dark, tinted = dark, wrong, beyond }] of Object.entries(told)) {
      if (name !== 'rests') assert.equal(method, 'mask and cutouts', name);
      assert.ok(compared > 3000 && tinted > 150, `${name}: ${compared} pixels, ${tinted} behind leaves or glass`);
      assert.ok(beyond <= 0.0002 * compared && wrong <= 0.04 * compared, `${name}: ${wrong} wrong, ${beyond} beyond outlines`);
    }
  });

test('too many are told, and cast nothing until all rests', async () => {
  const { told } = await inFoliage(shared, async ({ three, ExactShadows }, { floorOf, leafAtlas, white, wholly }) => {
    const { renderer, scene, light, camera } = floorOf(window.page, { width: 60, height: 40 });
    const many = new three.Mesh(new three.PlaneGeometry(2, 2, 40, 13), white({ map: leafAtlas(), alphaTest: 0.4 }));
    many.position.y = 1.2;
    many.rotation.x = -1.4;
    many.castShadow = true;
    scene.add(many);
    const shadows = new ExactShadows(renderer).add(scene);
    await wholly(window.page, shadows, scene, camera);
    light.position.x += 0.01;
    shadows.render(scene, camera);
    const [{ method, reason }] = shadows.lights;
    await wholly(window.page, shadows, scene, camera);
    return { method, reason, after: shadows.lights[0].method };
  });
  assert.equal(told.method, 'mask');
  assert.equal(told.reason, 'it has moved within half a second; leaves and glass cast nothing: its casters have 1040 triangles, more than 1000');
  assert.equal(told.after, 'lookup');
});
