// Meshes and materials of three.js that are not a plain mesh with one material: right by rays, or
// one warning that names them.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { useBrowser } from './support/browser.mjs';
import { openThree, releasesOf } from './support/three.mjs';

const shared = useBrowser({ sharesPages: true });

/**
 * Runs `act(world, page)` in a page with three.js, in a court with shadows that are masked or
 * looked up. It calls world.judge(name) for each picture. Returns the judgements and the page's
 * warnings.
 */
async function inCourt(act, { release, looked = false, settings = {} } = {}) {
  const page = await openThree(shared, release, { haste: looked ? 5 : 1 }); // movers rest for five seconds
  const told = await page.evaluate(async ([text, lookups, given]) => {
    const { ExactShadows, rendererOf, court, redOf, judged, rested } = window.page;
    const renderer = rendererOf({ width: 160, height: 100 });
    renderer.localClippingEnabled = true;
    const world = court(given);
    const { scene, camera, light } = world;
    const shadows = new ExactShadows(renderer, { lookups }).add(scene);
    const told = {};
    const draw = async () => {
      if (await rested(shadows, scene, camera, lookups) !== lookups) throw new Error(`${shadows.cost.lookedUp} lights are looked up`);
      // Surfaces that masks can't show lack the shadows of movers.
      for (const since = Date.now(); lookups && shadows.lights[0].method !== 'lookup' && Date.now() - since < 60000;) {
        await new Promise((resolve) => { setTimeout(resolve, 150 * (window.haste ?? 1)); });
        shadows.render(scene, camera);
      }
    };
    const judge = async (name, before = () => {}) => {
      await draw();
      const red = redOf(renderer);
      before();
      told[name] = judged(red, 160, 100, scene, camera, light);
    };
    await (0, eval)(`(${text})`)({ ...world, looked: lookups > 0, renderer, shadows, judge, draw }, window.page);
    return told;
  }, [act.toString(), looked ? 1 : 0, settings]);
  const warnings = page.reports.filter((text) => /shadow/i.test(text));
  await shared.check(page, [/shadow/i]);
  return { told, warnings };
}

function assertRight(told) {
  console.log(told);
  for (const [name, of] of Object.entries(told)) {
    assert.ok(of.surfaces > 4000 && of.dark > 300, `${name}: ${of.surfaces} pixels of surfaces, ${of.dark} in shadow`);
    assert.ok(of.beyond <= 0.0002 * of.surfaces && of.wrong <= 0.02 * of.surfaces,
      `${name}: ${of.wrong} of ${of.surfaces} pixels are wrong, ${of.beyond} of them beyond outlines`);
  }
}

for (const looked of [false, true])
  test(`a material array with a see-through side, with different sides, with different planes, ${looked ? 'looked up' : 'masked'}`, async () => {
    const { told, warnings } = await inCourt(async ({ chest, wall, columns, material, scene, judge }, { three }) => {
      const variant = (own) => Object.assign(material.clone(), own);
      const glass = variant({ transparent: true, opacity: 0 });
      const double = variant({ side: three.DoubleSide });
      chest.scale.set(2, 2, 2);
      chest.position.set(0.2, 0.8, 0.5);
      chest.material = [double, double, glass, double, glass, double];
      await judge('glass');
      chest.material = [double, double, double, double, double, double];
      chest.geometry.groups.splice(2, 1); // the top is not drawn
      await judge('a side without a group');
      wall.material = [double, double, double, variant({ side: three.BackSide }), material, double];
      for (const column of columns) column.material = [material, double, double];
      await judge('sides');
      const plane = (x, y, z, constant) => new three.Plane(new three.Vector3(x, y, z).normalize(), constant);
      wall.material = [double, double, double, double, variant({ side: three.DoubleSide, clippingPlanes: [plane(0.6, -1, 0, 1.1)], clipShadows: true }),
        variant({ side: three.DoubleSide, clippingPlanes: [plane(-0.3, -1, 0, 0.9)], clipShadows: true })];
      await judge('planes');
      scene.remove(chest);
      await judge('planes alone');
    }, { looked });
    assertRight(told);
    assert.deepEqual(warnings, []);
  });

