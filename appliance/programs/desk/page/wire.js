// The connection to kaori-desk: commands go out by POST, states come in as server-sent events.
import {complaint, text} from './texts.js';

const kRetry_ms = 1000;
const kAnswerTimeout_ms = 4000;
const kPart_bytes = 65536;  // The desk takes no longer requests.

const listeners = [];
const boxListeners = [];
const waiting = new Map();  // The number of a command -> the function that gets its answer.
const sending = new Map();  // The name of a value -> its newest text, while one is on its way.
let events = null;
let boxEvents = null;
let gesture = Math.floor(Math.random() * 1e6);
let onUnpaired = () => {};

function setLink(link) {
  document.body.dataset.link = link;
  for (const listener of listeners) listener(null);
}

export function onState(listener) {
  listeners.push(listener);
}

// Calls `listener` with each state of the box (machine.js), and with null while there is none.
export function onBox(listener) {
  boxListeners.push(listener);
}

let toastTimer = 0;
export function toast(message, bad = false) {
  const element = document.getElementById('toast');
  element.textContent = message;
  element.classList.toggle('bad', bad);
  element.classList.add('shown');
  clearTimeout(toastTimer);
  toastTimer = setTimeout(() => element.classList.remove('shown'), bad ? 4000 : 1800);
}

// `gone` is the text of a program that does not answer.
async function post(path, body, gone) {
  const reply = await fetch(path, {method: 'POST', body});
  if (reply.status === 401) {
    disconnect();
    onUnpaired();
    throw new Error('unpaired');
  }
  if (reply.status === 503) throw new Error(text(gone));
  if (!reply.ok) throw new Error((await reply.text()).trim());
  return reply;
}

async function send(command) {
  return (await (await post('/do', command, 'gone')).json()).number;
}

function showFault(error) {
  if (error.message !== 'unpaired') toast(error instanceof TypeError ? text('lost') : error.message, true);
}

// Hands a request to the box itself; what comes of it stands in its next state. Returns whether it was taken.
export async function askBox(request) {
  try {
    await post('/box', request, 'machineGone');
    return true;
  } catch (error) {
    showFault(error);
    return false;
  }
}

// Sends a command, waits until the lips have executed it, and shows `done` or the complaint. Returns whether it succeeded.
export async function ask(command, done) {
  try {
    const number = await send(command);
    const answer = await new Promise((resolve) => {
      waiting.set(number, resolve);
      setTimeout(() => waiting.delete(number) && resolve(text('noLips')), kAnswerTimeout_ms);
    });
    toast(answer === '' ? done ?? '' : complaint(answer), answer !== '');
    return answer === '';
  } catch (error) {
    showFault(error);
    return false;
  }
}

// Brings a backup in parts, and has the box look at it. `tell` hears how much of it is there. Returns whether it was taken.
export async function bring(file, tell) {
  try {
    for (let at = 0; at < file.size; at += kPart_bytes) {
      await post(`/brought/${at}`, file.slice(at, at + kPart_bytes), 'machineGone');
      tell(Math.min(1, (at + kPart_bytes) / file.size));
    }
  } catch (error) {
    showFault(error);
    return false;
  }
  return askBox(`restore ${file.name}`);
}

// Sends a value that a slider sets: only the newest value counts, and all values of one gesture are one change.
export async function set(name, value) {
  const busy = sending.has(name);
  sending.set(name, value);
  if (busy) return;
  while (true) {
    const now = sending.get(name);
    try {
      await send(`set ${name} ${now} ${gesture}`);
    } catch (error) {
      showFault(error);
    }
    if (sending.get(name) === now) break;
  }
  sending.delete(name);
}

export function newGesture() {
  gesture = gesture % 1e6 + 1;
}

function handleState(state) {
  const report = state.report;
  if (report && waiting.has(report.answered)) {
    waiting.get(report.answered)(report.complaint);
    waiting.delete(report.answered);
  }
  for (const listener of listeners) listener(state);
}

// Of its own, since settings are long and a mouth moves many times a second.
function openBox() {
  boxEvents = new EventSource('/box/events');
  boxEvents.onmessage = (event) => {
    const state = JSON.parse(event.data);
    for (const listener of boxListeners) listener(state);
  };
}

function open() {
  openBox();
  events = new EventSource('/events');
  events.onopen = () => setLink('live');
  events.onmessage = (event) => handleState(JSON.parse(event.data));
  events.onerror = () => {
    setLink('lost');
    if (events?.readyState === EventSource.CLOSED) setTimeout(meet, kRetry_ms);
  };
}

export function disconnect() {
  events?.close();
  events = null;
  boxEvents?.close();
  boxEvents = null;
  for (const listener of boxListeners) listener(null);
  setLink('waiting');
}

// Asks whether the desk knows this browser, and listens to its events if it does.
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

// Listens while the page is visible; a hidden page costs the box nothing.
export function begin(unpaired) {
  onUnpaired = unpaired;
  document.addEventListener('visibilitychange', () => {
    if (document.body.dataset.view !== 'desk') return;
    if (document.hidden) disconnect();
    else if (!events) meet();
  });
  meet();
}
