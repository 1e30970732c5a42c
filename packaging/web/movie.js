// Movies: the browser encodes pictures (WebCodecs, VP8) while the program takes them, and downloads them as a WebM
// file.
'use strict';
(() => {
  const secondsAKeyPicture = 2;
  const bitsAPixel = 0.2;

  // WebM is EBML (RFC 8794, Matroska's elements): an id, a length of 8 bytes, the content.
  const joined = (parts) => {
    const all = new Uint8Array(parts.reduce((size, part) => size + part.length, 0));
    parts.reduce((at, part) => { all.set(part, at); return at + part.length; }, 0);
    return all;
  };
  const bytesOf = (number, length) => Uint8Array.from({ length }, (_, i) => Math.floor(number / 2 ** (8 * (length - 1 - i))) % 256);
  const idOf = (id) => bytesOf(id, Math.ceil(Math.log2(id + 1) / 8));
  const head = (id, size) => joined([idOf(id), [1], bytesOf(size, 7)]);
  const element = (id, ...parts) => {
    const content = joined(parts.map((part) => typeof part === 'number' ? bytesOf(part, 8) : typeof part === 'string' ? new TextEncoder().encode(part) : part));
    return joined([head(id, content.length), content]);
  };
  const real = (value) => { const bytes = new DataView(new ArrayBuffer(8)); bytes.setFloat64(0, value); return new Uint8Array(bytes.buffer); };

  let encoder = null, rate = 30, size = null, pictures = 0, chunks = 0;
  let clusters = [];  // of whole seconds: { time (ms), content (Blob) }
  let cluster = null;  // the last: { time, blocks }
  const close = () => {
    if (cluster) clusters.push({ time: cluster.time, content: new Blob([element(0x1F43B675, element(0xE7, cluster.time), ...cluster.blocks)]) });
    cluster = null;
  };
  const take = (chunk) => {
    const time = Math.round(chunk.timestamp / 1000);
    if (chunk.type === 'key') {
      close();
      cluster = { time, blocks: [] };
    }
    const bytes = new Uint8Array(chunk.byteLength);
    chunk.copyTo(bytes);
    cluster.blocks.push(element(0xA3, [0x81], bytesOf(time - cluster.time, 2), [chunk.type === 'key' ? 0x80 : 0], bytes));
    ++chunks;
  };

  const file = () => {
    const info = element(0x1549A966, element(0x2AD7B1, 1000000), element(0x4489, real(pictures * 1000 / rate)), element(0x4D80, 'coaster'), element(0x5741, 'coaster'));
    const video = element(0xE0, element(0xB0, size.width), element(0xBA, size.height));
    const tracks = element(0x1654AE6B, element(0xAE, element(0xD7, 1), element(0x73C5, 1), element(0x9C, 0), element(0x83, 1), element(0x86, 'V_VP8'),
      element(0x23E383, Math.round(1e9 / rate)), video));
    // Where the parts begin, for players that jump. Its length does not depend on the numbers.
    const seekHead = (...parts) => element(0x114D9B74, ...parts.map(([id, at]) => element(0x4DBB, element(0x53AB, idOf(id)), element(0x53AC, at))));
    const parts = (infoAt, tracksAt, cuesAt) => seekHead([0x1549A966, infoAt], [0x1654AE6B, tracksAt], [0x1C53BB6B, cuesAt]);
    const before = parts(0, 0, 0).length;
    let at = before + info.length + tracks.length;
    const cues = [];
    for (const { time, content } of clusters) {
      cues.push(element(0xBB, element(0xB3, time), element(0xB7, element(0xF7, 1), element(0xF1, at))));
      at += content.size;
    }
    const table = element(0x1C53BB6B, ...cues);
    const start = element(0x1A45DFA3, element(0x4286, 1), element(0x42F7, 1), element(0x42F2, 4), element(0x42F3, 8), element(0x4282, 'webm'), element(0x4287, 2), element(0x4285, 2));
    return new Blob([start, head(0x18538067, at + table.length), parts(before, before + info.length, at), info, tracks, ...clusters.map(({ content }) => content), table], { type: 'video/webm' });
  };

  const movie = {
    failed: '', said: '',
    can: () => typeof VideoEncoder === 'function',
    begin: (pictureRate) => {
      movie.end();
      rate = pictureRate;
      encoder = new VideoEncoder({ output: take, error: (why) => { movie.failed = why.message; } });
    },
    waiting: () => encoder.encodeQueueSize,
    add: (rgba, width, height) => {
      if (movie.failed) return;
      try {
        if (!size) {
          size = { width, height };
          encoder.configure({ codec: 'vp8', width, height, framerate: rate, bitrate: Math.round(width * height * rate * bitsAPixel) });
        }
        const picture = new VideoFrame(rgba, { format: 'RGBX', codedWidth: width, codedHeight: height, timestamp: Math.round(pictures * 1e6 / rate) });
        encoder.encode(picture, { keyFrame: pictures % (secondsAKeyPicture * rate) === 0 });
        picture.close();
        ++pictures;
      } catch (why) {
        movie.failed = why.message;
      }
    },
    finish: (fileName) => {
      const mine = encoder;
      mine.flush().then(() => {
        close();
        const whole = file();
        offer(whole, fileName);
        movie.said = 'Downloaded ' + fileName + ': ' + (pictures / rate).toFixed(1) + ' s, ' + (whole.size / 1e6).toFixed(1) + ' MB.';
      }).catch((why) => { if (mine === encoder) movie.said = movie.failed = 'The browser\'s encoder failed: ' + (movie.failed || why.message); });
    },
    part: () => pictures > 0 ? chunks / pictures : 0,
    end: () => {
      if (encoder && encoder.state !== 'closed') encoder.close();
      encoder = null, size = null, cluster = null, clusters = [], pictures = 0, chunks = 0, movie.failed = '', movie.said = '';
    },
  };
  Module.coasterMovie = movie;
})();
