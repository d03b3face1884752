// Eight dials without an end: drag the cap up and down or the rim round, turn the wheel, press the arrow keys.
// Where a dial plays a value that has an end, the cap points to it, and a double click puts it back.
import {clamp, make, onDrag, positionIn} from './drag.js';
import {onState, turn} from './wire.js';

const kTurnPixels = 180;         // Drag for one whole turn.
const kWheelTurns = 1 / 2400;    // For each pixel of wheel.
const kRimRadius = 0.72;         // Outside of it a drag goes round.
const kLocalTime_ms = 400;       // How long this page's own turn counts before what the box says.
const kArc = 0.75;               // Of a circle, from the least value to the most; open below.
const kKeySteps = new Map([
  ['ArrowUp', 1 / 32], ['ArrowRight', 1 / 32], ['ArrowDown', -1 / 32], ['ArrowLeft', -1 / 32],
  ['PageUp', 1 / 4], ['PageDown', -1 / 4],
]);

const kDrawing = `
  <svg viewBox="0 0 100 100" aria-hidden="true">
    <circle class="track" cx="50" cy="50" r="45" pathLength="100"/>
    <circle class="sweep" cx="50" cy="50" r="45" pathLength="100"/>
    <g class="cap">
      <circle class="rim" cx="50" cy="50" r="36"/>
      <circle class="face" cx="50" cy="50" r="30"/>
      <path class="mark" d="M50 17V31"/>
    </g>
  </svg>`;

const kUnits = {
  '%': (value) => `${Math.round(value * 100)} %`,
  's': (value) => `${value.toFixed(1)} s`,
  '': (value) => value.toFixed(2),
};

class Dial {
  constructor(number, label) {
    Object.assign(this, {number, label, turns: 0, value: label.start, touched_ms: -Infinity});
    this.hasValue = label.high > label.low;
    this.knob = make('div', {
      class: 'knob', role: 'slider', tabindex: '0', 'aria-label': `Dial ${number}: ${label.text || 'no name'}`,
    });
    this.knob.innerHTML = kDrawing;
    this.reading = make('span', {class: 'reading'});
    this.element = make('div', {class: 'dial'}, this.knob, make('span', {class: 'name'}, label.text || `${number}`),
                        this.reading);
    this.cap = this.knob.querySelector('.cap');
    this.sweep = this.knob.querySelector('.sweep');
    if (this.hasValue) this.element.classList.add('valued');
    this.listen();
    this.show();
  }

  listen() {
    onDrag(this.knob, {begin: (event) => this.grip(event), move: (event) => this.drag(event)});
    this.knob.addEventListener('wheel', (event) => {
      event.preventDefault();
      this.turnBy(-event.deltaY * kWheelTurns * (event.deltaMode === 1 ? 33 : 1));
    }, {passive: false});
    if (this.hasValue) {
      this.knob.title = 'Drag up or down; double click puts it back';
      this.knob.addEventListener('dblclick', () => this.turnBy((this.label.start - this.value) / this.label.per_turn));
    }
    this.knob.addEventListener('keydown', (event) => {
      const step = kKeySteps.get(event.code);
      if (step === undefined) return;
      event.preventDefault();
      this.turnBy(event.shiftKey ? step / 8 : step);
    });
  }

  angle_turns(event) {
    const {x, y} = positionIn(this.knob, event);
    return Math.atan2(x, y) / (2 * Math.PI);
  }

  grip(event) {
    const {x, y} = positionIn(this.knob, event);
    this.goesRound = Math.hypot(x, y) > kRimRadius;
    this.last = {x: event.clientX, y: event.clientY, angle_turns: this.angle_turns(event)};
  }

  drag(event) {
    const now = {x: event.clientX, y: event.clientY, angle_turns: this.angle_turns(event)};
    const way = now.angle_turns - this.last.angle_turns;
    const round = way - Math.round(way);  // The short way across the top.
    const straight = (this.last.y - now.y + now.x - this.last.x) / kTurnPixels;
    this.last = now;
    this.turnBy((this.goesRound ? round * this.turnsRound() : straight) * (event.shiftKey ? 1 / 8 : 1));
  }

  // Turns for which the cap goes once round.
  turnsRound() {
    return this.hasValue ? (this.label.high - this.label.low) / this.label.per_turn / kArc : 1;
  }

  turnBy(turns) {
    if (turns === 0) return;
    this.turns += turns;
    this.value = clamp(this.value + turns * this.label.per_turn, this.label.low, this.label.high);
    this.touched_ms = performance.now();
    this.show();
    turn(this.number, turns);
  }

  // What the box says counts, but not while it is still on its way here.
  follow(turns, value) {
    if (performance.now() - this.touched_ms < kLocalTime_ms || (turns === this.turns && value === this.value)) return;
    this.turns = turns;
    this.value = value;
    this.show();
  }

  show() {
    if (this.hasValue) this.showValue();
    else this.showTurns();
  }

  showTurns() {
    const part = this.turns - Math.trunc(this.turns);
    this.point(this.turns, Math.abs(part));
    this.sweep.style.transform = part < 0 ? 'rotate(-90deg) scaleY(-1)' : 'rotate(-90deg)';
    this.knob.setAttribute('aria-valuenow', Math.round(this.turns * 100));
    this.knob.setAttribute('aria-valuetext', `${this.turns.toFixed(2)} turns`);
  }

  showValue() {
    const {low, high, unit} = this.label;
    const part = (this.value - low) / (high - low);
    const text = (kUnits[unit] ?? kUnits[''])(this.value);
    this.point((part - 0.5) * kArc, part * kArc);
    this.reading.textContent = text;
    this.knob.setAttribute('aria-valuenow', Math.round(part * 100));
    this.knob.setAttribute('aria-valuetext', text);
  }

  // The cap's angle and the length of the lit ring, both in circles.
  point(angle, length) {
    this.cap.style.transform = `rotate(${(angle * 360).toFixed(2)}deg)`;
    this.sweep.style.strokeDasharray = `${(length * 100).toFixed(2)} 200`;
  }
}

export function makeDials(parent, labels) {
  const dials = labels.map((label, n) => new Dial(n + 1, label));
  parent.append(...dials.map((dial) => dial.element));
  onState((state) => dials.forEach((dial, n) => dial.follow(state.dials[n], state.values[n])));
}
