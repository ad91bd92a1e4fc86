// Live code: runs a page's code in a frame, shows what it says, and lets it be edited.

(() => {
  const moduleMap = (root) => {
    const at = (path) => new URL(root + path, document.baseURI).href;
    return { imports: { three: at('lib/three/build/three.module.js'), 'three/addons/': at('lib/three/examples/jsm/'),
      stage: at('gallery/stage.js'), edgeshade: at('app/element/edgeshade-viewer.js'),
      'edgeshade/three': at('app/three/exact-shadows.js') } };
  };

  /** Tells the page what is drawn, and what goes wrong. */
  const watch = `
    const tell = (problem) => parent.postMessage({ edgeshadeLive: problem }, '*');
    addEventListener('error', (event) => tell(event.message || 'The code can\\'t be loaded.'));
    addEventListener('unhandledrejection', (event) => tell(String(event.reason?.message ?? event.reason)));
    const drawn = new MutationObserver(() => {
      if (!document.querySelector('canvas, edgeshade-viewer')) return;
      drawn.disconnect();
      requestAnimationFrame(() => requestAnimationFrame(() => tell('')));
    });
    drawn.observe(document.documentElement, { childList: true, subtree: true });`;

  const look = `html, body { margin: 0; height: 100%; overflow: hidden; font: 14px/1.4 system-ui, sans-serif; background: #cddae6; color: #23201c }
    canvas { display: block; touch-action: none }
    body { display: flex; flex-direction: column } edgeshade-viewer { flex: 1; min-height: 0 }
    label, output { padding: .4rem .7rem; background: #fbfaf8 } output:empty { display: none }
    body > input[type=range] { position: fixed; bottom: .8rem; left: 10%; width: 80% }`;

  const pageOf = (code, language, root) => `<!doctype html><html lang="en"><meta charset="utf-8"><title>Live</title>
<style>${look}</style><script>${watch}</${'script'}>
<script type="importmap">${JSON.stringify(moduleMap(root))}</${'script'}>
<body>${language === 'html' ? code : `<script type="module">${code}</${'script'}>`}</body></html>`;

  function connect(live) {
    const part = (selector) => live.querySelector(selector);
    const [frame, state, shown, text] = ['iframe', '.state', 'pre', 'textarea'].map(part);
    const root = live.dataset.root.replace(/index\.html$/, '');
    const original = text.value;
    const say = (sentence) => { state.textContent = sentence; };

    const run = () => {
      if (location.protocol === 'file:') return; // from-file.js says why
      say('Loading …');
      frame.hidden = false;
      frame.srcdoc = pageOf(text.value, live.dataset.language, root);
    };
    const edit = () => {
      text.style.height = `${Math.max(shown.offsetHeight, 200)}px`;
      shown.hidden = true;
      text.hidden = false;
      part('.edit').hidden = true;
      text.focus();
    };
    addEventListener('message', ({ source, data }) => {
      if (source === frame.contentWindow && typeof data?.edgeshadeLive === 'string') say(data.edgeshadeLive);
    });
    part('.edit').addEventListener('click', edit);
    part('.run').addEventListener('click', run);
    part('.reset').addEventListener('click', () => {
      text.value = original;
      run();
    });
    const seen = new IntersectionObserver((entries) => {
      if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
      seen.disconnect();
      run();
    });
    seen.observe(frame.parentElement);
  }

  document.querySelectorAll('.live').forEach(connect);
})();
