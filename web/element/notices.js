// Sentences for the user, over the picture.

const shownMilliseconds = 9000;
const most = 3;

export class Notices {
  #list;
  constructor(list) {
    this.#list = list;
    list.addEventListener('keydown', (event) => {
      if (event.key === 'Escape') this.clear();
    });
  }

  /**
   * An error stays until it is closed or something else succeeds; other sentences disappear by
   * themselves.
   */
  say(sentence, kind = 'note') {
    for (const old of this.#list.children) if (old.dataset.sentence === sentence) old.remove();
    const notice = document.createElement('div');
    notice.className = 'notice';
    notice.dataset.kind = kind;
    notice.dataset.sentence = sentence;
    notice.setAttribute('role', kind === 'error' ? 'alert' : 'status');
    const text = document.createElement('span');
    text.textContent = sentence;
    const close = document.createElement('button');
    close.textContent = '✕';
    close.setAttribute('aria-label', 'Close this message');
    close.addEventListener('click', () => notice.remove());
    notice.append(text, close);
    this.#list.append(notice);
    while (this.#list.children.length > most) this.#list.firstChild.remove();
    if (kind !== 'error') setTimeout(() => notice.remove(), shownMilliseconds);
    return notice;
  }

  clear() {
    this.#list.replaceChildren();
  }
}
