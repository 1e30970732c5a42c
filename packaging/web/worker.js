// Keeps the page for use without a network. Each build has its own cache, and the caches of other builds are deleted.
'use strict';
const name = 'coaster-@version@';
const files = ['./', @files@];

addEventListener('install', (event) => {
  const requests = files.map((file) => new Request(file, { cache: 'reload' }));
  event.waitUntil(caches.open(name).then((kept) => kept.addAll(requests)));
});
addEventListener('activate', (event) => {
  const isOld = (other) => other.startsWith('coaster-') && other !== name;
  event.waitUntil(caches.keys()
    .then((all) => Promise.all(all.filter(isOld).map((old) => caches.delete(old))))
    .then(() => clients.claim()));
});
addEventListener('fetch', (event) => {
  event.respondWith(caches.open(name)
    .then((kept) => kept.match(event.request, { ignoreSearch: true }))
    .then((found) => found || fetch(event.request)));
});
addEventListener('message', (event) => { if (event.data === 'use now') skipWaiting(); });
