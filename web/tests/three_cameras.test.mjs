// Targets of other sizes and cameras other than the page's in three.js: each has its own shadows,
// judged by rays.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { useBrowser } from './support/browser.mjs';
import { recipes } from './support/readme.mjs';
import { inPlaceOf, openThree, releasesOf } from './support/three.mjs';

const shared = useBrowser({ sharesPages: true });

/** Runs `act(page, given)` in a page with three.js; returns its result and the page's warnings. */
async function inPage(act, given, release) {
  const page = await openThree(shared, release);
  const told = await page.evaluate(([text, value]) => (0, eval)(`(${text})`)(window.page, value), [act.toString(), given]);
  const warnings = page.reports.filter((text) => /shadow/i.test(text));
  await shared.check(page, [/shadow/i]);
  return { told, warnings };
}

function assertRight(told, { least = 1000, dark = 60 } = {}) {
  for (const [name, of] of Object.entries(told)) {
    assert.ok(of.surfaces > least && of.dark > dark, `${name}: ${of.surfaces} pixels of surfaces, ${of.dark} in shadow`);
    assert.ok(of.beyond <= 0.0002 * of.surfaces && of.wrong <= 0.02 * of.surfaces,
      `${name}: ${of.wrong} of ${of.surfaces} pixels are wrong, ${of.beyond} of them beyond outlines`);
  }
}

for (const release of releasesOf('three-0.152', 'three'))
  test(`a composer of another pixel ratio, by the README's lines, in ${release}`, async () => {
    const { told, warnings } = await inPage(async ({ ExactShadows, rendererOf, court, targetOf, redOfTarget, judged, drawn }, lines) => {
      const { ShaderPass } = await import('three/addons/postprocessing/ShaderPass.js');
      const { CopyShader } = await import('three/addons/shaders/CopyShader.js');
      const renderer = rendererOf({ width: 160, height: 100 });
      const { scene, camera, light } = court();
      renderer.setAnimationLoop = () => {};
      Object.assign(window, { renderer, scene, camera });
      await import(`data:text/javascript,${encodeURIComponent(`${lines}\nObject.assign(window, { shadows, composer });`)}`);
      const { shadows, composer } = window;
      composer.addPass(new ShaderPass(CopyShader));
      await drawn(shadows, scene, camera);
      const told = {};
      for (const ratio of [0.75, 2]) {
        composer.reset(targetOf(160 * ratio, 100 * ratio));
        composer.setPixelRatio(ratio);
        composer.render();
        const { readBuffer, writeBuffer } = composer;
        const shown = composer.passes[1].uniforms.tDiffuse.value === readBuffer.texture ? readBuffer : writeBuffer;
        told[ratio] = judged(redOfTarget(renderer, shown), shown.width, shown.height, scene, camera, light);
        // The same by beginMasks(), with RenderPass.
        const { RenderPass } = await import('three/addons/postprocessing/RenderPass.js');
        const [own] = composer.passes;
        composer.passes[0] = new RenderPass(scene, camera);
        shadows.beginMasks(scene, camera, ...(ratio > 1 ? [shown] : [])); // otherwise drawn again when it begins
        composer.render();
        shadows.endMasks();
        const again = composer.passes[1].uniforms.tDiffuse.value === composer.readBuffer.texture ? composer.readBuffer : composer.writeBuffer;
        told[`${ratio} masks`] = judged(redOfTarget(renderer, again), again.width, again.height, scene, camera, light);
        composer.passes[0] = own;
      }
      return told;
    }, recipes.get('Composer'), release);
    console.log(release, told);
    assert.deepEqual(warnings, []);
    assertRight(told);
  });

