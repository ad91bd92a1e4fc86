// A room drawn here, with the details that maps find hard indoors: walls that meet, a blind in
// front of the window, things that stand and things that hang.

import { BoxGeometry, CylinderGeometry, Group, LatheGeometry, Mesh, MeshStandardMaterial, SphereGeometry, TorusGeometry,
  Vector2 } from 'three';

const paint = (color, roughness = 0.9) => new MeshStandardMaterial({ color, roughness });

/** In metres; the floor's upper side is y = 0. */
const size = { width: 5, height: 2.6, depth: 4, wall: 0.12 };

function builder(group) {
  const add = (geometry, material, [x, y, z]) => {
    const mesh = new Mesh(geometry, material);
    mesh.position.set(x, y, z);
    group.add(mesh);
    return mesh;
  };
  return { add, box: (material, extent, at) => add(new BoxGeometry(...extent), material, at) };
}

/** Walls, floor and ceiling overlap: where things only touch, light leaks between them. */
function addShell({ box }) {
  const { width, height, depth, wall } = size;
  const [plaster, boards] = [paint(0xe9e3d8), paint(0x9b7653)];
  const [wide, high, deep] = [width + 2 * wall, height + 2 * wall, depth + 2 * wall];
  box(boards, [wide, wall, deep], [0, -wall / 2, 0]);
  box(plaster, [wide, wall, deep], [0, height + wall / 2, 0]);
  for (const side of [-1, 1]) box(plaster, [wide, high, wall], [0, height / 2, (side * (depth + wall)) / 2]);
  box(plaster, [wall, high, deep], [(width + wall) / 2, height / 2, 0]);
  // The left wall has a window, z from -1.2 to 0.6 and y from 0.9 to 2.2.
  const x = -(width + wall) / 2, [low, top] = [-wall, height + wall], [back, front] = [-deep / 2, deep / 2];
  const part = ([y0, y1], [z0, z1]) => box(plaster, [wall, y1 - y0, z1 - z0], [x, (y0 + y1) / 2, (z0 + z1) / 2]);
  part([low, top], [back, -1.2]);
  part([low, top], [0.6, front]);
  part([low, 0.9], [-1.25, 0.65]);
  part([2.2, top], [-1.25, 0.65]);
  const frame = paint(0xf5f2ec, 0.5);
  for (const z of [-1.18, -0.3, 0.58]) box(frame, [0.05, 1.3, 0.05], [x, 1.55, z]);
  for (const y of [0.92, 2.18]) box(frame, [0.05, 0.05, 1.8], [x, y, -0.3]);
}

function addBlind({ box }) {
  const slat = paint(0xd8d2c4, 0.6);
  for (let i = 0; i < 11; ++i) box(slat, [0.05, 0.004, 1.7], [-2.38, 2.15 - 0.05 * i, -0.3]).rotation.z = 0.5;
}

function addTable({ add, box }) {
  const [wood, white] = [paint(0xb98a5a, 0.6), paint(0xf3f0ea, 0.35)];
  const metal = new MeshStandardMaterial({ color: 0x8d9196, roughness: 0.35, metalness: 0.8 });
  box(wood, [1.5, 0.035, 0.8], [-0.3, 0.74, -0.35]);
  for (const x of [-0.98, 0.38]) for (const z of [-0.7, 0]) box(wood, [0.05, 0.72, 0.05], [x, 0.36, z]);
  const profile = [[0, 0], [0.05, 0], [0.07, 0.02], [0.085, 0.09], [0.08, 0.09], [0.06, 0.02], [0, 0.01]];
  add(new LatheGeometry(profile.map(([r, y]) => new Vector2(r, y)), 48), white, [-0.75, 0.7575, -0.25]);
  const cup = add(new CylinderGeometry(0.035, 0.03, 0.09, 40), white, [0, 0.8025, -0.15]);
  add(new TorusGeometry(0.025, 0.006, 12, 32), white, [cup.position.x + 0.04, 0.8025, -0.15]);
  for (const [i, color] of [0x7a3b32, 0x33516b, 0x5f6d44].entries())
    box(paint(color, 0.7), [0.2 - 0.01 * i, 0.022, 0.28], [-0.25 + 0.01 * i, 0.7685 + 0.022 * i, -0.5]).rotation.y = 0.2 * i - 0.3;
  const apple = add(new SphereGeometry(0.04, 40, 24), paint(0xb5412f, 0.45), [-0.45, 0.7975, -0.12]);
  add(new CylinderGeometry(0.003, 0.003, 0.03, 8), wood, [apple.position.x, 0.85, -0.12]);
  add(new CylinderGeometry(0.002, 0.002, 0.75, 8), metal, [-0.3, 2.225, -0.35]); // the lamp's cord
  const shade = [[0.02, 0.16], [0.05, 0.15], [0.17, 0], [0.175, 0.002], [0.055, 0.16], [0.02, 0.17]];
  add(new LatheGeometry(shade.map(([r, y]) => new Vector2(r, y)), 64), metal, [-0.3, 1.7, -0.35]);
}

function addChair({ box }, [x, z], turn) {
  const wood = paint(0x6e4a32, 0.65);
  const chair = new Group();
  const parts = builder(chair);
  parts.box(wood, [0.42, 0.03, 0.42], [0, 0.45, 0]);
  for (const px of [-0.18, 0.18]) for (const pz of [-0.18, 0.18]) parts.box(wood, [0.035, 0.45, 0.035], [px, 0.225, pz]);
  for (const px of [-0.18, 0.18]) parts.box(wood, [0.03, 0.45, 0.03], [px, 0.68, 0.185]);
  for (let i = 0; i < 4; ++i) parts.box(wood, [0.36, 0.045, 0.012], [0, 0.57 + 0.09 * i, 0.185]);
  chair.position.set(x, 0, z);
  chair.rotation.y = turn;
  return chair;
}

function addShelf({ box }) {
  const wood = paint(0xc9a277, 0.6);
  const [x, z] = [1.5, -1.85];
  for (let i = 0; i < 4; ++i) box(wood, [1.2, 0.022, 0.28], [x, 0.4 + 0.45 * i, z]);
  for (const side of [-0.6, 0.6]) box(wood, [0.022, 1.8, 0.28], [x + side, 0.9, z]);
  const colors = [0x7a3b32, 0x33516b, 0x5f6d44, 0xc28f3d, 0x54405e, 0x8c8577];
  for (let shelf = 0; shelf < 3; ++shelf)
    for (let i = 0, at = -0.55; at < 0.35 - 0.2 * shelf; ++i) {
      const thick = 0.025 + 0.012 * ((7 * i + 3 * shelf) % 4), high = 0.2 + 0.03 * ((5 * i + shelf) % 5);
      box(paint(colors[(i + 2 * shelf) % colors.length], 0.8), [thick, high, 0.19],
        [x + at + thick / 2, 0.411 + 0.45 * shelf + high / 2, z - 0.02]);
      at += thick + 0.004;
    }
}

/** Builds the room as a Group. */
export function room() {
  const group = new Group();
  const parts = builder(group);
  addShell(parts);
  addBlind(parts);
  addTable(parts);
  addShelf(parts);
  group.add(addChair(parts, [0.05, 0.35], 0.25), addChair(parts, [-1.35, -0.3], -1.75));
  return group;
}
