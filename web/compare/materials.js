// A scene drawn with three.js's physical material, in the same light as edgeshade's picture.

import {
  Color, DirectionalLight, EquirectangularReflectionMapping, MeshPhysicalMaterial,
  NeutralToneMapping, PMREMGenerator, PerspectiveCamera, Scene, ShaderChunk, SRGBColorSpace,
  WebGLRenderer,
} from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { HDRLoader } from 'three/addons/loaders/HDRLoader.js';

export { REVISION } from 'three';

const colorOf = ([r, g, b]) => new Color().setRGB(r, g, b);

/** KHR_materials_pbrSpecularGlossiness, which three.js no longer reads: a dielectric whose
 * reflectance at normal incidence, 0.04 of its specular colour, equals the file's. Textures are
 * left out. */
const specularGlossiness = (parser) => {
  const saidOf = (index) => parser.json.materials[index].extensions?.KHR_materials_pbrSpecularGlossiness;
  return {
    name: 'KHR_materials_pbrSpecularGlossiness',
    getMaterialType: (index) => (saidOf(index) ? MeshPhysicalMaterial : null),
    extendMaterialParams: async (index, params) => {
      const said = saidOf(index);
      if (!said) return;
      const { diffuseFactor = [1, 1, 1], specularFactor = [1, 1, 1], glossinessFactor = 1 } = said;
      params.color = colorOf(diffuseFactor).multiplyScalar(1 - Math.max(...specularFactor));
      params.metalness = 0;
      params.roughness = 1 - glossinessFactor;
      params.specularColor = colorOf(specularFactor).multiplyScalar(1 / 0.04);
    },
  };
};

/** The factor by which three.js multiplies a lamp's reflections on rough metals, for light that
 * facets reflect more than once. The specification's appendix B leaves this out. */
const compensation = 'material.specularColorBlended * ( 1.0 / EssMs - 1.0 )';
const chunk = 'lights_fragment_begin';
const original = ShaderChunk[chunk];

function setCompensation(wanted) {
  if (!original.includes(compensation)) throw new Error(`three.js has no '${compensation}' any more.`);
  ShaderChunk[chunk] = wanted ? original : original.replace(compensation, 'vec3( 0.0 )');
}

const addressOf = (base64) => `data:application/octet-stream;base64,${base64}`;

/** Draws a .gltf's bytes; returns a PNG in base64. `environment`: a Radiance picture's bytes,
 * scaled by environmentIntensity; all bytes are in base64. `reflectsOnce`: leaves out light of the
 * lamp that facets reflect more than once. */
async function draw({ gltf, width, height, camera, sun, lux, background, environment, environmentIntensity, reflectsOnce }) {
  setCompensation(!reflectsOnce);
  const renderer = new WebGLRenderer({ canvas: document.getElementById('three'), antialias: false, preserveDrawingBuffer: true });
  renderer.setSize(width, height, false);
  renderer.toneMapping = NeutralToneMapping;
  renderer.outputColorSpace = SRGBColorSpace;
  const loader = new GLTFLoader();
  loader.register(specularGlossiness);
  const scene = new Scene();
  const loaded = await loader.loadAsync(addressOf(gltf));
  loaded.scene.traverse(({ material }) => {
    if (material?.isMeshBasicMaterial) material.toneMapped = false; // unlit: the file's exact
                                                                    // colours
  });
  scene.add(loaded.scene);
  const light = new DirectionalLight(0xffffff, lux);
  light.position.set(...sun);
  scene.add(light);
  if (environment) {
    const map = await new HDRLoader().loadAsync(addressOf(environment));
    map.mapping = EquirectangularReflectionMapping;
    const filter = new PMREMGenerator(renderer);
    scene.environment = filter.fromEquirectangular(map).texture;
    scene.environmentIntensity = environmentIntensity;
  }
  const eye = new PerspectiveCamera(camera.fov, width / height, 0.1, 100);
  eye.position.set(...camera.from);
  eye.lookAt(...camera.to);
  renderer.setClearColor(new Color().setRGB(...background, SRGBColorSpace), 1);
  renderer.render(scene, eye);
  const png = document.getElementById('three').toDataURL('image/png').split(',')[1];
  renderer.dispose();
  return png;
}

/** Compares two PNGs in base64, {a, b}. Returns {mean, most, pixels}: the difference of their
 * colours, in 8-bit values, where either shows something other than the background. */
async function apart({ a, b, background }) {
  const [first, second] = await Promise.all([a, b].map(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }),
      { colorSpaceConversion: 'none', premultiplyAlpha: 'none' });
    const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
    context.drawImage(bitmap, 0, 0);
    return context.getImageData(0, 0, bitmap.width, bitmap.height).data;
  }));
  const behind = background.map((value) => Math.round(255 * value));
  const shows = (pixels, i) => [0, 1, 2].some((c) => Math.abs(pixels[i + c] - behind[c]) > 1);
  let sum = 0, most = 0, pixels = 0;
  for (let i = 0; i < first.length; i += 4) {
    if (!shows(first, i) && !shows(second, i)) continue;
    ++pixels;
    for (let c = 0; c < 3; ++c) {
      const off = Math.abs(first[i + c] - second[i + c]);
      sum += off;
      most = Math.max(most, off);
    }
  }
  return { mean: sum / (3 * pixels), most, pixels };
}

/**
 * Joins `pictures`, rows of PNGs in base64, `width` x `height` each, into one picture; returns a
 * PNG in base64.
 */
async function sheet({ pictures, width, height }) {
  const canvas = document.createElement('canvas');
  canvas.width = pictures[0].length * width;
  canvas.height = pictures.length * height;
  const context = canvas.getContext('2d');
  context.imageSmoothingQuality = 'high';
  for (const [y, row] of pictures.entries())
    for (const [x, base64] of row.entries()) {
      const image = new Image();
      image.src = `data:image/png;base64,${base64}`;
      await image.decode();
      context.drawImage(image, x * width, y * height, width, height);
    }
  return canvas.toDataURL('image/png').split(',')[1];
}

window.materials = { draw, apart, sheet };
