// three.js's own passes, materials and renderers together with exact shadows.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { useBrowser } from './support/browser.mjs';
import { openThree, releasesOf } from './support/three.mjs';

const shared = useBrowser();

/** Runs `act(page)` in a page with three.js; returns its result. */
async function inPage(act, { release, allowed = [] } = {}) {
  const page = await openThree(shared, release);
  const told = await page.evaluate((text) => (0, eval)(`(${text})`)(window.page), act.toString());
  await shared.check(page, allowed);
  return told;
}

/** Warnings caused by querying constants that aren't names of state. */
const asking = [/invalid parameter name/, /too many errors/];

test('all that a host may have set is as it was, and three.js\' own passes are unharmed', async () => {
  const { before, after, plainBefore, plainAfter, errors } = await inPage(async ({ three, yard, fence, pattern, ExactShadows, cameraOf, drawn, hash, stateOf }) => {
    const world = yard({ width: 200, height: 120 });
    const { renderer, scene } = world;
    scene.add(fence(world, { alphaMap: pattern(true) }));
    const gl = renderer.getContext();
    const camera = cameraOf({ from: [5, 4, 6], to: [0, 0.6, 0], fov: 50 }, 200 / 120);
    // A pass of three.js with blending, stencil, scissor, a repeating sampler and a multisampled
    // target.
    const plain = new three.Scene();
    const texture = new three.DataTexture(new Uint8Array([255, 0, 0, 255, 0, 0, 255, 255]), 2, 1);
    texture.needsUpdate = true;
    const material = new three.MeshBasicMaterial({ map: texture, transparent: true, opacity: 0.5, blending: three.AdditiveBlending,
      stencilWrite: true, stencilRef: 3, polygonOffset: true, polygonOffsetFactor: 2, side: three.BackSide });
    plain.add(new three.Mesh(new three.BoxGeometry(3, 2, 1), material));
    const target = new three.WebGLRenderTarget(64, 64, { samples: 4, stencilBuffer: true });
    const drawPlain = () => {
      renderer.setRenderTarget(target);
      renderer.setScissorTest(true);
      renderer.setScissor(3, 4, 50, 40);
      renderer.render(plain, camera);
      const pixels = new Uint8Array(4 * 64 * 64);
      renderer.readRenderTargetPixels(target, 0, 0, 64, 64, pixels);
      return hash(pixels);
    };
    const shadows = new ExactShadows(renderer, { keepsState: true }).add(scene);
    await drawn(shadows, scene, camera);
    const plainBefore = drawPlain();
    // State as left by a host that draws by itself.
    gl.stencilFuncSeparate(gl.BACK, gl.GREATER, 5, 0x0F);
    gl.blendFuncSeparate(gl.ONE, gl.ZERO, gl.DST_COLOR, gl.ONE);
    gl.depthRange(0.25, 0.75);
    gl.clearColor(0.1, 0.2, 0.3, 0.4);
    gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, true);
    gl.pixelStorei(gl.UNPACK_ROW_LENGTH, 7);
    gl.bindSampler(2, gl.createSampler());
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, gl.createBuffer());
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
    // Its own textures: three.js leaves masks bound, which are made again for another size.
    for (let i = 0; i < 6; ++i) {
      gl.activeTexture(gl.TEXTURE0 + i);
      gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    }
    gl.activeTexture(gl.TEXTURE3);
    gl.enable(gl.SAMPLE_ALPHA_TO_COVERAGE);
    const before = stateOf(gl);
    shadows.beginMasks(scene, camera);
    const after = stateOf(gl);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    gl.bindSampler(2, null);
    renderer.resetState();
    const errors = gl.getError();
    return { before, after, plainBefore, plainAfter: drawPlain(), errors };
  }, { allowed: asking });
  assert.ok(Object.keys(before).length > 120, `${Object.keys(before).length} values`);
  assert.deepEqual(after, before);
  assert.equal(plainAfter, plainBefore);
  assert.equal(errors, 0);
});

