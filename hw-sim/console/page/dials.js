// Eight dials without an end: drag the cap up and down or the rim round, turn the wheel, press the arrow keys.
import {make, onDrag, placeIn} from './drag.js';
import {onState, turn} from './wire.js';

const kTurnPixels = 180;         // Drag for one whole turn.
const kWheelTurns = 1 / 2400;    // For each pixel of wheel.
const kRimRadius = 0.72;         // Outside of it a drag goes round.
const kLocalTime_ms = 400;       // How long our own hand is believed before the box's word.
const kKeySteps = new Map([
  ['ArrowUp', 1 / 32], ['ArrowRight', 1 / 32], ['ArrowDown', -1 / 32], ['ArrowLeft', -1 / 32],
  ['PageUp', 1 / 4], ['PageDown', -1 / 4],
]);

const kDrawing = `
  <svg viewBox="0 0 100 100" aria-hidden="true">
    <circle class="ticks" cx="50" cy="50" r="46" pathLength="24"/>
    <circle class="sweep" cx="50" cy="50" r="46" pathLength="100"/>
    <g class="cap">
      <circle class="rim" cx="50" cy="50" r="37"/>
      <circle class="face" cx="50" cy="50" r="31"/>
      <path class="mark" d="M50 16V30"/>
    </g>
  </svg>`;

class Dial {
  constructor(number, label) {
    this.number = number;
    this.turns = 0;
    this.touched_ms = -Infinity;
    this.knob = make('div', {
      class: 'knob', role: 'slider', tabindex: '0', 'aria-label': `Dial ${number}: ${label || 'no name'}`,
    });
    this.knob.innerHTML = kDrawing;
    this.element = make('div', {class: 'dial'}, this.knob, make('span', {class: 'name'}, label || `${number}`));
    this.cap = this.knob.querySelector('.cap');
    this.sweep = this.knob.querySelector('.sweep');
    this.listen();
    this.show();
  }

  listen() {
    onDrag(this.knob, {begin: (event) => this.grip(event), move: (event) => this.drag(event)});
    this.knob.addEventListener('wheel', (event) => {
      event.preventDefault();
      this.turnBy(-event.deltaY * kWheelTurns * (event.deltaMode === 1 ? 33 : 1));
    }, {passive: false});
    this.knob.addEventListener('keydown', (event) => {
      const step = kKeySteps.get(event.code);
      if (step === undefined) return;
      event.preventDefault();
      this.turnBy(event.shiftKey ? step / 8 : step);
    });
  }

  angle_turns(event) {
    const {x, y} = placeIn(this.knob, event);
    return Math.atan2(x, y) / (2 * Math.PI);
  }

  grip(event) {
    const {x, y} = placeIn(this.knob, event);
    this.goesRound = Math.hypot(x, y) > kRimRadius;
    this.last = {x: event.clientX, y: event.clientY, angle_turns: this.angle_turns(event)};
  }

  drag(event) {
    const now = {x: event.clientX, y: event.clientY, angle_turns: this.angle_turns(event)};
    const way = now.angle_turns - this.last.angle_turns;
    const round = way - Math.round(way);  // The short way across the top.
    const straight = (this.last.y - now.y + now.x - this.last.x) / kTurnPixels;
    this.last = now;
    this.turnBy((this.goesRound ? round : straight) * (event.shiftKey ? 1 / 8 : 1));
  }

  turnBy(turns) {
    if (turns === 0) return;
    this.turns += turns;
    this.touched_ms = performance.now();
    this.show();
    turn(this.number, turns);
  }

  // What the box says counts, but not while it is still on its way here.
  follow(turns) {
    if (performance.now() - this.touched_ms < kLocalTime_ms || turns === this.turns) return;
    this.turns = turns;
    this.show();
  }

  show() {
    this.cap.style.transform = `rotate(${(this.turns * 360).toFixed(2)}deg)`;
    const part = this.turns - Math.trunc(this.turns);
    this.sweep.style.strokeDasharray = `${Math.abs(part) * 100} 100`;
    this.sweep.style.transform = part < 0 ? 'rotate(-90deg) scaleY(-1)' : 'rotate(-90deg)';
    this.knob.setAttribute('aria-valuenow', Math.round(this.turns * 100));
    this.knob.setAttribute('aria-valuetext', `${this.turns.toFixed(2)} turns`);
  }
}

export function makeDials(parent, labels) {
  const dials = labels.map((label, n) => new Dial(n + 1, label));
  parent.append(...dials.map((dial) => dial.element));
  onState((state) => dials.forEach((dial, n) => dial.follow(state.dials[n])));
}
