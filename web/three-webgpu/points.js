// How many points of a light with a radius reach a fragment, by its primitive map, in TSL: as
// shaders_es2/primitive_map_points.glsl (docs/method.md, C42).

import { abs, Break, cross, dot, float, floor, If, int, length, Loop, select, sqrt, step, uint, vec4 } from 'three/tsl';
import { longest } from './map-nodes.js';

const fours = [0, 1, 2, 3];

/** Sums of products of a vector with four others, given by axis. */
const dots = (vector, [x, y, z]) => x.mul(vector.x).add(y.mul(vector.y)).add(z.mul(vector.z)).toVar();

const sumOf = (four) => dot(four, vec4(1));

/** For four places, 1 each if the triangle doesn't block it, else 0. */
function notBlocked({ ab, bc, ac, normal, above, hand }, towards) {
  const [first, second, third] = [ab, bc, ac].map((edge) => dots(edge, towards));
  const across = hand.mul(dots(normal, towards).add(above));
  const within = step(0, first).mul(step(0, second)).mul(step(third, vec4(0)))
    .max(step(first, vec4(0)).mul(step(second, vec4(0))).mul(step(0, third)));
  // A place on the other side of the plane has across < 0.
  return vec4(1).sub(within.mul(vec4(1).sub(step(0, across))));
}

/** For four places, 1 each unless it only grazes the triangle, else 0 (C47). */
function notGrazing(normal, towards) {
  const [x, y, z] = towards;
  return step(length(normal).mul(1e-5).mul(sqrt(x.mul(x).add(y.mul(y)).add(z.mul(z)))), abs(dots(normal, towards)));
}

/** A triangle as a point has it: planes through the point and each edge, the normal, and the side of it. */
function triangleBefore(map, record, { point, error, towardsEye, w }) {
  const [a, b, c] = [0, 1, 2].map((i) => map.record(record.add(uint(i))).xyz.toVar());
  const normal = cross(b.sub(a), c.sub(a)).toVar(), above = dot(normal, point.sub(a)).toVar();
  const size = abs(normal);
  // A point on the triangle is on the side that it is seen from.
  const isOn = abs(above).lessThanEqual(error.mul(size.x.add(size.y).add(size.z))).toVar();
  const side = select(isOn, dot(normal, towardsEye), above).toVar();
  const hand = select(side.greaterThan(0), float(1), select(side.lessThan(0), float(-1), float(0))).toVar();
  return { ab: cross(a.sub(point), b.sub(a)).toVar(), bc: cross(b.sub(point), c.sub(b)).toVar(), ac: cross(a.sub(point), c.sub(a)).toVar(),
    normal, above: w.mul(above).toVar(), hand, isOn };
}

/**
 * Number of places that the triangles of a list leave: {header, depth, isEmpty, isShort: whether it ends before
 * triangles that only points test which don't cast}; 0 of an empty one. `place`: {point, error, towardsEye; w: 1, or 0 for
 * directions}.
 */
export function pointsLeft(map, { header, depth, isEmpty, isShort }, place) {
  const left = float(0).toVar(), list = floor(header.y).toVar();
  Loop({ start: int(0), end: select(isEmpty, int(0), map.sixteens), type: 'int', condition: '<', name: 'sixteen' }, ({ sixteen }) => {
    const first = uint(sixteen).mul(uint(16)).add(uint(4)).toVar();
    const rows = (begin) => fours.map((k) => map.place(first.add(uint(begin + k))).toVar());
    const [x, y, z] = ['x', 'y', 'z'].map((axis, i) => rows(4 * i).map((row) => row.sub(place.w.mul(place.point[axis])).toVar()));
    const seen = rows(12), towards = fours.map((k) => [x[k], y[k], z[k]]);
    Loop({ start: int(0), end: int(longest), type: 'int', condition: '<', name: 'nth' }, ({ nth }) => {
      const entry = map.entry(uint(list).add(uint(nth))).toVar();
      const triangle = triangleBefore(map, uint(floor(entry.x)).mul(uint(3)).toVar(), place);
      If(triangle.isOn, () => { for (const k of fours) seen[k].mulAssign(notGrazing(triangle.normal, towards[k])); });
      for (const k of fours) seen[k].mulAssign(notBlocked(triangle, towards[k]));
      If(sumOf(seen[0].add(seen[1]).add(seen[2]).add(seen[3])).equal(0), () => { Break(); });
      If(depth.lessThanEqual(entry.y), () => { Break(); }); // all further ones are deeper
      If(isShort.and(entry.x.greaterThan(floor(entry.x))), () => { Break(); });
    });
    left.addAssign(sumOf(seen[0].add(seen[1]).add(seen[2]).add(seen[3])));
  });
  return left;
}
