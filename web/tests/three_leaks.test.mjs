// Materials that three.js's pages throw away are let go, and leave no errors of the GL.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { useBrowser } from './support/browser.mjs';
import { openThree } from './support/three.mjs';

const shared = useBrowser();

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
