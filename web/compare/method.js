// A way of drawing shadows: draw(frame) draws the world in the current target and viewport, bytes() says what it has on
// the GPU, release() frees what one light's maps take.
//
// A frame is {light, look, biases, softness, redraws}: see LightRig.aim(); `softness`: the light's extent, degrees of a
// sun's disc, hundredths of the scene's radius of a lamp; `redraws`: whether something that casts may have moved.

import { bytesOfMaps, LightRig } from './light-rig.js';

/** A sun's half angle in radians, a lamp's radius. */
export const extentOf = ({ light, softness }, radius) =>
  (light.kind === 'sun' ? (0.5 * softness * Math.PI) / 180 : 0.01 * softness * radius);

/** What methods have in common: a rig that is lit while they draw, and copies of the materials. */
export class Method {
  constructor(world, id, mapSize) {
    this.world = world;
    this.id = id;
    this.rig = new LightRig(mapSize);
    world.scene.add(this.rig.group);
  }

  /** What it makes of a copy of the file's materials. */
  change() {}

  draw(frame) {
    const { world, rig } = this;
    world.skins.wear(this.id, frame.look, (material) => this.change(material));
    rig.aim(frame.light, world, frame.look, frame.biases);
    rig.redraws = frame.redraws;
    rig.group.visible = true;
    world.setLook(frame.look);
    try {
      this.render(frame);
    } finally {
      rig.group.visible = false;
    }
  }

  bytes() {
    return bytesOfMaps(this.rig.light.shadow);
  }

  release() {
    this.rig.release();
  }

  dispose() {
    this.release();
    this.world.scene.remove(this.rig.group);
    this.world.skins.drop(this.id);
  }
}
