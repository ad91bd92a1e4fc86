// Frame times and wrong pixels of several methods in one run, with a moving light and a resting
// one.

import { REVISION, Vector3 } from 'three';
import { accuracyOf, maskLook } from './accuracy.js';
import { idOf, labelOf, methods } from './methods.js';
import { finish, frameStart, GpuTimer, median, spreadOf } from './timing.js';

const up = new Vector3(0, 1, 0), turned = new Vector3();
const degree = Math.PI / 180;

function rendererOf(context) {
  const extension = context.getExtension('WEBGL_debug_renderer_info');
  return context.getParameter(extension ? extension.UNMASKED_RENDERER_WEBGL : context.RENDERER);
}

const browserOf = (agent) => /Edg\/[\d.]+|OPR\/[\d.]+|Chrom\w+\/[\d.]+|Firefox\/[\d.]+|Version\/[\d.]+/.exec(agent)?.[0] ?? agent;

/**
 * The light after `frame` frames of moving: a sun turns by a quarter of a degree each, a lamp moves
 * along x.
 */
function movedLight(light, frame, radius) {
  if (light.kind === 'sun') return { ...light, direction: turned.set(...light.direction).applyAxisAngle(up, 0.25 * degree * frame).toArray() };
  const [x, y, z] = light.position;
  return { ...light, position: [x + 0.003 * radius * frame, y, z] };
}

/** Moves the camera around its target, a tenth of a degree each frame. */
function moveEye(world, { from, to, fov }, frame, aspect) {
  world.camera.position.set(...from).sub(turned.set(...to)).applyAxisAngle(up, 0.1 * degree * frame).add(turned);
  world.camera.lookAt(...to);
  world.setLens(fov, aspect);
}

/** Times of one motion in milliseconds; `turns`: the median of each turn. */
const timesOf = () => ({ frame: [], cpu: [], gpu: [], turns: [] });

/** Median ratio of turns to the turns of the other method that ran beside them. */
const ratioOf = ({ turns }, other) => Number(median(turns.map((each, i) => each / other.turns[i])).toFixed(3));

const percent = (count, of) => Number(((100 * count) / Math.max(of, 1)).toFixed(4));

export class Measurement {
  #world;
  #asked;
  #gpu;

  /**
   * `asked`: {contenders: [{name, mapSize}], frames: of each motion, in `rounds` turns, width,
   * height, light, eye, biases, softness, ambient, model, loading; warmUp: frames at the start of
   * each turn that aren't counted; patience: seconds to wait for a resting light to be looked up;
   * onProgress(text)}.
   */
  constructor(world, asked) {
    this.#world = world;
    this.#asked = { frames: 30, rounds: 3, warmUp: 2, patience: 5, onProgress: () => {}, ...asked };
    this.#asked.rounds = Math.min(this.#asked.rounds, this.#asked.frames); // at least one frame
                                                                           // each
    this.#gpu = new GpuTimer(world.context);
  }

  /** Runs all measurements; returns the results in the form in which they are saved. */
  async run() {
    const { rounds, width, height, contenders, onProgress } = this.#asked;
    if (contenders.length === 0) throw new Error('There is nothing to measure: tick a method, and a size if it is a map.');
    const world = this.#world;
    world.setWholeView(width, height);
    const rows = contenders.map((contender) => ({ contender, method: world.method(contender.name, contender.mapSize),
      moves: timesOf(), rests: timesOf() }));
    await this.#prepareExact();
    for (let round = 0; round < rounds; ++round)
      for (const motion of ['moves', 'rests'])
        for (const row of rows) {
          onProgress(`Round ${round + 1} of ${rounds}: ${labelOf(row.contender.name, row.contender.mapSize)}, light ${motion} …`);
          await this.#turn(row, motion, round);
        }
    const accuracy = this.#accuracyOf(rows);
    return this.#report(rows, accuracy);
  }

  /** Waits until all casters have exact shadows. */
  async #prepareExact() {
    const { width, height, eye } = this.#asked;
    moveEye(this.#world, eye, 0, width / height);
    this.#world.method('exact').draw(this.#frame());
    await this.#world.exact.ready();
  }

