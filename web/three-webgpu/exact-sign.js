// Whether a sum of three products is negative, exactly, in TSL, for sums that float arithmetic can't
// decide. Shading languages may fuse, reorder and round sums as they like; integers they may not.
//
// Two triangles of an edge have opposite coefficients. So exactly one of them finds its sum negative, or
// both find 0, and no ray passes between them (docs/method.md, C35).

import { abs, floatBitsToUint, Fn, If, int, Loop, max, select, uint } from 'three/tsl';

/**
 * Share of the sum of the products' sizes that float arithmetic may be off by: three products and two sums,
 * each rounded to one of its neighbours (2 ** -23), and as much again.
 */
const uncertain = 6 * 2 ** -23;

/** Bits of a limb. A product of two floats' digits, 24 bits each, takes two limbs. */
const bits = 24;

const lowBits = (number, count) => number.bitAnd(uint(2 ** count - 1));

/** `float`: its bits, a uint. */
const exponentOf = (float) => lowBits(float.shiftRight(uint(23)), 8);

/** The 24 digits of a float of these bits, its exponent not 0. */
const digitsOf = (float) => lowBits(float, 23).bitOr(uint(2 ** 23));

/** The sum of two floats' exponents; 0 if a float is 0, or denormal. */
function exponentOfProduct(one, other) {
  const [first, second] = [exponentOf(one).toVar(), exponentOf(other).toVar()];
  return select(first.equal(uint(0)).or(second.equal(uint(0))), uint(0), first.add(second));
}

/** High and low limb of the product of two floats' digits. */
function productOf(one, other) {
  const [oneHigh, oneLow, otherHigh, otherLow] = [one, other].map((float) => digitsOf(float).toVar())
    .flatMap((digits) => [digits.shiftRight(uint(12)).toVar(), lowBits(digits, 12).toVar()]);
  const middle = oneHigh.mul(otherLow).add(oneLow.mul(otherHigh)).toVar();
  const lower = oneLow.mul(otherLow).add(lowBits(middle, 12).shiftLeft(uint(12))).toVar();
  const high = oneHigh.mul(otherHigh).add(middle.shiftRight(uint(12))).add(lower.shiftRight(uint(bits)));
  return { high: high.toVar(), low: lowBits(lower, bits).toVar() };
}

/**
 * Adds a product, or its negative, to `limbs`, the highest last, `down` bits below the largest one. One that
 * is below all limbs adds its sign alone: the others' sum is 0 or larger than it.
 */
function addTo(limbs, { high, low }, sign, down) {
  const whole = down.div(uint(bits)).toVar(), rest = down.sub(whole.mul(uint(bits))).toVar();
  const rise = uint(bits).sub(rest).toVar();
  const parts = [high.shiftRight(rest), lowBits(high.shiftLeft(rise), bits).bitOr(low.shiftRight(rest)), lowBits(low.shiftLeft(rise), bits)]
    .map((part) => int(part).mul(sign).toVar());
  for (let first = limbs.length - 1; first >= parts.length - 1; --first)
    If(whole.equal(uint(limbs.length - 1 - first)), () => {
      for (const [i, part] of parts.entries()) limbs[first - i].addAssign(part);
    });
  If(whole.greaterThan(uint(limbs.length - parts.length)), () => { limbs[0].addAssign(sign); });
}

/** 1 if a.x * b.x + a.y * b.y + a.z * b.z >= 0 for the floats as they are, else 0. */
export const isAtLeastZero = Fn(([a, b]) => {
  const [x, y, z] = ['x', 'y', 'z'].map((axis) => exponentOfProduct(floatBitsToUint(a[axis]).toVar(), floatBitsToUint(b[axis]).toVar()).toVar());
  const largest = max(max(x, y), z).toVar();
  const limbs = Array.from({ length: 5 }, () => int(0).toVar());
  // A loop: software renderers take long to compile all that is called.
  Loop({ start: int(0), end: int(3), type: 'int', condition: '<', name: 'axis' }, ({ axis }) => {
    const [one, other] = [a, b].map((vector) => floatBitsToUint(vector.element(axis)).toVar());
    const exponent = exponentOfProduct(one, other).toVar();
    If(exponent.greaterThan(uint(0)), () => {
      const sign = select(one.bitXor(other).shiftRight(uint(31)).equal(uint(0)), int(1), int(-1)).toVar();
      addTo(limbs, productOf(one, other), sign, largest.sub(exponent).toVar());
    });
  });
  const carry = int(0).toVar();
  for (const limb of limbs) carry.assign(limb.add(carry).shiftRight(uint(bits))); // rounds down
  return select(carry.lessThan(int(0)), int(0), int(1));
}).setLayout({ name: 'edgeshadeAtLeastZero', type: 'int', inputs: [{ name: 'a', type: 'vec3' }, { name: 'b', type: 'vec3' }] });

/** {sum, error: that it may be off by} of such a sum in floats. */
export function floatSum(a, b) {
  const terms = [a.x.mul(b.x), a.y.mul(b.y), a.z.mul(b.z)];
  return { sum: terms.reduce((all, term) => all.add(term)).toVar(), error: terms.map((term) => abs(term)).reduce((all, term) => all.add(term)).mul(uncertain).toVar() };
}
