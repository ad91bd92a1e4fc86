// three.js with exact shadows: they match `render --mask`, in several releases, when meshes are
// added, removed, moved, bent or instanced.

import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { useBrowser } from './support/browser.mjs';
import { repository } from './support/server.mjs';
import { compareMasks, nativeMask, openThree, releases, size } from './support/three.mjs';

const shared = useBrowser({ sharesPages: true });
const corner = { from: [5, 4, 6], to: [0, 0.6, 0], fov: 50 };
const sun = ['--sun', '0.5,1,-0.3'];
/** Messages of three.js's exporter about exported scenes. */
const exporting = [/GLTFExporter/];

/** Limits on wrong pixels: 0.03 % of all by default, and 0.02 % away from outlines. */
function assertSame({ surfaces, dark, wrong, beyond }, { most = 0.0003 } = {}) {
  assert.ok(surfaces > 0.2 * size.width * size.height && dark > 200, `${surfaces} pixels of surfaces, ${dark} in shadow`);
  assert.ok(beyond <= 0.0002 * surfaces, `${beyond} of ${surfaces} pixels, beyond outlines`);
  assert.ok(wrong <= most * surfaces, `${wrong} of ${surfaces} pixels`);
}

/** A page, or null if Chromium can't draw with the native program's GL. */
async function opened(context, release) {
  const page = await openThree(shared, release);
  const name = await page.evaluate(() => window.page.rendererName());
  if (/llvmpipe/.test(name)) return page;
  context.skip(`Chromium draws with ${name} here`);
  await page.close();
  return null;
}

const sunAndLamp = [
  ['a sun', { kind: 'DirectionalLight', position: [-0.62, 0.62, -0.3] }, ['--sun', '-0.62,0.62,-0.30']],
  ['a lamp', { kind: 'PointLight', position: [1.5, 2.2, 2.0] }, ['--light', '1.5,2.2,2']],
];
for (const release of releases)
  for (const [name, options, light] of release === releases.at(-1) ? sunAndLamp : sunAndLamp.slice(0, 1))
    test(`the sample in ${release}, ${name}`, async (context) => {
      const view = { from: [-2.6, 3.6, 10.2], to: [0.2, 1.3, -0.2], fov: 45 };
      const page = await opened(context, release);
      if (!page) return;
      const red = await page.evaluate(async ({ seen, of, wide }) => {
        const { three, ExactShadows, rendererOf, loaded, whiten, cameraOf, lampOf, drawn, redTextOf } = window.page;
        const renderer = rendererOf(wide);
        const scene = new three.Scene();
        scene.add(await loaded('/assets/pavilion.glb'), ...lampOf(of));
        whiten(scene);
        await drawn(new ExactShadows(renderer).add(scene), scene, cameraOf(seen, wide.width / wide.height));
        return redTextOf(renderer);
      }, { seen: view, of: options, wide: size });
      const mask = nativeMask(join(repository, 'assets/pavilion.glb'), view, light);
      const told = await compareMasks(page, red, mask);
      console.log(release, name, told);
      assertSame(told, { most: 0.002 }); // the sun shines along roofs
      await shared.check(page);
    });

/**
 * Compares a yard with a box, which change(world, shadows) changes after its first picture: three.js's
 * picture of the change against the native mask of its export. change() runs in the page and may
 * return its own camera.
 */
async function changed(context, change, { view = corner, light = sun, most } = {}) {
  const page = await opened(context);
  if (!page) return;
  const { red, glb } = await page.evaluate(async ({ text, seen, wide }) => {
    const { yard, changedPicture } = window.page;
    return changedPicture(yard(wide), seen, (0, eval)(`(${text})`));
  }, { text: change.toString(), seen: view, wide: size });
  const told = await compareMasks(page, red, nativeMask(Buffer.from(glb, 'base64'), view, light));
  assertSame(told, { most });
  await shared.check(page, exporting);
}

test('an object that has moved, been turned and mirrored', (context) => changed(context, ({ box }) => {
  box.position.set(-1, 0.9, 0.4);
  box.rotation.set(0.3, 0.8, 0.1);
  box.scale.set(-1, 1.5, 1);
}));

test('an object below another that moves', (context) => changed(context, ({ three, scene, box }) => {
  const arm = new three.Group();
  scene.add(arm);
  arm.add(box);
  arm.rotation.y = 1;
  arm.position.set(0.5, 0.5, 0);
}));

test('an object that was added, and one that was removed', (context) => changed(context, ({ three, scene, box, mesh }) => {
  scene.remove(box);
  const ball = mesh(new three.SphereGeometry(0.7, 24, 16));
  ball.position.set(0.6, 1.2, 0.2);
  scene.add(ball);
}));

