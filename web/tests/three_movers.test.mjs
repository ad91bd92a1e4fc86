// Casters that move over a lookup in three.js: the lookup is kept in every frame, and the picture
// has the shadows of `render --mask`.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { useBrowser } from './support/browser.mjs';
import { compareMasks, inNativeGl, nativeMask, size } from './support/three.mjs';

const shared = useBrowser({ sharesPages: true });

const inPage = (...of) => inNativeGl(shared, ...of);

test('a figure walks through a resting pavilion, rests, and starts again', async (context) => {
  const view = { from: [-2.6, 3.0, 8.2], to: [0.2, 1.3, -0.2], fov: 45 };
  const { page, told } = await inPage(context, async ({ three, ExactShadows, rendererOf, loaded, walkingFigure, glbAsPosed, base64Of, whiten, cameraOf, lampOf, drawn, redTextOf }, { seen, wide }) => {
    const renderer = rendererOf(wide);
    const camera = cameraOf(seen, wide.width / wide.height);
    const scene = new three.Scene();
    const { figure, pose } = await walkingFigure();
    scene.add(await loaded('/assets/pavilion.glb'), figure, ...lampOf({ kind: 'DirectionalLight', position: [-0.62, 0.62, -0.3] }));
    figure.rotation.y = Math.PI / 2;
    whiten(scene);
    const shadows = new ExactShadows(renderer).add(scene);
    const pause = (milliseconds) => new Promise((resolve) => { setTimeout(resolve, milliseconds); });
    const walkTo = (step) => {
      pose(0.11 * step);
      figure.position.set(-2.4 + 0.21 * (step % 20), 0.47, 1.1 + 0.13 * (step % 20));
    };
    walkTo(0);
    await drawn(shadows, scene, camera);
    let step = 0;
    // It walks while the map is built: 200 ms a frame leave time for that.
    for (const since = performance.now(); shadows.cost.lookedUp !== 1 && performance.now() - since < 60000;) {
      await pause(200);
      walkTo(++step);
      shadows.render(scene, camera);
    }
    const frames = { walking: 0, kept: 0 };
    const methods = new Set(), judged = [];
    const draw = async (judges) => {
      shadows.render(scene, camera);
      frames.walking += 1;
      frames.kept += shadows.cost.lookedUp;
      for (const { method, reason } of shadows.lights) methods.add(`${method}: ${reason}`);
      if (judges) judged.push({ red: redTextOf(renderer), glb: base64Of(await glbAsPosed(scene)) });
    };
    for (let i = 0; i < 20; ++i) {
      walkTo(++step);
      await draw(i % 10 === 0);
    }
    for (let i = 0; i < 4; ++i) { // it rests, longer than half a second
      await pause(300);
      await draw(i === 3);
    }
    for (let i = 0; i < 10; ++i) { // and starts again
      walkTo(++step);
      await draw(i === 0 || i === 9);
    }
    const { vertexRuns } = shadows.cost;
    shadows.dispose();
    return { ...frames, methods: [...methods], judged, vertexRuns };
  }, { seen: view, wide: size });
  if (!page) return;
  assert.equal(told.kept, told.walking, `lookups kept in ${told.kept} of ${told.walking} frames`);
  assert.deepEqual(told.methods, ['lookup and movers: casters that came or moved lately are counted on top: 1']);
  assert.ok(told.vertexRuns > 0);
  for (const [i, { red, glb }] of told.judged.entries()) {
    const compared = await compareMasks(page, red, nativeMask(Buffer.from(glb, 'base64'), view, ['--sun', '-0.62,0.62,-0.30']));
    console.log(`picture ${i}`, compared);
    assert.ok(compared.surfaces > 0.2 * size.width * size.height && compared.dark > 1000, JSON.stringify(compared));
    assert.ok(compared.beyond <= 0.0002 * compared.surfaces, `picture ${i}: ${compared.beyond} of ${compared.surfaces} pixels, beyond outlines`);
    assert.ok(compared.wrong <= 0.003 * compared.surfaces, `picture ${i}: ${compared.wrong} of ${compared.surfaces} pixels`);
  }
  await shared.check(page);
});

