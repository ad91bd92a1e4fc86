// The scene shared by all methods: one renderer, one camera, one model, and the methods used so
// far.

import { Box3, HemisphereLight, PerspectiveCamera, Scene, Vector3, WebGLRenderer, WebGLRenderTarget } from 'three';
import { ExactShadows } from 'edgeshade/three';
import { idOf, makeMethod } from './methods.js';
import { Skins } from './skins.js';

export class World {
  scene = new Scene();
  camera = new PerspectiveCamera();
  renderer;
  exact;
  skins = null;
  box = new Box3();
  center = new Vector3();
  radius = 1;
  triangles = 0;
  #model = null;
  #sky = new HemisphereLight(0xe8f0ff, 0xb9a58c, 1);
  #methods = new Map();
  #target = new WebGLRenderTarget(1, 1);

  /** Throws if there is no WebGL 2. */
  constructor(canvas, { antialias }) {
    this.renderer = new WebGLRenderer({ canvas, antialias, powerPreference: 'high-performance' });
    this.renderer.setPixelRatio(1);
    this.renderer.setClearColor(0x000000, 0);
    this.scene.add(this.#sky);
    this.exact = new ExactShadows(this.renderer).add(this.scene);
  }

  get context() {
    return this.renderer.getContext();
  }

  /** Shows another Object3D, with fresh methods. */
  show(model) {
    for (const method of this.#methods.values()) method.dispose();
    this.#methods.clear();
    this.skins?.dispose();
    if (this.#model) {
      this.scene.remove(this.#model);
      this.#model.traverse(({ geometry }) => geometry?.dispose());
    }
    this.#model = model;
    this.skins = new Skins(model);
    this.scene.add(model);
    this.box.setFromObject(model);
    this.box.getCenter(this.center);
    this.radius = Math.max(this.box.getSize(new Vector3()).length() / 2, 1e-6);
    this.triangles = 0;
    model.traverse(({ isMesh, geometry, count = 1 }) => {
      if (isMesh) this.triangles += count * Math.floor((geometry.index ?? geometry.attributes.position).count / 3);
    });
  }

  method(name, mapSize) {
    const id = idOf(name, mapSize);
    if (!this.#methods.has(id)) this.#methods.set(id, makeMethod(this, name, mapSize));
    return this.#methods.get(id);
  }

  /** Sets the brightness of the sky. */
  set ambient(share) {
    this.#sky.intensity = share;
  }

  /** Masks show only the one light. */
  setLook(look) {
    this.#sky.visible = look === 'shown';
  }

  /** `aspect`: width over height. The near plane is as far away as the scene allows. */
  setLens(fov, aspect) {
    const { camera, radius, center } = this;
    const away = camera.position.distanceTo(center);
    Object.assign(camera, { fov, aspect, near: Math.max(0.004 * radius, away - radius), far: away + 1.01 * radius });
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
  }

  resize(width, height) {
    const { domElement } = this.renderer;
    if (domElement.width !== width || domElement.height !== height) this.renderer.setSize(width, height, false);
  }

  /** From here on the whole canvas is drawn to. */
  setWholeView(width, height) {
    this.resize(width, height);
    this.renderer.setScissorTest(false);
    this.renderer.setViewport(0, 0, width, height);
  }

  /** RGBA of a frame, rows from the bottom; alpha tells whether there is a surface. */
  pixelsOf(method, frame, width, height) {
    const { renderer } = this;
    this.#target.setSize(width, height);
    renderer.setRenderTarget(this.#target);
    try {
      method.draw(frame);
      const pixels = new Uint8Array(4 * width * height);
      renderer.readRenderTargetPixels(this.#target, 0, 0, width, height, pixels);
      return pixels;
    } finally {
      renderer.setRenderTarget(null);
    }
  }
}