for (const release of releasesOf('three-0.169', 'three'))
  for (const looked of [false, true])
    test(`a BatchedMesh, ${looked ? 'looked up' : 'masked'}, in ${release}`, async () => {
      const { told, warnings } = await inCourt(async ({ scene, material, chest, judge }, { three }) => {
        const batch = new three.BatchedMesh(8, 2000, 4000, material);
        batch.castShadow = batch.receiveShadow = true;
        const ids = [new three.BoxGeometry(0.7, 0.5, 0.9), new three.CylinderGeometry(0.15, 0.25, 1.1, 9)].map((geometry) => batch.addGeometry(geometry));
        const add = (id) => (batch.addInstance ? batch.addInstance(id) : id);
        const instances = [0, 1, 1, 0, 1].map((n) => add(ids[n]));
        instances.forEach((instance, i) => batch.setMatrixAt(instance,
          new three.Matrix4().makeRotationY(0.4 * i).setPosition(1.3 * (i % 3) - 1.2, 0.8 + 0.1 * i, 0.9 * Math.floor(i / 3) + 0.7)));
        scene.remove(chest);
        scene.add(batch);
        await judge('all');
        batch.setVisibleAt(instances[1], false);
        batch.setMatrixAt(instances[2], new three.Matrix4().makeTranslation(2.4, 1.2, 1.6));
        await judge('hidden and moved');
        batch.deleteInstance(instances[0]);
        batch.setVisibleAt(instances[1], true);
        batch.position.x = 0.3;
        await judge('deleted');
        batch.material = Object.assign(material.clone(), { transparent: true, opacity: 0 });
        await judge('see-through');
      }, { release, looked });
      assertRight(told);
      assert.deepEqual(warnings, []);
    });

for (const looked of [false, true])
  test(`wireframes ${looked ? 'receive by lookup' : 'are left out'}, with a warning each`, async () => {
    const { told, warnings } = await inCourt(async ({ scene, material, ground, placed, columns, chest, judge, looked }, { three }) => {
      const cage = placed(new three.BoxGeometry(1.6, 0.8, 1.6), [0.2, 1.6, 0.9]);
      cage.material = Object.assign(material.clone(), { wireframe: true, colorWrite: false, depthWrite: false });
      cage.name = 'cage';
      await judge('a wireframe');
      chest.material = material.clone();
      chest.material.wireframe = true;
      chest.material.colorWrite = chest.material.depthWrite = false;
      chest.name = 'chest';
      await judge('a material that becomes one');
    }, { looked });
    assertRight(told);
    assert.equal(warnings.length, 2, `${warnings}`);
    assert.match(warnings[0], /^Mesh 'cage' casts no shadow, .*: its material is a wireframe\.$/);
    assert.match(warnings[1], /^Mesh 'chest' casts no shadow, .*: its material is a wireframe\.$/);
  });

for (const looked of [false, true])
  test(`displaced surfaces cast and receive as they are drawn, ${looked ? 'looked up' : 'masked'}; a warning of those that bend`, async () => {
    const { told, warnings } = await inCourt(async ({ material, placed, judge, scene, shadows }, { three }) => {
      const { blobs } = await import('/tests/foliage.js'), { displaced } = await import('/tests/texel-alpha.js');
      const bumps = blobs(7, 5), { data } = bumps.image;
      for (let i = 0; i < data.length; i += 4) data[i] = data[i + 3];
      Object.assign(bumps, { wrapS: three.MirroredRepeatWrapping, wrapT: three.RepeatWrapping, rotation: 0.2 });
      bumps.repeat.set(1.3, 0.9);
      const sheet = placed(new three.PlaneGeometry(2.4, 2, 24, 20).rotateX(-Math.PI / 2), [0.2, 1.4, 0.3]);
      sheet.material = Object.assign(material.clone(), { displacementMap: bumps, displacementScale: 0.7, displacementBias: -0.2, side: three.DoubleSide });
      const ball = placed(new three.SphereGeometry(0.5, 24, 16), [-1.6, 0.8, 1.4]);
      ball.material = Object.assign(material.clone(), { displacementMap: bumps, displacementScale: 0.3 });
      const drawn = [sheet, ball].map((mesh) => mesh.geometry);
      const asDrawn = () => { for (const mesh of [sheet, ball]) mesh.geometry = displaced(mesh); };
      const asBefore = () => { [sheet.geometry, ball.geometry] = drawn; };
      await judge('displaced', asDrawn);
      asBefore();
      sheet.material.displacementScale = 0.4;
      ball.material.displacementBias = 0.1;
      for (let i = 0; i < data.length; i += 4) data[i] = 255 - data[i];
      bumps.needsUpdate = true;
      await judge('changed', asDrawn);
      asBefore();
      scene.remove(ball);
      const bent = Object.assign(sheet, { name: 'bent' });
      bent.geometry = bent.geometry.clone();
      bent.geometry.morphAttributes.position = [bent.geometry.attributes.position.clone()];
      bent.updateMorphTargets();
      shadows.render(scene, new three.PerspectiveCamera());
    }, { looked });
    assertRight(told);
    assert.deepEqual(warnings, ["Mesh 'bent' casts no shadow, and receives only shadows of lights that are looked up: its material's displacementMap moves vertices that bones or morph targets move, too."]);
  });

