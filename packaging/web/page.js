// The page around the program: what it keeps, files in and out, the clipboard, and messages when it cannot run.
'use strict';
const said = document.getElementById('said');
const canvas = document.getElementById('canvas');

function say(text, button, act) {
  said.textContent = text;
  said.hidden = false;
  if (!button) return;
  const pressed = document.createElement('button');
  pressed.textContent = button;
  pressed.onclick = act;
  said.append(document.createElement('br'), pressed);
}

function note(text) {
  const shown = document.getElementById('note');
  shown.firstChild.textContent = text;
  shown.hidden = false;
}

// What the program keeps is in a folder that the browser stores: settings, medals, autosaves and saved tracks.
const kept = '/home/coaster';
let keeps = true;
let keeping = true;  // also while what was kept is read
let again = false;
function keepsNothing(why) {
  if (keeps) note(`The browser stores nothing more (${why}), so settings and unsaved work end with this page.`);
  keeps = false;
}
// IDBFS waits forever for a transaction that ends because the store is full.
if (window.IDBDatabase) {
  const begin = IDBDatabase.prototype.transaction;
  IDBDatabase.prototype.transaction = function (...words) {
    const begun = begin.apply(this, words);
    begun.addEventListener('abort', () => keepsNothing(begun.error ? begun.error.message : 'interrupted'));
    return begun;
  };
}
// One tab at a time keeps: two would overwrite each other's files.
function whenAlone(begin) {
  if (!navigator.locks) return begin(true);
  navigator.locks.request('coaster keeps', { ifAvailable: true }, (lock) => {
    begin(lock !== null);
    return lock ? new Promise(() => {}) : undefined;
  });
}
function keep() {
  if (!keeps) return;
  if (keeping) return void (again = true);
  keeping = true;
  Module.FS.syncfs(false, (failed) => {
    keeping = false;
    if (failed) keepsNothing(failed);
    else if (again) {
      again = false;
      keep();
    }
  });
}

// Files from outside come to /tmp/opened under their own names.
function take(file) {
  return file.arrayBuffer().then((bytes) => {
    const path = '/tmp/opened/' + file.name.replace(/[/\0]/g, '_');
    Module.FS.mkdirTree('/tmp/opened');
    Module.FS.writeFile(path, new Uint8Array(bytes));
    return path;
  });
}
const openFile = (path) => Module.ccall('coaster_open', null, ['string'], [path]);

let picked = '';
function pick() {
  const input = document.createElement('input');
  input.type = 'file';
  picked = '';
  input.oncancel = () => { picked = '-'; };
  input.onchange = () => {
    if (input.files.length === 0) picked = '-';
    else take(input.files[0]).then((path) => { picked = path; }, () => { picked = '-'; });
  };
  input.click();
  return 1;
}

function offer(blob, name) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

const download = (path) => offer(new Blob([Module.FS.readFile(path)]), path.slice(path.lastIndexOf('/') + 1));

function fullScreen() {
  const page = document.documentElement;
  if (document.fullscreenElement) return void document.exitFullscreen();
  if (!page.requestFullscreen) return note('This browser shows no page in full screen.');
  page.requestFullscreen({ navigationUI: 'hide' }).catch((why) => note('No full screen: ' + why.message));
}

const reload = () => location.reload();

// The program is fetched and compiled, and the graphics start, while coaster.js and the data are still loading. In a
// page of one file (packaging/web/one_file) `packed` holds the program's bytes.
function compile() {
  if (window.packed) return WebAssembly.compile(packed.program);
  const fetched = () => fetch('coaster.wasm', { credentials: 'same-origin' });
  // Some hosts send another type than application/wasm.
  const compileWhole = async () => WebAssembly.compile(await (await fetched()).arrayBuffer());
  return WebAssembly.compileStreaming(fetched()).catch(compileWhole);
}
const compiled = compile();
compiled.catch(() => {});  // instantiate() reports it
canvas.getContext('webgl2', { alpha: false, depth: false, antialias: false });  // as platform/web_surface does later

// Keeps the compiled program, for workers (beside.js).
function instantiate(imports, done) {
  const begun = compiled.then((program) => {
    Module.program = program;
    return WebAssembly.instantiate(program, imports).then((instance) => done(instance, program));
  });
  begun.catch((why) => {
    if (why instanceof Error && why.name === 'ExitStatus') return;
    say('coaster cannot start: ' + (why.message || why), 'Reload', reload);
  });
  return {};
}

