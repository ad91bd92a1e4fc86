// Clipping planes of three.js in exact shadows: the renderer's and materials', judged by rays.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { useBrowser } from './support/browser.mjs';
import { inPlaceOf, openThree, releasesOf } from './support/three.mjs';

const shared = useBrowser({ sharesPages: true });

/** Runs `act(page, house)` in a page with three.js; returns its result. */
async function inPage(act, release) {
  const page = await openThree(shared, release, { haste: 3 });
  const told = await page.evaluate(([made, text]) => {
    const run = (source) => (0, eval)(`(${source})`);
    return run(text)(window.page, run(made));
  }, [house.toString(), act.toString()]);
  await shared.check(page);
  return told;
}

/** A house of white walls with a roof, a chest and columns, a sun or a lamp, and a camera. */
function house({ three, rendererOf, lampOf, cameraOf }, { lamp = false, aim = [0.45, 1, 0.37] } = {}) {
  const renderer = rendererOf({ width: 160, height: 100 });
  const scene = new three.Scene();
  const gradientMap = new three.DataTexture(new Uint8Array(8).fill(255), 2, 1);
  gradientMap.needsUpdate = true;
  const material = new three.MeshToonMaterial({ color: 0xffffff, side: three.DoubleSide, gradientMap });
  const placed = (mesh, at) => {
    mesh.castShadow = mesh.receiveShadow = true;
    mesh.position.set(...at);
    scene.add(mesh);
    return mesh;
  };
  const boxOf = (size, at) => placed(new three.Mesh(new three.BoxGeometry(...size), material), at);
  boxOf([9, 0.2, 9], [0, -0.1, 0]);
  for (const side of [-1, 1]) {
    boxOf([0.2, 2, 4.4], [2.1 * side, 1.01, 0]);
    boxOf([4, 2, 0.2], [0, 1.01, 2.1 * side]);
  }
  boxOf([5, 0.2, 5], [0, 2.13, 0]);
  boxOf([0.9, 0.7, 0.6], [-0.6, 0.37, -0.5]);
  const columns = placed(new three.InstancedMesh(new three.CylinderGeometry(0.15, 0.15, 1.6, 7), material, 2), [0, 0.82, 0]);
  columns.setMatrixAt(0, new three.Matrix4().makeTranslation(0.9, 0, 0.8));
  columns.setMatrixAt(1, new three.Matrix4().makeTranslation(1.1, 0, -1.1));
  const [light, target] = lampOf(lamp ? { kind: 'PointLight', position: [0.15, 1.47, 0.31] }
    : { kind: 'DirectionalLight', position: aim });
  scene.add(light, ...(target ? [target] : []));
  const camera = cameraOf({ from: [4.3, 6.1, 5.2], to: [0, 0.4, 0], fov: 50 }, 1.6);
  return { renderer, scene, light, camera, material };
}

const assertRight = (name, { surfaces, dark, wrong, beyond }) => {
  assert.ok(surfaces > 4000 && dark > 150, `${name}: ${surfaces} pixels of surfaces, ${dark} in shadow`);
  assert.ok(beyond <= 1 && wrong <= 0.02 * surfaces, `${name}: ${wrong} of ${surfaces} pixels are wrong, ${beyond} of them beyond outlines`);
};

for (const release of releasesOf('three-0.152', 'three'))
  for (const lamp of release === inPlaceOf('three') ? [false, true] : [false])
    test(`a house cut open, under a ${lamp ? 'lamp' : 'sun'}, in ${release}`, async () => {
      const told = await inPage(new Function('page', 'house', `return (${everyCut})(page, house, ${lamp})`), release);
      console.log(told);
      for (const [name, of] of Object.entries(told)) assertRight(name, of);
      assert.ok(told['local, cut'].dark !== told['local, whole'].dark);
      assert.ok(told.intersection.surfaces > told['local, cut'].surfaces);
    });

