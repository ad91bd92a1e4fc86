// A way of drawing shadows: draw(frame) draws the world in the current target and viewport, bytes()
// returns its size on the GPU, release() frees the maps of one light.
//
// A frame is {light, look, biases, softness, redraws}: see LightRig.aim(); `softness`: the light's
// extent, in degrees of a sun's disc or hundredths of the scene's radius for a lamp; `redraws`:
// whether a caster may have moved.

import { bytesOfMaps, LightRig } from './light-rig.js';

/** A sun's half angle in radians, or a lamp's radius. */
export const extentOf = ({ light, softness }, radius) =>
  (light.kind === 'sun' ? (0.5 * softness * Math.PI) / 180 : 0.01 * softness * radius);

/** Common base of methods: a rig that is lit while they draw, and copies of the materials. */
export class Method {
  constructor(world, id, mapSize) {
    this.world = world;
    this.id = id;
    this.rig = new LightRig(mapSize);
    world.scene.add(this.rig.group);
  }

  /** Changes a copy of one of the file's materials. */
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
