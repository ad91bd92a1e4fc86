// Alpha tests of three.js's materials in exact shadows: every source of alpha, and changes of it.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { useBrowser } from './support/browser.mjs';
import { openThree, releasesOf } from './support/three.mjs';

const shared = useBrowser();

for (const release of releasesOf('three-0.152', 'three'))
  test(`alpha of map, of alphaMap and of other texture coordinates, in ${release}`, async () => {
    const page = await openThree(shared, release);
    const told = await page.evaluate(async () => {
      const { yard, fence, pattern, ExactShadows, cameraOf, drawn, redOf, whiten } = window.page;
      const world = yard({ width: 240, height: 140 });
      const { renderer, scene } = world;
      const camera = cameraOf({ from: [5, 4, 6], to: [0, 0.6, 0], fov: 50 }, 240 / 140);
      const shadows = new ExactShadows(renderer, { alphaTestedCast: 'whole', lookups: 0 }).add(scene);
      const pictures = {};
      const draw = async (name, sheet) => {
        if (sheet) scene.add(sheet);
        whiten(scene);
        await drawn(shadows, scene, camera);
        pictures[name] = redOf(renderer);
        return sheet;
      };
      await draw('none');
      const sheet = await draw('map', fence(world, { map: pattern() }));
      shadows.alphaTestedCast = 'none';
      await draw('castsNothing');
      shadows.alphaTestedCast = 'whole';
      sheet.material.opacity = 0.4; // all below 0.5: nothing is visible, but its shadow is
      await draw('faded');
      sheet.material.opacity = 1;
      await draw('mapAgain');
      sheet.material.map.offset.x += 0.17;
      await draw('moved');
      sheet.material.map.dispose();
      await draw('movedAgain');
      scene.remove(sheet);
      scene.remove(await draw('alphaMap', fence(world, { alphaMap: pattern(true) })));
      const other = fence(world, { alphaMap: pattern(true) });
      other.geometry.setAttribute('uv1', other.geometry.attributes.uv.clone());
      other.geometry.attributes.uv.array.fill(0);
      other.material.alphaMap.channel = 1;
      scene.remove(await draw('otherCoordinates', other));
      const unlike = (a, b) => pictures[a].reduce((sum, value, i) => sum + (Math.abs(value - pictures[b][i]) > 20), 0);
      const pairs = [['none', 'map'], ['map', 'castsNothing'], ['none', 'faded'], ['map', 'faded'], ['map', 'moved'],
        ['map', 'mapAgain'], ['moved', 'movedAgain'], ['map', 'alphaMap'], ['map', 'otherCoordinates']];
      return Object.fromEntries(pairs.map(([a, b]) => [`${a} ${b}`, unlike(a, b)]));
    });
    console.log(release, told);
    for (const other of ['none map', 'map castsNothing', 'none faded', 'map faded', 'map moved'])
      assert.ok(told[other] > 200, `${other}: ${told[other]}`);
    for (const same of ['map mapAgain', 'moved movedAgain', 'map alphaMap', 'map otherCoordinates'])
      assert.equal(told[same], 0, same);
    await shared.check(page);
  });

test("a spot's radius softens its shadow, and leaves its cone to three.js", async () => {
  const page = await openThree(shared);
  const told = await page.evaluate(async () => {
    const { yard, lampOf, ExactShadows, cameraOf, drawn, redOf, whiten } = window.page;
    const { renderer, scene, light, box } = yard({ width: 240, height: 140 });
    const camera = cameraOf({ from: [5, 4, 6], to: [0, 0.6, 0], fov: 50 }, 240 / 140);
    scene.remove(light, light.target);
    const [spot, aim] = lampOf({ kind: 'SpotLight', position: [1.4, 3, -0.9] });
    aim.position.set(-0.2, 0, 0.1);
    scene.add(spot, aim);
    whiten(scene);
    const shadows = new ExactShadows(renderer, { lightSamples: 16 }).add(scene);
    const shades = () => new Set(redOf(renderer)).size;
    await drawn(shadows, scene, camera);
    const hard = shades();
    shadows.setRadius(spot, 0.3);
    await drawn(shadows, scene, camera);
    const soft = shades();
    box.castShadow = false;
    await drawn(shadows, scene, camera);
    const unshaded = redOf(renderer);
    spot.castShadow = false;
    renderer.render(scene, camera);
    const plain = redOf(renderer);
    // Except for sides of the ground that face away: three.js lights them no more than the masks
    // do.
    return { hard, soft, coneDiffers: plain.reduce((sum, value, i) => sum + (Math.abs(value - unshaded[i]) > 2), 0) };
  });
  console.log(told);
  assert.ok(told.soft > told.hard + 8, `${told.hard} shades, then ${told.soft}`);
  assert.ok(told.coneDiffers < 20, `${told.coneDiffers} pixels`);
  await shared.check(page);
});