test('without vertex array objects attributes are kept, in WebGL 1', async () => {
  const { before, after, lit } = await inPage(async ({ stateOf, attributesOf }) => {
    const { ShadowMasks } = await import('/masks/shadow-masks.js');
    const gl = document.createElement('canvas').getContext('webgl');
    const { getExtension } = gl;
    gl.getExtension = (name) => (name === 'OES_vertex_array_object' ? null : getExtension.call(gl, name));
    const masks = await ShadowMasks.create(gl);
    masks.add(masks.prepareNow({ positions: [-1, -1, 0, 1, -1, 0, 0, 1, 0] }), [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
    for (let i = 0; i < 4; ++i) {
      gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
      gl.vertexAttribPointer(i, 2, gl.SHORT, true, 16, 4 * i);
      if (i % 2) gl.enableVertexAttribArray(i);
    }
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    const all = () => ({ ...stateOf(gl), ...attributesOf(gl) });
    const before = all();
    const view = { viewFromWorld: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -3, 1], clipFromView: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, -1, 0, 0, -0.2, 0], width: 16, height: 16 };
    const { textures } = masks.draw(view, [{ direction: [0, 0, -1] }]);
    const after = all();
    return { before, after, lit: textures[0] instanceof WebGLTexture };
  }, { allowed: asking });
  assert.deepEqual(after, before);
  assert.ok(lit);
});

test('large meshes are taken over and uploaded in steps, two at once, and cast what they cast otherwise', async () => {
  const { steps, uploads, masks, shadowed, problem } = await inPage(async ({ three }) => {
    const { ShadowMasks } = await import('/masks/shadow-masks.js');
    const gl = document.createElement('canvas').getContext('webgl');
    const engine = await ShadowMasks.create(gl);
    const shapeOf = ({ index, attributes: { position } }) => ({ positions: position.array, indices: index.array });
    const shapes = [new three.TorusKnotGeometry(0.4, 0.12, 300, 40), new three.SphereGeometry(0.5, 200, 100)].map(shapeOf);
    const at = (x, y, z) => new three.Matrix4().makeTranslation(x, y, z).elements;
    const { meshes } = await engine.prepareTogether(shapes, []);
    const view = { viewFromWorld: at(0, 0, -3), clipFromView: new three.PerspectiveCamera(60, 1, 0.1, 10).projectionMatrix.elements, width: 64, height: 64 };
    engine.add(engine.prepareNow({ positions: [-3, -3, -1, 3, -3, -1, 3, 3, -1, -3, 3, -1], indices: [0, 1, 2, 0, 2, 3] }), at(0, 0, 0));
    const maskOf = (numbers) => {
      const ids = numbers.map((number, i) => engine.add(number, at(i - 0.5, 0, 0)));
      const { textures } = engine.draw(view, [{ direction: [0.3, 0.2, -1] }]);
      const bytes = new Uint8Array(4 * 64 * 64);
      gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, textures[0], 0);
      gl.readPixels(0, 0, 64, 64, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
      gl.bindFramebuffer(gl.FRAMEBUFFER, null);
      for (const id of ids) engine.remove(id);
      return bytes.filter((_, i) => i % 4 === 0);
    };
    const masks = [maskOf([])], steps = [0, 0], numbers = [null, null], uploads = [];
    masks.push(maskOf(meshes.map((bytes) => engine.take(bytes))));
    const taking = meshes.map((bytes) => engine.taking(bytes));
    while (numbers.includes(null))
      for (const [i, generator] of taking.entries()) {
        if (numbers[i] !== null) continue;
        const { done, value } = generator.next();
        steps[i] += 1;
        if (done) numbers[i] = value;
      }
    for (const number of numbers) {
      uploads.push(1);
      while (!engine.uploadStep(number)) uploads[uploads.length - 1] += 1;
    }
    masks.push(maskOf(numbers));
    let problem = '';
    try {
      engine.taking('why not').next();
    } catch ({ message }) {
      problem = message;
    }
    return { steps, uploads, masks: masks.map(String), shadowed: masks.map((mask) => mask.filter((value) => value < 128).length), problem };
  }, { allowed: asking });
  assert.ok(Math.min(...steps) > 5, `${steps} steps`);
  assert.deepEqual(uploads, [4, 4]);
  assert.deepEqual([shadowed[0], masks[1] === masks[2], problem], [0, true, 'why not']);
  assert.ok(shadowed[1] > 50, `${shadowed[1]} pixels in shadow`);
});

