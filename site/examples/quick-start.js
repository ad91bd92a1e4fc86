import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { ExactShadows } from 'edgeshade/three';

const renderer = new THREE.WebGLRenderer({ antialias: true });
renderer.setSize(innerWidth, innerHeight);
document.body.append(renderer.domElement);

const scene = new THREE.Scene();
scene.background = new THREE.Color(0xcddae6);
const white = new THREE.MeshStandardMaterial({ color: 0xe8e2d6 });
const floor = new THREE.Mesh(new THREE.BoxGeometry(8, 0.2, 8), white);
floor.position.y = -0.1;
const knot = new THREE.Mesh(new THREE.TorusKnotGeometry(0.6, 0.18, 128, 24), white);
knot.position.y = 1.2;
scene.add(floor, knot, new THREE.HemisphereLight(0xffffff, 0x887766, 1));
const sun = new THREE.DirectionalLight(0xffffff, 3);
sun.position.set(-2, 3, 1);
scene.add(sun);

// These four lines are all that exact shadows need.
const shadows = new ExactShadows(renderer).add(scene);
sun.castShadow = true;
scene.traverse((object) => { if (object.isMesh) object.castShadow = object.receiveShadow = true; });
renderer.setAnimationLoop(() => shadows.render(scene, camera)); // in place of renderer.render()

const camera = new THREE.PerspectiveCamera(40, innerWidth / innerHeight, 0.1, 50);
camera.position.set(3, 3, 4);
new OrbitControls(camera, renderer.domElement).target.set(0, 0.7, 0);
camera.lookAt(0, 0.7, 0);
