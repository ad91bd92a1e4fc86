// The models that need no file of the user's, each with its view.

import { modelAt } from './model.js';
import { room } from './room.js';

/** `view`: camera, sun (compass and height in degrees), lamp, and which of the two lights is on. */
export const samples = {
  pavilion: {
    name: 'Pavilion',
    load: () => modelAt('../assets/pavilion.glb'),
    view: { camera: { from: [-2.6, 3.6, 10.2], to: [0.2, 1.3, -0.2], fov: 45 }, sun: { azimuth: 296, elevation: 42 },
      lamp: [1.5, 2.2, 2], light: 'sun' },
  },
  room: {
    name: 'Room',
    load: async () => ({ name: 'room', object: room() }),
    view: { camera: { from: [2.1, 1.65, 1.75], to: [-0.6, 0.75, -0.6], fov: 58 }, sun: { azimuth: 268, elevation: 34 },
      lamp: [-0.3, 1.72, -0.35], light: 'lamp' },
  },
};