test('a material takes shadows as long as it is theirs, and is as it came after dispose()', async () => {
  const { inShadow, plain, after, again, keys } = await inPage(async ({ three, yard, ExactShadows, cameraOf, drawn, redAt }) => {
    const { renderer, scene, box, ground } = yard({ width: 200, height: 120 });
    const camera = cameraOf({ from: [0, 6, 0.01], to: [0, 0, 0], fov: 50 }, 200 / 120);
    const place = [-0.55, 0, 0.4]; // in the box's shadow
    const keys = [Object.hasOwn(ground.material, 'customProgramCacheKey')];
    const shadows = new ExactShadows(renderer).add(scene);
    await drawn(shadows, scene, camera);
    const inShadow = redAt(renderer, camera, place);
    renderer.render(scene, camera); // three.js's own pass, without masks
    const plain = redAt(renderer, camera, place);
    shadows.dispose();
    renderer.render(scene, camera);
    const after = redAt(renderer, camera, place);
    keys.push(Object.hasOwn(ground.material, 'customProgramCacheKey'));
    const others = new ExactShadows(renderer).add(box).add(ground);
    await drawn(others, scene, camera);
    const again = redAt(renderer, camera, place);
    return { inShadow, plain, after, again, keys };
  });
  assert.equal(inShadow, 0);
  assert.ok(plain > 100 && after === plain, `${plain} ${after}`);
  assert.equal(again, 0);
  assert.deepEqual(keys, [false, false]);
});

const kinds = ['MeshStandardMaterial', 'MeshPhysicalMaterial', 'MeshLambertMaterial', 'MeshPhongMaterial', 'MeshToonMaterial'];

test('every material that is lit, lights of every kind, several of them', async () => {
  for (const release of releasesOf('three-0.152', 'three')) {
    const told = await inPage(async ({ three, yard, ExactShadows, cameraOf, lampOf, drawn, redAt }) => {
      const { renderer, scene, ground, box, light } = yard({ width: 200, height: 120 });
      const camera = cameraOf({ from: [0, 6, 0.01], to: [0, 0, 0], fov: 50 }, 200 / 120);
      const shadows = new ExactShadows(renderer).add(scene);
      const result = {};
      const shaded = [-0.55, 0, 0.4], open = [1.8, 0, 1];
      const both = async () => {
        await drawn(shadows, scene, camera);
        return [redAt(renderer, camera, shaded), redAt(renderer, camera, open)];
      };
      for (const kind of ['MeshStandardMaterial', 'MeshPhysicalMaterial', 'MeshLambertMaterial', 'MeshPhongMaterial', 'MeshToonMaterial']) {
        ground.material = new three[kind]({ color: 0xffffff });
        result[kind] = await both();
      }
      ground.receiveShadow = false;
      result.receivesNone = await both();
      ground.receiveShadow = true;
      if ('intensity' in light.shadow) {
        light.shadow.intensity = 0.5;
        result.half = await both();
        light.shadow.intensity = 1;
      }
      light.castShadow = false;
      result.castsNone = await both();
      light.castShadow = true;
      box.castShadow = false;
      result.boxCastsNone = await both();
      box.castShadow = true;
      // First two lamps without shadows, a spot, a second sun from the same side: more than one
      // texture can hold.
      scene.remove(light, light.target);
      const weak = () => Object.assign(lampOf({ kind: 'PointLight', position: [0, 5, 0] })[0], { castShadow: false, intensity: 0.01 });
      const suns = [0, 1, 2].flatMap(() => lampOf({ kind: 'DirectionalLight', position: [0.5, 1, -0.3] }));
      for (const sun of suns) if (sun.isLight) sun.intensity = 0.3;
      const [lamp] = lampOf({ kind: 'PointLight', position: [1.4, 3, -0.9] });
      const [spot, aim] = lampOf({ kind: 'SpotLight', position: [1.4, 3, -0.9] });
      aim.position.set(-0.4, 0, 0.3);
      lamp.intensity = spot.intensity = 0.3;
      scene.add(weak(), ...suns, spot, aim, weak(), lamp);
      ground.material = new three.MeshStandardMaterial({ color: 0xffffff });
      result.many = await both();
      // A shadow catcher shows only shadow.
      scene.remove(...suns, spot, lamp);
      scene.add(light, light.target);
      ground.material = new three.ShadowMaterial({ color: 0xffffff, opacity: 1 });
      result.catcher = await both();
      return result;
    }, { release });
    for (const kind of kinds) {
      const [dark, lit] = told[kind];
      assert.ok(dark < 3 && lit > 100, `${release} ${kind}: ${dark}, ${lit}`);
    }
    for (const without of ['receivesNone', 'castsNone', 'boxCastsNone']) assert.ok(told[without][0] > 100, `${release} ${without}: ${told[without]}`);
    if (told.half) assert.ok(told.half[0] > 60 && told.half[0] < told.half[1], `${release} half: ${told.half}`);
    assert.ok(told.many[0] < 60 && told.many[1] > 100, `${release} many: ${told.many}`);
    assert.ok(told.catcher[0] > 200 && told.catcher[1] < 3, `${release} catcher: ${told.catcher}`);
  }
});

