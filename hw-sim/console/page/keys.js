// The keyboard: caps on the page, and the real one, both as usages of HID page 7.
import {caption} from './buttons.js';
import {make, onHold} from './drag.js';
import {sendLast, tell} from './wire.js';

// KeyboardEvent.code -> usage (HID Usage Tables, keyboard page).
const kUsages = new Map();
const kNames = new Map();

function addRun(first, codes, names = codes) {
  codes.forEach((code, n) => {
    kUsages.set(code, first + n);
    kNames.set(first + n, names[n]);
  });
}
const letters = [...'ABCDEFGHIJKLMNOPQRSTUVWXYZ'];
addRun(0x04, letters.map((letter) => `Key${letter}`), letters);
addRun(0x1e, [...'1234567890'].map((digit) => `Digit${digit}`), [...'1234567890']);
addRun(0x28, ['Enter', 'Escape', 'Backspace'], ['Enter', 'Esc', '⌫']);
addRun(0x2c, ['Space', 'Minus', 'Equal', 'BracketLeft', 'BracketRight', 'Backslash'], ['Space', '-', '=', '[', ']', '\\']);
addRun(0x33, ['Semicolon', 'Quote', 'Backquote', 'Comma', 'Period', 'Slash', 'CapsLock'], [';', '\'', '`', ',', '.', '/', 'Caps']);
addRun(0x3a, Array.from({length: 12}, (_, n) => `F${n + 1}`));
addRun(0x49, ['Insert', 'Home', 'PageUp', 'Delete', 'End', 'PageDown', 'ArrowRight', 'ArrowLeft', 'ArrowDown', 'ArrowUp'],
       ['Ins', 'Home', 'PgUp', 'Del', 'End', 'PgDn', '→', '←', '↓', '↑']);
addRun(0x54, ['NumpadDivide', 'NumpadMultiply', 'NumpadSubtract', 'NumpadAdd', 'NumpadEnter', 'Numpad1', 'Numpad2',
              'Numpad3', 'Numpad4', 'Numpad5', 'Numpad6', 'Numpad7', 'Numpad8', 'Numpad9', 'Numpad0', 'NumpadDecimal']);
addRun(0x87, ['IntlRo', 'KanaMode', 'IntlYen', 'Convert', 'NonConvert']);
addRun(0xe0, ['ControlLeft', 'ShiftLeft', 'AltLeft', 'MetaLeft', 'ControlRight', 'ShiftRight', 'AltRight', 'MetaRight']);

const held = new Set();
const caps = new Map();

// These stay with the browser unless the show has a use for them: reload, full screen, tools. And everything
// with Ctrl, Alt or Meta.
const kBrowsers = new Set(['F5', 'F11', 'F12']);
const isBrowsers = (event) => event.ctrlKey || event.altKey || event.metaKey ||
    (kBrowsers.has(event.code) && !caps.has(kUsages.get(event.code)));

export function holdKey(usage, down) {
  if (down === held.has(usage)) return;
  if (down) held.add(usage);
  else held.delete(usage);
  caps.get(usage)?.classList.toggle('held', down);
  tell(`key usage-${usage} ${down ? 'press' : 'release'}`);
}

const kDown_ms = 70, kUp_ms = 60;  // The show looks at its keys once a frame.
const pause = (ms) => new Promise((done) => setTimeout(done, ms));
let taps = Promise.resolve();

// Down and up again, one after another: what is tapped quicker than the show looks stays in its order.
export function tapKey(...usages) {
  taps = taps.then(async () => {
    usages.forEach((usage) => holdKey(usage, true));
    await pause(kDown_ms);
    [...usages].reverse().forEach((usage) => holdKey(usage, false));
    await pause(kUp_ms);
  });
  return taps;
}

// A key that was let go elsewhere would stay down for ever.
function releaseAll() {
  for (const usage of [...held]) holdKey(usage, false);
}

// What a focused control uses is its own: Enter and Space of a button, arrows of a dial, all of a field. Every other key plays.
function isOfControl({defaultPrevented, target, code}) {
  if (defaultPrevented || target.matches('input, select')) return true;
  return target.matches('button') && ['Enter', 'NumpadEnter', 'Space'].includes(code);
}

function listenToKeyboard() {
  window.addEventListener('keydown', (event) => {
    const usage = kUsages.get(event.code);
    if (usage === undefined || isBrowsers(event) || isOfControl(event)) return;
    event.preventDefault();
    if (!event.repeat) holdKey(usage, true);
  });
  window.addEventListener('keyup', (event) => {
    const usage = kUsages.get(event.code);
    if (usage !== undefined) holdKey(usage, false);
  });
  window.addEventListener('blur', releaseAll);
  window.addEventListener('pagehide', () => sendLast([...held].map((usage) => `key usage-${usage} release`)));
}

function makeCap({usage, text, group}) {
  const key = kNames.get(usage) ?? `#${usage}`;
  const cap = make('button', {type: 'button', class: 'cap', 'data-group': group, 'aria-label': `${text || key}: key ${key}`},
                   make('kbd', {}, key), make('span', {class: 'text'}, text));
  if (key === 'Space') cap.classList.add('wide');
  onHold(cap, {push: () => holdKey(usage, true), release: () => holdKey(usage, false)});
  caps.set(usage, cap);
  return cap;
}

const kShift = 0xe1, kBackspace = 0x2a, kEnter = 0x28, kMinus = 0x2d;

function tapLetter(letter) {
  const usage = kUsages.get(`Key${letter.toUpperCase()}`) ?? kUsages.get(`Digit${letter}`) ?? ('-_ '.includes(letter) ? kMinus : null);
  if (usage === null) return;
  tapKey(...(/[A-Z]/.test(letter) ? [kShift, usage] : [usage]));
}

// Fingers have no keys: what they write here is typed on the show's keyboard, letter by letter.
export function makeTypingField() {
  const field = make('input', {type: 'text', class: 'typing', placeholder: 'type', 'aria-label': 'Type on the keyboard',
                               autocomplete: 'off', autocapitalize: 'none', autocorrect: 'off', spellcheck: 'false'});
  let before = '';
  field.addEventListener('input', () => {
    const now = field.value;
    let same = 0;
    while (same < now.length && now[same] === before[same]) ++same;
    for (let n = same; n < before.length; ++n) tapKey(kBackspace);
    [...now.slice(same)].forEach(tapLetter);
    before = now;
  });
  field.addEventListener('keydown', (event) => {
    if (event.key !== 'Enter') return;
    tapKey(kEnter);
    field.value = before = '';
    field.blur();
  });
  const offer = () => {
    field.value = before = '';
    if (window.matchMedia('(hover: none)').matches) field.focus();
  };
  return {element: field, offer};
}

// Keys of one group stand together; the ways of drawing in the order of their keys on the keyboard, the others as the
// labels have them.
function inOrder(labels) {
  const rows = 'QWERTYUIOPASDFGHJKLZXCVBNM';
  const position = ({usage}) => rows.indexOf(kNames.get(usage) ?? ' ');
  const styles = labels.filter(({group}) => group === 'style').sort((a, b) => position(a) - position(b));
  return [...labels.filter(({group}) => group !== 'style'), ...styles];
}

export function makeKeys(parent, labels) {
  const ordered = inOrder(labels);
  ordered.forEach((label, n) => {
    const text = caption(label.group, ordered[n - 1]?.group);
    if (text) parent.append(make('span', {class: 'caption', 'data-group': label.group}, text));
    parent.append(makeCap(label));
  });
  listenToKeyboard();
}
