// A building model drawn in code: storeys of small meshes, each with a geometry of its own, as
// converters of building models write them.

import * as three from 'three';

const storey = 3; // metres

/** Numbers from 0 to 1, the same every time. */
function randoms(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

/** Part `i` of a storey `width` metres wide: {geometry, at}. */
function part(i, width, random) {
  const across = () => (random() - 0.5) * width, kind = i % 6;
  if (kind === 0) return { geometry: new three.BoxGeometry(0.8 + 2 * random(), 2.6, 0.12), at: [across(), 1.3, across()] };
  if (kind === 1) return { geometry: new three.BoxGeometry(0.3, 2.7, 0.3), at: [across(), 1.35, across()] };
  if (kind === 2) return { geometry: new three.CylinderGeometry(0.04, 0.04, 1 + 2 * random(), 16), at: [across(), 2.4, across()], turned: true };
  if (kind === 3) return { geometry: new three.TorusGeometry(0.2, 0.04, 8, 12), at: [across(), 2.3, across()] };
  if (kind === 4) return { geometry: new three.BoxGeometry(0.6, 0.05, 0.6), at: [across(), 2.5, across()] };
  return { geometry: new three.SphereGeometry(0.12 + 0.05 * random(), 12, 8), at: [across(), 0.2, across()] };
}

/** A group of this many casting and receiving meshes, in storeys of at most 500 on slabs. */
export function building(count, { seed = 1, width = 24 } = {}) {
  const group = new three.Group(), random = randoms(seed);
  const material = new three.MeshStandardMaterial({ color: 0xffffff });
  const add = ({ geometry, at, turned }, floor) => {
    const mesh = new three.Mesh(geometry, material);
    mesh.position.set(at[0], at[1] + storey * floor, at[2]);
    if (turned) mesh.rotation.set(0, random() * Math.PI, Math.PI / 2);
    mesh.castShadow = mesh.receiveShadow = true;
    group.add(mesh);
  };
  for (let i = 0; i < count; ++i) {
    const floor = Math.floor(i / 500);
    if (i % 500 === 0) add({ geometry: new three.BoxGeometry(width + 1, 0.2, width + 1), at: [0, -0.1, 0] }, floor);
    else add(part(i, width, random), floor);
  }
  return group;
}

/** A camera that sees the whole of a model, with the model's {bounds, middle, size}. */
export function viewOf(model) {
  const bounds = new three.Box3().setFromObject(model), middle = bounds.getCenter(new three.Vector3());
  const size = bounds.getSize(new three.Vector3()).length();
  const camera = new three.PerspectiveCamera(40, 16 / 9, size / 100, 10 * size);
  camera.position.set(0.7, 0.35, 0.6).multiplyScalar(size).add(middle);
  camera.lookAt(middle);
  return { camera, bounds, middle, size };
}