test('render targets, viewports and pixel ratios: shadows are where they are in the picture', async () => {
  const told = await inPage(async ({ three, yard, ExactShadows, cameraOf, drawn, redOf }) => {
    const { renderer, scene } = yard({ width: 200, height: 120 });
    const camera = cameraOf({ from: [5, 4, 6], to: [0, 0.6, 0], fov: 50 }, 200 / 120);
    const shadows = new ExactShadows(renderer).add(scene);
    await drawn(shadows, scene, camera);
    const whole = redOf(renderer);
    const target = new three.WebGLRenderTarget(200, 120);
    renderer.setRenderTarget(target);
    shadows.render(scene, camera);
    const pixels = new Uint8Array(4 * 200 * 120);
    renderer.readRenderTargetPixels(target, 0, 0, 200, 120, pixels);
    renderer.setRenderTarget(null);
    // The target's values are linear, so only dark or not can be compared.
    const inTarget = [];
    for (let y = 119; y >= 0; --y) for (let x = 0; x < 200; ++x) inTarget.push(pixels[4 * (y * 200 + x)]);
    renderer.setSize(300, 200);
    renderer.clear();
    renderer.setViewport(70, 30, 200, 120);
    shadows.render(scene, camera);
    const inside = redOf(renderer);
    const part = [];
    for (let y = 0; y < 120; ++y) part.push(...inside.slice((y + 50) * 300 + 70, (y + 50) * 300 + 270));
    renderer.setPixelRatio(2);
    renderer.setSize(100, 60);
    renderer.setViewport(0, 0, 100, 60);
    shadows.render(scene, camera);
    const dense = redOf(renderer);
    const apart = (a, b) => a.reduce((sum, value, i) => sum + ((value > 20) !== (b[i] > 20)), 0);
    return { dark: whole.filter((value) => value < 20).length, target: apart(whole, inTarget), viewport: apart(whole, part), ratio: apart(whole, dense) };
  });
  assert.ok(told.dark > 500, `${told.dark} dark pixels`);
  assert.deepEqual({ target: told.target, viewport: told.viewport, ratio: told.ratio }, { target: 0, viewport: 0, ratio: 0 });
});

test('a lost context comes back with its shadows', async () => {
  const { before, after } = await inPage(async ({ yard, ExactShadows, cameraOf, drawn, hash, redOf }) => {
    const { renderer, scene } = yard({ width: 200, height: 120 });
    const camera = cameraOf({ from: [5, 4, 6], to: [0, 0.6, 0], fov: 50 }, 200 / 120);
    const shadows = new ExactShadows(renderer).add(scene);
    await drawn(shadows, scene, camera);
    const before = hash(redOf(renderer));
    const loss = renderer.getContext().getExtension('WEBGL_lose_context');
    const event = (name) => new Promise((resolve) => renderer.domElement.addEventListener(name, resolve, { once: true }));
    const lost = event('webglcontextlost');
    loss.loseContext();
    await lost;
    await new Promise((resolve) => { setTimeout(resolve); }); // the event is over
    shadows.render(scene, camera);
    const restored = event('webglcontextrestored');
    loss.restoreContext();
    await restored;
    await drawn(shadows, scene, camera);
    return { before, after: hash(redOf(renderer)) };
  }, { allowed: [/Context Lost|CONTEXT_LOST|loseContext/] });
  assert.equal(after, before);
});

test('what is wrong is said in a sentence', async () => {
  const told = await inPage(async ({ three, yard, ExactShadows, cameraOf }) => {
    const sentences = [];
    const attempt = async (act) => {
      try {
        await act();
        sentences.push('nothing');
      } catch (error) {
        sentences.push(error.message);
      }
    };
    await attempt(() => new ExactShadows({}));
    const { renderer, scene, box } = yard({ width: 100, height: 60 });
    const camera = cameraOf({ from: [5, 4, 6], to: [0, 0.6, 0], fov: 50 }, 5 / 3);
    const shadows = new ExactShadows(renderer).add(scene);
    box.geometry = new three.BufferGeometry();
    box.geometry.setAttribute('position', new three.BufferAttribute(new Float32Array([0, 0, NaN, 1, 0, 0, 0, 1, 0]), 3));
    box.geometry.boundingSphere = new three.Sphere(new three.Vector3(), 1);
    shadows.render(scene, camera);
    await attempt(() => shadows.ready());
    shadows.render(scene, camera); // the others have their shadows
    shadows.dispose();
    await attempt(() => shadows.render(scene, camera));
    return sentences;
  });
  assert.match(told[0], /WebGLRenderer/);
  assert.match(told[1], /not finite|finite/);
  assert.match(told[2], /disposed/);
});
