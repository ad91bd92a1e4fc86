// Whether a ray meets a solid part of an alpha-tested triangle, in TSL: as primitiveIsSolid() in
// shaders_es2/primitive_map_lookup.glsl (docs/method.md, C34).

import { int, Loop, select, uint, vec2 } from 'three/tsl';
import { sampledAt, valuesAt } from './texels.js';

/**
 * `first`: four numbers of the record that follow its edges, whose first fours are `rectangle`; `next`: their
 * index; `behind`: of meeting().
 */
export function isSolid(map, { next, behind }, first, rectangle, ray, directional) {
  const planes = [first, ...[1, 2].map((i) => map.record(next.add(uint(i))).toVar())];
  const how = map.record(uint(first.w).mul(uint(3)).add(uint(1))).toVar();
  const [u, v, alpha] = valuesAt(planes, ray, behind, directional);
  Loop({ start: int(0), end: select(rectangle.z.greaterThan(0), int(1), int(0)), type: 'int', condition: '<', name: 'texture' }, () => {
    alpha.mulAssign(sampledAt(map, vec2(u, v), rectangle, how));
  });
  return alpha.greaterThanEqual(how.x);
}