test('alpha in a WebGL 1 host of its own: seen through, changed, refused in a sentence', async () => {
  const page = await openThree(shared);
  const told = await page.evaluate(async () => {
    const { ShadowMasks } = await import('/masks/shadow-masks.js');
    const gl = document.createElement('canvas').getContext('webgl');
    const masks = await ShadowMasks.create(gl);
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, 2, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array([0, 255, 0, 0, 0, 0, 0, 255]));
    for (const name of ['TEXTURE_MIN_FILTER', 'TEXTURE_MAG_FILTER']) gl.texParameteri(gl.TEXTURE_2D, gl[name], gl.NEAREST);
    for (const name of ['TEXTURE_WRAP_S', 'TEXTURE_WRAP_T']) gl.texParameteri(gl.TEXTURE_2D, gl[name], gl.CLAMP_TO_EDGE);
    const square = (z) => ({ positions: [-1, -1, z, 1, -1, z, 1, 1, z, -1, 1, z], indices: [0, 1, 2, 0, 2, 3] });
    const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
    const wall = masks.add(await masks.prepare(square(0)), identity);
    const sheet = masks.add(await masks.prepare({ ...square(1), alphaTested: true, texcoords: [0, 0, 1, 0, 1, 1, 0, 1] }), identity);
    // A lamp between them: the wall is lit, the sheet shows its dark side.
    const rowOf = () => {
      const view = { viewFromWorld: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -4, 1], clipFromView: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -0.1, 0, 0, 0, 0, 1], width: 8, height: 8 };
      const { textures } = masks.draw(view, [{ kind: 'point', position: [0.1, 0.2, 0.5] }]);
      gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, textures[0], 0);
      const pixels = new Uint8Array(4 * 8);
      gl.readPixels(0, 4, 8, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
      gl.bindFramebuffer(gl.FRAMEBUFFER, null);
      return [...pixels].filter((_, i) => i % 4 === 0).map((red) => (red > 127 ? 'l' : 'd')).join('');
    };
    const rows = [rowOf()];
    masks.setAlpha(sheet, { texture });
    rows.push(rowOf());
    masks.setAlpha(sheet, { texture, channel: 'green' });
    rows.push(rowOf());
    masks.setAlpha(sheet, { texture, cutoff: 2 });
    rows.push(rowOf());
    masks.setAlpha(sheet, {});
    rows.push(rowOf());
    const sentences = [[sheet, { channel: 'red' }], [wall, { texture }], [sheet, { texcoordTransform: [1, 0] }]].map(([id, alpha]) => {
      try {
        masks.setAlpha(id, alpha);
        return 'nothing';
      } catch (error) {
        return error.message;
      }
    });
    masks.remove(sheet);
    return { rows, sentences, error: gl.getError() };
  });
  assert.deepEqual(told.rows, ['dddddddd', 'lllldddd', 'ddddllll', 'llllllll', 'dddddddd']);
  assert.match(told.sentences[0], /channel 'red'/);
  assert.match(told.sentences[1], /not alpha-tested/);
  assert.match(told.sentences[2], /9 numbers/);
  assert.equal(told.error, 0);
  await shared.check(page);
});
