// A demo of edgeshade/three-webgpu: the sample in the sun and beside a lamp. In the address, `?webgl`
// draws with WebGL 2, `?move` has a ball that moves, and `?map` shows three.js's own maps.

import * as three from 'three/webgpu';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { DRACOLoader } from 'three/addons/loaders/DRACOLoader.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { ExactShadows } from 'edgeshade/three-webgpu';

const asked = new URLSearchParams(location.search);
const told = document.getElementById('told');

async function lit(scene) {
  const draco = new DRACOLoader().setDecoderPath(import.meta.resolve('three/addons/libs/draco/gltf/'));
  const { scene: sample } = await new GLTFLoader().setDRACOLoader(draco).loadAsync('../assets/pavilion.glb');
  draco.dispose();
  const sun = new three.DirectionalLight(0xfff1dd, 2.5), lamp = new three.PointLight(0xffd9a0, 25);
  sun.position.set(-6.2, 6.2, -3);
  Object.assign(sun.shadow.camera, { left: -9, right: 9, top: 9, bottom: -9 }); // for three.js's own map
  lamp.position.set(1.5, 2.2, 2);
  const ball = new three.Mesh(new three.SphereGeometry(0.4, 32, 16), new three.MeshStandardMaterial({ color: 0xc05030 }));
  ball.visible = asked.has('move');
  scene.add(sample, sun, lamp, ball, new three.AmbientLight(0xc8d8ff, 0.6));
  scene.traverse((object) => {
    object.castShadow = Boolean(object.isMesh || object.isDirectionalLight || object.isPointLight);
    object.receiveShadow = Boolean(object.isMesh);
  });
  return ball;
}

async function show() {
  const renderer = new three.WebGPURenderer({ antialias: true, forceWebGL: asked.has('webgl') });
  await renderer.init();
  renderer.shadowMap.enabled = true;
  document.body.prepend(renderer.domElement);
  const scene = new three.Scene(), camera = new three.PerspectiveCamera(45, 1, 0.1, 200);
  camera.position.set(-2.6, 3.6, 10.2);
  const controls = new OrbitControls(camera, renderer.domElement);
  controls.target.set(0.2, 1.3, -0.2);
  const ball = await lit(scene);
  const shadows = asked.has('map') ? null : new ExactShadows(renderer).add(scene);
  shadows?.addEventListener('error', ({ message }) => { told.textContent = message; });
  const resize = () => {
    renderer.setPixelRatio(devicePixelRatio);
    renderer.setSize(innerWidth, innerHeight);
    camera.aspect = innerWidth / innerHeight;
    camera.updateProjectionMatrix();
  };
  addEventListener('resize', resize);
  resize();
  renderer.setAnimationLoop((time) => {
    controls.update();
    ball.position.set(2.2 * Math.sin(time / 1500), 1.2, 2.6 + Math.cos(time / 1500));
    if (!shadows) {
      renderer.render(scene, camera);
      told.textContent = "three.js's own maps";
      return;
    }
    shadows.render(scene, camera);
    told.textContent = shadows.lights.map(({ light, method, reason }) => `${light.type}: ${method} (${reason})`).join('\n');
  });
}

show().catch((error) => { told.textContent = error.message; });
