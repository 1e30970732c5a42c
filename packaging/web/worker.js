// Keeps the page for use without a network. Each build has a name of its own (@version@), and files of others go.
'use strict';
const name = 'coaster-@version@';
const files = ['./', @files@];

addEventListener('install', (event) => {
  event.waitUntil(caches.open(name).then((kept) => kept.addAll(files.map((file) => new Request(file, { cache: 'reload' })))));
});
addEventListener('activate', (event) => {
  event.waitUntil(caches.keys().then((all) => Promise.all(all.filter((other) => other.startsWith('coaster-') && other !== name)
    .map((other) => caches.delete(other)))).then(() => clients.claim()));
});
addEventListener('fetch', (event) => {
  event.respondWith(caches.open(name).then((kept) => kept.match(event.request, { ignoreSearch: true }))
    .then((found) => found || fetch(event.request)));
});
addEventListener('message', (event) => { if (event.data === 'use now') skipWaiting(); });