  #frame(changes) {
    const { light, biases, softness } = this.#asked;
    return { light, biases, softness, look: 'shown', redraws: true, ...changes };
  }

  /** Runs the frames of one method, one motion and one round. */
  async #turn({ contender: { name }, method, ...motions }, motion, round) {
    const { frames, rounds, warmUp, patience, light, width, height, eye } = this.#asked;
    const world = this.#world, times = motions[motion];
    const rest = motion === 'rests', kept = rest && methods[name].keepsMap === true;
    const [from, to] = [Math.floor((frames * round) / rounds), Math.floor((frames * (round + 1)) / rounds)];
    const draw = (i, redraws) => {
      moveEye(world, eye, rest ? i : 0, width / height);
      method.draw(this.#frame({ redraws, ...(!rest && { light: movedLight(light, i, world.radius) }) }));
    };
    // Not counted: preparations in the first frames, and the time until a resting light is looked
    // up, if it will be.
    const end = performance.now() + 1000 * patience;
    const waits = () => rest && name === 'exact' && world.exact.cost?.lookedUp === 0 && performance.now() < end;
    for (let i = 0; i < warmUp || waits(); ++i) {
      await frameStart();
      draw(from - 1 - (i % 2), i === 0 || !kept);
      finish(world.context);
    }
    for (let i = from; i < to; ++i) {
      await frameStart();
      const since = performance.now();
      this.#gpu.begin();
      draw(i, !kept);
      this.#gpu.end();
      const called = performance.now();
      finish(world.context);
      times.frame.push(performance.now() - since);
      times.cpu.push(called - since);
    }
    times.turns.push(median(times.frame.slice(from - to)));
    times.gpu.push(...(await this.#gpu.take()));
    if (methods[name].reference === name) times.cost = world.exact.cost;
    this.#bytes.set(method, method.bytes());
    method.release();
  }

  #bytes = new Map();

  /** The results of accuracyOf(), by contender. */
  #accuracyOf(rows) {
    const { width, height, eye } = this.#asked;
    const world = this.#world, references = new Map();
    moveEye(world, eye, 0, width / height);
    const maskOf = (method) => {
      const pixels = world.pixelsOf(method, this.#frame({ look: maskLook }), width, height);
      method.release();
      return pixels;
    };
    return rows.map(({ contender: { name }, method }) => {
      const { reference } = methods[name];
      if (!reference || reference === name) return null;
      if (!references.has(reference)) references.set(reference, maskOf(world.method(reference)));
      return accuracyOf(references.get(reference), maskOf(method), width, height);
    });
  }

  #report(rows, accuracy) {
    const { frames, rounds, width, height, light, eye, biases, softness, ambient, model, loading } = this.#asked;
    const world = this.#world;
    const ours = rows.find(({ contender: { name } }) => name === 'exact');
    const motionOf = (row, motion) => {
      const { frame, cpu, gpu, cost } = row[motion];
      return { frame_ms: spreadOf(frame), cpu_ms: spreadOf(cpu), gpu_ms: spreadOf(gpu),
        ratio_to_exact: ours ? ratioOf(row[motion], ours[motion]) : null, ...(cost && { cost }) };
    };
    const results = rows.map((row, i) => {
      const { contender: { name, mapSize }, method } = row, told = accuracy[i];
      return {
        id: idOf(name, mapSize),
        label: labelOf(name, mapSize),
        map_size: methods[name].sized ? mapSize : null,
        bytes_gpu: this.#bytes.get(method) ?? 0,
        light_moves: motionOf(row, 'moves'),
        light_rests: { ...motionOf(row, 'rests'), map_kept: methods[name].keepsMap ?? null },
        reference: told && methods[name].reference,
        wrong_percent: told && percent(told.wrong, told.surfaces),
        wrong_beyond_1px_percent: told && percent(told.beyond, told.surfaces),
        mean_difference_percent: told && percent(told.apart, told.surfaces),
      };
    });
    return {
      date: new Date().toISOString().slice(0, 10),
      model,
      triangles: world.triangles,
      meshes_without_shadows: world.skins.without,
      device: rendererOf(world.context),
      browser: browserOf(navigator.userAgent),
      processors: navigator.hardwareConcurrency ?? null,
      three_revision: REVISION,
      size: { width, height },
      antialias: world.context.getContextAttributes().antialias,
      gpu_timer: this.#gpu.there,
      settings: { frames, rounds, light, softness, camera: eye, ambient, bias: biases.bias, normal_bias: biases.normalBias },
      loading,
      results,
    };
  }
}