test('a box that starts to move leaves the map, and is taken into another after a long rest', async (context) => {
  const view = { from: [5, 4, 6], to: [0, 0.6, 0], fov: 50 };
  const { page, told } = await inPage(context, async ({ yard, ExactShadows, cameraOf, glbAsPosed, base64Of, whiten, rested, redTextOf }, { seen, wide }) => {
    const { renderer, scene, box, light } = yard(wide);
    whiten(scene);
    const camera = cameraOf(seen, wide.width / wide.height);
    const shadows = new ExactShadows(renderer, { lookups: 4 }).add(scene);
    const stages = [], judged = [];
    const draw = async () => {
      shadows.render(scene, camera);
      stages.push(shadows.lights.map(({ method, reason, light: of }) => (of === light ? `${method}: ${reason}` : 'another light')));
      judged.push({ red: redTextOf(renderer), glb: base64Of(await glbAsPosed(scene)) });
    };
    const until = async (method) => {
      for (const since = Date.now(); shadows.lights[0].method !== method && Date.now() - since < 60000;) {
        await new Promise((resolve) => { setTimeout(resolve, 100); });
        shadows.render(scene, camera);
      }
    };
    await rested(shadows, scene, camera);
    await draw();
    box.position.x = 0.9;
    await draw(); // the map had the box
    await until('lookup and movers');
    box.position.x = 1.3;
    await draw();
    await until('lookup'); // it rests for five of the page's seconds
    await draw();
    box.parent.remove(box);
    await draw();
    shadows.dispose();
    return { stages, judged };
  }, { seen: view, wide: size }, undefined, { haste: 3 });
  if (!page) return;
  const moved = 'casters have come, gone or started to move within half a second';
  assert.deepEqual(told.stages, [['lookup: it rests, and so do all casters'], [`mask: ${moved}`],
    ['lookup and movers: casters that came or moved lately are counted on top: 1'],
    ['lookup: it rests, and so do all casters'], [`mask: ${moved}`]]);
  for (const [i, { red, glb }] of told.judged.entries()) {
    const compared = await compareMasks(page, red, nativeMask(Buffer.from(glb, 'base64'), view, ['--sun', '0.5,1,-0.3']));
    console.log(`stage ${i}`, compared);
    assert.equal(compared.beyond, 0, `stage ${i}`);
  }
  await shared.check(page);
});

test('four lights are looked up while a mesh morphs, another moves and a third only receives', async (context) => {
  const { page, told } = await inPage(context, async ({ three, yard, ExactShadows, cameraOf, lampOf, whiten, drawn, redOf }, { wide }) => {
    const { renderer, scene, light } = yard(wide);
    light.intensity = 1;
    for (const of of [{ kind: 'PointLight', position: [2, 3, 2] }, { kind: 'SpotLight', position: [-1, 5, 1] }, { kind: 'DirectionalLight', position: [-0.4, 1, 0.8] }]) {
      const [lamp, ...target] = lampOf(of);
      lamp.intensity = 1;
      scene.add(lamp, ...target);
    }
    const box = new three.BoxGeometry(0.6, 0.6, 0.6, 3, 3, 3);
    const bent = box.attributes.position.clone();
    for (let i = 0; i < bent.count; ++i) bent.setX(i, bent.getX(i) + 0.8 * bent.getY(i) ** 2);
    box.morphAttributes.position = [bent];
    const morphing = new three.Mesh(box), moving = new three.Mesh(new three.TorusGeometry(0.4, 0.15, 8, 20)), receiver = new three.Mesh(new three.PlaneGeometry(1.5, 1.5));
    morphing.position.set(-1.5, 1, 0.6);
    receiver.position.set(1.4, 0.8, -1);
    for (const mesh of [morphing, moving, receiver]) {
      mesh.castShadow = mesh !== receiver;
      mesh.receiveShadow = true;
      mesh.material = new three.MeshStandardMaterial({ side: three.DoubleSide });
      scene.add(mesh);
    }
    whiten(scene);
    const camera = cameraOf({ from: [5, 4, 6], to: [0, 0.6, 0], fov: 50 }, wide.width / wide.height);
    const set = (step) => {
      morphing.morphTargetInfluences[0] = 0.5 + 0.5 * Math.sin(0.7 * step);
      moving.position.set(-1.5 + 0.2 * (step % 12), 1.5, 1.2);
      moving.rotation.x = 0.4 * step;
      receiver.position.z = -1 + 0.1 * (step % 9);
    };
    const of = new ExactShadows(renderer, { lookups: 4 }).add(scene);
    set(0);
    await drawn(of, scene, camera);
    let step = 0;
    for (const since = performance.now(); of.cost.lookedUp !== 4 && performance.now() - since < 60000;) {
      await new Promise((resolve) => { setTimeout(resolve, 150); });
      set(++step);
      of.render(scene, camera);
    }
    const steps = [1, 2, 3, 4, 5].map((i) => step + i), lookedUp = [], pictures = [];
    for (const at of steps) {
      set(at);
      of.render(scene, camera);
      lookedUp.push(of.cost.lookedUp);
      pictures.push(redOf(renderer));
    }
    const methods = of.lights.map(({ light: { type }, method }) => `${type} ${method}`);
    of.dispose();
    const masks = new ExactShadows(renderer, { lookups: 0 }).add(scene);
    await drawn(masks, scene, camera);
    const wrong = pictures.map((red, i) => {
      set(steps[i]);
      masks.render(scene, camera);
      return redOf(renderer).filter((value, k) => Math.abs(value - red[k]) > 2).length;
    });
    const reasons = masks.lights.map(({ method, reason }) => `${method}: ${reason}`);
    masks.dispose();
    return { lookedUp, methods, wrong, reasons };
  }, { wide: size });
  if (!page) return;
  assert.deepEqual(told.lookedUp, [4, 4, 4, 4, 4]);
  assert.deepEqual(told.methods, ['PointLight', 'SpotLight', 'DirectionalLight', 'DirectionalLight'].map((type) => `${type} lookup and movers`));
  assert.deepEqual(new Set(told.reasons), new Set(['mask: lookups is 0, or its materials have no texture left for a map']));
  for (const wrong of told.wrong) assert.ok(wrong <= 40, `${told.wrong} pixels differ from masks`);
  await shared.check(page);
});
