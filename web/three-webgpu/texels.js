// Texels of textures in a light's map, sampled at level 0, in TSL: as cutoutAlpha() in
// shaders_es2/primitive_map_lookup.glsl (docs/method.md, C34).

import { clamp, float, floor, int, Loop, select, uint, vec2 } from 'three/tsl';

/** Texel of a row that a place beyond it wraps to; `wrap`: CutoutWrap. */
function wrappedTexel(place, size, wrap) {
  const period = size.mul(select(wrap.greaterThan(0.5), float(2), float(1))).toVar();
  const rest = place.sub(period.mul(floor(place.div(period)))).toVar();
  const turned = select(rest.lessThan(size), rest, period.sub(1).sub(rest));
  return clamp(select(wrap.greaterThan(1.5), place, turned), 0, size.sub(1));
}

/** A texel, 0..1. The table has eight to a texel of its own, twelve bits each (PackedAlpha in src/shadow/primitive_map). */
function texelAt(map, place, rectangle, how) {
  const row = wrappedTexel(place.y, rectangle.w, how.z), column = wrappedTexel(place.x, rectangle.z, how.y);
  const index = uint(rectangle.y.add(row.mul(rectangle.z)).add(column)).toVar();
  const eight = map.record(uint(rectangle.x).add(index.shiftRight(uint(3)))).toVar();
  const two = uint(eight.element(index.shiftRight(uint(1)).bitAnd(uint(3)))).toVar();
  return float(select(index.bitAnd(uint(1)).equal(uint(1)), two.shiftRight(uint(12)), two.bitAnd(uint(4095)))).div(4080);
}

/**
 * A texture at texture coordinates, 0..1. `rectangle`: (the table's texel at which its own begin, those before it
 * from there, width, height); `how`: (cutoff, wrap along u, along v, 1: linear or 0: nearest).
 */
export function sampledAt(map, uv, rectangle, how) {
  const isLinear = how.w.greaterThan(0.5);
  const place = uv.mul(rectangle.zw).sub(select(isLinear, float(0.5), float(0))).toVar();
  const first = floor(place).toVar(), share = select(isLinear, place.sub(first), vec2(0)).toVar();
  const sum = float(0).toVar();
  // A loop: software renderers take long to compile four times as much.
  Loop({ start: int(0), end: select(isLinear, int(4), int(1)), type: 'int', condition: '<', name: 'corner' }, ({ corner }) => {
    const right = float(corner.bitAnd(int(1))), up = float(corner.shiftRight(int(1)));
    const step = vec2(right, up).toVar();
    const weights = step.mul(share).add(vec2(1).sub(step).mul(vec2(1).sub(share))).toVar();
    sum.addAssign(weights.x.mul(weights.y).mul(texelAt(map, first.add(step), rectangle, how)));
  });
  return sum;
}

/** Values of planes of a triangle, such as its texture coordinates, where a ray meets it; `behind`: of meeting(). */
export const valuesAt = (planes, ray, behind, directional) =>
  planes.map((of) => of.x.mul(ray.x).add(of.y.mul(ray.y)).add(of.z.mul(ray.z))).map((value) => (directional ? value : value.div(behind)).toVar());
