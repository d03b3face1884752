// The operator's lips before the camera: drag down to open, sideways to narrow and widen, or hold the arrow keys; they
// spring shut.
import {onArrows} from './arrows.js';
import {clamp, make, onDrag, positionIn, springBack} from './drag.js';
import {onState, set} from './wire.js';

const kRest = [0, 0];          // Shut, at rest width.
const kShutHeight = 0.25;      // Painted lips have a height even when shut; in widths of the mouth at rest.
const kOpenHeight = 0.85;      // Added when wide open.
const kWidthSpan = 0.4;        // Added or taken at the sides of the pad.
const kKeyOpen = 0.8;          // Of wide open, while the arrow key down is held;
const kKeyWide = 0.8;          // of the way sideways, while left or right is held.
const kLocalTime_ms = 400;

const kDrawing = `
  <svg viewBox="-100 -60 200 160" aria-hidden="true">
    <path class="inside"/><path class="lip upper"/><path class="lip lower"/>
  </svg>`;

// Two lips round an opening: open 0..1, wide -1..1.
function shapes(open, wide) {
  const half = 46 * (1 + wide * 0.36);
  const gap = open * 44;
  const up = 15 - open * 3;
  const low = 19 - open * 2;
  const outerTop = `C${-half * 0.5} ${-up - gap * 0.25} ${-half * 0.22} ${-up * 1.5 - gap * 0.3} 0 ${-up - gap * 0.3}` +
      ` C${half * 0.22} ${-up * 1.5 - gap * 0.3} ${half * 0.5} ${-up - gap * 0.25} ${half} 0`;
  const innerTop = (y) => `Q0 ${y} ${-half} 0`;
  const innerLow = `Q0 ${gap * 1.7 + 3} ${-half} 0`;
  return {
    upper: `M${-half} 0 ${outerTop} ${innerTop(-gap * 0.5 + 3)}Z`,
    lower: `M${-half} 0 C${-half * 0.6} ${low + gap * 0.8} ${-half * 0.25} ${low * 1.35 + gap * 0.88}` +
        ` 0 ${low * 1.35 + gap * 0.88} C${half * 0.25} ${low * 1.35 + gap * 0.88} ${half * 0.6} ${low + gap * 0.8} ${half} 0 ${innerLow}Z`,
    inside: `M${-half} 0 Q0 ${-gap * 0.5} ${half} 0 ${innerLow}Z`,
  };
}

function draw(svg, [open, wide]) {
  for (const [name, path] of Object.entries(shapes(open, wide))) svg.querySelector(`.${name}`).setAttribute('d', path);
}

function send([open, wide]) {
  const height = kShutHeight + open * kOpenHeight;
  const width = 1 + wide * kWidthSpan;
  set('lips', `lips ${height.toFixed(4)} ${width.toFixed(4)}`);
}

// The upper quarter of the pad is shut, its lower edge wide open.
function read(element, event) {
  const {x, y} = positionIn(element, event);
  return [clamp((0.5 - y) / 1.3, 0, 1), clamp(x * 1.15, -1, 1)];
}

export function makeLips(parent) {
  const element = make('div', {class: 'lips', tabindex: '0', role: 'application',
                               'aria-label': 'Lips: drag down to open, sideways to widen, or hold the arrow keys'});
  element.innerHTML = kDrawing;
  parent.append(make('h2', {}, 'Lips'), element,
                make('span', {class: 'name'}, 'Drag down to open, sideways to widen'));
  let value = kRest;
  let touched_ms = -Infinity;
  let stop = () => {};
  const put = (next) => {
    value = next;
    touched_ms = performance.now();
    draw(element, value);
    send(value);
  };
  const follow = (event) => {
    stop();
    put(read(element, event));
  };
  const letGo = () => { stop = springBack(value, kRest, put); };
  onDrag(element, {begin: follow, move: follow, end: letGo});
  onArrows(element, (direction) => {
    if (direction === null) return letGo();
    const [x, y] = direction;
    stop();
    return put([y < 0 ? kKeyOpen : 0, x * kKeyWide]);
  });
  draw(element, kRest);
  onState(({lips}) => {
    if (performance.now() - touched_ms < kLocalTime_ms) return;
    draw(element, [clamp((lips.height - kShutHeight) / kOpenHeight, 0, 1), clamp((lips.width - 1) / kWidthSpan, -1, 1)]);
  });
}
