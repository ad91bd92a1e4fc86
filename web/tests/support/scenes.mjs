// A small scene for tests that need any picture, and one with a texture.

import { pngOf } from './png.mjs';

const floats = (values) => Buffer.from(new Float32Array(values).buffer);
const corners = [[-1, -1], [1, -1], [1, 1], [-1, 1]];

/** A box of half-widths `half` that stands on y = 0, as 36 positions. */
function box([hx, hy, hz]) {
  const at = (i, y) => [corners[i][0] * hx, y, corners[i][1] * hz];
  const quads = [[at(3, 2 * hy), at(2, 2 * hy), at(1, 2 * hy), at(0, 2 * hy)],
    [at(0, 0), at(1, 0), at(2, 0), at(3, 0)]];
  for (let i = 0; i < 4; ++i) {
    const j = (i + 1) % 4;
    quads.push([at(j, 0), at(i, 0), at(i, 2 * hy), at(j, 2 * hy)]);
  }
  return quads.flatMap(([a, b, c, d]) => [a, b, c, a, c, d]).flat();
}

const parts = { ground: [4, 0.1, 4], pillar: [0.4, 1.5, 0.4], stone: [0.5, 0.3, 0.3] };

/**
 * A ground, a pillar and a stone that slides along (2 s): the JSON without a buffer, and the
 * binary.
 */
function smallScene() {
  const blobs = [...Object.values(parts).map((half) => floats(box(half))), floats([0, 2]), floats([1, 0.2, 1, 1, 0.2, -1])];
  const binary = Buffer.concat(blobs);
  let byteOffset = 0;
  const bufferViews = blobs.map(({ length }) => {
    const view = { buffer: 0, byteOffset, byteLength: length };
    byteOffset += length;
    return view;
  });
  const accessor = (bufferView, count, type, min, max) => ({ bufferView, componentType: 5126, count, type, min, max });
  const solid = Object.values(parts).map(([x, y, z], i) => accessor(i, 36, 'VEC3', [-x, 0, -z], [x, 2 * y, z]));
  const json = {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0, 1, 2] }],
    nodes: [{ mesh: 0 }, { mesh: 1, translation: [0, 0.2, 0] }, { mesh: 2, translation: [1, 0.2, 1] }],
    meshes: solid.map((_, i) => ({ primitives: [{ attributes: { POSITION: i }, material: i }] })),
    materials: [[0.5, 0.6, 0.4, 1], [0.8, 0.5, 0.3, 1], [0.5, 0.5, 0.6, 1]]
      .map((baseColorFactor) => ({ pbrMetallicRoughness: { baseColorFactor } })),
    accessors: [...solid, accessor(3, 2, 'SCALAR', [0], [2]), accessor(4, 2, 'VEC3')],
    animations: [{ samplers: [{ input: 3, output: 4 }], channels: [{ sampler: 0, target: { node: 2, path: 'translation' } }] }],
    bufferViews,
  };
  return { json, binary };
}

/** The scene as a self-contained .gltf. */
export function smallGltf() {
  const { json, binary } = smallScene();
  const uri = `data:application/octet-stream;base64,${binary.toString('base64')}`;
  return Buffer.from(JSON.stringify({ ...json, buffers: [{ byteLength: binary.length, uri }] }));
}

/** The small scene, whose pillar is blue in the variant "midnight", as .gltf. */
export function variedGltf() {
  const gltf = JSON.parse(smallGltf());
  const name = 'KHR_materials_variants';
  const material = gltf.materials.push({ pbrMetallicRoughness: { baseColorFactor: [0.1, 0.1, 0.8, 1] } }) - 1;
  gltf.extensionsUsed = [name];
  gltf.extensions = { [name]: { variants: [{ name: 'midnight' }] } };
  gltf.meshes[1].primitives[0].extensions = { [name]: { mappings: [{ material, variants: [0] }] } };
  return Buffer.from(JSON.stringify(gltf));
}

function glbChunk(type, bytes, padding) {
  const body = Buffer.concat([bytes, Buffer.alloc(-bytes.length & 3, padding)]);
  const head = Buffer.alloc(8);
  head.writeUInt32LE(body.length, 0);
  head.write(type, 4, 'latin1');
  return Buffer.concat([head, body]);
}

/** The same as .glb. */
export function smallGlb() {
  const { json, binary } = smallScene();
  const text = Buffer.from(JSON.stringify({ ...json, buffers: [{ byteLength: binary.length }] }));
  const chunks = Buffer.concat([glbChunk('JSON', text, ' '), glbChunk('BIN\0', binary, 0)]);
  const head = Buffer.alloc(12);
  head.write('glTF', 0, 'latin1');
  head.writeUInt32LE(2, 4);
  head.writeUInt32LE(head.length + chunks.length, 8);
  return Buffer.concat([head, chunks]);
}