/** Pictures of every camera that three.js has, judged; `looked`: with lights that are looked up. */
async function everyCamera(page, { looked, keepsState }) {
  const { three, ExactShadows, rendererOf, court, targetOf, redOfTarget, redOf, partOf, judged, drawn, rested } = page;
  const renderer = rendererOf({ width: 160, height: 100 });
  const { scene, camera, light, chest } = court({ lamp: looked });
  const shadows = new ExactShadows(renderer, { lookups: looked ? 1 : 0, keepsState }).add(scene);
  // The page's camera sees the chest; of other cameras some see its shadow alone.
  chest.layers.set(1);
  const seesChest = (of) => { of.layers.enable(1); };
  seesChest(camera);
  const told = {}, errors = [];
  const ready = async () => { await (looked ? rested(shadows, scene, camera) : drawn(shadows, scene, camera)); };
  const attempt = async (name, act) => {
    try {
      await act((part, ...given) => { told[part ? `${name}, ${part}` : name] = judged(...given); });
    } catch (error) {
      errors.push(`${name}: ${error.message}`);
    }
  };
  const other = new three.PerspectiveCamera(70, 1.25, 0.1, 100);
  other.position.set(-3, 4, 4);
  other.lookAt(0, 0.2, -0.4);
  await ready();
  await attempt('nested', (judge) => {
    const target = targetOf(100, 80);
    let times = 0;
    chest.renderOrder = -1;
    chest.onBeforeRender = () => {
      if (times++) return;
      renderer.setRenderTarget(target);
      renderer.render(scene, other);
      renderer.setRenderTarget(null);
    };
    shadows.render(scene, camera);
    chest.onBeforeRender = () => {};
    judge('', redOfTarget(renderer, target), 100, 80, scene, other, light);
    judge('around it', redOf(renderer), 160, 100, scene, camera, light);
  });
  await attempt('between beginMasks() and endMasks()', (judge) => {
    const target = targetOf(100, 80);
    shadows.beginMasks(scene, camera);
    renderer.setRenderTarget(target);
    renderer.render(scene, other);
    renderer.setRenderTarget(null);
    renderer.render(scene, camera);
    shadows.endMasks();
    judge('other', redOfTarget(renderer, target), 100, 80, scene, other, light);
    judge('own', redOf(renderer), 160, 100, scene, camera, light);
  });
  await attempt('a CubeCamera', (judge) => {
    const cube = new three.CubeCamera(0.01, 50, new three.WebGLCubeRenderTarget(64));
    cube.position.set(0.3, 1.9, 0.2);
    seesChest(cube);
    shadows.render(scene, cube);
    for (const [i, of] of cube.children.entries()) judge(`side ${i}`, redOfTarget(renderer, cube.renderTarget, i), 64, 64, scene, of, light);
    const sides = Object.keys(told).filter((one) => one.startsWith('a CubeCamera'));
    const sum = { surfaces: 0, dark: 0, wrong: 0, beyond: 0 };
    for (const side of sides) {
      for (const key in sum) sum[key] += told[side][key];
      delete told[side];
    }
    told['a CubeCamera'] = sum;
  });
  const array = new three.ArrayCamera([camera, other].map((of, i) => {
    const made = new three.PerspectiveCamera(of.fov, 0.8, 0.1, 100);
    made.position.copy(of.position);
    made.quaternion.copy(of.quaternion);
    made.updateMatrixWorld();
    seesChest(made);
    made.viewport = new three.Vector4(80 * i, 0, 80, 100);
    return made;
  }));
  seesChest(array);
  array.position.copy(camera.position);
  array.quaternion.copy(camera.quaternion);
  const judgeArray = (judge) => {
    const red = redOf(renderer);
    for (const [i, of] of array.cameras.entries()) judge(`camera ${i}`, partOf(red, 160, 80 * i, 0, 80, 100), 80, 100, scene, of, light);
  };
  await attempt('an ArrayCamera', (judge) => {
    array.updateMatrixWorld();
    array.projectionMatrix.copy(new three.PerspectiveCamera(120, 1, 0.1, 100).projectionMatrix);
    shadows.render(scene, array);
    judgeArray(judge);
  });
  await attempt('a headset', (judge) => {
    renderer.clear();
    const { xr } = renderer, { getCamera, updateCamera } = xr;
    Object.assign(xr, { enabled: true, isPresenting: true, getCamera: () => array, updateCamera: () => {} });
    shadows.render(scene, camera);
    Object.assign(xr, { enabled: false, isPresenting: false, getCamera, updateCamera });
    judgeArray(judge);
  });
  for (const name of ['Reflector', 'Refractor', 'Water'])
    await attempt(name, async (judge) => {
      const { [name]: Made } = await import(`three/addons/objects/${name}.js`);
      const size = { textureWidth: 100, textureHeight: 80 };
      const water = { waterNormals: new three.Texture(), sunDirection: new three.Vector3(0, 1, 0), clipBias: 0 };
      const pane = new Made(new three.PlaneGeometry(12, 12), { ...size, multisample: 0, ...(name === 'Water' ? water : {}) });
      pane.position.set(0, 0.3, 0);
      pane.rotation.x = -Math.PI / 2;
      scene.add(pane);
      let seen = null, target = null;
      scene.onBeforeRender = (_, __, by, into) => {
        if (!into) return;
        seen = by.clone();
        seen.projectionMatrix.copy(camera.projectionMatrix); // without the oblique near plane
        seen.projectionMatrixInverse.copy(camera.projectionMatrixInverse);
        target = into;
      };
      shadows.render(scene, camera);
      scene.onBeforeRender = () => {};
      scene.remove(pane);
      const red = redOfTarget(renderer, target);
      // The eye's own side of the plane is clipped.
      const plane = new three.Plane().setFromNormalAndCoplanarPoint(new three.Vector3(0, 0, 1).applyQuaternion(pane.quaternion), pane.position);
      if (name === 'Refractor') plane.negate();
      seen.matrixWorldAutoUpdate = false;
      Object.assign(seen, { matrixAutoUpdate: false });
      judge('', red, target.width, target.height, scene, seen, light, { clippingPlanes: [plane] });
      shadows.render(scene, camera);
      judge('afterwards', redOf(renderer), 160, 100, scene, camera, light);
    });
  return { told, errors, lookedUp: shadows.cost.lookedUp };
}

