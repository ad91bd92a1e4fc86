// A sun's direction as compass direction and height, in degrees. Compass 0 is -Z, north on a map;
// 90 is +X.

const degrees = 180 / Math.PI;

export function anglesOf([x, y, z]) {
  const azimuth = (Math.atan2(x, -z) * degrees + 360) % 360;
  return { azimuth, elevation: Math.atan2(y, Math.hypot(x, z)) * degrees };
}

export function directionOf(azimuth, elevation) {
  const [a, e] = [azimuth / degrees, elevation / degrees];
  return [Math.sin(a) * Math.cos(e), Math.sin(e), -Math.cos(a) * Math.cos(e)];
}
