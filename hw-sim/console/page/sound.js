// What the loudspeaker plays, through this machine's own loudspeaker: off until the button is pressed, since browsers
// let no page make a sound by itself. The simulator sends 16-bit frames (left, right) as the simulated loudspeaker has
// played them, in packets of: u32 number of frames, u32 rate in Hz, frames; all little-endian.
import {make} from './drag.js';

const kRate_hz = 48000;      // Of the context, as of the loudspeaker: packets meet frame by frame, and nothing clicks.
const kHeadBytes = 8;
const kFrameBytes = 4;
const kLead_s = 0.08;        // The first packet waits so long, so that a late one does not tear the sound.
const kMostLead_s = 0.5;     // What is further behind than this is left out: a page that was stopped catches up.
const kRetry_ms = 1000;
const kQuiet_db = -60;

class Player {
  constructor() {
    this.context = new AudioContext({latencyHint: 'interactive', sampleRate: kRate_hz});
    this.analyser = new AnalyserNode(this.context, {fftSize: 2048});
    this.analyser.connect(this.context.destination);
    this.next = 0;    // The context's frame at which the next packet begins.
    this.frames = 0;  // Played since the button was pressed.
  }

  // Queues one packet behind those that wait.
  play(rate_hz, samples) {
    const frames = samples.length / 2;
    const now_s = this.context.currentTime;
    if (this.next < now_s * kRate_hz) this.next = Math.ceil((now_s + kLead_s) * kRate_hz);
    if (rate_hz !== kRate_hz || this.next > (now_s + kMostLead_s) * kRate_hz) return;
    const buffer = this.context.createBuffer(2, frames, rate_hz);
    for (const channel of [0, 1]) {
      const into = buffer.getChannelData(channel);
      for (let n = 0; n < frames; ++n) into[n] = samples[2 * n + channel] / 32768;
    }
    const source = new AudioBufferSourceNode(this.context, {buffer});
    source.connect(this.analyser);
    source.start(this.next / kRate_hz);
    this.next += frames;
    this.frames += frames;
  }

  // The peak of what leaves the page now, of full scale.
  peak_db() {
    const wave = new Float32Array(this.analyser.fftSize);
    this.analyser.getFloatTimeDomainData(wave);
    const peak = wave.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
    return 20 * Math.log10(Math.max(peak, 1e-5));
  }

  close() {
    this.context.close();
  }
}

// Calls play(rate_hz, samples) for each whole packet of the stream, until that ends.
async function readPackets(reader, play) {
  let rest = new Uint8Array();
  for (;;) {
    const {done, value} = await reader.read();
    if (done) return;
    const bytes = new Uint8Array(rest.length + value.length);
    bytes.set(rest);
    bytes.set(value, rest.length);
    let at = 0;
    while (bytes.length - at >= kHeadBytes) {
      const head = new DataView(bytes.buffer, at, kHeadBytes);
      const end = at + kHeadBytes + head.getUint32(0, true) * kFrameBytes;
      if (end > bytes.length) break;
      play(head.getUint32(4, true), new Int16Array(bytes.slice(at + kHeadBytes, end).buffer));
      at = end;
    }
    rest = bytes.slice(at);
  }
}

// The button; it says what the page plays in its own data: `frames` since it was pressed, `peak` in dB of full scale.
export function makeSound() {
  const level = make('i', {});
  const button = make('button', {type: 'button', id: 'sound', 'aria-pressed': 'false', title: 'Plays what the loudspeaker plays'},
                      'Sound', make('span', {class: 'level'}, level));
  let player = null;
  let stop = null;

  const listen = async () => {
    while (player && !document.hidden) {
      stop = new AbortController();
      try {
        const reply = await fetch('/sound', {signal: stop.signal});
        await readPackets(reply.body.getReader(), (rate_hz, samples) => player?.play(rate_hz, samples));
      } catch { /* The simulator is gone, or the sound was turned off. */ }
      if (player) await new Promise((done) => setTimeout(done, kRetry_ms));
    }
  };
  const show = () => {
    button.setAttribute('aria-pressed', String(player !== null));
    const peak_db = player ? player.peak_db() : -Infinity;
    level.style.width = `${100 * Math.min(1, Math.max(0, 1 - peak_db / kQuiet_db))}%`;
    button.dataset.frames = player?.frames ?? 0;
    button.dataset.peak = peak_db.toFixed(1);
    if (player) requestAnimationFrame(show);
  };
  button.addEventListener('click', () => {
    if (player) {
      player.close();
      player = null;
      stop?.abort();
      return;
    }
    player = new Player();
    listen();
    show();
  });
  // A hidden page listens to nothing.
  document.addEventListener('visibilitychange', () => {
    if (document.hidden) stop?.abort();
    else if (player) listen();
  });
  return button;
}