async function everyCut({ three, ExactShadows, drawn, rested, redOf, comparedWithRays }, makeHouse, lamp) {
  const { renderer, scene, light, camera, material } = makeHouse(window.page, { lamp });
  const shadows = new ExactShadows(renderer, { lookups: 0 }).add(scene);
  const roofOff = new three.Plane(new three.Vector3(0.1, -1, 0.05).normalize(), 1.37);
  const front = new three.Plane(new three.Vector3(-0.8, 0, -0.6), 1.1);
  const told = {};
  const judge = async (name) => {
    await drawn(shadows, scene, camera);
    told[name] = comparedWithRays(redOf(renderer), renderer, scene, camera, light);
  };
  if (!lamp) await judge('unclipped');
  material.clippingPlanes = [roofOff, front];
  material.clipShadows = true;
  if (!lamp) await judge('local, not enabled');
  renderer.localClippingEnabled = true;
  await judge('local, cut');
  material.clipShadows = false;
  await judge('local, whole');
  material.clipIntersection = true;
  await judge('intersection, whole');
  material.clipShadows = true;
  await judge('intersection');
  material.clippingPlanes = [front];
  material.clipIntersection = false;
  renderer.clippingPlanes = [roofOff];
  await judge('global and local');
  material.clippingPlanes = null;
  await judge('global');
  // A light at rest is looked up.
  shadows.dispose();
  const looking = new ExactShadows(renderer).add(scene);
  for (const name of ['looked up, global', 'looked up, low', 'looked up, cut']) {
    if (await rested(looking, scene, camera) !== 1) throw new Error(`${name}: no light is looked up`);
    told[name] = comparedWithRays(redOf(renderer), renderer, scene, camera, light);
    if (name === 'looked up, global') {
      renderer.clippingPlanes = [new three.Plane(new three.Vector3(0, -1, 0), 0.8)]; // into hollow walls
      continue;
    }
    renderer.clippingPlanes = [];
    material.clippingPlanes = [roofOff, front];
  }
  return told;
}

test('a plane that is dragged is followed in every frame', async () => {
  const told = await inPage(async ({ three, ExactShadows, rested, redOf, comparedWithRays }, makeHouse) => {
    const { renderer, scene, light, camera, material } = makeHouse(window.page, { aim: [-0.7, 1, 0.4] });
    renderer.localClippingEnabled = true;
    const plane = new three.Plane(new three.Vector3(0, -1, 0), 1.9);
    Object.assign(material, { clippingPlanes: [plane], clipShadows: true });
    const shadows = new ExactShadows(renderer).add(scene);
    await rested(shadows, scene, camera);
    const frames = [], lookedUp = [shadows.cost.lookedUp];
    for (const [height, tilt] of [[1.5, 0], [1.5, 0.2], [0.9, 0.2], [0.3, 0.1], [2.5, 0]]) {
      plane.normal.set(tilt, -1, 0.1 * tilt).normalize();
      plane.constant = height;
      shadows.render(scene, camera);
      frames.push(comparedWithRays(redOf(renderer), renderer, scene, camera, light));
      lookedUp.push(shadows.cost.lookedUp);
    }
    lookedUp.push(await rested(shadows, scene, camera));
    // Planes that only clip visible surfaces leave the light looked up.
    material.clipShadows = false;
    plane.constant = 1.2;
    await rested(shadows, scene, camera);
    plane.constant = 0.8;
    shadows.render(scene, camera);
    frames.push(comparedWithRays(redOf(renderer), renderer, scene, camera, light));
    lookedUp.push(shadows.cost.lookedUp);
    return { frames, lookedUp };
  });
  console.log(told);
  for (const [i, frame] of told.frames.entries()) assertRight(`frame ${i}`, frame);
  assert.deepEqual(told.lookedUp, [1, 0, 0, 0, 0, 0, 1, 1]);
});

test('more planes than the engine takes are refused in a sentence, by ready()', async () => {
  const told = await inPage(async ({ three, ExactShadows }, makeHouse) => {
    const { renderer, scene, camera } = makeHouse(window.page);
    const shadows = new ExactShadows(renderer).add(scene);
    renderer.clippingPlanes = Array.from({ length: 13 }, () => new three.Plane(new three.Vector3(0, -1, 0), 1));
    shadows.render(scene, camera);
    const problem = await shadows.ready().then(() => 'none', ({ message }) => message);
    return problem;
  });
  assert.match(told, /^13 planes are more than the 12/);
});