test('a lit overrideMaterial has shadows, or a warning that names what it would show wrongly', async () => {
  const { told: { told, unlike }, warnings } = await inPage(async ({ three, ExactShadows, rendererOf, court, redOf, judged, drawn, rested }) => {
    const renderer = rendererOf({ width: 160, height: 100 });
    const { scene, camera, light, material, chest } = court();
    const told = {};
    const judge = (name) => { told[name] = judged(redOf(renderer), 160, 100, scene, camera, light); };
    scene.overrideMaterial = new three.MeshToonMaterial({ color: 0xffffff, gradientMap: material.gradientMap });
    material.color.set(0x0000ff);
    const shadows = new ExactShadows(renderer, { lookups: 0 }).add(scene);
    await drawn(shadows, scene, camera);
    judge('masks');
    chest.material = new three.MeshToonMaterial({ color: 0xffffff, transparent: true, opacity: 0.5 });
    chest.name = 'glass';
    chest.castShadow = false;
    shadows.render(scene, camera);
    const unlike = judged(redOf(renderer), 160, 100, scene, camera, light);
    shadows.render(scene, camera);
    shadows.dispose();
    chest.castShadow = chest.receiveShadow = false;
    scene.remove(chest);
    const looking = new ExactShadows(renderer).add(scene);
    if (await rested(looking, scene, camera) !== 1) throw new Error('no light is looked up');
    judge('lookup');
    return { told, unlike };
  });
  console.log(told, unlike);
  assertRight(told);
  assert.ok(unlike.wrong > 0.9 * unlike.dark - 50 && unlike.wrong < 1.2 * unlike.dark, 'nothing is shadowed');
  assert.equal(warnings.length, 1, `${warnings}`);
  assert.match(warnings[0], /^Camera 'PerspectiveCamera' shows no shadows .*overrideMaterial.*'glass'/);
});

for (const [release, looked, keepsState] of [['three-0.152', false, false], ['three', false, false], ['three', false, true], ['three', true, false]])
  test(`nested and other cameras have their own ${looked ? 'lookups' : 'masks'}, in ${inPlaceOf(release)}${keepsState ? ', all state kept' : ''}`, async () => {
    const { told: { told, errors, lookedUp }, warnings } = await inPage(everyCamera, { looked, keepsState }, release);
    console.log(release, looked, keepsState, told);
    assert.deepEqual(errors, []);
    assert.deepEqual(warnings, []);
    assert.equal(lookedUp, looked ? 1 : 0);
    assert.equal(Object.keys(told).length, 15);
    assertRight(told, { least: 300, dark: 30 });
  });