let last = '';  // the program's last message
let begun = false;
const here = location.href.replace(/#.*/, '');
const isLink = () => location.hash.startsWith('#coaster=');

var Module = {
  canvas,
  arguments: ['--address', here],
  preRun: [() => {
    Module.ENV.HOME = kept;
    Module.FS.mkdirTree(kept);
    Module.addRunDependency('kept');
    const begin = () => {
      Module.FS.chdir(kept);  // where the dialogs begin
      Module.removeRunDependency('kept');
    };
    whenAlone((alone) => {
      if (!alone) {
        keeps = false;
        note('coaster is open in another tab, too. This one keeps nothing: share or save what you build here.');
        return begin();
      }
      Module.FS.mount(Module.IDBFS, {}, kept);
      Module.FS.syncfs(true, (failed) => {
        keeping = false;
        if (failed) keepsNothing(failed);
        begin();
      });
    });
  }],
  postRun: [() => {
    if (Module.coasterEnded !== undefined) return;
    begun = true;
    said.hidden = true;
    canvas.focus();
    if (isLink()) openFile(location.hash);
  }],
  onAbort: (why) => {
    begun = false;
    say(`coaster has stopped: ${why}. Changes since the last autosave are lost.`, 'Reload', reload);
  },
  // Also called with 0 when main() has begun the loop of frames.
  quit: (code, thrown) => {
    if (code === 0 && !begun) throw thrown;
    if (Module.pauseMainLoop) Module.pauseMainLoop();
    Module.coasterEnded = code;
    keep();
    if (code === 0) say('coaster has ended.', 'Start again', reload);
    else say((last || 'coaster has ended with code ' + code) + '.', 'Reload', reload);
    throw thrown;
  },
  print: (text) => console.log(text),
  printErr: (text) => {
    last = text.replace(/^\r/, '').replace(/\.$/, '');
    console.warn(last);
  },
  instantiateWasm: instantiate,
  getPreloadedPackage: () => window.packed ? packed.data.buffer : undefined,
  coasterFullScreen: fullScreen,
  coasterPick: pick,
  coasterPicked: () => picked,
  coasterDownload: download,
  coasterCopy: copy,
};

// Autosaves; returns whether there are unsaved changes. A page may end at any time, so it is done more often than in a
// window.
const autosave = () => begun && Module.ccall('coaster_autosave', 'number', [], []) === 1;
setInterval(() => {
  autosave();
  keep();
}, 2000);
addEventListener('pagehide', keep);
// The browser asks whether to leave unsaved changes, and stores them meanwhile.
addEventListener('beforeunload', (event) => {
  const unsaved = autosave();
  keep();
  if (!unsaved) return;
  event.preventDefault();
  event.returnValue = true;  // for older browsers
});

// The browser calls no frame of a hidden page, so the ride stands still.
let hiddenAt = 0;
document.addEventListener('visibilitychange', () => {
  if (document.hidden) autosave();
  keep();
  if (document.hidden) return void (hiddenAt = Date.now());
  const minutes = Math.round((Date.now() - hiddenAt) / 60000);
  if (hiddenAt > 0 && minutes >= 10) note(`This page was hidden for ${minutes} minutes. The ride has waited.`);
});

// Links that are opened in this page.
addEventListener('hashchange', () => { if (isLink()) openFile(location.hash); });

// Files that are dropped on it.
addEventListener('dragover', (event) => event.preventDefault());
addEventListener('drop', (event) => {
  event.preventDefault();
  if (event.dataTransfer.files.length > 0) take(event.dataTransfer.files[0]).then(openFile);
});

// A page may play after an input, a finger only where it is lifted; Emscripten tries where it is put down. A call or
// another tab may have silenced the page.
function play() {
  if (!window.AL) return;
  for (const { audioCtx } of Object.values(AL.contexts))
    if (audioCtx.state !== 'running' && audioCtx.state !== 'closed') audioCtx.resume();
}
for (const input of ['touchend', 'mouseup', 'keydown']) addEventListener(input, play, true);

// Some browsers let a page write the clipboard only during an input, and in timers that begin there and last at most a
// second (WebKit). The program copies in a later frame. What none of them takes waits for the next input.
let copied = null;  // what the clipboard does not have yet
// Pages that do not come by https have the old way alone.
const writeText = navigator.clipboard ? (text) => navigator.clipboard.writeText(text) : async (text) => {
  const give = (event) => {
    event.clipboardData.setData('text/plain', text);
    event.preventDefault();
  };
  addEventListener('copy', give);
  const given = document.execCommand('copy');
  removeEventListener('copy', give);
  if (!given) throw new Error('not during an input');
};
function writeClipboard(failed) {
  if (copied === null) return;
  const text = copied;
  writeText(text).then(() => { if (copied === text) copied = null; }, failed || (() => {}));
}
function copy(text) {
  copied = text;
  const tell = () => {
    if (copied === text) note('This browser copies only during a click or a key: press once more.');
  };
  writeClipboard();
  setTimeout(() => writeClipboard(tell), 1000);
}
for (const input of ['pointerup', 'keydown'])
  addEventListener(input, () => [0, 50, 200, 900].forEach((delay) => setTimeout(writeClipboard, delay)), true);
addEventListener('blur', () => { copied = null; });  // another program may copy now

// The browser gives the clipboard only with this event.
addEventListener('paste', (event) => {
  event.preventDefault();
  Module.ccall('coaster_paste', null, ['string'], [event.clipboardData.getData('text/plain')]);
});
addEventListener('contextmenu', (event) => event.preventDefault());
addEventListener('gesturestart', (event) => event.preventDefault());  // Safari's zoom by two fingers

// Without a network the files come from the worker. A new version waits until the user takes it.
if ('serviceWorker' in navigator && location.protocol.startsWith('http')) {
  const offer = (waiting) => {
    const note = document.getElementById('update');
    note.hidden = false;
    note.onclick = () => {
      navigator.serviceWorker.addEventListener('controllerchange', reload);
      waiting.postMessage('use now');
    };
  };
  navigator.serviceWorker.register('worker.js').then((worker) => {
    // At the first visit the only worker may itself be waiting for a moment.
    const offerUpdate = () => { if (worker.waiting && worker.active) offer(worker.waiting); };
    offerUpdate();
    worker.addEventListener('updatefound', () => worker.installing.addEventListener('statechange', offerUpdate));
  }, () => {});
}
