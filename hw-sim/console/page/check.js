// The line check: what of the show's controls and devices was seen, what fails, and the calls that begin and end it.
import {make} from './drag.js';
import {call, onState} from './wire.js';

const kBegin = 1, kEnd = 0, kLampsWereLit = 2;
const kStates = ['missing', 'noisy', 'stuck', 'short', 'unseen', 'seen'];  // As board::CheckedState counts; the first four fail.
const kService = 2;  // The key switch among the lines.

function makeCall(text, what) {
  const button = make('button', {type: 'button'}, text);
  button.addEventListener('click', () => call(`check ${what}`));
  return button;
}

// In words what is to be done, or what came of it.
function doing(check, inService) {
  if (check?.running) {
    const seen = check.items.filter(([, , state]) => kStates[state] === 'seen').length;
    return `${seen} of ${check.items.length} are seen. Move each control to both ends, first right, forwards, up or clockwise. ` +
        'No control moves the face.';
  }
  const last = check ? `The last one: ${check.summary}. ` : '';
  return last + (inService ? '' : 'Turn the service key on to begin one.');
}

// A device with its items: those that fail first.
function makeDevice(name, items) {
  const list = make('ul', {}, ...[...items].sort((a, b) => a[2] - b[2]).map(([, words, state]) =>
      make('li', {'data-state': kStates[state]}, words)));
  return make('li', {}, make('span', {class: 'title'}, name), list);
}

function show(list, items) {
  const devices = new Map();
  for (const item of items) devices.set(item[0], [...(devices.get(item[0]) ?? []), item]);
  list.replaceChildren(...[...devices].map(([name, all]) => makeDevice(name, all)));
}

export function makeCheck(parent) {
  const begin = makeCall('Begin', kBegin), end = makeCall('End', kEnd), lamps = makeCall('All lamps were lit', kLampsWereLit);
  const words = make('p', {class: 'doing', 'aria-live': 'polite'});
  const list = make('ol', {'aria-label': 'Controls and devices'});
  parent.append(make('div', {class: 'calls', role: 'group', 'aria-label': 'Calls of the line check'}, begin, end, lamps), words, list);
  let told = '';
  onState(({on_stage: now, lines}) => {
    const check = now?.check ?? null;
    const inService = ((lines.closed >>> kService) & 1) === 1;
    begin.disabled = !inService || !now;
    end.disabled = lamps.disabled = !check?.running;
    const text = doing(check, inService);
    if (words.textContent !== text) words.textContent = text;
    const items = JSON.stringify(check?.items ?? []);
    if (items !== told) show(list, check?.items ?? []);
    told = items;
  });
}
