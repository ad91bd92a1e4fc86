// Lights that are looked up, with multisampling: edges of triangles on a curved surface stay lit.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { useBrowser } from './support/browser.mjs';
import { openThree } from './support/three.mjs';

const shared = useBrowser({ angle: 'swiftshader' }); // Mesa's software renderer ignores `centroid`

test('a knot has the shadows that it has without multisampling', async () => {
  const page = await openThree(shared, undefined, { haste: 3 });
  const told = await page.evaluate(async () => {
    const { three, ExactShadows, cameraOf, redOf, rendererOf, rested } = window.page;
    /** The picture's red bytes; shadows are black, and surfaces of any slope nearly white. */
    const pictureOf = async (antialias, Material) => {
      const renderer = rendererOf({ width: 240, height: 180, antialias });
      const scene = new three.Scene();
      const sun = new three.DirectionalLight(0xffffff, 30);
      sun.position.set(-2, 3, 1);
      const knot = new three.Mesh(new three.TorusKnotGeometry(0.6, 0.18, 128, 24), new Material({ color: 0xffffff }));
      knot.position.y = 1.2;
      sun.castShadow = knot.castShadow = knot.receiveShadow = true;
      scene.add(sun, knot);
      const shadows = new ExactShadows(renderer).add(scene);
      const lookedUp = await rested(shadows, scene, cameraOf({ from: [1.5, 1.8, 2], to: [0, 0.9, 0], fov: 40 }, 4 / 3));
      const red = redOf(renderer);
      shadows.dispose();
      renderer.dispose();
      return { lookedUp, red };
    };
    const found = {};
    for (const name of ['MeshStandardMaterial', 'MeshLambertMaterial', 'MeshPhongMaterial', 'MeshToonMaterial']) {
      const [plain, smooth] = [await pictureOf(false, three[name]), await pictureOf(true, three[name])];
      const lit = plain.red.filter((value) => value > 200).length;
      // Within lit parts, away from outlines, no sample may be dark: one of four takes 64 of 255.
      const isInside = (at) => [-242, -241, -240, -239, -238, -2, -1, 0, 1, 2, 238, 239, 240, 241, 242].every((step) => plain.red[at + step] > 200);
      const dark = smooth.red.filter((value, at) => value < plain.red[at] - 40 && isInside(at)).length;
      found[name] = { lookedUp: [plain.lookedUp, smooth.lookedUp], lit, dark };
    }
    return found;
  });
  console.log(JSON.stringify(told));
  for (const [name, { lookedUp, lit, dark }] of Object.entries(told)) {
    assert.deepEqual(lookedUp, [1, 1], name);
    assert.ok(lit > 1500, `${name}: ${lit} pixels are lit`);
    assert.equal(dark, 0, `${name}: ${dark} of ${lit} lit pixels are darker with multisampling`);
  }
  await shared.check(page);
});
