// Scenes that show one feature of glTF's materials each, to compare with another renderer: rows of
// spheres with textures made here.

import { dataUri, pngOf } from '../tests/support/png.mjs';

const columns = 96, rows = 48;

/** Arrays of a sphere of radius 1. `mirrored`: u runs from right to left. */
function sphere(mirrored) {
  const positions = [], texcoords = [], tangents = [], indices = [];
  for (let j = 0; j <= rows; ++j)
    for (let i = 0; i <= columns; ++i) {
      const [turn, down] = [2 * Math.PI * i / columns, Math.PI * j / rows];
      positions.push(Math.sin(down) * Math.sin(turn), Math.cos(down), Math.sin(down) * Math.cos(turn));
      const u = 4 * i / columns;
      texcoords.push(mirrored ? 4 - u : u, 2 * j / rows);
      const hand = mirrored ? -1 : 1;
      tangents.push(hand * Math.cos(turn), 0, -hand * Math.sin(turn), hand);
    }
  for (let j = 0; j < rows; ++j)
    for (let i = 0; i < columns; ++i) {
      const [a, b] = [j * (columns + 1) + i, (j + 1) * (columns + 1) + i];
      if (j > 0) indices.push(a, b, a + 1);
      if (j < rows - 1) indices.push(a + 1, b, b + 1);
    }
  return { positions, texcoords, tangents, indices };
}

const side = 64;
const texels = (colorOf) => Uint8Array.from({ length: 4 * side * side }, (_, at) => {
  const i = at >> 2;
  return colorOf((i % side + 0.5) / side, (Math.floor(i / side) + 0.5) / side)[at & 3];
});
const bytes = (color) => color.map((value) => Math.round(255 * value));
const wave = (t) => 0.5 + 0.5 * Math.sin(2 * Math.PI * t);

/** The contents of the scenes' textures, by name. */
const textures = {
  patches: (u, v) => bytes([0.2 + 0.7 * wave(u), 0.2 + 0.6 * wave(v), 0.5, 1]),
  // Waves across and down, steep enough to show the side from which they are lit.
  bumps: (u, v) => {
    const [x, y] = [0.45 * Math.cos(4 * Math.PI * u), 0.45 * Math.cos(4 * Math.PI * v)];
    const length = Math.hypot(x, y, 1);
    return bytes([...[x, y, 1].map((c) => 0.5 + 0.5 * c / length), 1]);
  },
  shade: (u, v) => bytes([wave(2 * u) * wave(2 * v), 0.2 + 0.7 * wave(u), wave(v), 1]),
  glow: (u, v) => bytes([wave(3 * u) > 0.7 ? 1 : 0, wave(3 * v) > 0.7 ? 0.6 : 0, 0.1, 1]),
};

