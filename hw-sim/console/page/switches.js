// The panel of GPIO lines: GO, BACK and PANIC, switches that stay as they are put, and the tally lamp that the box drives.
import {make, onHold} from './drag.js';
import {onState, tell} from './wire.js';

// Line, caption, what it does. The first ones are held; the others latch.
const kHeld = [
  ['go', 'GO', 'The foot switch: plays the cue that stands by'],
  ['back', 'Back', 'A push button: holds what runs; again, or where nothing runs: to the cue before'],
  ['panic', 'Panic', 'A push button: ends what runs, and the panic scene; again while it comes: at once'],
];
const kLatching = [
  ['blackout', 'Blackout', 'Fades the picture to black and back; everything plays on beneath'],
  ['service', 'Service', 'The key switch: the screen says how the lips are calibrated'],
  ['presence', 'Presence', 'Somebody stands before the box'],
];

function makeHeld([line, text, help]) {
  const button = make('button', {type: 'button', class: line, title: help, 'aria-label': `${text}: ${help}`}, text);
  onHold(button, {push: () => tell(`line ${line} on`), release: () => tell(`line ${line} off`)});
  return button;
}

// `bit` is the line's number in the state's `lines.closed`.
function makeSwitch([line, text, help], bit) {
  const button = make('button', {type: 'button', title: help, 'aria-label': `${text}: ${help}`, 'aria-pressed': 'false'}, text);
  let on = false;
  button.addEventListener('click', () => tell(`line ${line} ${on ? 'off' : 'on'}`));
  button.addEventListener('mousedown', (event) => event.preventDefault());  // The focus stays where it was.
  onState(({lines}) => {
    on = ((lines.closed >>> bit) & 1) === 1;
    button.setAttribute('aria-pressed', String(on));
  });
  return button;
}

export function makeSwitches(parent) {
  const lamp = make('span', {class: 'tally', role: 'img'}, 'Tally');
  lamp.title = 'The tally lamp: lit by the box while the show is live and not blacked out';
  parent.append(...kHeld.map(makeHeld), ...kLatching.map((one, n) => makeSwitch(one, n + 1)), lamp);
  onState(({lines}) => {
    lamp.classList.toggle('lit', lines.tally);
    lamp.setAttribute('aria-label', `Tally lamp: ${lines.tally ? 'lit' : 'dark'}`);
  });
}
