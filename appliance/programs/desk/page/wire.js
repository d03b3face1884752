// The line to the desk: what the hand asks goes out, how things stand comes in.
import {complaint, word} from './words.js';

const kRetry_ms = 1000;
const kPatience_ms = 4000;

const listeners = [];
const waiting = new Map();  // Number of a command -> whom its answer is for.
const drawn = new Map();    // Name of a value -> the newest text, while one is on its way.
let events = null;
let gesture = Math.floor(Math.random() * 1e6);
let onUnpaired = () => {};

function setLink(link) {
  document.body.dataset.link = link;
  for (const listener of listeners) listener(null);
}

export function onState(listener) {
  listeners.push(listener);
}

let toastTimer = 0;
export function toast(text, bad = false) {
  const element = document.getElementById('toast');
  element.textContent = text;
  element.classList.toggle('bad', bad);
  element.classList.add('shown');
  clearTimeout(toastTimer);
  toastTimer = setTimeout(() => element.classList.remove('shown'), bad ? 4000 : 1800);
}

async function send(text) {
  const reply = await fetch('/do', {method: 'POST', body: text});
  if (reply.status === 401) {
    disconnect();
    onUnpaired();
    throw new Error('unpaired');
  }
  if (reply.status === 503) throw new Error(word('gone'));
  if (!reply.ok) throw new Error((await reply.text()).trim());
  return (await reply.json()).number;
}

// Asks, waits until the lips have done it, and says what came of it. True: it was done.
export async function ask(text, done) {
  try {
    const number = await send(text);
    const answer = await new Promise((resolve) => {
      waiting.set(number, resolve);
      setTimeout(() => waiting.delete(number) && resolve(word('noLips')), kPatience_ms);
    });
    toast(answer === '' ? done ?? '' : complaint(answer), answer !== '');
    return answer === '';
  } catch (error) {
    if (error.message !== 'unpaired') toast(error instanceof TypeError ? word('lost') : error.message, true);
    return false;
  }
}

// A slider is being drawn: only its newest value counts, and all of it is one change.
export async function set(name, value) {
  const busy = drawn.has(name);
  drawn.set(name, value);
  if (busy) return;
  while (true) {
    const now = drawn.get(name);
    try {
      await send(`set ${name} ${now} ${gesture}`);
    } catch (error) {
      if (error.message !== 'unpaired') toast(error instanceof TypeError ? word('lost') : error.message, true);
    }
    if (drawn.get(name) === now) break;
  }
  drawn.delete(name);
}

export function newGesture() {
  gesture = gesture % 1e6 + 1;
}

function take(state) {
  const report = state.report;
  if (report && waiting.has(report.answered)) {
    waiting.get(report.answered)(report.complaint);
    waiting.delete(report.answered);
  }
  for (const listener of listeners) listener(state);
}

function open() {
  events = new EventSource('/events');
  events.onopen = () => setLink('live');
  events.onmessage = (event) => take(JSON.parse(event.data));
  events.onerror = () => {
    setLink('lost');
    if (events?.readyState === EventSource.CLOSED) setTimeout(meet, kRetry_ms);
  };
}

export function disconnect() {
  events?.close();
  events = null;
  setLink('waiting');
}

// Looks whether the desk knows this browser, and listens where it does.
export async function meet() {
  disconnect();
  try {
    const {paired} = await (await fetch('/hello')).json();
    if (!paired) return onUnpaired();
    document.body.dataset.view = 'desk';
    if (!document.hidden) open();
  } catch {
    setLink('lost');
    setTimeout(meet, kRetry_ms);
  }
}

// Listens while the page can be seen; a hidden page costs the box nothing.
export function begin(unpaired) {
  onUnpaired = unpaired;
  document.addEventListener('visibilitychange', () => {
    if (document.body.dataset.view !== 'desk') return;
    if (document.hidden) disconnect();
    else if (!events) meet();
  });
  meet();
}
