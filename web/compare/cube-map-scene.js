// The scene as three.js draws it: one point light with a cube shadow map, and the surfaces' look as
// near to edgeshade's as its Lambert material comes.

import {
  AmbientLight, AnimationMixer, BasicShadowMap, Box3, Color, LinearSRGBColorSpace,
  MeshLambertMaterial, NoColorSpace, PCFShadowMap, PerspectiveCamera, PointLight, Scene, Vector3,
  WebGLRenderer,
} from 'three';
import { DRACOLoader } from 'three/addons/loaders/DRACOLoader.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { MeshoptDecoder } from 'three/addons/libs/meshopt_decoder.module.js';

export { REVISION } from 'three';

const background = [0.86, 0.89, 0.92]; // edgeshade's

/** Lambert in the display's own values, which is how edgeshade shades. */
function lambertOf(source) {
  const { map } = source;
  if (map) map.colorSpace = NoColorSpace;
  return new MeshLambertMaterial({
    color: source.color.clone().convertLinearToSRGB(),
    map,
    vertexColors: source.vertexColors,
    side: source.side,
    alphaTest: source.alphaTest,
    transparent: source.transparent,
    opacity: source.opacity,
    depthWrite: source.depthWrite,
    flatShading: source.flatShading,
  });
}

export class CubeMapScene {
  #renderer;
  #scene = new Scene();
  #camera = new PerspectiveCamera();
  #ambient = new AmbientLight();
  #light = new PointLight(0xffffff, 1, 0, 0); // no falloff, as edgeshade's
  #radius = 1;
  #center = new Vector3();

  constructor(canvas) {
    this.#renderer = new WebGLRenderer({ canvas, antialias: false, powerPreference: 'high-performance' });
    this.#renderer.outputColorSpace = LinearSRGBColorSpace; // colours are the display's already
    this.#renderer.shadowMap.enabled = true;
    this.#scene.background = new Color().setRGB(...background);
    this.#light.castShadow = true;
    this.#scene.add(this.#ambient, this.#light);
  }

  get context() {
    return this.#renderer.getContext();
  }

  async load(address) {
    const draco = new DRACOLoader();
    const gltf = await new GLTFLoader().setDRACOLoader(draco).setMeshoptDecoder(MeshoptDecoder).loadAsync(address);
    draco.dispose();
    const made = new Map();
    gltf.scene.traverse((object) => {
      if (!object.isMesh) return;
      if (!made.has(object.material)) made.set(object.material, lambertOf(object.material));
      object.material = made.get(object.material);
      object.castShadow = true;
      object.receiveShadow = true;
    });
    const mixer = new AnimationMixer(gltf.scene); // at its start, where edgeshade's stands
    for (const clip of gltf.animations) mixer.clipAction(clip).play();
    mixer.setTime(0);
    this.#scene.add(gltf.scene);
    const box = new Box3().setFromObject(gltf.scene);
    box.getCenter(this.#center);
    this.#radius = box.getSize(new Vector3()).length() / 2;
  }

  /** Takes over edgeshade's camera, first light and ambient share. */
  follow({ camera: { from, to, fov }, lights: [[x, y, z]], ambient }) {
    this.#ambient.intensity = Math.PI * ambient; // three.js divides reflected light by pi
    this.#light.intensity = Math.PI * (1 - ambient);
    this.#light.position.set(x, y, z);
    const lens = this.#light.shadow.camera;
    lens.near = 0.01 * this.#radius;
    lens.far = this.#light.position.distanceTo(this.#center) + this.#radius;
    lens.updateProjectionMatrix();
    const { width, height } = this.#renderer.domElement;
    this.#camera.position.set(...from);
    this.#camera.fov = fov;
    this.#camera.aspect = width / height;
    const away = this.#camera.position.distanceTo(this.#center);
    this.#camera.near = Math.max(0.002 * this.#radius, away - this.#radius);
    this.#camera.far = away + this.#radius;
    this.#camera.updateProjectionMatrix();
    this.#camera.lookAt(...to);
  }

  resize(width, height) {
    const { domElement } = this.#renderer;
    if (domElement.width !== width || domElement.height !== height)
      this.#renderer.setSize(width, height, false);
  }

  /** {mapSize, pcf, bias, normalBias}; the biases are three.js's own. */
  setShadow({ mapSize, pcf, bias, normalBias }) {
    const { shadow } = this.#light;
    this.#renderer.shadowMap.type = pcf ? PCFShadowMap : BasicShadowMap;
    shadow.bias = bias;
    shadow.normalBias = normalBias;
    if (shadow.mapSize.x === mapSize) return;
    shadow.mapSize.set(mapSize, mapSize);
    shadow.map?.depthTexture?.dispose();
    shadow.map?.dispose();
    shadow.map = null; // the next frame makes one
  }

  /** Whether every frame draws the map anew, as it must when something that casts has moved. */
  set drawsMap(always) {
    this.#light.shadow.autoUpdate = always;
  }

  draw() {
    this.#renderer.render(this.#scene, this.#camera);
  }
}