test('an object that is hidden, and one on a layer that is not seen', (context) => changed(context, ({ three, scene, box, mesh }) => {
  box.visible = false;
  const unseen = mesh(new three.BoxGeometry(3, 0.1, 3));
  unseen.position.y = 2;
  unseen.layers.set(3);
  scene.add(unseen, Object.assign(mesh(new three.TorusGeometry(0.8, 0.25, 12, 24)), { name: 'seen' }));
  scene.getObjectByName('seen').position.y = 1.4;
}));

test('a geometry whose vertices have changed', (context) => changed(context, ({ box }) => {
  const { position } = box.geometry.attributes;
  for (let i = 0; i < position.count; ++i) position.setXYZ(i, 1.6 * position.getX(i), position.getY(i), 0.4 * position.getZ(i));
  position.needsUpdate = true;
}));

test('instances', (context) => changed(context, ({ three, scene, box, material }) => {
  const many = new three.InstancedMesh(new three.TorusKnotGeometry(0.25, 0.08, 60, 8), material, 6);
  many.castShadow = many.receiveShadow = true;
  for (let i = 0; i < 6; ++i)
    many.setMatrixAt(i, new three.Matrix4().makeTranslation(Math.cos(i) * 1.4, 0.6 + 0.2 * i, Math.sin(i) * 1.4));
  scene.remove(box);
  scene.add(many);
}));

test('a skinned mesh in its pose', (context) => changed(context, ({ three, scene, box, material }) => {
  const tube = new three.CylinderGeometry(0.2, 0.2, 2, 12, 8);
  tube.translate(0, 1, 0);
  const { position } = tube.attributes;
  const indices = [], weights = [];
  for (let i = 0; i < position.count; ++i) {
    const share = Math.min(Math.max(position.getY(i) / 2, 0), 1);
    indices.push(0, 1, 0, 0);
    weights.push(1 - share, share, 0, 0);
  }
  tube.setAttribute('skinIndex', new three.Uint16BufferAttribute(indices, 4));
  tube.setAttribute('skinWeight', new three.Float32BufferAttribute(weights, 4));
  const bones = [new three.Bone(), new three.Bone()];
  bones[0].add(bones[1]);
  bones[1].position.y = 1;
  const skinned = new three.SkinnedMesh(tube, material);
  skinned.castShadow = skinned.receiveShadow = true;
  skinned.add(bones[0]);
  skinned.bind(new three.Skeleton(bones));
  bones[1].rotation.z = 1.1;
  bones[0].rotation.x = 0.2;
  scene.remove(box);
  scene.add(skinned);
}));

test('an orthographic camera', (context) => changed(context, ({ three }) => {
  const [high, wide] = [3, 3 * 480 / 270];
  return new three.OrthographicCamera(-wide, wide, high, -high, 0.1, 100);
}, { view: { ...corner, height: 6 } }));

test('a lamp', (context) => changed(context, ({ three, scene, light }) => {
  scene.remove(light);
  const lamp = new three.PointLight(0xffffff, Math.PI, 0, 0);
  lamp.position.set(1.6, 3, 1.2);
  lamp.castShadow = true;
  scene.add(lamp);
}, { light: ['--light', '1.6,3,1.2'] }));

test('what is seen through the holes of an alpha-tested sheet', (context) => changed(context, (world) => {
  const sheet = window.page.fence(world, { map: window.page.pattern() });
  sheet.castShadow = false;
  world.scene.add(sheet);
}, { most: 0.001 }));

test('alpha-tested sheets that cast whole triangles, of one side, instanced', (context) => changed(context, (world, shadows) => {
  shadows.alphaTestedCast = 'whole';
  const { three, scene } = world;
  const { geometry, material } = window.page.fence(world, { map: window.page.pattern(), side: three.FrontSide });
  const many = new three.InstancedMesh(geometry, material, 3);
  many.castShadow = many.receiveShadow = true;
  for (let i = 0; i < 3; ++i)
    many.setMatrixAt(i, new three.Matrix4().makeRotationY(0.5 + 1.1 * i).setPosition(1.6 - 1.7 * i, 1.3 + 0.4 * i, 1.2 - i));
  scene.add(many);
}, { light: [...sun, '--cast-masked'], most: 0.001 }));

test('a see-through sheet neither casts nor disturbs', (context) => changed(context, (world) => {
  const { fence, pattern } = window.page;
  world.scene.add(Object.assign(fence(world, { map: pattern(), transparent: true, opacity: 0.001 }), { name: 'see-through' }));
}));