/** 8x8 pixels of many colours and alphas, RGBA. */
export const texels = Uint8Array.from({ length: 4 * 64 }, (_, at) => {
  const i = at >> 2;
  return [37 * i, 91 * i + 20, 255 - 4 * i, 37 * (i % 8) ** 2 * (i >> 3)][at & 3] % 256;
});

/** The same as lossless WebP. */
export const texelsAsWebp = Buffer.from('UklGRkoAAABXRUJQVlA4TD4AAAAvB8ABEJkKRPQ/NlH/gvc/QBYMIpFd4gPqikAg' +
  'kAQx8Ogf/1cMAA1UECFkkMYOuH3nOgEpe2wAxqGweAT6Aw==', 'base64');

/** The same as PNG. */
export const texelsAsPng = () => pngOf(texels, 8, 8);

/** The small scene with a picture on its pillar, as .gltf. `image`: glTF's entry; `material`:
 * further properties of its material; `animated`: whether the stone moves. */
export function texturedGltf(image, material = {}, { animated = false } = {}) {
  const { json, binary } = smallScene();
  const uvs = floats(Array.from({ length: 6 }, () => [0, 0, 1, 0, 1, 1, 0, 0, 1, 1, 0, 1]).flat());
  json.bufferViews.push({ buffer: 0, byteOffset: binary.length, byteLength: uvs.length });
  json.accessors.push({ bufferView: json.bufferViews.length - 1, componentType: 5126, count: 36, type: 'VEC2' });
  json.meshes[1].primitives[0].attributes.TEXCOORD_0 = json.accessors.length - 1;
  json.images = [image];
  json.samplers = [{ magFilter: 9728, minFilter: 9728 }];
  json.textures = [{ source: 0, sampler: 0 }];
  json.materials[1] = { pbrMetallicRoughness: { baseColorTexture: { index: 0 } }, ...material };
  json.nodes[1].scale = [3, 0.5, 3];
  if (!animated) delete json.animations;
  const all = Buffer.concat([binary, uvs]);
  const uri = `data:application/octet-stream;base64,${all.toString('base64')}`;
  return Buffer.from(JSON.stringify({ ...json, buffers: [{ byteLength: all.length, uri }] }));
}

/** A square's positions and indices, packed by meshoptimizer's encoder and by Draco's. */
const packedSquare = {
  meshopt: ['oAAAAAEzAAAA//8AAAAAAAAAAQwAAAD/AAAAAAAAAAAAAAAAAAAAAAAAAAAAAIC/AAAAAAAAgL8=', '4f4u8AQAdodWZ3iphmWJaJgBaQAA'],
  draco: ['RFJBQ08CAgEBAAAABAIAAgAAAS//AREB/wAAAQAJAwAAAAAAgD8AAAAAAACAPwAAgL8AAAAAAACAvwAAgL8AAAAAAACAPwAAgD8AAAAAAACAvw=='],
};

/** The square as .gltf; `packing`: meshopt or draco. */
export function packedGltf(packing) {
  const blobs = packedSquare[packing].map((base64) => Buffer.from(base64, 'base64'));
  const uriOf = (bytes) => `data:application/octet-stream;base64,${bytes.toString('base64')}`;
  const views = blobs.map(({ length }, buffer) => ({ buffer, byteOffset: 0, byteLength: length }));
  const unpacked = [{ byteLength: 48, byteStride: 12, count: 4, mode: 'ATTRIBUTES' }, { byteLength: 12, byteStride: 2, count: 6, mode: 'TRIANGLES' }];
  const name = packing === 'draco' ? 'KHR_draco_mesh_compression' : 'EXT_meshopt_compression';
  const viewOf = (i) => (packing === 'draco' ? {} : { bufferView: i });
  return Buffer.from(JSON.stringify({
    asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0 }],
    extensionsUsed: [name], extensionsRequired: [name],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1,
      ...(packing === 'draco' && { extensions: { [name]: { bufferView: 0, attributes: { POSITION: 0 } } } }) }] }],
    accessors: [{ ...viewOf(0), componentType: 5126, count: 4, type: 'VEC3', min: [-1, 0, -1], max: [1, 0, 1] },
      { ...viewOf(1), componentType: 5123, count: 6, type: 'SCALAR' }],
    buffers: blobs.map((bytes) => ({ byteLength: bytes.length, uri: uriOf(bytes) })),
    bufferViews: packing === 'draco' ? views : unpacked.map(({ byteLength, byteStride, count, mode }, i) => ({
      buffer: i, byteLength, ...(i === 0 && { byteStride }), extensions: { [name]: { ...views[i], byteStride, count, mode } } })),
  }));
}
