// Alpha-tested meshes of three.js cast what their alpha leaves, where a light is looked up: judged by
// rays.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { useBrowser } from './support/browser.mjs';
import { inFoliage, inPlaceOf, releasesOf } from './support/three.mjs';

const shared = useBrowser({ sharesPages: true });

const inPage = (...of) => inFoliage(shared, ...of);

const assertRight = (name, { surfaces, dark, wrong, beyond }) => {
  assert.ok(surfaces > 5000 && dark > 300, `${name}: ${surfaces} pixels of surfaces, ${dark} in shadow`);
  assert.ok(beyond <= 0.0002 * surfaces && wrong <= 0.04 * surfaces, `${name}: ${wrong} of ${surfaces} pixels are wrong, ${beyond} of them beyond outlines`);
};

const leaves = async ({ ExactShadows, redOf, comparedWithRays }, { floorOf, treeOf, leafAtlas, white, wholly }, light) => {
  const { renderer, scene, light: source, camera } = floorOf(window.page, light);
  scene.add(treeOf(white({ map: leafAtlas(), alphaTest: 0.4 })));
  const shadows = new ExactShadows(renderer).add(scene);
  const lookedUp = await wholly(window.page, shadows, scene, camera);
  return { lookedUp, ...comparedWithRays(redOf(renderer), renderer, scene, camera, source), error: renderer.getContext().getError() };
};

for (const release of releasesOf('three-0.152', 'three'))
  for (const [kind, position] of [['DirectionalLight', [0.4, 1, 0.3]], ['PointLight', [0.3, 3.4, 0.6]], ['SpotLight', [0.6, 4, 0.8]]])
    if (release === inPlaceOf('three') || kind === 'DirectionalLight')
      test(`leaves of an atlas on cards and instances, ${kind}, in ${release}`, async () => {
        const { told } = await inPage(leaves, { release, given: { kind, position } });
        console.log(told);
        assert.equal(told.lookedUp, 1);
        assert.equal(told.error, 0);
        assertRight('leaves', told);
      });

test('alphaMap with its own transform, coordinates, wrap and filter; and its changes', async () => {
  const { told } = await inPage(async ({ three }, { floorOf, blobs, white, judging }) => {
    const world = floorOf(window.page), { renderer } = world;
    const alphaMap = blobs(11, 7, { green: true });
    Object.assign(alphaMap, { wrapS: three.MirroredRepeatWrapping, wrapT: three.RepeatWrapping, rotation: 0.4, channel: 1 });
    alphaMap.repeat.set(1.3, 0.8);
    alphaMap.offset.set(0.2, -0.3);
    const sheet = new three.Mesh(new three.PlaneGeometry(3, 3), white({ alphaMap, alphaTest: 0.45, opacity: 0.9 }));
    sheet.geometry.setAttribute('uv1', sheet.geometry.attributes.uv.clone());
    sheet.geometry.attributes.uv.array.fill(0);
    const { shadows, told, judge } = judging(window.page, world, sheet);
    await judge('alphaMap');
    alphaMap.offset.x += 0.37;
    await judge('moved');
    alphaMap.image.data.reverse(); // alpha is in green then, too, and elsewhere
    for (let i = 0; i < alphaMap.image.data.length; i += 4) alphaMap.image.data[i + 1] = alphaMap.image.data[i + 2];
    alphaMap.needsUpdate = true;
    await judge('other texels');
    sheet.material.alphaTest = 0.2;
    await judge('other cutoff');
    const nearest = blobs(11, 7, { green: true, seed: 3 });
    nearest.magFilter = nearest.minFilter = three.NearestFilter;
    Object.assign(nearest, { channel: 1, wrapS: three.ClampToEdgeWrapping });
    nearest.repeat.set(1.4, 1.2);
    sheet.material.alphaMap = nearest;
    await judge('nearest');
    sheet.material.alphaMap = null;
    sheet.material.alphaTest = 0.95; // nothing is left of it
    await judge('no texture');
    told.error = renderer.getContext().getError();
    return told;
  });
  console.log(told);
  assert.equal(told.error, 0);
  for (const [name, of] of Object.entries(told)) if (of.surfaces) assertRight(name, { ...of, dark: of.dark + (name === 'no texture' ? 300 : 0) });
});

