// Movies: the browser encodes pictures (WebCodecs, VP8) while the program takes them, and downloads them as a WebM
// file.
'use strict';
(() => {
  const secondsPerKeyPicture = 2;
  const bitsPerPixel = 0.2;

  // WebM is EBML (RFC 8794): elements of an id, a length of 8 bytes and the content. The ids are Matroska's (RFC 9559).
  const ids = {
    ebml: 0x1A45DFA3, ebmlVersion: 0x4286, ebmlReadVersion: 0x42F7, maxIdLength: 0x42F2, maxSizeLength: 0x42F3,
    docType: 0x4282, docTypeVersion: 0x4287, docTypeReadVersion: 0x4285,
    segment: 0x18538067, seekHead: 0x114D9B74, seek: 0x4DBB, seekId: 0x53AB, seekPosition: 0x53AC,
    info: 0x1549A966, timestampScale: 0x2AD7B1, duration: 0x4489, muxingApp: 0x4D80, writingApp: 0x5741,
    tracks: 0x1654AE6B, trackEntry: 0xAE, trackNumber: 0xD7, trackUid: 0x73C5, flagLacing: 0x9C, trackType: 0x83,
    codecId: 0x86, defaultDuration: 0x23E383, video: 0xE0, pixelWidth: 0xB0, pixelHeight: 0xBA,
    cluster: 0x1F43B675, timestamp: 0xE7, simpleBlock: 0xA3,
    cues: 0x1C53BB6B, cuePoint: 0xBB, cueTime: 0xB3, cueTrackPositions: 0xB7, cueTrack: 0xF7, cueClusterPosition: 0xF1,
  };

  const joined = (parts) => {
    const all = new Uint8Array(parts.reduce((size, part) => size + part.length, 0));
    let at = 0;
    for (const part of parts) {
      all.set(part, at);
      at += part.length;
    }
    return all;
  };
  // Big-endian.
  const bytesOf = (number, length) => {
    const byte = (i) => Math.floor(number / 2 ** (8 * (length - 1 - i))) % 256;
    return Uint8Array.from({ length }, (_, i) => byte(i));
  };
  const idOf = (id) => bytesOf(id, Math.ceil(Math.log2(id + 1) / 8));
  const head = (id, size) => joined([idOf(id), [1], bytesOf(size, 7)]);
  const contentOf = (part) => {
    if (typeof part === 'number') return bytesOf(part, 8);
    return typeof part === 'string' ? new TextEncoder().encode(part) : part;
  };
  const element = (id, ...parts) => {
    const content = joined(parts.map(contentOf));
    return joined([head(id, content.length), content]);
  };
  const real = (value) => {
    const bytes = new DataView(new ArrayBuffer(8));
    bytes.setFloat64(0, value);
    return new Uint8Array(bytes.buffer);
  };

  let encoder = null;
  let rate = 30;
  let size = null;
  let pictures = 0, chunks = 0;  // given to the encoder, and received from it
  let clusters = [];  // of whole seconds: { time (ms), content (Blob) }
  let cluster = null;  // the last: { time, blocks }
  const close = () => {
    if (cluster) {
      const content = element(ids.cluster, element(ids.timestamp, cluster.time), ...cluster.blocks);
      clusters.push({ time: cluster.time, content: new Blob([content]) });
    }
    cluster = null;
  };
  const take = (chunk) => {
    const time = Math.round(chunk.timestamp / 1000);
    const isKey = chunk.type === 'key';
    if (isKey) {
      close();
      cluster = { time, blocks: [] };
    }
    const bytes = new Uint8Array(chunk.byteLength);
    chunk.copyTo(bytes);
    const track = 0x81;
    const flags = isKey ? 0x80 : 0;
    cluster.blocks.push(element(ids.simpleBlock, [track], bytesOf(time - cluster.time, 2), [flags], bytes));
    ++chunks;
  };

  const header = () => element(ids.ebml,
    element(ids.ebmlVersion, 1), element(ids.ebmlReadVersion, 1),
    element(ids.maxIdLength, 4), element(ids.maxSizeLength, 8),
    element(ids.docType, 'webm'), element(ids.docTypeVersion, 2), element(ids.docTypeReadVersion, 2));
  const infoOf = (milliseconds) => element(ids.info,
    element(ids.timestampScale, 1000000), element(ids.duration, real(milliseconds)),
    element(ids.muxingApp, 'coaster'), element(ids.writingApp, 'coaster'));
  const trackOf = ({ width, height }) => element(ids.tracks, element(ids.trackEntry,
    element(ids.trackNumber, 1), element(ids.trackUid, 1), element(ids.flagLacing, 0), element(ids.trackType, 1),
    element(ids.codecId, 'V_VP8'), element(ids.defaultDuration, Math.round(1e9 / rate)),
    element(ids.video, element(ids.pixelWidth, width), element(ids.pixelHeight, height))));
  const cueOf = (time, at) => element(ids.cuePoint, element(ids.cueTime, time),
    element(ids.cueTrackPositions, element(ids.cueTrack, 1), element(ids.cueClusterPosition, at)));
  // Where the parts begin, for players that jump. Its length does not depend on the numbers.
  const seekHeadOf = (infoAt, tracksAt, cuesAt) => {
    const seek = (id, at) => element(ids.seek, element(ids.seekId, idOf(id)), element(ids.seekPosition, at));
    return element(ids.seekHead, seek(ids.info, infoAt), seek(ids.tracks, tracksAt), seek(ids.cues, cuesAt));
  };
  const file = () => {
    const info = infoOf(pictures * 1000 / rate);
    const tracks = trackOf(size);
    const infoAt = seekHeadOf(0, 0, 0).length;
    const tracksAt = infoAt + info.length;
    let at = tracksAt + tracks.length;
    const points = [];
    for (const { time, content } of clusters) {
      points.push(cueOf(time, at));
      at += content.size;
    }
    const cues = element(ids.cues, ...points);
    const parts = [
      header(), head(ids.segment, at + cues.length), seekHeadOf(infoAt, tracksAt, at), info, tracks,
      ...clusters.map(({ content }) => content), cues,
    ];
    return new Blob(parts, { type: 'video/webm' });
  };

  const movie = {
    failed: '',
    said: '',
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
          const bitrate = Math.round(width * height * rate * bitsPerPixel);
          encoder.configure({ codec: 'vp8', width, height, framerate: rate, bitrate });
        }
        const timestamp = Math.round(pictures * 1e6 / rate);
        const picture = new VideoFrame(rgba, { format: 'RGBX', codedWidth: width, codedHeight: height, timestamp });
        encoder.encode(picture, { keyFrame: pictures % (secondsPerKeyPicture * rate) === 0 });
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
        const seconds = (pictures / rate).toFixed(1);
        const megabytes = (whole.size / 1e6).toFixed(1);
        movie.said = `Downloaded ${fileName}: ${seconds} s, ${megabytes} MB.`;
      }).catch((why) => {
        if (mine !== encoder) return;
        movie.failed = `The browser's encoder failed: ${movie.failed || why.message}`;
        movie.said = movie.failed;
      });
    },
    part: () => pictures > 0 ? chunks / pictures : 0,
    end: () => {
      if (encoder && encoder.state !== 'closed') encoder.close();
      encoder = null;
      size = null;
      cluster = null;
      clusters = [];
      pictures = 0;
      chunks = 0;
      movie.failed = '';
      movie.said = '';
    },
  };
  Module.coasterMovie = movie;
})();