class Builder {
  #chunks = [];
  #length = 0;
  #indices = new Map();
  json = {
    asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: [] }], nodes: [], meshes: [],
    materials: [], accessors: [], bufferViews: [],
  };

  accessor(array, componentType, count, type, more = {}) {
    const content = Buffer.from(array.buffer);
    this.json.bufferViews.push({ buffer: 0, byteOffset: this.#length, byteLength: content.length });
    this.#chunks.push(content);
    this.#length += content.length;
    return this.json.accessors.push({ bufferView: this.json.bufferViews.length - 1, componentType, count, type, ...more }) - 1;
  }

  texture(name) {
    if (!this.#indices.has(name)) {
      const index = (this.json.images ??= []).push({ uri: dataUri(pngOf(texels(textures[name]), side, side)) }) - 1;
      (this.json.textures ??= []).push({ source: index });
      this.#indices.set(name, index);
    }
    return this.#indices.get(name);
  }

  add({ material, mirrored = false, tangents = false, colors = false, secondSet = false }, x) {
    const made = sphere(mirrored);
    const count = made.positions.length / 3;
    const floats = (values, type, more) => this.accessor(new Float32Array(values), 5126, count, type, more);
    const attributes = {
      POSITION: floats(made.positions, 'VEC3', { min: [-1, -1, -1], max: [1, 1, 1] }),
      NORMAL: floats(made.positions, 'VEC3'),
      TEXCOORD_0: floats(made.texcoords, 'VEC2'),
    };
    if (tangents) attributes.TANGENT = floats(made.tangents, 'VEC4');
    if (secondSet) attributes.TEXCOORD_1 = floats(made.texcoords.map((t) => 0.5 * t + 0.25), 'VEC2');
    if (colors) attributes.COLOR_0 = floats(made.positions.map((p) => 0.5 + 0.5 * p), 'VEC3');
    const indices = this.accessor(new Uint32Array(made.indices), 5125, made.indices.length, 'SCALAR');
    const { json } = this;
    json.materials.push(material);
    json.meshes.push({ primitives: [{ attributes, indices, material: json.materials.length - 1 }] });
    json.nodes.push({ mesh: json.meshes.length - 1, translation: [x, 0, 0] });
    json.scenes[0].nodes.push(json.nodes.length - 1);
  }

  gltf() {
    const names = new Set(this.json.materials.flatMap(extensionsIn));
    if (names.size) this.json.extensionsUsed = [...names];
    const all = Buffer.concat(this.#chunks);
    const uri = `data:application/octet-stream;base64,${all.toString('base64')}`;
    return Buffer.from(JSON.stringify({ ...this.json, buffers: [{ byteLength: all.length, uri }] }));
  }
}

/** The names of all extensions below a JSON value. */
function extensionsIn(value) {
  if (typeof value !== 'object' || value === null) return [];
  return [...Object.keys(value.extensions ?? {}), ...Object.values(value).flatMap(extensionsIn)];
}

const factors = (metallicFactor, roughnessFactor, color = [0.8, 0.45, 0.2]) =>
  ({ pbrMetallicRoughness: { baseColorFactor: [...color, 1], metallicFactor, roughnessFactor } });
const steps = [0.1, 0.3, 0.5, 0.7, 1];

/** Each feature: the content of five spheres, for its builder. */
const features = {
  'dielectrics, roughness 0.1 to 1': () => steps.map((roughness) => ({ material: factors(0, roughness) })),
  'metals, roughness 0.1 to 1': () => steps.map((roughness) => ({ material: factors(1, roughness, [0.9, 0.7, 0.4]) })),
  'metal and roughness by texture': (to) => [1, 0.75, 0.5, 0.25, 0].map((metal) => {
    const material = factors(metal, 1);
    material.pbrMetallicRoughness.metallicRoughnessTexture = { index: to.texture('shade') };
    return { material };
  }),
  'base colour by texture and at vertices': (to) => [false, true, true, false, true].map((colors, i) => {
    const material = factors(0, 0.6, [1, 1, 1]);
    if (i !== 1) material.pbrMetallicRoughness.baseColorTexture = { index: to.texture('patches') };
    return { material, colors };
  }),
  emission: (to) => [0.2, 0.5, 1, 2, 4].map((emissiveStrength) => ({ material: {
    ...factors(0, 0.5), emissiveFactor: [1, 1, 1], emissiveTexture: { index: to.texture('glow') },
    extensions: { KHR_materials_emissive_strength: { emissiveStrength } } } })),
  'normals by texture': (to) => [0, 0.5, 1, 1, 1].map((scale, i) => ({ material: {
    ...factors(i > 2 ? 1 : 0, 0.35), normalTexture: { index: to.texture('bumps'), scale } } })),
  'normals by texture, mirrored': (to) => [0, 0.5, 1, 1, 1].map((scale, i) => ({ mirrored: true, material: {
    ...factors(i > 2 ? 1 : 0, 0.35), normalTexture: { index: to.texture('bumps'), scale } } })),
  'normals by texture and tangents of both hands': (to) => [0, 1, 2, 3, 4].map((i) => ({
    tangents: true, mirrored: i % 2 === 1,
    material: { ...factors(i > 2 ? 1 : 0, 0.35), normalTexture: { index: to.texture('bumps') } } })),
  occlusion: (to) => [0, 0.25, 0.5, 0.75, 1].map((strength) => ({ material: {
    ...factors(0, 0.6), occlusionTexture: { index: to.texture('shade'), strength } } })),
  'specular-glossiness': () => [0, 0.3, 0.5, 0.7, 0.9].map((glossinessFactor) => ({ material: {
    extensions: { KHR_materials_pbrSpecularGlossiness: {
      diffuseFactor: [0.3, 0.2, 0.1, 1], specularFactor: [0.5, 0.4, 0.2], glossinessFactor } } } })),
  unlit: (to) => steps.map((roughness, i) => ({ colors: i > 2, material: {
    ...(i % 2 ? { pbrMetallicRoughness: { baseColorTexture: { index: to.texture('patches') } } } : factors(0, roughness)),
    extensions: { KHR_materials_unlit: {} } } })),
  'second coordinates and their transforms': (to) => [0, 1, 2, 3, 4].map((i) => {
    const material = factors(0, 0.6, [1, 1, 1]);
    const KHR_texture_transform = { offset: [0.1 * i, 0.3], rotation: 0.3 * i, scale: [1 + 0.5 * i, 1.5] };
    material.pbrMetallicRoughness.baseColorTexture = {
      index: to.texture('patches'), texCoord: i % 2, ...(i > 1 && { extensions: { KHR_texture_transform } }) };
    return { material, secondSet: true };
  }),
  'clear coat': (to) => steps.map((clearcoatRoughnessFactor, i) => ({ material: {
    ...factors(i % 2, 0.7), extensions: { KHR_materials_clearcoat: { clearcoatFactor: 1, clearcoatRoughnessFactor,
      ...(i === 4 && { clearcoatNormalTexture: { index: to.texture('bumps') } }) } } } })),
  'index of refraction and specular': () => [1.1, 1.33, 1.5, 2, 2.4].map((ior, i) => ({ material: {
    ...factors(0, 0.25), extensions: { KHR_materials_ior: { ior },
      KHR_materials_specular: { specularFactor: 1 - 0.15 * i, specularColorFactor: [1, 1 - 0.2 * i, 0.5] } } } })),
  'see-through': () => [0.15, 0.3, 0.5, 0.7, 0.9].map((alpha) => ({ material: {
    alphaMode: 'BLEND', pbrMetallicRoughness: { baseColorFactor: [0.3, 0.5, 0.8, alpha], metallicFactor: 0, roughnessFactor: 0.4 } } })),
};

/** {name, gltf} of every feature; gltf: the bytes of a self-contained .gltf. */
export const materialScenes = () => Object.entries(features).map(([name, spheresOf]) => {
  const builder = new Builder();
  spheresOf(builder).forEach((of, i) => builder.add(of, 2.2 * (i - 2)));
  return { name, gltf: builder.gltf() };
});

/** An equirectangular Radiance picture: sky, horizon, ground, and windows of two colours. Its
 * middle column shows the direction `middle`, an angle around +Y from -Z towards +X. */
export function panorama({ width = 128, height = 64, middle = 0 } = {}) {
  const content = Buffer.alloc(4 * width * height);
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x) {
      const polar = Math.PI * (y + 0.5) / height;
      const turn = 2 * Math.PI * (x + 0.5) / width - Math.PI + middle;
      const [right, up, back] = [Math.sin(polar) * Math.sin(turn), Math.cos(polar), -Math.sin(polar) * Math.cos(turn)];
      const sky = up > 0 ? [0.5 + 0.2 * up, 0.7 + 0.2 * up, 1] : [0.25, 0.2, 0.15];
      const window = (to, color) => {
        const along = Math.max(0, right * to[0] + up * to[1] + back * to[2]) ** 40;
        return color.map((c) => c * along);
      };
      const [warm, cool] = [window([0.6, 0.5, 0.62], [9, 7, 4]), window([-0.8, 0.1, 0.59], [1, 2, 4])];
      const color = sky.map((c, i) => c + warm[i] + cool[i]);
      const exponent = Math.ceil(Math.log2(Math.max(...color))) + 1;
      const at = 4 * (y * width + x);
      color.forEach((c, i) => { content[at + i] = Math.min(255, Math.floor(c * 256 / 2 ** exponent)); });
      content[at + 3] = exponent + 128;
    }
  return Buffer.concat([Buffer.from(`#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y ${height} +X ${width}\n`, 'latin1'), content]);
}

/**
 * Mean light of the panorama, weighted by solid angle and luminance, as edgeshade computes it for
 * scaling.
 */
export function meanOf(picture) {
  const start = picture.indexOf('\n', picture.indexOf('-Y')) + 1;
  const [, height, width] = /-Y (\d+) \+X (\d+)/.exec(picture.toString('latin1', 0, start)).map(Number);
  let sum = 0, weights = 0;
  for (let y = 0; y < height; ++y) {
    const weight = Math.sin(Math.PI * (y + 0.5) / height);
    for (let x = 0; x < width; ++x) {
      const at = start + 4 * (y * width + x);
      const scale = 2 ** (picture[at + 3] - 136);
      const [r, g, b] = [0, 1, 2].map((c) => picture[at + c] * scale);
      sum += weight * (0.2126 * r + 0.7152 * g + 0.0722 * b);
      weights += weight;
    }
  }
  return sum / weights;
}