test('alphaMap and map with their own sizes, transforms and coordinates, looked up and in masks', async () => {
  const { told } = await inPage(async ({ three, drawn, redOf, comparedWithRays }, { floorOf, blobs, white, judging }) => {
    const world = floorOf(window.page), { renderer, scene, light, camera } = world;
    const map = blobs(9, 6), alphaMap = blobs(5, 8, { green: true, seed: 5 });
    for (const texture of [map, alphaMap]) Object.assign(texture, { wrapS: three.RepeatWrapping, wrapT: three.MirroredRepeatWrapping });
    const sheet = new three.Mesh(new three.PlaneGeometry(3, 3), white({ map, alphaMap, alphaTest: 0.2, opacity: 0.95 }));
    const { shadows, told, judge } = judging(window.page, world, sheet);
    await judge('one transform');
    light.position.x += 0.01;
    await drawn(shadows, scene, camera);
    told['in masks'] = comparedWithRays(redOf(renderer), renderer, scene, camera, light);
    const uv1 = sheet.geometry.attributes.uv.clone();
    for (let i = 0; i < uv1.count; ++i) uv1.setXY(i, 1.5 * uv1.getY(i) - 0.3, 0.8 * uv1.getX(i) + 0.1 * uv1.getY(i));
    sheet.geometry.setAttribute('uv1', uv1);
    map.channel = 1;
    map.repeat.set(1.4, 1.2);
    Object.assign(alphaMap, { rotation: 0.4, wrapS: three.ClampToEdgeWrapping, needsUpdate: true });
    sheet.material.needsUpdate = true; // other coordinates
    await judge('of their own');
    const { data } = map.image;
    for (let i = 3; i < data.length; i += 4) data[i] = 255 - data[i];
    map.needsUpdate = true;
    await judge('other texels');
    for (const texture of [map, alphaMap]) texture.magFilter = texture.minFilter = three.NearestFilter;
    for (const texture of [map, alphaMap]) texture.needsUpdate = true;
    await judge('nearest');
    data.fill(255);
    map.needsUpdate = true;
    await judge('no alpha in map');
    told.error = renderer.getContext().getError();
    return told;
  });
  console.log(told);
  assert.equal(told.error, 0);
  for (const [name, of] of Object.entries(told)) if (of.surfaces) assertRight(name, of);
});

test('the other choices, and a light that moves', async () => {
  const { told } = await inPage(async ({ ExactShadows, drawn, redOf }, { floorOf, treeOf, leafAtlas, white, wholly }) => {
    const { renderer, scene, light, camera } = floorOf(window.page);
    const tree = treeOf(white({ map: leafAtlas(), alphaTest: 0.4 }));
    scene.add(tree);
    const shadows = new ExactShadows(renderer).add(scene);
    const dark = () => redOf(renderer).reduce((sum, red) => sum + (red < 128), 0);
    const told = {};
    for (const choice of ['exact', 'exact-or-whole', 'whole', 'none']) {
      shadows.alphaTestedCast = choice;
      await wholly(window.page, shadows, scene, camera);
      told[`${choice}, looked up`] = dark();
      light.position.x += 0.001;
      await drawn(shadows, scene, camera);
      told[`${choice}, mask`] = dark();
    }
    const refused = (act) => {
      try {
        act();
        return '';
      } catch (error) {
        return error.message;
      }
    };
    told.constructed = refused(() => new ExactShadows(renderer, { alphaTestedCast: 'exactly' }));
    shadows.alphaTestedCast = true;
    told.drawn = refused(() => shadows.render(scene, camera));
    return told;
  });
  console.log(told);
  const { 'none, mask': none, 'whole, mask': whole, 'exact, looked up': exact } = told;
  assert.ok(none + 300 < exact && exact + 300 < whole, 'holes and leaves are many pixels');
  const alike = (name, value) => assert.ok(Math.abs(told[name] - value) < 60, `${name}: ${told[name]}, not ${value}`);
  alike('exact, mask', exact);
  alike('exact-or-whole, mask', whole);
  alike('exact-or-whole, looked up', exact);
  alike('whole, looked up', whole);
  alike('none, looked up', none);
  assert.equal(told.constructed, "alphaTestedCast is 'exactly', which is not one of exact, exact-or-whole, whole, none.");
  assert.match(told.drawn, /^alphaTestedCast is 'true', which is not one of/);
});

