// See-through meshes of three.js tint the light, where it is looked up: judged by rays.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { useBrowser } from './support/browser.mjs';
import { inFoliage, inPlaceOf } from './support/three.mjs';

const shared = useBrowser({ sharesPages: true });

const inPage = (...of) => inFoliage(shared, ...of);

const assertRight = (name, { compared, tinted, wrong, beyond }) => {
  assert.ok(compared > 5000 && tinted > 300, `${name}: ${compared} pixels, ${tinted} of them tinted`);
  assert.ok(beyond <= 0.0002 * compared && wrong <= 0.04 * compared, `${name}: ${wrong} of ${compared} pixels are wrong, ${beyond} of them beyond outlines`);
};

/** Panes above one another, of several kinds, and a pillar; [mesh, tint]. */
const window3 = async ({ three, ExactShadows, rested }, { floorOf, comparedTints }, { kind, position, inGlobe }) => {
  const { renderer, scene, light, camera } = floorOf(window.page, { kind, position });
  const tints = new Map();
  const added = (mesh, tint, at, turned = [0, 0, 0]) => {
    mesh.position.set(...at);
    mesh.rotation.set(...turned);
    mesh.castShadow = mesh.receiveShadow = true;
    tints.set(mesh, tint);
    scene.add(mesh);
    return mesh;
  };
  const linear = (r, g, b) => new three.Color().setRGB(r, g, b, three.LinearSRGBColorSpace);
  const blended = (colour, opacity, settings) => new three.MeshLambertMaterial({ color: linear(...colour), opacity, transparent: true, ...settings });
  const glass = (colour, transmission, settings) => new three.MeshPhysicalMaterial({ color: linear(...colour), transmission, roughness: 0.1, ...settings });
  // Its back is towards a light from above.
  added(new three.Mesh(new three.PlaneGeometry(2, 1.6), blended([1, 0.4, 0.2], 0.2)), [0.8, 0.32, 0.16], [-0.6, 1.1, -0.3], [1.3, 0, 0.1]);
  added(new three.Mesh(new three.PlaneGeometry(1.4, 1.8), blended([0.2, 0.5, 1], 0.25, { side: three.DoubleSide })), [0.15, 0.375, 0.75], [0.3, 1.5, 0.2], [-1.4, 0.2, 0.4]);
  added(new three.Mesh(new three.BoxGeometry(1.2, 0.1, 1.2), glass([0.9, 0.8, 0.3], 0.9)), [0.81, 0.72, 0.27], [0.7, 0.9, -0.4], [0.1, 0.3, 0]);
  added(new three.Mesh(new three.BoxGeometry(1, 0.2, 0.5), glass([0.5, 1, 0.5], 1, { transparent: true, opacity: 0.5, side: three.BackSide })), [0.5, 1, 0.5], [0, 1.9, 0.5], [0, 0.4, 0]);
  const row = added(new three.InstancedMesh(new three.PlaneGeometry(0.5, 1), blended([1, 1, 1], 0.5), 3), [0.5, 0.5, 0.5], [-1.2, 0.5, 1.3]);
  for (let i = 0; i < 3; ++i) row.setMatrixAt(i, new three.Matrix4().makeRotationX(-1.2).setPosition(0.35 * i, 0.12 * i, 0.1 * i));
  if (inGlobe) added(new three.Mesh(new three.SphereGeometry(0.3, 20, 12), glass([1, 0.7, 0.5], 1)), [1, 0.7, 0.5], position);
  const shadows = new ExactShadows(renderer, { transparentCast: 'tint' }).add(scene);
  const lookedUp = await rested(shadows, scene, camera);
  return { lookedUp, ...comparedTints(renderer, scene, camera, light, (mesh) => tints.get(mesh) ?? null), error: renderer.getContext().getError() };
};

for (const [release, kind, position, inGlobe] of [['three-0.152', 'DirectionalLight', [0.3, 1, 0.25]], ['three', 'DirectionalLight', [0.3, 1, 0.25]],
  ['three', 'PointLight', [0.5, 3.4, 0.4]], ['three', 'PointLight', [0.2, 3.1, 0.3], true]])
  test(`stained glass in a row, ${kind}${inGlobe ? ' in a globe' : ''}, in ${inPlaceOf(release)}`, async () => {
    const { told } = await inPage(window3, { release, given: { kind, position, inGlobe } });
    console.log(told);
    assert.equal(told.lookedUp, 1);
    assert.equal(told.error, 0);
    assertRight('panes', told);
  });

