// Texels of three.js's textures on the CPU, filtered at level 0 as GLES 3.0.6, 3.8.8 to 3.8.10,
// specifies.

import * as three from 'three';

const bytesOf = new WeakMap(); // by image

/** RGBA bytes of an image, rows in the order of its own. */
function pixelsOf(image) {
  if (image.data) return image.data;
  if (!bytesOf.has(image)) bytesOf.set(image, image.getContext('2d').getImageData(0, 0, image.width, image.height).data);
  return bytesOf.get(image);
}

function wrapped(place, size, wrap) {
  if (wrap === three.ClampToEdgeWrapping) return Math.min(Math.max(place, 0), size - 1);
  const period = wrap === three.MirroredRepeatWrapping ? 2 * size : size;
  const rest = place - period * Math.floor(place / period);
  return rest < size ? rest : period - 1 - rest;
}

/** A channel of a texture at texture coordinates, 0 to 1. */
export function sampled(texture, uv, channel) {
  const { image, wrapS, wrapT, flipY, magFilter, matrix } = texture;
  const { width, height } = image;
  texture.updateMatrix();
  const at = uv.clone().applyMatrix3(matrix);
  const pixels = pixelsOf(image);
  const texel = (x, y) => {
    const row = wrapped(y, height, wrapT);
    return pixels[4 * ((flipY ? height - 1 - row : row) * width + wrapped(x, width, wrapS)) + channel] / 255;
  };
  const x = at.x * width, y = at.y * height;
  if (magFilter === three.NearestFilter) return texel(Math.floor(x), Math.floor(y));
  const i = Math.floor(x - 0.5), j = Math.floor(y - 0.5), u = x - 0.5 - i, v = y - 0.5 - j;
  return (1 - v) * ((1 - u) * texel(i, j) + u * texel(i + 1, j)) + v * ((1 - u) * texel(i, j + 1) + u * texel(i + 1, j + 1));
}

/** Whether a hit of Raycaster is in a hole of its alpha-tested mesh. */
export function isHole({ object, ...hit }) {
  const material = Array.isArray(object.material) ? object.material[hit.face.materialIndex] : object.material;
  const { alphaTest, alphaMap, map, opacity } = material;
  if (!(alphaTest > 0)) return false;
  const at = (texture, channel) => (texture ? sampled(texture, texture.channel === 1 ? hit.uv1 ?? hit.uv2 : hit.uv, channel) : 1);
  return opacity * at(alphaMap, 1) * at(map, 3) < alphaTest;
}

/** A mesh's geometry, its vertices where its displacementMap draws them. */
export function displaced({ geometry, material: { displacementMap: map, displacementScale, displacementBias } }) {
  const { position, normal, uv } = geometry.attributes;
  const moved = position.clone(), at = new three.Vector3(), along = new three.Vector3(), place = new three.Vector2();
  for (let i = 0; i < position.count; ++i) {
    const height = sampled(map, place.fromBufferAttribute(uv, i), 0) * displacementScale + displacementBias;
    at.fromBufferAttribute(position, i).addScaledVector(along.fromBufferAttribute(normal, i).normalize(), height);
    moved.setXYZ(i, at.x, at.y, at.z);
  }
  return Object.assign(geometry.clone().setAttribute('position', moved), { boundingSphere: null });
}