for (const release of releasesOf('three-0.169', 'three'))
  for (const keepsState of [false, true])
    test(`reversed depths, in ${release}${keepsState ? ', all state kept' : ''}`, async () => {
      const { told, warnings } = await inPage(async ({ three, ExactShadows, rendererOf, court, redOf, judged, rested, targetOf, redOfTarget }, given) => {
        const names = { reversedDepthBuffer: true, reverseDepthBuffer: true };
        const renderer = rendererOf({ width: 160, height: 100, ...names });
        const gl = renderer.getContext(), clip = gl.getExtension('EXT_clip_control');
        const { scene, camera, light } = court();
        const told = {};
        for (const lookups of [0, 1]) {
          const shadows = new ExactShadows(renderer, { keepsState: given, lookups }).add(scene);
          await rested(shadows, scene, camera, lookups);
          shadows.render(scene, camera);
          told[`lookups ${lookups}`] = judged(redOf(renderer), 160, 100, scene, camera, light);
          if (!lookups) {
            const target = targetOf(100, 80);
            renderer.setRenderTarget(target);
            shadows.render(scene, camera);
            renderer.setRenderTarget(null);
            told['a target'] = judged(redOfTarget(renderer, target), 100, 80, scene, camera, light);
            const level = new three.OrthographicCamera(-4, 4, 2.5, -2.5, 0.1, 50);
            level.position.copy(camera.position);
            level.quaternion.copy(camera.quaternion);
            for (let i = 0; i < 2; ++i) shadows.render(scene, level);
            told.orthographic = judged(redOf(renderer), 160, 100, scene, level, light);
          }
          shadows.dispose();
        }
        return { told, mode: clip && gl.getParameter(clip.CLIP_DEPTH_MODE_EXT) === clip.ZERO_TO_ONE_EXT };
      }, keepsState, release);
      console.log(release, keepsState, told);
      assert.deepEqual(warnings, []);
      assert.ok(told.mode, 'depths are still reversed');
      assertRight(told.told);
    });

test('a camera that masks cannot follow has no shadows, and one warning', async () => {
  const { told, warnings } = await inPage(async ({ three, ExactShadows, rendererOf, court, targetOf, redOfTarget, redOf, judged, drawn }) => {
    const renderer = rendererOf({ width: 160, height: 100 });
    const { scene, camera, light, chest } = court();
    const shadows = new ExactShadows(renderer, { lookups: 0 }).add(scene);
    await drawn(shadows, scene, camera);
    const target = targetOf(160, 100);
    const other = camera.clone();
    const others = () => {
      shadows.beginMasks(scene, camera);
      renderer.setRenderTarget(target);
      renderer.render(scene, other);
      renderer.setRenderTarget(null);
      renderer.render(scene, camera);
      shadows.endMasks();
      return judged(redOfTarget(renderer, target), 160, 100, scene, other, light);
    };
    const told = { same: others() };
    Object.assign(other, { name: 'mirrored' });
    other.projectionMatrix.scale(new three.Vector3(-1, 1, 1));
    chest.material = chest.material.clone();
    const flipped = () => { shadows.beginMasks(scene, camera); renderer.setRenderTarget(target); renderer.render(scene, other); renderer.setRenderTarget(null); shadows.endMasks(); };
    flipped();
    flipped();
    other.updateProjectionMatrix();
    other.name = 'x-ray';
    chest.layers.set(1);
    chest.name = 'chest';
    other.layers.enable(1);
    for (let i = 0; i < 2; ++i) others();
    return told;
  });
  console.log(told, warnings);
  assertRight({ same: told.same });
  assert.equal(warnings.length, 2);
  assert.match(warnings[0], /^Camera 'mirrored' shows no shadows .*mirrors/);
  assert.match(warnings[1], /^Camera 'x-ray' shows no shadows .*'chest'/);
});