test('none, opaque and tint, looked up and in masks; changes; a sentence for others', async () => {
  const { told } = await inPage(async ({ three, ExactShadows, drawn, redOf, comparedWithRays }, { floorOf, comparedTints, white, wholly }) => {
    const { renderer, scene, light, camera } = floorOf(window.page);
    const pane = new three.Mesh(new three.BoxGeometry(1.6, 0.1, 1.4), white({ opacity: 0.5, transparent: true, side: three.FrontSide }));
    pane.position.set(0.6, 1.3, -0.2);
    pane.castShadow = pane.receiveShadow = true;
    scene.add(pane);
    const shadows = new ExactShadows(renderer, { lookups: 1 }).add(scene);
    const told = {};
    const count = () => redOf(renderer).filter((red) => red < 128).length;
    for (const choice of ['none', 'opaque', 'tint']) {
      shadows.transparentCast = choice;
      light.position.x += 0.001;
      await drawn(shadows, scene, camera);
      told[`${choice}, mask`] = [shadows.cost.lookedUp, count()];
      await wholly(window.page, shadows, scene, camera);
      told[`${choice}, looked up`] = [shadows.cost.lookedUp, count()];
    }
    const tint = () => comparedTints(renderer, scene, camera, light, (mesh) => (mesh === pane ? [pane.material.color.r * 0.5, pane.material.color.g * 0.5, pane.material.color.b * 0.5] : null));
    told.tint = tint();
    pane.material.color.setRGB(0.3, 0.8, 1);
    shadows.render(scene, camera);
    told.inMotion = shadows.cost.lookedUp;
    await wholly(window.page, shadows, scene, camera);
    told.changed = tint();
    pane.material.opacity = 1;
    pane.material.transparent = false;
    pane.material.needsUpdate = true;
    await wholly(window.page, shadows, scene, camera);
    told.solid = comparedWithRays(redOf(renderer), renderer, scene, camera, light, { seeThroughCasts: true });
    const refused = (act) => {
      try {
        act();
        return '';
      } catch (error) {
        return error.message;
      }
    };
    told.constructed = refused(() => new ExactShadows(renderer, { transparentCast: true }));
    shadows.transparentCast = 'tinted';
    told.rendered = refused(() => shadows.render(scene, camera));
    return told;
  });
  console.log(told);
  const { 'none, mask': [noneMasked, none], 'opaque, mask': [opaqueMasked, opaque], 'tint, mask': [, tint] } = told;
  assert.deepEqual([noneMasked, opaqueMasked], [0, 0]);
  assert.ok(opaque > none + 300);
  assert.equal(tint, none, 'half of the light is more than 128');
  for (const [name, value] of Object.entries(told)) if (name.endsWith('looked up')) assert.equal(value[0], 1, name);
  assert.ok(Math.abs(told['none, looked up'][1] - none) < 60 && Math.abs(told['opaque, looked up'][1] - opaque) < 60);
  assertRight('tint', told.tint);
  assert.equal(told.inMotion, 0);
  assertRight('changed', told.changed);
  assert.ok(told.solid.beyond <= 2, `${told.solid.beyond} wrong`);
  assert.equal(told.constructed, "transparentCast is 'true', which is not one of none, opaque, tint.");
  assert.match(told.rendered, /^transparentCast is 'tinted'/);
});

