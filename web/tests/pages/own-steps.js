// How long edgeshade's own steps hold the page's thread: in frames, between them, and on workers' answers.

/** Microtasks in a row that may follow from a step. */
const mostMicrotasks = 50;

/**
 * Times all later steps of engines that are created after this call: timers, and answers of workers. Returns
 * {steps, map, follow(shadows)}; `steps`: {at, ms, what} of each, milliseconds; `map`: when the last map was sent to
 * its worker, and when it came; follow() times the masks of frames, too. Around steps[N] are the performance
 * marks `begin N` and `end N`, for traces.
 */
export function watchSteps() {
  const steps = [], map = { askedAt: null, cameAt: null };
  const begin = (what) => {
    performance.mark(`begin ${steps.length}`);
    return steps.push({ what, at: performance.now(), ms: 0 }) - 1;
  };
  const end = (index) => {
    steps[index].ms = performance.now() - steps[index].at;
    performance.mark(`end ${index}`);
  };
  const timed = (what, act) => async function (...given) {
    const index = begin(what);
    act.apply(this, given);
    for (let i = 0; i < mostMicrotasks; ++i) await undefined;
    end(index);
  };
  const { setTimeout: original } = window;
  window.setTimeout = (act, ...given) => original(typeof act === 'function' ? timed('timer', act) : act, ...given);
  const { postMessage } = Worker.prototype;
  Worker.prototype.postMessage = function (message, ...given) {
    if (message.task) map.askedAt = performance.now();
    return postMessage.call(this, message, ...given);
  };
  const { set } = Object.getOwnPropertyDescriptor(Worker.prototype, 'onmessage');
  const answered = (act) => timed('answer', function (event) {
    if (event.data.result?.texels) map.cameAt = performance.now();
    act.call(this, event);
  });
  Object.defineProperty(Worker.prototype, 'onmessage', { set(act) { set.call(this, act && answered(act)); }, configurable: true });
  const follow = (shadows) => {
    for (const name of ['beginMasks', 'endMasks']) {
      const act = shadows[name].bind(shadows);
      shadows[name] = (...given) => {
        const index = begin(name);
        try {
          return act(...given);
        } finally {
          end(index);
        }
      };
    }
    return shadows;
  };
  return { steps, map, follow };
}
