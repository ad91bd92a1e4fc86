// A small world of three.js that changes at random, with surfaces that are white wherever they are lit.

import * as three from 'three';
import { blobs, white } from './foliage.js';

/** Random numbers that a seed determines. */
function randomOf(seed) {
  let state = seed >>> 0;
  const next = () => {
    state = (state + 0x6D2B79F5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 4294967296;
  };
  return {
    between: (least, most) => least + (most - least) * next(),
    oneOf: (list) => list[Math.floor(list.length * next())],
    isTrue: (share) => next() < share,
  };
}

const closed = [
  ({ between }) => new three.BoxGeometry(between(0.2, 1.2), between(0.2, 1.2), between(0.2, 1.2)),
  ({ between }) => new three.SphereGeometry(between(0.2, 0.6), 10, 7),
  ({ between }) => new three.TorusGeometry(between(0.3, 0.6), between(0.05, 0.2), 6, 12),
  ({ between }) => new three.CylinderGeometry(between(0.1, 0.5), between(0.1, 0.5), between(0.3, 1.2), 9),
  () => new three.TorusKnotGeometry(0.35, 0.1, 32, 5),
  () => new three.IcosahedronGeometry(0.5, 0), // without an index
];
const open = [
  ({ between }) => new three.PlaneGeometry(between(0.4, 1.4), between(0.4, 1.4), 2, 2),
  ({ between }) => new three.CylinderGeometry(between(0.2, 0.5), between(0.2, 0.5), 1, 9, 1, true),
  () => new three.SphereGeometry(0.6, 10, 5, 0, 5, 0, 1.4),
];

/** Gives a geometry a morph target, which shears and lengthens it. */
function bend(geometry) {
  const target = geometry.attributes.position.clone();
  for (let i = 0; i < target.count; ++i) target.setXYZ(i, target.getX(i) + 0.5 * target.getY(i), 1.4 * target.getY(i), target.getZ(i));
  geometry.morphAttributes.position = [target];
}

function turn(object, { between, isTrue, oneOf }) {
  object.rotation.set(between(-3, 3), between(-3, 3), between(-3, 3));
  const size = between(0.6, 1.4);
  object.scale.set(size * (isTrue(0.3) ? -1 : 1), size * between(0.7, 1.3), size);
  if (isTrue(0.1)) object.scale[oneOf('xyz')] *= 2;
}

function place(object, random) {
  const { between, isTrue } = random;
  if (isTrue(0.5)) turn(object, random);
  object.position.set(between(-2.5, 2.5), between(0.4, 2.5), between(-2.5, 2.5));
}

function placeInstances(mesh, random) {
  const { between } = random, instance = new three.Object3D();
  for (let i = 0; i < mesh.instanceMatrix.count; ++i) {
    turn(instance, random);
    instance.scale.x = Math.abs(instance.scale.x); // three.js shows mirrored instances inside out
    instance.position.set(between(-1, 1), between(-0.3, 0.6), between(-1, 1));
    instance.scale.multiplyScalar(0.5);
    instance.updateMatrix();
    mesh.setMatrixAt(i, instance.matrix);
  }
  mesh.instanceMatrix.needsUpdate = true;
}

/** A pane of glass, closed or a sheet, or a sheet with holes; named 'pane' or 'leaf'. */
function seeThroughOf(random) {
  const { oneOf, isTrue, between } = random;
  const name = oneOf(['pane', 'leaf']), isClosed = name === 'pane' && isTrue(0.5);
  const geometry = isClosed ? oneOf(closed)(random) : new three.PlaneGeometry(between(0.6, 2), between(0.6, 2), oneOf([1, 2]), 1);
  const material = white();
  if (name === 'pane') Object.assign(material, { transparent: true, opacity: between(0.2, 0.8), depthWrite: false, color: new three.Color().setRGB(between(0.2, 1), between(0.2, 1), between(0.2, 1)) });
  else Object.assign(material, { alphaTest: between(0.3, 0.7), map: blobs(oneOf([4, 8]), 8, { seed: Math.floor(between(1, 1000)) }) });
  return Object.assign(new three.Mesh(geometry, material), { name, castShadow: true, receiveShadow: true });
}

/** A mesh whose name is its kind: plain, instanced, morphed, or with several materials. */
function meshOf(random, seeThrough) {
  const { oneOf, isTrue, between } = random;
  if (seeThrough && isTrue(0.5)) return seeThroughOf(random);
  const isClosed = isTrue(0.7), geometry = oneOf(isClosed ? closed : open)(random);
  const material = white({ side: isClosed && isTrue(0.5) ? three.FrontSide : three.DoubleSide });
  const name = oneOf(['plain', 'plain', 'plain', 'instanced', 'morphed', 'materials']);
  const made = name === 'instanced' ? new three.InstancedMesh(geometry, material, 5)
    : new three.Mesh(geometry, name === 'materials' && geometry.groups.length > 1 ? geometry.groups.map(() => material.clone()) : material);
  if (name === 'instanced') placeInstances(made, random);
  if (name === 'morphed') {
    bend(geometry);
    made.updateMorphTargets();
    made.morphTargetInfluences[0] = between(0, 1);
  }
  return Object.assign(made, { name, castShadow: true, receiveShadow: true });
}

/**
 * Some meshes above a ground, up to three lights, each of one channel of colour, and a camera; with `seeThrough`, one
 * white light, panes and leaves too. Returns {scene, camera, lights, planes, unit, random, step()}: `planes` clip
 * everything, `unit` is the length of what would be 1, and step() makes some changes and returns their names.
 */
export function randomWorld(seed, { width, height }, { seeThrough = false } = {}) {
  const random = randomOf(seed), { between, oneOf, isTrue } = random;
  const unit = oneOf([1, 1, 1, 0.001, 1000]);
  const scene = new three.Scene(), root = new three.Group(), arm = new three.Group(), hand = new three.Group();
  root.scale.setScalar(unit);
  if (isTrue(0.2)) root.position.set(between(-1e5, 1e5), between(-100, 100), between(-1e5, 1e5)).multiplyScalar(unit);
  scene.add(root);
  root.add(arm);
  arm.add(hand);
  const ground = new three.Mesh(new three.BoxGeometry(9, 0.2, 9), white({ side: three.FrontSide }));
  ground.position.y = -0.1;
  ground.castShadow = ground.receiveShadow = true;
  root.add(ground);

  const world = { scene, unit, random, lights: [], planes: [] };
  const meshes = [], removed = [];
  const named = (name) => oneOf(meshes.filter((mesh) => mesh.name === name));
  const childless = () => oneOf(meshes.filter((mesh) => mesh.children.length === 0));
  const toWorld = (point) => point.multiplyScalar(unit).add(root.position);

  const add = (mesh, parent = root) => {
    parent.add(mesh);
    meshes.push(mesh);
  };
  const addNew = () => {
    const mesh = meshOf(random, seeThrough);
    place(mesh, random);
    add(mesh, oneOf([root, root, arm, hand, named('plain') ?? root]));
  };
  const moveLight = (light) => { toWorld(light.position.set(between(-2.5, 2.5), light.isDirectionalLight ? between(1, 4) : between(2.8, 5), between(-2.5, 2.5))); };
  const setLight = (channel) => {
    const had = world.lights[channel], kind = oneOf(['DirectionalLight', 'PointLight', 'SpotLight']);
    const color = new three.Color().setRGB(...[0, 1, 2].map((i) => (seeThrough || i === channel ? 1 : 0)));
    const light = kind === 'DirectionalLight' ? new three.DirectionalLight(color, Math.PI) : new three[kind](color, Math.PI, 0, ...(kind === 'SpotLight' ? [0.7, 0, 0] : [0]));
    light.castShadow = true;
    moveLight(light);
    had?.target?.removeFromParent();
    had?.removeFromParent();
    world.lights[channel] = light;
    scene.add(light);
    if (!light.target) return;
    light.target.position.copy(root.position);
    scene.add(light.target);
  };
  const setCamera = () => {
    const high = 4 * unit, wide = high * width / height, angle = between(0, 6.3), away = isTrue(0.8) ? 7 : between(1, 7);
    const camera = isTrue(0.8) ? new three.PerspectiveCamera(50, width / height, 0.1 * unit, 100 * unit) : new three.OrthographicCamera(-wide, wide, high, -high, 0.1 * unit, 100 * unit);
    toWorld(camera.position.set(away * Math.cos(angle), between(2, 6), away * Math.sin(angle)));
    camera.lookAt(toWorld(new three.Vector3(0, 0.6, 0)));
    world.camera = camera;
  };
  const planeOf = () => new three.Plane(new three.Vector3(between(-1, 1), between(-1, 1), between(-1, 1)).normalize(), between(0, unit)).translate(root.position);

  const changes = {
    addNew,
    remove: () => {
      const mesh = meshes.length > 3 && childless();
      if (!mesh) return;
      mesh.removeFromParent();
      meshes.splice(meshes.indexOf(mesh), 1);
      if (isTrue(0.5)) removed.push(mesh);
      else mesh.geometry.dispose();
    },
    addAgain: () => { if (removed.length > 0) add(removed.pop()); },
    addCopy: () => {
      const copy = named('plain')?.clone(false);
      if (!copy) return;
      place(copy, random);
      add(copy);
    },
    move: () => place(oneOf(meshes), random),
    nudge: () => { oneOf(meshes).position.y += between(0.01, 0.3); },
    turn: () => turn(oneOf(meshes), random),
    turnArm: () => {
      arm.rotation.y += between(-1, 1);
      if (isTrue(0.3)) arm.scale.x *= -1;
    },
    moveHand: () => { hand.position.x = between(-0.5, 0.5); },
    reparent: () => {
      const mesh = childless();
      if (mesh) oneOf([root, arm, hand])[oneOf(['add', 'attach'])](mesh);
    },
    hideOrShow: () => {
      const mesh = oneOf(meshes);
      mesh.visible = !mesh.visible;
    },
    castOrNot: () => {
      const mesh = oneOf(meshes);
      mesh.castShadow = !mesh.castShadow;
    },
    bendVertices: () => {
      const { geometry } = oneOf(meshes), by = between(0.7, 1.3);
      if (geometry.morphAttributes.position) return;
      const { position } = geometry.attributes;
      for (let i = 0; i < position.count; ++i) position.setXYZ(i, by * position.getX(i), position.getY(i), position.getZ(i) / by);
      position.needsUpdate = true;
      geometry.computeBoundingBox();
      geometry.computeBoundingSphere();
    },
    replaceGeometry: () => {
      const mesh = named('plain');
      if (mesh) mesh.geometry = oneOf(closed)(random);
    },
    drawPart: () => {
      const geometry = named('plain')?.geometry;
      if (!geometry) return;
      const { count } = geometry.index ?? geometry.attributes.position;
      geometry.setDrawRange(0, isTrue(0.3) ? Infinity : 3 * Math.floor(between(0.3, 1) * count / 3));
      for (const mesh of meshes) if (mesh.geometry === geometry) mesh.material = white(); // it is open
    },
    morph: () => {
      const mesh = named('morphed');
      if (mesh) mesh.morphTargetInfluences[0] = between(-0.5, 1);
    },
    moveInstances: () => {
      const mesh = named('instanced');
      if (mesh) placeInstances(mesh, random);
    },
    countInstances: () => {
      const mesh = named('instanced');
      if (mesh) mesh.count = Math.floor(between(0, 6));
    },
    showBothSides: () => { for (const material of [oneOf(meshes).material].flat()) material.side = three.DoubleSide; },
    fade: () => {
      const mesh = named('pane');
      if (mesh) mesh.material.opacity = between(0.2, 0.8);
    },
    cutMore: () => {
      const mesh = named('leaf');
      if (mesh) mesh.material.alphaTest = between(0.3, 0.7);
    },
    replaceLight: () => setLight(Math.floor(between(0, world.lights.length))),
    moveLight: () => moveLight(oneOf(world.lights)),
    setCamera,
    clip: () => { if (!seeThrough) world.planes = Array.from({ length: oneOf([0, 1, 1, 2]) }, planeOf); },
  };

  /** Rays miss nothing that has grown. */
  const boundForRays = () => {
    for (const mesh of meshes) {
      if (mesh.name === 'morphed') mesh.geometry.boundingSphere = new three.Sphere(new three.Vector3(), 10);
      if (mesh.isInstancedMesh) mesh.computeBoundingSphere();
    }
  };

  for (let channel = 0, count = seeThrough ? 1 : oneOf([1, 1, 2, 3]); channel < count; ++channel) setLight(channel);
  for (let i = 0; i < 7; ++i) addNew();
  setCamera();
  boundForRays();
  world.step = () => {
    const names = Array.from({ length: isTrue(0.5) ? 1 : Math.floor(between(2, 5)) }, () => oneOf(Object.keys(changes)));
    for (const name of names) changes[name]();
    boundForRays();
    return names.join(', ');
  };
  return world;
}
