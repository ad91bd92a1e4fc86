// Leaves and other cutouts that cast onto a floor, for tests of the three.js adapter.

import * as three from 'three';

/** A material that is white where a light reaches it, and black elsewhere. */
export function white(settings) {
  const material = new three.MeshToonMaterial({ color: 0xffffff, side: three.DoubleSide, ...settings });
  material.gradientMap = new three.DataTexture(new Uint8Array(8).fill(255), 2, 1);
  material.gradientMap.needsUpdate = true;
  return material;
}

/** A floor, a box on it, a light and a camera that looks down. */
export function floorOf({ rendererOf, lampOf, cameraOf }, { kind = 'DirectionalLight', position = [0.4, 1, 0.3], width = 200, height = 130 } = {}) {
  const renderer = rendererOf({ width, height });
  const scene = new three.Scene();
  const made = (geometry, at) => {
    const mesh = new three.Mesh(geometry, white());
    mesh.position.set(...at);
    mesh.castShadow = mesh.receiveShadow = true;
    scene.add(mesh);
    return mesh;
  };
  const floor = made(new three.BoxGeometry(7, 0.2, 7), [0, -0.1, 0]);
  made(new three.BoxGeometry(0.6, 0.8, 0.6), [-1.9, 0.41, 0.8]);
  const [light, target] = lampOf({ kind, position });
  if (light.isSpotLight) light.angle = 1.2;
  scene.add(light, ...(target ? [target] : []));
  return { renderer, scene, floor, light, camera: cameraOf({ from: [1.5, 5.5, 5], to: [0, 0.3, 0], fov: 45 }, width / height) };
}

/** A canvas of 2 x 2 pictures of leaves, soft at their edges: an atlas as foliage has them. */
export function leafAtlas(size = 64) {
  const canvas = new OffscreenCanvas(size, size), half = size / 2;
  const context = canvas.getContext('2d', { willReadFrequently: true });
  context.fillStyle = '#fff';
  for (const [i, j, petals] of [[0, 0, 3], [1, 0, 5], [0, 1, 2], [1, 1, 7]]) {
    context.setTransform(1, 0, 0, 1, (i + 0.5) * half, (j + 0.5) * half);
    for (let k = 0; k < petals; ++k) {
      context.beginPath();
      context.ellipse(0.22 * half, 0, 0.22 * half, 0.09 * half, 0, 0, 2 * Math.PI);
      context.fill();
      context.rotate(2 * Math.PI / petals);
    }
  }
  const texture = new three.CanvasTexture(canvas);
  texture.minFilter = three.LinearFilter;
  texture.generateMipmaps = false;
  return texture;
}

/** A card that shows one of the atlas's pictures. */
export function cardOf(picture, width = 1, height = 1) {
  const geometry = new three.PlaneGeometry(width, height), { uv } = geometry.attributes;
  for (let i = 0; i < uv.count; ++i) uv.setXY(i, (uv.getX(i) + picture % 2) / 2, (uv.getY(i) + (picture >> 1)) / 2);
  return geometry;
}

/** A tree of crossing cards, two of them instanced. */
export function treeOf(material) {
  const tree = new three.Group();
  const placed = (mesh, [x, y, z], [a, b, c]) => {
    mesh.position.set(x, y, z);
    mesh.rotation.set(a, b, c);
    mesh.castShadow = mesh.receiveShadow = true;
    tree.add(mesh);
  };
  placed(new three.Mesh(cardOf(1, 2.2, 2.2), material), [0, 1.3, 0], [-1.2, 0.2, 0]);
  placed(new three.Mesh(cardOf(0, 1.6, 1.6), material), [0.8, 0.9, -0.7], [-0.7, 0.9, 0.3]);
  placed(new three.Mesh(cardOf(3, 1.5, 1.5), material), [-0.9, 1.6, -0.8], [-1.7, -0.3, 0.2]);
  const instances = new three.InstancedMesh(cardOf(2, 1.2, 1.2), material, 3);
  for (let i = 0; i < 3; ++i)
    instances.setMatrixAt(i, new three.Matrix4().makeRotationFromEuler(new three.Euler(-1.1 - 0.4 * i, 0.5 * i, 0.1)).setPosition(1.3 - 0.9 * i, 0.6 + 0.3 * i, 1.1 + 0.3 * i));
  placed(instances, [0, 0, 0], [0, 0.1, 0]);
  return tree;
}

/** Random blobs of alpha, in the alpha or the green channel. */
export function blobs(width, height, { green = false, seed = 7 } = {}) {
  const texels = new Uint8Array(4 * width * height).fill(255);
  for (let i = 0, state = seed; i < width * height; ++i) {
    state = (Math.imul(state, 1103515245) + 12345) & 0x7fffffff;
    texels[4 * i + (green ? 1 : 3)] = state >> 16 & 255;
  }
  const texture = new three.DataTexture(texels, width, height);
  texture.magFilter = texture.minFilter = three.LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

/** Draws frames until a light's map holds all casters, also those that have changed lately. */
export async function wholly({ rested }, shadows, scene, camera, lights = 1) {
  await rested(shadows, scene, camera, lights);
  const holdAll = () => [...shadows.lights.values()].filter(({ method }) => method === 'lookup').length === lights;
  const pause = () => new Promise((resolve) => { setTimeout(resolve, 150, false); });
  for (const since = Date.now(); Date.now() - since < 60000;) {
    shadows.render(scene, camera); // reads new textures
    const settled = await Promise.race([shadows.settled.then(() => true), pause()]);
    if (settled && holdAll()) break;
  }
  return shadows.cost.lookedUp;
}

/**
 * Hangs a sheet above the floor: {shadows, told, judge}, where judge(name) draws until the light's map holds all
 * casters, and puts what comparedWithRays() returns into `told`.
 */
export function judging(page, { renderer, scene, camera, light }, sheet) {
  sheet.position.set(0.2, 1.2, 0);
  sheet.rotation.set(-1.3, 0.2, 0.3);
  sheet.castShadow = sheet.receiveShadow = true;
  scene.add(sheet);
  const shadows = new page.ExactShadows(renderer).add(scene), told = {};
  const judge = async (name) => {
    if (await wholly(page, shadows, scene, camera) !== 1) throw new Error(`${name}: no light is looked up`);
    told[name] = page.comparedWithRays(page.redOf(renderer), renderer, scene, camera, light);
  };
  return { shadows, told, judge };
}
