// Whether a resting light reaches a fragment, by its primitive map, in TSL: as
// shaders_es2/host/lookup.glsl and primitive_map_lookup.glsl (docs/method.md, C34 to C36).

import { abs, Break, cameraPosition, clamp, cross, dFdx, dFdy, dot, float, floor, If, int, length, Loop, max, positionView, positionWorld, screenCoordinate, screenSize, select,
  uint, vec2, vec3 } from 'three/tsl';
import { isSolid } from './cutouts.js';
import { floatSum, isAtLeastZero } from './exact-sign.js';
import { longest } from './map-nodes.js';
import { pointsLeft } from './points.js';
import { takeTint } from './tints.js';

/** Levels of divided texels, or more. */
const mostLevels = 64;

/** A float's rounding, as a share. */
const unit = 2 ** -24;

const largest = (of) => max(max(of.x, of.y), of.z);

/** Change of a position between its pixel and the farthest of the picture's sides. */
function changeAcross(along, up) {
  const { x, y } = screenCoordinate;
  return abs(along).mul(max(x, screenSize.x.sub(x))).add(abs(up).mul(max(y, screenSize.y.sub(y))));
}

/**
 * The fragment's place on its triangle, in the world or in the camera's space, where the numbers of large worlds are
 * small: call it outside of branches, as it takes derivatives.
 */
export function placeOnTriangle(isWorld) {
  const position = (isWorld ? positionWorld : positionView).toVar();
  const along = dFdx(position).toVar(), up = dFdy(position).toVar();
  return { isWorld, position, normal: cross(along, up).toVar(), change: changeAcross(along, up).toVar() };
}

/**
 * How far rounding may put a point off its triangle, in map space, as a function of roundings of its terms:
 * `change`, as of placeOnTriangle(), as rasterisers may interpolate from any of the picture's corners. `terms`:
 * sizes that the point is the sum of.
 */
function roundingOf([x, y, z], change, terms) {
  const drift = abs(x).mul(change.x).add(abs(y).mul(change.y)).add(abs(z).mul(change.z)).toVar();
  return (roundings) => max(largest(terms), 1).mul(roundings).add(largest(drift).mul(8)).mul(unit);
}

/** The ray of a point, its depth, and its place on its tile. */
function rayOf(map, point, directional) {
  const at = vec2(point.x, point.y).toVar(), depth = float(point.z).toVar(), tile = float(0).toVar();
  if (directional) return { ray: vec3(point.x, point.y, 1).toVar(), at, depth, tile };
  If(map.sixTiles.equal(1), () => {
    const size = abs(point).toVar();
    const take = (across, along, number) => {
      at.assign(across);
      depth.assign(abs(along));
      tile.assign(select(along.greaterThan(0), float(number), float(number + 1)));
    };
    If(size.x.greaterThanEqual(size.y).and(size.x.greaterThanEqual(size.z)), () => take(vec2(point.y, point.z), point.x, 0))
      .ElseIf(size.y.greaterThanEqual(size.z), () => take(vec2(point.z, point.x), point.y, 2))
      .Else(() => take(vec2(point.x, point.y), point.z, 4));
  });
  at.divAssign(max(depth, 1e-36));
  return { ray: point, at, depth, tile };
}

/** The header of the texel at a place of a tile, in divided texels, too. */
function headerAt(map, at, tile) {
  const place = at.mul(map.size.mul(0.5)).add(map.size.mul(0.5)).toVar();
  const cell = clamp(floor(place), vec2(0), vec2(map.size.sub(1))).toVar();
  const texel = tile.mul(map.size).add(cell.y).mul(map.size).add(cell.x).toVar();
  const header = vec2(0).toVar();
  Loop({ start: int(0), end: int(mostLevels), type: 'int', condition: '<', name: 'level' }, () => {
    header.assign(map.header(uint(texel)));
    If(header.y.greaterThanEqual(0), () => { Break(); });
    place.assign(place.sub(cell).mul(4));
    cell.assign(clamp(floor(place), vec2(0), vec2(3)));
    texel.assign(cell.y.mul(4).add(cell.x).sub(header.y));
  });
  return header;
}

/**
 * How a ray meets a triangle's edges: {meets: whether it is inside all, or on them; beside: with `tints`, by edge
 * 1 where it is inside, 0 where it is on it}.
 */
