// Search over all pages' sections, offline: the index is made from search-data.js when it is first needed.

(() => {
  const root = document.currentScript.dataset.root.replace(/index\.html$/, '');
  const $ = (id) => document.getElementById(id);
  const [dialog, words, found, count] = ['search', 'search-words', 'search-found', 'search-count'].map($);
  const most = 20;
  let index = null;

  const load = (path) => new Promise((resolve, reject) => {
    const script = Object.assign(document.createElement('script'), { src: root + path, onload: resolve,
      onerror: () => reject(new Error(`${path} can't be loaded.`)) });
    document.head.append(script);
  });

  /** A promise of the index. Scripts, not fetch(): they work from files, too. */
  const made = () => {
    index ??= Promise.all([load('lib/minisearch.js'), load('search-data.js')]).then(() => {
      const search = new MiniSearch({ fields: ['title', 'section', 'text'], storeFields: ['title', 'section', 'page', 'text'],
        searchOptions: { prefix: true, fuzzy: 0.15, boost: { title: 4, section: 3 }, combineWith: 'AND' } });
      search.addAll(window.searchData);
      return search;
    });
    return index;
  };

  /** The text around the first word that is found. */
  function excerpt(text, terms) {
    const at = Math.max(0, Math.min(...terms.map((term) => text.toLowerCase().indexOf(term)).filter((place) => place >= 0), text.length) - 40);
    return `${at ? '… ' : ''}${text.slice(at === text.length - 40 ? 0 : at, at + 140)} …`;
  }

  async function show() {
    const wanted = words.value.trim();
    if (!wanted) {
      found.replaceChildren();
      count.textContent = '';
      return;
    }
    try {
      const results = (await made()).search(wanted);
      if (wanted !== words.value.trim()) return; // typing went on
      count.textContent = results.length ? `${results.length} sections` : 'Nothing is found.';
      found.replaceChildren(...results.slice(0, most).map(({ title, section, page, text, terms }) => {
        const item = document.createElement('li');
        const link = Object.assign(document.createElement('a'), { href: root + page, textContent: section ? `${title}: ${section}` : title });
        const words = Object.assign(document.createElement('p'), { textContent: excerpt(text, terms) });
        item.append(link, words);
        return item;
      }));
    } catch (error) {
      count.textContent = error.message;
    }
  }

  const open = () => {
    dialog.showModal();
    words.select();
    made().catch(() => {}); // show() reports it
  };
  $('search-open').addEventListener('click', open);
  words.addEventListener('input', show);
  words.addEventListener('keydown', (event) => {
    if (event.key !== 'Enter') return;
    event.preventDefault();
    found.querySelector('a')?.click();
  });
  found.addEventListener('click', () => dialog.close());
  addEventListener('keydown', (event) => {
    const typing = event.target.closest?.('input, textarea, select, edgeshade-viewer');
    if (event.key !== '/' || typing || dialog.open) return;
    event.preventDefault();
    open();
  });
})();
