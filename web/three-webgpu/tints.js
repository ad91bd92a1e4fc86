// Light that a tinted triangle lets through, in TSL: as primitiveIsTinted() in
// shaders_es2/primitive_map_lookup.glsl (docs/method.md, C38).

import { float, If, int, Loop, select, uint, vec2, vec3, vec4 } from 'three/tsl';
import { sampledAt, valuesAt } from './texels.js';

/**
 * Multiplies `tint` by the triangle's if it is before the point. A ray on an edge belongs to one of the two
 * neighbours, as `owner` says; that and `color` are the fours that its record and its tint begin with. `met`: of
 * meeting().
 */
export function takeTint(map, { beside, height, tolerance, next, behind }, owner, color, { ray, directional, tint }) {
  const owns = ['x', 'y', 'z'].map((axis) => beside[axis].greaterThan(0).or(owner[axis].greaterThan(0.5))).reduce((all, one) => all.and(one));
  If(owns.and(height.greaterThan(tolerance)), () => {
    tint.mulAssign(color.xyz);
    const [rectangle, how] = [1, 2].map((i) => map.record(uint(owner.w).mul(uint(3)).add(uint(i))).toVar());
    const [u, v] = valuesAt([1, 2].map((i) => map.record(next.add(uint(i))).toVar()), ray, behind, directional);
    // Red, green and blue follow one another.
    Loop({ start: int(0), end: select(rectangle.z.greaterThan(0), int(3), int(0)), type: 'int', condition: '<', name: 'layer' }, ({ layer }) => {
      const before = rectangle.y.add(float(layer).mul(rectangle.z).mul(rectangle.w));
      const share = sampledAt(map, vec2(u, v), vec4(rectangle.x, before, rectangle.zw).toVar(), how).toVar();
      tint.mulAssign(vec3(...[0, 1, 2].map((one) => select(layer.equal(int(one)), share, float(1)))));
    });
  });
}
