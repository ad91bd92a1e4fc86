// Tables with several rows are sorted by a press on a column's heading, by number where cells have numbers.

(() => {
  /** A cell's number; "1,234.5 ms" is 1234.5. Null: it begins with no number. */
  const numberOf = (text) => {
    const found = text.replaceAll(',', '').replace('−', '-').match(/^[^\d-]{0,2}(-?\d+(\.\d+)?)/);
    return found ? Number(found[1]) : null;
  };

  function compare(a, b) {
    const [x, y] = [numberOf(a), numberOf(b)];
    if (x !== null && y !== null) return x - y;
    if (x !== null || y !== null) return x !== null ? -1 : 1; // numbers before words
    return a.localeCompare(b);
  }

  function sort(table, column, heading) {
    const falls = heading.getAttribute('aria-sort') === 'ascending';
    for (const other of table.tHead.rows[0].cells) other.removeAttribute('aria-sort');
    heading.setAttribute('aria-sort', falls ? 'descending' : 'ascending');
    const text = (row) => row.cells[column]?.textContent.trim() ?? '';
    const rows = [...table.tBodies[0].rows].sort((a, b) => (falls ? -1 : 1) * compare(text(a), text(b)));
    table.tBodies[0].append(...rows);
  }

  for (const table of document.querySelectorAll('table:not(.fixed)')) {
    if (!table.tHead || table.tBodies[0]?.rows.length < 3) continue;
    [...table.tHead.rows[0].cells].forEach((heading, column) => {
      if (!heading.textContent.trim()) return;
      const button = document.createElement('button');
      button.type = 'button';
      button.className = 'sort';
      button.append(...heading.childNodes);
      button.addEventListener('click', () => sort(table, column, heading));
      heading.append(button);
    });
  }
})();
