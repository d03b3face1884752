// The connection to the simulator: input goes out as lines of text, the state comes in, 20 times a second at most.

const kMostLines = 80;  // In one message; the simulator takes 4096 bytes.

const kRetry_ms = 1000;

const waiting = new Map();  // Slot -> line, or what adds up under the slot's own words.
const listeners = [];
let sending = false;
let edges = 0;
let events = null;

function text(slot, value) {
  return typeof value === 'number' ? `${slot} ${value.toFixed(5)}` : value;
}

function drain() {
  const slots = [...waiting].slice(0, kMostLines);
  for (const [slot] of slots) waiting.delete(slot);
  return slots.map(([slot, value]) => text(slot, value)).join('\n');
}

// One message at a time: what happens meanwhile shares the next one.
async function flush() {
  if (sending) return;
  sending = true;
  while (waiting.size > 0) {
    try {
      const reply = await fetch('/input', {method: 'POST', body: drain()});
      if (!reply.ok) console.warn(await reply.text());
    } catch {
      waiting.clear();  // The simulator is gone; old input must not reach a new one.
    }
  }
  sending = false;
}

// Something happened once: a button went down. Kept in order.
export function tell(line) {
  waiting.set(`edge ${++edges}`, line);
  flush();
}

// Something of the show is called: "goto 14". It is made on the box's board, and not by a device.
export async function call(line) {
  try {
    const reply = await fetch('/call', {method: 'POST', body: line});
    if (!reply.ok) console.warn(await reply.text());
  } catch {
    // The simulator is gone, and the page says so already.
  }
}

// Where something stands: only the newest counts.
export function set(slot, line) {
  waiting.set(slot, line);
  flush();
}

// Something went on by so much: "roll pointer". It adds up.
export function add(words, amount) {
  waiting.set(words, (waiting.get(words) ?? 0) + amount);
  flush();
}

// Dials count from 1.
export function turn(dial, turns) {
  add(`dial ${dial} turn`, turns);
}

// The page is going: sent even though nobody waits for it any more.
export function sendLast(lines) {
  if (lines.length > 0) navigator.sendBeacon('/input', lines.join('\n'));
}

export function onState(listener) {
  listeners.push(listener);
}

function setLink(link) {
  document.body.dataset.link = link;
}

function open(picture) {
  events = new EventSource('/events');
  events.onopen = () => {
    setLink('live');
    picture.src = `/picture?${Date.now()}`;  // A new stream after each break.
  };
  events.onerror = () => {
    setLink('lost');
    if (events?.readyState === EventSource.CLOSED) setTimeout(() => reopen(picture), kRetry_ms);
  };
  events.onmessage = (event) => {
    const state = JSON.parse(event.data);
    for (const listener of listeners) listener(state);
  };
}

// A browser that has given up: begin anew, unless the page was hidden meanwhile.
function reopen(picture) {
  if (events?.readyState !== EventSource.CLOSED) return;
  events.close();
  open(picture);
}

function close(picture) {
  events?.close();
  events = null;
  picture.removeAttribute('src');
}

// Listens while the page can be seen; a hidden page costs the show nothing.
export function connect(picture) {
  const follow = () => {
    if (document.hidden) close(picture);
    else if (!events) open(picture);
  };
  document.addEventListener('visibilitychange', follow);
  follow();
}
