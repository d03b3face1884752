// Two joysticks seen from above: a pad that springs back, a twist that springs back, a slider that stays.
import {clamp, make, onDrag, placeIn, springBack} from './drag.js';
import {onState, set} from './wire.js';

const kKeys = new Map([['ArrowLeft', [-1, 0]], ['ArrowRight', [1, 0]], ['ArrowUp', [0, 1]], ['ArrowDown', [0, -1]]]);
const kLocalTime_ms = 400;

// A control that is dragged within -1..1 on each axis and says where it stands.
class Pad {
  constructor(element, {springs, send, draw}) {
    Object.assign(this, {element, springs, send, draw, touched_ms: -Infinity});
    this.stop = () => {};
    onDrag(element, {
      begin: (event) => this.take(event),
      move: (event) => this.take(event),
      end: () => this.letGo(),
    });
  }

  take(event) {
    const {x, y} = placeIn(this.element, event);
    this.stop();
    this.put([clamp(x * 1.15, -1, 1), clamp(y * 1.15, -1, 1)]);
  }

  put(value) {
    this.value = value;
    this.touched_ms = performance.now();
    this.draw(value);
    this.send(value);
  }

  letGo() {
    if (this.springs) this.stop = springBack(this.value, [0, 0], (value) => this.put(value));
  }

  follow(value) {
    if (performance.now() - this.touched_ms > kLocalTime_ms) this.draw(value);
  }
}

// A real stick moves in a round hole.
function inCircle([x, y]) {
  const length = Math.max(1, Math.hypot(x, y));
  return [x / length, y / length];
}

const number = (value) => value.toFixed(4);

function makePad(side, name) {
  const knob = make('span', {class: 'thumb'});
  const element = make('div', {class: 'pad', tabindex: '0', role: 'application',
                               'aria-label': `${name}: drag, or press the arrow keys`}, knob);
  const pad = new Pad(element, {
    springs: true,
    send: (value) => set(`${side} move`, `${side} move ${inCircle(value).map(number).join(' ')}`),
    draw: (value) => {
      const [x, y] = inCircle(value);
      knob.style.transform = `translate(${x * 100}%, ${-y * 100}%)`;
    },
  });
  listenToArrows(element, pad);
  return pad;
}

function listenToArrows(element, pad) {
  const held = new Set();
  const lean = () => {
    if (held.size === 0) return pad.letGo();
    const sum = [...held].map((code) => kKeys.get(code)).reduce((a, b) => [a[0] + b[0], a[1] + b[1]], [0, 0]);
    pad.stop();
    return pad.put(sum.map((v) => clamp(v, -1, 1) * 0.8));
  };
  element.addEventListener('keydown', (event) => {
    if (!kKeys.has(event.code)) return;
    event.preventDefault();
    held.add(event.code);
    if (!event.repeat) lean();
  });
  element.addEventListener('keyup', (event) => {
    if (held.delete(event.code)) lean();
  });
  element.addEventListener('blur', () => {
    if (held.size === 0) return;
    held.clear();
    lean();
  });
}

function makeTwist(side, name) {
  const knob = make('span', {class: 'thumb'});
  const element = make('div', {class: 'twist', role: 'application', 'aria-label': `${name}: twist`}, knob);
  return new Pad(element, {
    springs: true,
    send: ([x]) => set(`${side} twist`, `${side} twist ${number(x)}`),
    draw: ([x]) => { knob.style.left = `${50 + x * 50}%`; },
  });
}

function makeSlider(side, name) {
  const input = make('input', {type: 'range', min: '0', max: '1', step: '0.005', value: '0', class: 'slide',
                               'aria-label': `${name}: slider`});
  let touched_ms = -Infinity;
  input.addEventListener('input', () => {
    touched_ms = performance.now();
    set(`${side} slide`, `${side} slide ${number(input.valueAsNumber)}`);
  });
  const follow = (value) => {
    if (performance.now() - touched_ms > kLocalTime_ms) input.value = value;
  };
  return {element: input, follow};
}

export function makeStick(parent, side, label) {
  const name = label.text || (side === 'left' ? 'Left stick' : 'Right stick');
  const pad = makePad(side, name);
  const twist = makeTwist(side, name);
  const slider = makeSlider(side, name);
  parent.append(make('h2', {}, name), pad.element, slider.element, twist.element,
                make('span', {class: 'name of-twist'}, label.twist || 'Twist'),
                make('span', {class: 'name of-slide'}, label.slide || 'Slider'));
  onState(({sticks}) => {
    const stick = sticks[side === 'left' ? 0 : 1];
    pad.follow([stick.x, stick.y]);
    twist.follow([stick.twist, 0]);
    slider.follow(stick.slider);
  });
}
