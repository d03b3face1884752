// Two joysticks seen from above: a pad that springs back, a twist that springs back, a slider that stays, and buttons.
// Each of them can be dragged, and can be moved by the arrow keys while it has the focus.
import {onArrows} from './arrows.js';
import {clamp, make, onDrag, onHold, positionIn, springBack} from './drag.js';
import {onState, set, tell} from './wire.js';

const kKeyPart = 0.8;  // Of a control's way, while its arrow key is held.
const kLocalTime_ms = 400;

// A control that is dragged within -1..1 on each axis and says where it stands.
class Pad {
  constructor(element, {springs, send, draw}) {
    Object.assign(this, {element, springs, send, draw, touched_ms: -Infinity});
    this.stop = () => {};
    onDrag(element, {
      begin: (event) => this.follow(event),
      move: (event) => this.follow(event),
      end: () => this.letGo(),
    });
  }

  follow(event) {
    const {x, y} = positionIn(this.element, event);
    this.stop();
    this.put([clamp(x * 1.15, -1, 1), clamp(y * 1.15, -1, 1)]);
  }

  put(value) {
    this.value = value;
    this.touched_ms = performance.now();
    this.draw(value);
    this.send(value);
  }

  // Arrow keys hold the control in this direction, or let it go where it is null.
  lean(direction) {
    if (direction === null) return this.letGo();
    this.stop();
    return this.put(direction.map((value) => value * kKeyPart));
  }

  letGo() {
    if (this.springs) this.stop = springBack(this.value, [0, 0], (value) => this.put(value));
  }

  // The simulator's word, unless this page has moved the control just now.
  update(value) {
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
  onArrows(element, (direction) => pad.lean(direction));
  return pad;
}

function makeTwist(side, name, text) {
  const knob = make('span', {class: 'thumb'});
  const element = make('div', {class: 'twist', tabindex: '0', role: 'slider', 'aria-orientation': 'horizontal',
                               'aria-valuemin': '-100', 'aria-valuemax': '100', 'aria-valuenow': '0',
                               'aria-label': `${name}: ${text}, the twist`,
                               title: 'Drag sideways, or hold the left or the right arrow key'}, knob);
  const pad = new Pad(element, {
    springs: true,
    send: ([x]) => set(`${side} twist`, `${side} twist ${number(x)}`),
    draw: ([x]) => {
      knob.style.left = `${50 + x * 50}%`;
      element.setAttribute('aria-valuenow', Math.round(x * 100));
    },
  });
  onArrows(element, (direction) => pad.lean(direction));
  return pad;
}

function makeSlider(side, name, text) {
  const input = make('input', {type: 'range', min: '0', max: '1', step: '0.005', value: '0', class: 'slide',
                               'aria-label': `${name}: ${text}, the slider`});
  let touched_ms = -Infinity;
  input.addEventListener('input', () => {
    touched_ms = performance.now();
    set(`${side} slide`, `${side} slide ${number(input.valueAsNumber)}`);
  });
  const update = (value) => {
    if (performance.now() - touched_ms > kLocalTime_ms) input.value = value;
  };
  return {element: input, update};
}

// What a button calls stands on it; one that calls nothing has its number. Which is down is the simulator's word.
function makeStickButtons(side, name, labels) {
  const buttons = labels.map(({text, group}, n) => {
    const button = make('button', {type: 'button', 'aria-pressed': 'false', 'data-group': group,
                                   class: text ? '' : 'blank', title: text ? `Button ${n + 1}: ${text}` : `Button ${n + 1}`,
                                   'aria-label': text ? `${name}, button ${n + 1}: ${text}` : `${name}, button ${n + 1}`},
                        text || `${n + 1}`);
    onHold(button, {
      push: () => tell(`${side} hold ${n + 1}`),
      release: () => tell(`${side} release ${n + 1}`),
    });
    return button;
  });
  const update = (down) => buttons.forEach((button, n) => {
    button.setAttribute('aria-pressed', String((down >> n & 1) === 1));
  });
  return {element: make('div', {class: 'stick-buttons', role: 'group', 'aria-label': `${name}: buttons`}, ...buttons), update};
}

export function makeStick(parent, side, label) {
  const name = label.text || (side === 'left' ? 'Left stick' : 'Right stick');
  const pad = makePad(side, name);
  const twist = makeTwist(side, name, label.twist || 'Twist');
  const slider = makeSlider(side, name, label.slide || 'Slider');
  const buttons = makeStickButtons(side, name, label.buttons);
  parent.append(make('h2', {}, name), pad.element, slider.element, twist.element,
                make('span', {class: 'name of-twist'}, label.twist || 'Twist'),
                make('span', {class: 'name of-slide'}, label.slide || 'Slider'), buttons.element);
  onState(({sticks}) => {
    const stick = sticks[side === 'left' ? 0 : 1];
    pad.update([stick.x, stick.y]);
    twist.update([stick.twist, 0]);
    slider.update(stick.slider);
    buttons.update(stick.buttons);
  });
}
