// The keyboard on a touch screen: a field outside the picture has the focus while the program takes text, and the
// program gets what changes in it.
'use strict';
(() => {
  const field = document.getElementById('typed');
  const filler = '        ';  // so that there is something to remove
  let wanted = false, touched = false;

  const room = () => window.visualViewport ? visualViewport.height * visualViewport.scale : innerHeight;
  const show = () => {
    field.value = filler;
    field.focus({ preventScroll: true });
  };
  const follow = () => {
    if (wanted && touched && document.activeElement !== field) show();
    if (wanted || document.activeElement !== field) return;
    field.blur();
    canvas.focus();
  };
  Module.coasterTakesText = (takes) => {
    wanted = takes !== 0;
    follow();
  };
  addEventListener('pointerdown', (event) => { touched = event.pointerType === 'touch'; }, true);
  // Some browsers show a keyboard only while a finger is lifted. One that the user has put away comes back.
  addEventListener('touchend', () => {
    if (wanted && document.activeElement === field && room() > innerHeight - 50) field.blur();
    follow();
  }, true);

  let before = filler;
  field.addEventListener('focus', () => { before = field.value; });
  field.addEventListener('input', () => {
    const now = field.value;
    let same = 0;
    while (same < before.length && same < now.length && before[same] === now[same]) ++same;
    Module.ccall('coaster_type', null, ['number', 'string'], [before.length - same, now.slice(same)]);
    before = now;
    if (before.length < 4 || before.length > 200) field.value = before = filler;
  });
  // The picture takes the room that the keyboard leaves.
  if (window.visualViewport) visualViewport.addEventListener('resize', () => { canvas.style.height = room() + 'px'; });
})();
