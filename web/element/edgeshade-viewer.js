// <edgeshade-viewer>: a glTF scene with pixel-exact shadows. edgeshade-viewer.d.ts has its types
// and describes every attribute, event and method.

import { changesFromAttributes, viewAttributes, withOthers } from './attributes.js';
import { backgroundOf, watchTheme } from './background.js';
import { sceneAmong } from './files.js';
import { FrameLoop } from './frame-loop.js';
import { listenForGestures } from './gestures.js';
import { createContext, register, unregister } from './graphics.js';
import { look } from './look.js';
import { MapMaker } from './map-maker.js';
import { putBytes } from './memory.js';
import { Notices } from './notices.js';
import { watchPictureSize } from './picture-size.js';
import { Progress } from './progress.js';
import { compiledModule, instantiate } from './runtime.js';
import { SceneLoader, Superseded } from './scene-loader.js';

export { keys } from './gestures.js';
export { sizeText } from './files.js';
export { hourColors } from './hour-colors.js';
export { version } from './version.js';

const picturesAtRest = 16; // averaged by default

const nextFrame = () => new Promise((resolve) => requestAnimationFrame(() => resolve()));

export class EdgeshadeViewer extends HTMLElement {
  static observedAttributes = ['src', 'label', 'variant', ...viewAttributes];

  #canvas;
  #notices;
  #progress;
  #loop;
  #loader = new SceneLoader();
  #maps = new MapMaker((bytes) => this.#takeMap(bytes),
    () => this.#viewer?.buildMapsHere());
  #started = null; // a promise, once connected
  #program = null;
  #context = null;
  #handle = 0;
  #viewer = null; // null: not started, or the start failed
  #lost = false;
  #stopWatching = () => {};
  #shown = null; // the source, as given to load(), of the scene on show
  #home = null; // changes that reset() applies; null: those of the attributes

