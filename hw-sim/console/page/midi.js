// The last messages of MIDI surfaces in words, and what each of them is for by the files of the surface and of the show.
import {make} from './drag.js';
import {onState} from './wire.js';

const kMost = 16;  // As board::MidiHeard keeps.
const kNone = -1;

// A dial or a button of the board, and what the show has on it; of buttons on the sheet that is there.
function purpose(dial, button, labels, sheet) {
  if (dial !== kNone) return `dial ${dial + 1}: ${labels.dials[dial]?.text || 'nothing'}`;
  if (button === kNone) return 'unknown: no dial and no button of a surface';
  const buttons = sheet === 1 ? labels.second_buttons : labels.buttons;
  return `button ${button + 1}: ${buttons[button]?.text || 'nothing'}`;
}

function makeMessage([, device, words, dial, button], labels, sheet) {
  const does = make('span', {class: 'does'}, `\u2192 ${purpose(dial, button, labels, sheet)}`);
  return make('li', {class: dial === kNone && button === kNone ? 'unknown' : ''},
              make('span', {class: 'device'}, device), make('span', {class: 'words'}, words), does);
}

// A row stays as it was written: the sheet may change later. The newest one is on top.
export function makeMidi(parent, labels) {
  const words = make('p', {class: 'doing'}, 'No MIDI surface has sent anything yet.');
  const list = make('ol', {'aria-label': 'Last MIDI messages', tabindex: '0'});
  parent.append(words, list);
  let seen = null;
  onState(({on_stage: now}) => {
    const messages = now?.midi ?? [];
    if (messages.length === 0) return;
    words.hidden = true;
    const fresh = messages.filter(([count]) => seen === null || count > seen || count + kMost < seen);
    for (const message of fresh) list.prepend(makeMessage(message, labels, now.sheet));
    seen = messages.at(-1)[0];
    while (list.children.length > kMost) list.lastElementChild.remove();
  });
}
