// Long work in the background: a worker gets the program, a copy of its memory and the file that the work reads.
'use strict';
(() => {
  // Runs in the worker.
  const work = () => {
    onmessage = ({ data }) => {
      self.Module = {
        noInitialRun: true,
        instantiateWasm: (imports, done) => {
          WebAssembly.instantiate(data.program, imports).then((instance) => done(instance, data.program));
          return {};
        },
        getPreloadedPackage: () => new ArrayBuffer(0),
        onAbort: (why) => postMessage({ failed: String(why) }),
        onRuntimeInitialized: () => {
          try {
            Module.FS.mkdirTree(data.folder);
            Module.FS.chdir(data.folder);
            if (data.path) {
              const whole = data.path.startsWith('/') ? data.path : data.folder + '/' + data.path;
              Module.FS.mkdirTree(whole.replace(/[^/]*$/, ''));
              Module.FS.writeFile(whole, data.file);
            }
            _emscripten_resize_heap(data.memory.length);
            HEAPU8.set(data.memory);
            postMessage({ found: UTF8ToString(Module._coaster_work(data.work)) });
          } catch (why) {
            postMessage({ failed: String(why.message || why) });
          }
        },
      };
      if (data.source) importScripts(data.source);
      else (0, eval)(data.text);  // a page from disk
    };
  };

  let worker = null;
  // As app/long_job.h prints it.
  const failure = (why) => `6 failed1 5${new TextEncoder().encode(why).length} ${why}`;
  const beside = {
    part: 0,
    found: undefined,
    begin: (job, path) => {
      beside.end();
      const script = document.getElementById('program');
      if (!window.Worker || !Module.program) return 0;
      try {
        worker = new Worker(URL.createObjectURL(new Blob(['(' + work + ')()'], { type: 'text/javascript' })));
      } catch (refused) {
        return 0;
      }
      const message = {
        work: job,
        path,
        file: path ? Module.FS.readFile(path) : undefined,
        folder: Module.FS.cwd(),
        program: Module.program,
        memory: Module.HEAPU8.slice(),
        source: script.src,
        text: script.textContent,
      };
      const fail = (why) => { beside.found = failure(`The page's worker stopped: ${why}`); };
      worker.onmessage = ({ data }) => {
        if (data.part !== undefined) beside.part = data.part;
        else if (data.failed !== undefined) fail(data.failed);
        else beside.found = data.found;
      };
      worker.onerror = (event) => fail(event.message);
      worker.postMessage(message, [message.memory.buffer]);
      return 1;
    },
    end: () => {
      if (worker) worker.terminate();
      worker = null;
      beside.part = 0;
      beside.found = undefined;
    },
  };
  Module.coasterWork = beside;
})();
