// Shared parts of the gallery's scenes: a picture that fills the page, a camera to orbit, exact shadows, and
// shapes that cast and receive them.

import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { ExactShadows } from 'edgeshade/three';

/** A box of width, height and depth on the floor height y, its middle at x and z. */
export function block([width, height, depth], [x, y, z], material) {
  const mesh = new THREE.Mesh(new THREE.BoxGeometry(width, height, depth), material);
  mesh.position.set(x, y + height / 2, z);
  return solid(mesh);
}

/** A cylinder of a radius and height, likewise. */
export function post(radius, height, [x, y, z], material) {
  const mesh = new THREE.Mesh(new THREE.CylinderGeometry(radius, radius, height, 24), material);
  mesh.position.set(x, y + height / 2, z);
  return solid(mesh);
}

/** Everything below an object casts and receives shadow. */
export function solid(object) {
  object.traverse((part) => { part.castShadow = part.receiveShadow = true; });
  return object;
}

/** A matt material of a colour. */
export const matt = (color, more) => new THREE.MeshStandardMaterial({ color, roughness: 0.9, ...more });

/** A casting sun from a direction. */
export function sunFrom(x, y, z, intensity = 3) {
  const sun = new THREE.DirectionalLight(0xfff1dc, intensity);
  sun.position.set(x, y, z);
  sun.castShadow = true;
  return sun;
}

/**
 * `eye`, `look`: places of the camera and of what it looks at; `options`: those of ExactShadows.
 * draw() asks for a frame, animate(tick) calls tick(seconds) before each frame from then on.
 */
export function stage({ eye, look = [0, 1, 0], sky = 0xcddae6, ambient = 1, options } = {}) {
  const renderer = new THREE.WebGLRenderer({ antialias: true });
  renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
  document.body.append(renderer.domElement);
  const scene = new THREE.Scene();
  scene.background = new THREE.Color(sky);
  scene.add(new THREE.HemisphereLight(0xffffff, 0x8a8070, ambient));
  const camera = new THREE.PerspectiveCamera(38, 1, 0.05, 200);
  camera.position.set(...eye);
  const controls = new OrbitControls(camera, renderer.domElement);
  controls.target.set(...look);
  controls.maxPolarAngle = 1.55;
  controls.listenToKeyEvents(window); // arrow keys pan, with Shift they orbit
  controls.update();
  const shadows = new ExactShadows(renderer, options).add(scene);

  let asked = 0, tick = null;
  const frame = (now) => {
    asked = 0;
    tick?.(now / 1000);
    shadows.render(scene, camera);
    if (tick) draw();
  };
  const draw = () => { asked ||= requestAnimationFrame(frame); };
  const fit = () => {
    const { innerWidth: width, innerHeight: height } = window;
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    renderer.setSize(width, height);
    draw();
  };
  controls.addEventListener('change', draw);
  shadows.addEventListener('change', draw);
  addEventListener('resize', fit);
  fit();
  const animate = (each) => {
    tick = matchMedia('(prefers-reduced-motion: reduce)').matches ? null : each;
    each(0);
    draw();
  };
  return { scene, camera, renderer, controls, shadows, draw, animate };
}
