// The needles: in this mode the mouse over the picture is the show's own pointer, and a row of tools presses the
// keys that make an expression. Whether they are open is the simulator's word: who pressed Tab, and is the stage there.
import {clamp, make, onHold, positionIn} from './drag.js';
import {holdKey, makeTypingField, tapKey} from './keys.js';
import {add, sendLast, onState, set, tell} from './wire.js';

const kTab = 0x2b, kEscape = 0x29, kShift = 0xe1;

// What is written on a tool, its key, what it does, and the usages that it holds.
const kTools = [
  ['Keys', 'H', 'all of them in the picture, or few', [0x0b]],
  ['Mirror', 'M', 'both sides together', [0x10]],
  ['Smooth', 'S', 'the skin about a needle follows', [0x16]],
  ['Zero', '⌫', 'this needle back to its rest', [0x2a]],
  ['Undo', 'Z', '', [0x1d]],
  ['Redo', 'Y', '', [0x1c]],
  ['Compare', 'C', 'held: as it was before', [0x06]],
  ['Name', 'N', 'then type', [0x11]],
  ['Save', '⏎', '', [0x28]],
  ['As new', '⇧⏎', 'saved under another name', [kShift, 0x28]],
  ['Delete', 'Del', 'twice: away with it', [0x4c]],
];
const kTyped = new Set(['Name', 'As new']);

// The show reads its input once a frame: a chord must last that long.
const kLeastHold_ms = 130;

const kPixelsPerNotch = 100;
const kButtons = [1, 3, 2];  // Of a mouse event: left, middle, right; the pointer's third is the middle one.

let open = false;
let edges = 0;  // A move must not overtake the push before it: after each edge moves begin a new slot.

export const editorIsOpen = () => open;

function pointerLine(picture, event) {
  const {x, y} = positionIn(picture, event);
  const part = (value) => clamp((value + 1) / 2, 0, 1).toFixed(5);
  return `pointer ${part(x)} ${part(-y)}`;
}

function edge(...lines) {
  ++edges;
  lines.forEach(tell);
}

// For onDrag: the first button of the pointer, by mouse or finger.
export function pointing(picture) {
  let held = false;
  window.addEventListener('pagehide', () => sendLast(held ? ['release pointer'] : []));
  return {
    begin: (event) => {
      held = true;
      edge(pointerLine(picture, event), 'press pointer');
    },
    move: (event) => set(`pointer ${edges}`, pointerLine(picture, event)),
    end: () => {
      held = false;
      edge('release pointer');
    },
  };
}

// What the mouse does besides dragging: it moves, it pushes the other buttons, it turns the wheel.
function hover(picture) {
  const others = new Map();
  picture.addEventListener('pointermove', (event) => {
    if (open && event.pointerType === 'mouse') set(`pointer ${edges}`, pointerLine(picture, event));
  });
  picture.addEventListener('mousedown', (event) => {
    if (!open || event.button === 0 || !(event.button in kButtons)) return;
    others.set(event.button, kButtons[event.button]);
    edge(pointerLine(picture, event), `press pointer ${kButtons[event.button]}`);
  });
  window.addEventListener('mouseup', (event) => {
    const button = others.get(event.button);
    if (others.delete(event.button)) edge(`release pointer ${button}`);
  });
  picture.addEventListener('wheel', (event) => {
    if (!open) return;
    event.preventDefault();
    add('roll pointer', clamp(-event.deltaY / kPixelsPerNotch, -9, 9));
  }, {passive: false});
}

function makeTool([text, key, help, usages], typing) {
  const label = help ? `${text}: ${help}` : text;
  const tool = make('button', {type: 'button', class: 'tool', title: label, 'aria-label': label},
                    make('span', {class: 'text'}, text), make('kbd', {}, key));
  let since = 0;
  onHold(tool, {
    push: () => {
      since = performance.now();
      usages.forEach((usage) => holdKey(usage, true));
    },
    release: () => {
      const letGo = () => [...usages].reverse().forEach((usage) => holdKey(usage, false));
      setTimeout(letGo, Math.max(0, kLeastHold_ms - (performance.now() - since)));
      if (kTyped.has(text)) typing.offer();
    },
  });
  return tool;
}

function makeRoll(text, help, notches) {
  const roll = make('button', {type: 'button', class: 'tool', title: help, 'aria-label': help}, text);
  onHold(roll, {push: () => add('roll pointer', notches), release: () => {}});
  return roll;
}

// Escape first: while a name is typed, Tab would leave that alone.
async function toggle() {
  if (open) await tapKey(kEscape);
  await tapKey(kTab);
}

export function makeEditor(stage, picture) {
  const typing = makeTypingField();
  const tools = make('div', {class: 'tools'}, ...kTools.map((tool) => makeTool(tool, typing)), typing.element);
  const mouse = make('div', {class: 'mouse', 'data-port': 'pointer'}, makeRoll('Out', 'The needle outwards', 1),
                     makeRoll('In', 'The needle inwards', -1));
  const toggle_button = make('button', {type: 'button', class: 'tool switch', 'aria-pressed': 'false'}, 'Needles');
  toggle_button.addEventListener('click', toggle);
  toggle_button.addEventListener('mousedown', (event) => event.preventDefault());
  tools.append(mouse);
  stage.append(make('div', {id: 'needles', role: 'toolbar', 'aria-label': 'Needles'}, tools, toggle_button));
  hover(picture);
  onState((state) => {
    open = state.editor_open;
    document.body.dataset.needles = open ? 'open' : 'shut';
    toggle_button.setAttribute('aria-pressed', String(open));
  });
}