test('panes whose textures are of colour, opacity and transmission', async () => {
  const { told } = await inPage(async ({ three, ExactShadows }, { floorOf, comparedTints, blobs, sampled, wholly }) => {
    const { renderer, scene, light, camera } = floorOf(window.page, { kind: 'PointLight', position: [0.3, 3.6, 0.4] });
    /** Red, green and blue of a texture of noise. */
    const coloured = (width, height) => {
      const texture = blobs(width, height);
      for (let i = 0; i < texture.image.data.length; ++i) if (i % 4 < 3) texture.image.data[i] = 60 + (i * 97 + (i >> 3) * 31) % 190;
      return texture;
    };
    const added = (material, at, turned) => {
      const mesh = new three.Mesh(new three.PlaneGeometry(1.6, 1.4), material);
      mesh.position.set(...at);
      mesh.rotation.set(...turned);
      mesh.castShadow = mesh.receiveShadow = true;
      scene.add(mesh);
      return mesh;
    };
    const color = new three.Color().setRGB(1, 0.8, 0.6, three.LinearSRGBColorSpace);
    const blended = added(new three.MeshLambertMaterial({ color, map: coloured(5, 4), alphaMap: blobs(3, 6, { green: true }), transparent: true, opacity: 0.8, side: three.DoubleSide }), [-0.7, 1.2, -0.4], [-1.4, 0.1, 0.2]);
    blended.geometry.setAttribute('uv1', blended.geometry.attributes.uv.clone());
    for (const uv of [blended.geometry.attributes.uv1.array]) for (let i = 0; i < uv.length; ++i) uv[i] = 1 - 0.8 * uv[i];
    blended.material.alphaMap.channel = 1;
    const glass = added(new three.MeshPhysicalMaterial({ color, map: coloured(4, 4), transmissionMap: coloured(6, 5), transmission: 0.9 }), [0.8, 0.9, 0.3], [-1.6, 0.2, 0.1]);
    for (const { map } of [blended.material, glass.material]) Object.assign(map, { wrapS: three.RepeatWrapping, rotation: 0.3 });
    const shadows = new ExactShadows(renderer, { transparentCast: 'tint' }).add(scene);
    const tintOf = ({ material }, hit) => {
      if (!material.transparent && !material.transmission) return null;
      const { map, alphaMap, transmissionMap, opacity, transparent, transmission = 0 } = material;
      if (!hit) return [1, 1, 1];
      const at = (texture, channel) => (texture ? sampled(texture, texture.channel === 1 ? hit.uv1 : hit.uv, channel) : 1);
      const alpha = transparent ? opacity * at(map, 3) * at(alphaMap, 1) : 1;
      return ['r', 'g', 'b'].map((name, i) => color[name] * at(map, i) * (1 - alpha * (1 - transmission * at(transmissionMap, 0))));
    };
    const told = {};
    const judge = async (name) => {
      told[`${name} lookedUp`] = await wholly(window.page, shadows, scene, camera);
      told[name] = comparedTints(renderer, scene, camera, light, tintOf);
    };
    await judge('at first');
    color.setRGB(0.5, 1, 1, three.LinearSRGBColorSpace);
    for (const { material } of [blended, glass]) material.color.copy(color);
    glass.material.transmission = 0.6;
    blended.material.map.offset.set(0.3, 0.1);
    await judge('changed');
    return { ...told, error: renderer.getContext().getError() };
  });
  console.log(told);
  assert.equal(told.error, 0);
  for (const name of ['at first', 'changed']) {
    assert.equal(told[`${name} lookedUp`], 1);
    assertRight(name, told[name]);
  }
});

test('leaves that are see-through and alpha-tested are cut out', async () => {
  const { told } = await inPage(async ({ ExactShadows, redOf, comparedWithRays }, { floorOf, treeOf, leafAtlas, white, wholly }) => {
    const { renderer, scene, light, camera } = floorOf(window.page);
    scene.add(treeOf(white({ map: leafAtlas(), alphaTest: 0.4, transparent: true })));
    const shadows = new ExactShadows(renderer).add(scene);
    const lookedUp = await wholly(window.page, shadows, scene, camera);
    return { lookedUp, ...comparedWithRays(redOf(renderer), renderer, scene, camera, light, { seeThroughCasts: true }) };
  });
  console.log(told);
  assert.equal(told.lookedUp, 1);
  assert.ok(told.dark > 300);
  // The leaves' own edges are blended with what is behind them.
  assert.ok(told.beyond <= 0.0002 * told.surfaces, `${told.beyond} wrong`);
});