function sidesOf(edges, ray, tints) {
  const sums = edges.map((edge) => floatSum(edge, ray));
  const meets = sums.map(({ sum, error }) => sum.greaterThanEqual(error.negate())).reduce((all, one) => all.and(one)).toVar();
  const certain = sums.map(({ sum, error }) => sum.greaterThan(error)).reduce((all, one) => all.and(one));
  const beside = tints && vec3(1).toVar();
  // A loop, since a branch doesn't keep software renderers from computing all of it.
  Loop({ start: int(0), end: select(meets.and(certain.not()), int(3), int(0)), type: 'int', condition: '<', name: 'edge' }, ({ edge }) => {
    const one = select(edge.equal(int(0)), edges[0], select(edge.equal(int(1)), edges[1], edges[2])).toVar();
    meets.assign(meets.and(isAtLeastZero(one, ray).equal(int(1))));
    if (!tints) return;
    const isBeside = float(int(1).sub(isAtLeastZero(one.negate(), ray))).toVar();
    beside.assign(vec3(...['x', 'y', 'z'].map((axis, i) => select(edge.equal(int(i)), isBeside, beside[axis]))));
  });
  return { meets, beside };
}

/**
 * How a ray meets a record's triangle: {meets, beside, as of sidesOf(); behind: where it meets the plane, a depth
 * or the inverse of its distance as a share of the point's; height: of the point behind the plane; tolerance;
 * next: index of what follows its edges}.
 */
function meeting(map, record, ray, point, directional, tints) {
  const first = uint(record).mul(uint(3)).toVar();
  const [a, b, c] = [0, 1, 2].map((i) => map.record(first.add(uint(i))).toVar());
  const behind = a.w.mul(ray.x).add(b.w.mul(ray.y)).add(c.w.mul(ray.z)).toVar();
  const slope = abs(a.w).add(abs(b.w)).add(abs(c.w));
  return { ...sidesOf([a.xyz, b.xyz, c.xyz], ray, tints), behind, height: (directional ? point.z.sub(behind) : behind.sub(1)).toVar(),
    tolerance: slope.add(1).mul(64 * unit).toVar(), next: first.add(uint(3)) };
}

/** Takes the tint of a triangle that blocks nothing for it, or lets the light through its holes: changes `met`. */
function takeAlpha(map, met, ray, directional, { tint, cutouts }) {
  const first = map.record(met.next).toVar(), look = map.record(uint(first.w).mul(uint(3))).toVar();
  const isTinted = look.w.lessThan(0).toVar();
  if (tint) If(isTinted, () => { takeTint(map, met, first, look, { ray, directional, tint }); });
  if (tint) met.meets.assign(met.meets.and(isTinted.not()));
  if (cutouts) If(met.meets, () => { met.meets.assign(isSolid(map, met, first, look, ray, directional)); });
}

/** Whether a texel lists no triangle for a point; `casts`: as in askList(). */
const isEmpty = (header, casts) => header.y.equal(0).or(casts.and(header.y.greaterThan(floor(header.y))));

/**
 * Makes `lit` 0 where a listed triangle blocks the ray to the point (C35); with a `tint`, multiplies that by
 * the tints of those before the point.
 */
function askList(map, header, { ray, depth }, point, directional, casts, { lit, tint, cutouts }) {
  const list = floor(header.y).toVar();
  const own = float(0).toVar(), distance = float(1e30).toVar(), foremost = float(-1e30).toVar(), apart = float(0).toVar();
  Loop({ start: int(0), end: select(isEmpty(header, casts), int(0), int(longest)), type: 'int', condition: '<', name: 'nth' }, ({ nth }) => {
    const entry = map.entry(uint(list).add(uint(nth))).toVar();
    const number = floor(entry.x).toVar(), hasAlpha = entry.x.lessThan(0); // or a tint
    const met = meeting(map, tint || cutouts ? select(hasAlpha, number.add(1).negate(), number) : number, ray, point, directional, Boolean(tint));
    const { meets, height, tolerance } = met;
    if (tint || cutouts) If(meets.and(hasAlpha), () => { takeAlpha(map, met, ray, directional, { tint, cutouts }); });
    If(meets, () => {
      If(height.greaterThan(tolerance), () => {
        lit.assign(0);
        Break();
      });
      If(abs(height).lessThanEqual(tolerance), () => {
        foremost.assign(max(foremost, height));
        apart.assign(max(apart, tolerance.mul(0.125)));
        If(abs(height).lessThan(distance), () => {
          distance.assign(abs(height));
          own.assign(height);
        });
      });
    });
    If(depth.lessThanEqual(entry.y), () => { Break(); }); // all further ones are deeper
    If(casts.and(entry.x.greaterThan(number)), () => { Break(); }); // or only points that don't cast test them
  });
  If(casts.and(foremost.greaterThan(own.add(apart))), () => { lit.assign(0); });
}