test('vertices of the GPU alone, instances with morph targets, far instances: a warning each', async () => {
  const { told, warnings } = await inCourt(async ({ scene, renderer, material, draw, judge }, { three }) => {
    const gl = renderer.getContext(), buffer = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array([0, 1, 0, 1, 1, 0, 0, 2, 0]), gl.STATIC_DRAW);
    renderer.resetState();
    const odd = (name, mesh) => scene.add(Object.assign(mesh, { name, castShadow: true, frustumCulled: false }));
    const own = new three.BufferGeometry();
    own.setAttribute('position', new three.GLBufferAttribute(buffer, gl.FLOAT, 3, 4, 3));
    own.boundingSphere = new three.Sphere(new three.Vector3(), 3); // three.js asks for it
    odd('own buffer', new three.Mesh(own, material));
    const morphed = new three.BoxGeometry(1, 1, 1);
    morphed.morphAttributes.position = [morphed.attributes.position.clone()];
    const crowd = odd('crowd', new three.InstancedMesh(three.InstancedMesh.prototype.setMorphAt ? morphed : own, material, 2)).children.at(-1);
    for (const i of [0, 1]) {
      crowd.setMatrixAt(i, new three.Matrix4().makeTranslation(i, 2, 0));
      crowd.setMorphAt?.(i, new three.Mesh(morphed));
    }
    const far = odd('far', new three.InstancedMesh(new three.BoxGeometry(1, 1, 1).translate(1e6, 0, 0), material, 1)).children.at(-1);
    far.setMatrixAt(0, new three.Matrix4().makeTranslation(-1e6, 2, 0));
    for (let i = 0; i < 2; ++i) await draw();
    for (const name of ['own buffer', 'crowd', 'far']) scene.getObjectByName(name).visible = false;
    await judge('without them');
  });
  assertRight(told);
  assert.equal(warnings.length, 3, `${warnings}`);
  assert.match(warnings[0], /^Mesh 'own buffer' casts no shadow, .*GPU alone\.$/);
  // Early releases don't draw instances with morph targets at all.
  assert.match(warnings[1], releasesOf('three-0.169', 'three').length ? /^Mesh 'crowd' casts no shadow, .*morph targets/ : /^Mesh 'crowd' casts no shadow, .*GPU alone\.$/);
  assert.match(warnings[2], /^Mesh 'far' has imprecise shadows: /);
});

for (const release of releasesOf('three-0.152', 'three'))
  test(`shaders that inline chunks, and shaders of one's own, in ${release}`, async () => {
    const { told, warnings } = await inCourt(async ({ scene, ground, chest, wall, columns, judge, draw }, { three }) => {
      const { ShaderChunk, ShaderLib, UniformsUtils } = three;
      const chunks = ['lights_pars_begin', 'lights_fragment_begin'];
      ground.material = ground.material.clone();
      ground.material.onBeforeCompile = (shader) => {
        for (const name of chunks) shader.fragmentShader = shader.fragmentShader.replace(`#include <${name}>`, ShaderChunk[name]);
      };
      await judge('inlined');
      const { vertexShader, fragmentShader, uniforms } = ShaderLib.toon;
      const own = new three.ShaderMaterial({ lights: true, uniforms: UniformsUtils.clone(uniforms), vertexShader, fragmentShader: fragmentShader.replaceAll(`#include <${chunks[1]}>`, ShaderChunk[chunks[1]]) });
      ground.material = wall.material = own;
      await judge('a ShaderMaterial');
      ground.material = new three.MeshToonMaterial({ name: 'flat', color: 0xffffff });
      ground.material.onBeforeCompile = (shader) => { shader.fragmentShader = shader.fragmentShader.replace(/#include <lights_fragment_\w+>/g, ''); };
      for (let i = 0; i < 2; ++i) await draw();
    }, { release });
    assertRight(told);
    assert.equal(warnings.length, 1, `${warnings}`);
    assert.match(warnings[0], /^Material 'flat' shows no shadows: .*lights_fragment_begin/);
  });

for (const looked of [false, true])
  test(`vertices a million units from their mesh's origin, ${looked ? 'looked up' : 'masked'}`, async () => {
    const { told, warnings } = await inCourt(async ({ scene, light, judge }) => {
      light.position.set(-0.913, 1, -0.287); // along no face whose vertices are rounded to 1 / 16
      scene.traverse((mesh) => {
        if (!mesh.isMesh) return;
        mesh.geometry.translate(1e6, 0, -1e6);
        mesh.position.x -= 1e6;
        mesh.position.z += 1e6;
      });
      await judge('far');
    }, { looked });
    assertRight(told);
    assert.deepEqual(warnings, []);
  });