  constructor() {
    super();
    const root = this.attachShadow({ mode: 'open' });
    root.innerHTML = look;
    this.#canvas = root.querySelector('canvas');
    this.#notices = new Notices(root.querySelector('.notices'));
    this.#progress = new Progress(root.querySelector('.progress'));
    this.#loop = new FrameLoop((now) => this.#draw(now), () => this.#wantsFrame());
    this.#canvas.addEventListener('webglcontextlost', (event) => this.#lose(event));
    this.#canvas.addEventListener('webglcontextrestored', () => this.#restore());
    listenForGestures(this.#canvas, {
      takesWheel: () => this.loaded,
      pointer: (...args) => this.#touch(() => this.#viewer.pointer(...args)),
      wheel: (...args) => this.#touch(() => this.#viewer.wheel(...args)),
      run: (command) => this.run(command),
    });
  }

  connectedCallback() {
    this.#label();
    if (!this.#started && this.getAttribute('src')) this.#tellProgress('start');
    this.#started ??= this.#start();
    const watches = [
      watchPictureSize(this.#canvas, (...size) => this.#resize(...size)),
      watchTheme(() => this.#takeBackground()),
    ];
    this.#stopWatching = () => watches.forEach((stop) => stop());
    this.#maps.resume();
    this.#loop.wake();
  }

  disconnectedCallback() {
    this.#stopWatching();
    this.#loop.stop();
    this.#loader.cancel();
    this.#maps.stop();
  }

  attributeChangedCallback(name, before, after) {
    if (before === after || !this.#started) return;
    if (name === 'src') {
      if (after) this.load(after).catch(() => {});
    } else if (name === 'label') this.#label();
    else if (name === 'variant') this.#reload();
    else if (this.loaded) this.#applyAttributes([name]);
  }

  // ---- interface for pages ---------------------------------------------------------------------

  /** Whether a scene is shown. */
  get loaded() {
    return Boolean(this.#viewer?.hasScene());
  }

  get state() {
    return this.#viewer ? JSON.parse(this.#viewer.state()) : null;
  }

  get stats() {
    return this.#viewer ? JSON.parse(this.#viewer.stats()) : null;
  }

  get lightPoints() {
    return this.#viewer ? JSON.parse(this.#viewer.lightPoints()) : null;
  }

  get smoothing() {
    return this.#viewer ? JSON.parse(this.#viewer.smoothing()) : null;
  }

  get sceneSize() {
    return this.#viewer?.sceneSize() ?? 0;
  }

  get sun() {
    return this.#viewer ? JSON.parse(this.#viewer.sun()) : null;
  }

  get sunHours() {
    const counted = this.#viewer?.sunHoursCounted() ?? -1;
    if (counted < 0) return null;
    return { counted, of: this.#viewer.sunHoursOf(), step: this.state.sun_hours_step };
  }

  sunHoursAt(clientX, clientY) {
    if (!this.loaded || this.#lost) return null;
    this.#makeCurrent();
    const box = this.#canvas.getBoundingClientRect();
    const lit = this.#viewer.sunHoursAt((clientX - box.left) * (this.#canvas.width / box.width),
      (clientY - box.top) * (this.#canvas.height / box.height));
    return lit < 0 ? null : { lit, of: this.#viewer.sunHoursOf(), step: this.state.sun_hours_step };
  }

  get animations() {
    return this.#viewer ? JSON.parse(this.#viewer.animations()) : [];
  }

  get animationSeconds() {
    return this.#viewer?.animationSeconds() ?? 0;
  }

  async load(source, { home, state } = {}) {
    const clicked = performance.now();
    try {
      const wanted = this.#sourceOf(source);
      if (!this.#viewer) this.#tellProgress('start');
      await (this.#started ??= this.#start());
      if (!this.#viewer) throw new Error(this.#problem);
      this.setAttribute('aria-busy', 'true');
      this.#tellProgress('download', 0);
      const variant = this.getAttribute('variant') ?? '';
      const scene = await this.#loader.load(wanted, variant, (...step) => this.#tellProgress(...step));
      const detail = await this.#show(scene, wanted, { home, state }, clicked);
      this.#shown = source;
      return detail;
    } catch (error) {
      if (error instanceof Superseded) return null;
      this.#doneLoading();
      this.#fail(error.message);
      throw error;
    }
  }

  change(changes) {
    this.#touch(() => {
      const problem = this.#viewer.change(JSON.stringify(changes));
      if (problem) throw new Error(problem);
    });
  }

  run(command) {
    this.#touch(() => {
      const problem = this.#viewer.run(command);
      if (problem) throw new Error(problem);
      if (command === 'reset') this.#goHome();
    });
  }

  fit() {
    this.run('fit');
  }

  reset() {
    this.run('reset');
  }

  async screenshot() {
    if (!this.loaded || this.#lost) throw new Error('There is no picture to save yet.');
    this.#viewer.invalidate();
    this.#viewer.frame(performance.now() / 1000); // toBlob() must follow in the same task
    return new Promise((resolve, reject) => {
      this.#canvas.toBlob(
        (blob) => (blob ? resolve(blob) : reject(new Error('The picture could not be encoded.'))),
        'image/png',
      );
    });
  }

  say(sentence, kind = 'note') {
    this.#notices.say(sentence, kind);
  }

  focus(options) {
    this.#canvas.focus(options);
  }

  // ---- starting --------------------------------------------------------------------------------

  #problem = '';

  async #start() {
    try {
      const antialias = this.getAttribute('antialias') !== 'off';
      this.#context = createContext(this.#canvas, { antialias });
      this.#program = await instantiate(await compiledModule());
      this.#handle = register(this.#program, this.#context);
      const viewer = new this.#program.Viewer();
      const problem = viewer.start(this.#maps);
      if (problem) throw new Error(problem);
      if (antialias) viewer.change(JSON.stringify({ smooth: picturesAtRest }));
      this.#viewer = viewer;
      this.#resize(this.#canvas.width, this.#canvas.height, window.devicePixelRatio || 1);
    } catch (error) {
      this.#problem = error.message;
      if (!this.getAttribute('src')) this.#fail(error.message);
    }
    if (this.getAttribute('src')) queueMicrotask(() => this.load(this.getAttribute('src')).catch(() => {}));
  }

  /**
   * Loads the scene again in its current view: another variant shades its materials differently.
   */
  #reload() {
    if (!this.loaded || !this.#shown) return;
    this.load(this.#shown, { home: this.#home ?? undefined, state: this.state }).catch(() => {});
  }

  #label() {
    this.#canvas.setAttribute('aria-label', this.getAttribute('label') ||
      'Scene. Arrow keys orbit, with Shift they pan, plus and minus zoom.');
  }

  #sourceOf(source) {
    if (typeof source === 'string' || source instanceof URL) {
      try {
        return { url: new URL(source, document.baseURI).href, given: String(source) };
      } catch {
        throw new Error(`'${source}' is not the address of a scene.`);
      }
    }
    return sceneAmong(source instanceof Blob ? [source] : source);
  }

  // ---- showing a scene -------------------------------------------------------------------------

  async #show(scene, source, { home, state }, clicked) {
    const milliseconds = { ...scene.milliseconds };
    let since = performance.now();
    const lap = (stage) => {
      milliseconds[stage] = performance.now() - since;
      since = performance.now();
    };
    this.#tellProgress('upload');
    await nextFrame(); // so that the bar becomes visible
    lap('wait');
    this.#upload(scene.bytes);
    lap('upload');
    this.#notices.clear();
    this.#tellProgress('draw');
    const isOfSrc = source.given !== undefined && source.given === this.getAttribute('src');
    this.#home = home ?? (isOfSrc ? null : {});
    this.#takeBackground();
    this.#goHome();
    if (state) this.#changeOrSay(state);
    this.#makeCurrent();
    this.#viewer.frame(performance.now() / 1000);
    lap('draw');
    await nextFrame();
    this.#doneLoading();
    for (const warning of scene.warnings.slice(0, 2)) this.say(warning);
    const { name, triangles, fileBytes, warnings, variants, cameras } = scene;
    const detail = { name, triangles, fileBytes, warnings, variants, cameras, milliseconds,
      source: source.given ?? null, totalMilliseconds: performance.now() - clicked };
    this.#loop.wake();
    this.#tell('load', detail);
    this.#tell('change');
    return detail;
  }

  #upload(bytes) {
    if (this.#lost) throw new Error('The graphics context is lost at the moment: please try again.');
    this.#makeCurrent();
    const problem = this.#viewer.show(...putBytes(this.#program, bytes));
    if (problem) throw new Error(problem);
    this.#maps.show(bytes);
  }

  #takeMap(bytes) {
    try {
      if (this.#viewer.takeMap(...putBytes(this.#program, bytes)))
        this.#viewer.buildMapsHere();
    } catch {
      this.#viewer.buildMapsHere();
    }
    this.#loop.wake();
  }

  #goHome() {
    if (this.#home) this.#changeOrSay(this.#home);
    else this.#applyAttributes();
  }

  #applyAttributes(names = viewAttributes) {
    try {
      const read = withOthers(names);
      this.change(changesFromAttributes((name) =>
        read.includes(name) ? this.getAttribute(name) : null));
    } catch (error) {
      this.#fail(error.message);
    }
  }

  #changeOrSay(changes) {
    try {
      this.change(changes);
    } catch (error) {
      this.#fail(error.message);
    }
  }

  #doneLoading() {
    this.removeAttribute('aria-busy');
    this.#progress.hide();
  }

  // ---- drawing ---------------------------------------------------------------------------------

  #resize(width, height, ratio) {
    const most = this.#context?.getParameter(this.#context.MAX_RENDERBUFFER_SIZE) || 4096;
    const shrink = Math.min(1, most / Math.max(width, height));
    const [w, h] = [Math.max(1, Math.floor(width * shrink)), Math.max(1, Math.floor(height * shrink))];
    if (this.#canvas.width !== w) this.#canvas.width = w;
    if (this.#canvas.height !== h) this.#canvas.height = h;
    if (!this.#viewer) return;
    this.#viewer.resize(w, h, ratio * shrink);
    this.#viewer.invalidate();
    if (!this.#lost && this.loaded) this.#draw(performance.now() / 1000); // no empty picture in
                                                                          // between
  }

  #takeBackground() {
    const background = backgroundOf(this);
    if (!this.#viewer || !background) return;
    this.#viewer.change(JSON.stringify({ background }));
    this.#loop.wake();
  }

  #wantsFrame() {
    return this.isConnected && !this.#lost && this.loaded && this.#viewer.wantsFrame();
  }

  #draw(now) {
    if (!this.loaded || this.#lost) return;
    this.#makeCurrent();
    const drew = this.#viewer.frame(now);
    const problem = this.#viewer.lastProblem();
    if (problem && !this.#context.isContextLost()) this.#fail(problem);
    if (drew) this.#tell('frame');
  }

  /** Lets the viewer change, then draws and announces the new state. */
  #touch(action) {
    if (!this.#viewer) return;
    this.#makeCurrent();
    action();
    this.#loop.wake();
    this.#tell('change');
  }

  #makeCurrent() {
    this.#program.GL.makeContextCurrent(this.#handle);
  }

  // ---- losing the context ----------------------------------------------------------------------

  #lose(event) {
    event.preventDefault(); // otherwise the context would not come back
    this.#lost = true;
    this.#viewer?.forgetGpu();
    if (this.#program) unregister(this.#program, this.#handle);
    this.say('The graphics context was lost, as happens when a device sleeps or is busy. ' +
      'The picture comes back by itself.');
    this.#tell('contextlost');
  }

  #restore() {
    if (!this.#program) return;
    this.#handle = register(this.#program, this.#context);
    const problem = this.#viewer?.restoreGpu();
    this.#lost = false;
    if (problem) {
      this.#fail(problem);
      return;
    }
    this.#viewer?.invalidate();
    this.#loop.wake();
    this.say('The picture is back.');
    this.#tell('contextrestored');
  }

  // ---- events ----------------------------------------------------------------------------------

  #tell(type, detail = null) {
    this.dispatchEvent(new CustomEvent(type, { detail }));
  }

  #tellProgress(stage, fraction = 0) {
    this.#tell('progress', { stage, fraction: this.#progress.show(stage, fraction) });
  }

  #fail(message) {
    this.#notices.say(message, 'error');
    this.#tell('error', { message });
  }
}

customElements.define('edgeshade-viewer', EdgeshadeViewer);