/** A place in map space: {point; across: its triangle, of length 1; rounding: of roundingOf(); towardsEye: of any length}. */
function findOn(map, { isWorld, position, normal, change }) {
  const [x, y, z, offset] = [0, 1, 2, 3].map((column) => map.mapFrom(isWorld).element(int(column)).xyz.toVar());
  const along = (vector) => x.mul(vector.x).add(y.mul(vector.y)).add(z.mul(vector.z)); // in map space
  const point = along(position).add(offset).toVar();
  const terms = abs(x.mul(position.x)).add(abs(y.mul(position.y))).add(abs(z.mul(position.z))).add(abs(offset)).toVar();
  // cameraPosition is that of a view, where a camera has several.
  const towardsEye = isWorld ? along(cameraPosition.sub(position).toVar()) : map.eye.xyz.sub(map.eye.w.mul(point));
  const across = cross(y, z).mul(normal.x).add(cross(z, x).mul(normal.y)).add(cross(x, y).mul(normal.z)).toVar();
  across.divAssign(max(length(across), 1e-36));
  return { point, across, rounding: roundingOf([x, y, z], change, terms), towardsEye: towardsEye.toVar() };
}

/** Calls act(ray, header) where a point is on a tile: rayOf() it, and headerAt() its place. */
function texelOf(map, point, directional, act) {
  const ray = rayOf(map, point, directional);
  const isOnTile = max(abs(ray.at.x), abs(ray.at.y)).lessThanEqual(1);
  If(directional ? isOnTile : isOnTile.and(ray.depth.greaterThan(0)), () => act(ray, headerAt(map, ray.at, ray.tile)));
}

/**
 * Makes `share.lit`, 1, 0 where the light doesn't reach the fragment, and multiplies `share.tint`, if there is
 * one, by tints of triangles before it; `share.cutouts`: whether maps may have cutouts. `map`: MapNodes;
 * `directional`: the light's kind; `place`: of placeOnTriangle(); `casts`: whether all triangles there are
 * casters, and `held`: in the map; `front`: whether the triangle's front is visible.
 */
export function lookUp({ map, directional, place, casts, held, front, share }) {
  const { point, across, rounding, towardsEye } = findOn(map, place);
  const off = rounding(16).toVar();
  const lightSide = (directional ? across.z.negate() : dot(across, point).negate()).toVar();
  const away = lightSide.mul(dot(across, towardsEye)).lessThan(0).toVar();
  If(lightSide.lessThan(0), () => { across.assign(across.negate()); });
  point.addAssign(across.mul(select(away, off.mul(-2).sub(256 * unit), off)));
  If(away.and(casts), () => { share.lit.assign(0); }).Else(() => {
    texelOf(map, point, directional, (ray, header) => {
      If(ray.depth.greaterThan(header.x), () => { share.lit.assign(0); }).Else(() => {
        askList(map, header, ray, point, directional, casts.and(held).and(front).toVar(), share);
      });
    });
  });
}

/**
 * The same for the map of a light with a radius: makes `share.lit` the share of its points that reach the
 * fragment. The point isn't moved, as the light may be on both sides of its triangle (docs/method.md, C42).
 */
export function lookUpPoints({ map, directional, place, casts, held, front, share: { lit } }) {
  const { point, across, rounding, towardsEye } = findOn(map, place);
  const error = rounding(64).toVar();
  const [middle, ...arms] = [0, 1, 2, 3].map((i) => map.place(uint(i)).toVar());
  const reach = length(vec3(...arms.map((arm) => dot(across, arm.xyz))));
  const towardsLight = middle.xyz.sub(middle.w.mul(point)).toVar();
  const lightSide = dot(across, towardsLight).toVar();
  // Whether all of the light is clearly on one side of the triangle.
  const whole = casts.and(abs(lightSide).greaterThan(reach.add(length(towardsLight).mul(0.02)).add(error))).toVar();
  If(whole.and(lightSide.mul(dot(across, towardsEye)).lessThan(0)), () => { lit.assign(0); }).Else(() => {
    texelOf(map, point, directional, ({ depth }, header) => {
      If(depth.sub(error).greaterThan(header.x), () => { lit.assign(0); }).Else(() => {
        const isShort = whole.and(held).and(front).toVar(); // lit sheets needn't be tested
        const list = { header, depth, isShort, isEmpty: isEmpty(header, isShort).toVar() };
        const left = pointsLeft(map, list, { point, error, towardsEye, w: middle.w });
        lit.assign(select(list.isEmpty, float(1), left.div(arms[0].w)));
      });
    });
  });
}