test('glass with transmission is not in masks, and receives shadow by lookup', async () => {
  const { told } = await inPage(async ({ three, ExactShadows, drawn, rested, redOf, redAt }, { floorOf }) => {
    const { renderer, scene, light, camera } = floorOf(window.page);
    const shadows = new ExactShadows(renderer).add(scene);
    const sheet = new three.Mesh(new three.BoxGeometry(1.5, 0.1, 1.5), scene.children[0].material);
    sheet.position.set(0.5, 1.6, 0);
    sheet.castShadow = true;
    scene.add(sheet);
    const pane = new three.Mesh(new three.PlaneGeometry(2.2, 2.2), new three.MeshPhysicalMaterial({ color: 0xffffff, transmission: 1, roughness: 0, ior: 1, specularIntensity: 0 }));
    pane.position.copy(camera.position).multiplyScalar(0.45);
    pane.quaternion.copy(camera.quaternion);
    pane.receiveShadow = true;
    await drawn(shadows, scene, camera);
    const without = redOf(renderer);
    scene.add(pane);
    light.position.x += 0.001;
    await drawn(shadows, scene, camera);
    const withPane = redOf(renderer), masked = shadows.cost.lookedUp;
    // three.js blurs what is behind a pane by up to two pixels: it samples a picture with four samples a
    // pixel, by cubic filters.
    const { width, height } = renderer.domElement;
    const isFlat = (picture, i) => {
      const x = i % width, y = Math.floor(i / width), around = [];
      for (let v = Math.max(0, y - 2); v <= Math.min(height - 1, y + 2); ++v)
        for (let u = Math.max(0, x - 2); u <= Math.min(width - 1, x + 2); ++u) around.push(picture[v * width + u]);
      return Math.max(...around) - Math.min(...around) <= 20;
    };
    const unlike = (a, b) => a.filter((red, i) => Math.abs(red - b[i]) > 8 && isFlat(a, i)).length;
    const changed = (a, b) => a.filter((red, i) => Math.abs(red - b[i]) > 8).length;
    // A white pane in the sheet's shadow.
    pane.position.set(-0.2, 0.8, -0.1);
    pane.rotation.set(-Math.PI / 2, 0, 0);
    Object.assign(pane.material, { transmission: 0.01 });
    const lookedUp = await rested(shadows, scene, camera);
    return { masked, unlike: unlike(without, withPane), changed: changed(without, withPane), lookedUp, lit: redAt(renderer, camera, [-1.1, 0.8, 0.3]), shaded: redAt(renderer, camera, [-0.4, 0.8, 0.3]) };
  });
  console.log(told);
  assert.equal(told.masked, 0);
  // 0.152 does not filter what is behind it.
  if (inPlaceOf('three') !== 'three-0.152') assert.ok(told.changed > 100, 'the pane is there');
  assert.equal(told.unlike, 0, 'pixels that show other shadows, two pixels beyond edges');
  assert.equal(told.lookedUp, 1);
  assert.ok(told.lit > 150 && told.shaded < 60, `${told.lit} and ${told.shaded}`);
});

test('what tints otherwise is told once, by name and reason', async () => {
  const { told, reports } = await inPage(async ({ three, ExactShadows, lampOf, rested }, { floorOf, blobs, white }) => {
    const { renderer, scene, camera } = floorOf(window.page, { width: 60, height: 40 });
    const added = (name, material, geometry = new three.PlaneGeometry(1, 1)) => {
      const mesh = new three.Mesh(geometry, material);
      Object.assign(mesh, { name, castShadow: true });
      mesh.position.y = 1;
      scene.add(mesh);
    };
    const see = (settings) => white({ transparent: true, opacity: 0.5, ...settings });
    const several = new three.PlaneGeometry(1, 1);
    several.addGroup(0, 3, 0);
    several.addGroup(3, 3, 1);
    const picture = new three.WebGLRenderTarget(4, 4);
    renderer.setRenderTarget(picture);
    renderer.clear();
    renderer.setRenderTarget(null);
    added('textured', see({ map: picture.texture }));
    added('plain', see());
    added('two', [see(), see({ opacity: 0.2 })], several); // each part tints by its own material
    added('frame', [white(), see()], several);
    const [soft, target] = lampOf({ kind: 'DirectionalLight', position: [0, 1, 0.1] });
    soft.name = 'soft';
    scene.add(soft, target);
    const shadows = new ExactShadows(renderer, { transparentCast: 'tint' }).add(scene).setRadius(soft, 0.01);
    const lookedUp = await rested(shadows, scene, camera);
    for (let i = 0; i < 3; ++i) shadows.render(scene, camera);
    return lookedUp;
  }, { allowed: [/^(See-through mesh|Mesh|Light) '/] });
  assert.equal(told, 1);
  assert.deepEqual([...reports].sort(), [
    "Light 'soft' lacks the shadows of cutouts and tints, as it is not looked up: it has a radius.",
    "See-through mesh 'textured' tints by its colour alone, without its map.",
  ]);
});