test('what is not exact is told once, by name and reason', async () => {
  const { told, reports } = await inPage(async ({ three, ExactShadows, lampOf, rested }, { floorOf, blobs, white }) => {
    const { renderer, scene, camera } = floorOf(window.page, { width: 60, height: 40 });
    const added = (name, material, geometry = new three.PlaneGeometry(1, 1)) => {
      const mesh = new three.Mesh(geometry, material);
      mesh.name = name;
      mesh.position.y = 1;
      mesh.castShadow = true;
      scene.add(mesh);
      return mesh;
    };
    const alphaTest = 0.5, map = blobs(8, 8);
    const unlike = new three.PlaneGeometry(1, 1);
    unlike.setAttribute('uv1', new three.BufferAttribute(new Float32Array([0, 0, 1, 0, 0.2, 0.7, 0.5, 0.5]), 2));
    const alphaMap = blobs(4, 4, { green: true });
    alphaMap.channel = 1;
    added('both', white({ map, alphaMap, alphaTest }), unlike);
    const target = new three.WebGLRenderTarget(4, 4);
    added('target', white({ map: target.texture, alphaTest }));
    renderer.initTexture(map);
    renderer.setRenderTarget(target);
    renderer.clear();
    renderer.setRenderTarget(null);
    const coloured = new three.PlaneGeometry(1, 1);
    coloured.setAttribute('color', new three.BufferAttribute(new Float32Array(16).fill(1), 4));
    added('coloured', white({ map, alphaTest, vertexColors: true }), coloured);
    const several = new three.PlaneGeometry(1, 1);
    several.addGroup(0, 3, 0);
    several.addGroup(3, 3, 1);
    added('several', [white({ map, alphaTest }), white({ map, alphaTest: 0.3 })], several);
    added('mixed', [white({ map, alphaTest }), white()], several);
    const [soft, target1] = lampOf({ kind: 'DirectionalLight', position: [0, 1, 0.1] });
    const [second, target2] = lampOf({ kind: 'DirectionalLight', position: [0.2, 1, 0.1] });
    soft.name = 'soft';
    second.name = 'second';
    scene.add(soft, target1, second, target2);
    const shadows = new ExactShadows(renderer).add(scene).setRadius(soft, 0.01);
    const lookedUp = await rested(shadows, scene, camera);
    for (let i = 0; i < 3; ++i) shadows.render(scene, camera);
    return lookedUp;
  }, { allowed: [/^(Alpha-tested mesh|Mesh|Light) '/] });
  assert.equal(told, 1);
  assert.deepEqual([...reports].sort(), [
    "Alpha-tested mesh 'both' casts the shadow of its alphaMap alone, without its map's alpha.",
    "Alpha-tested mesh 'coloured' casts as if its vertices' alpha were 1.",
    "Alpha-tested mesh 'target' casts nothing: its texture may change in every frame.",
    "Light 'second' lacks the shadows of cutouts and tints, as it is not looked up: at most 1 at once.",
    "Light 'soft' lacks the shadows of cutouts and tints, as it is not looked up: it has a radius.",
  ]);
});
