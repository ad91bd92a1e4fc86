// Says why pictures don't move if the page was opened as a file.

if (location.protocol === 'file:')
  for (const state of document.querySelectorAll('.stage .state'))
    state.textContent = 'Live pictures need a server, as browsers run no modules from files: ./run site --serve starts one.';
