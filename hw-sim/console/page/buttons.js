// The 32 lit buttons of the box: 4 rows of 8, as on the table. A lamp is what the show says, never a guess.
import {make, onHold} from './drag.js';
import {onState, tell} from './wire.js';

const kColumns = 8;
const kCaptions = new Map([
  ['face', 'Faces'], ['expression', 'Expressions'], ['style', 'Drawing styles'], ['scene', 'Scenes'],
  ['cue', 'Cue list'], ['blink', 'Eyes'], ['motion', 'Motions'],
]);

// What stands above the first button of each run of one group.
export function caption(group, groupBefore) {
  return group && group !== groupBefore ? kCaptions.get(group) ?? '' : '';
}

// What the button calls on the sheet that is there.
function write(button, {text, group}, number) {
  button.setAttribute('aria-label', text ? `Button ${number}: ${text}` : `Button ${number}`);
  button.dataset.group = group;
  button.querySelector('.text').textContent = text || `${number}`;
  button.classList.toggle('blank', !text);
}

function makeButton(label, number) {
  const button = make('button', {type: 'button', 'aria-pressed': 'false'},
                      make('span', {class: 'lamp'}), make('span', {class: 'text'}));
  write(button, label, number);
  onHold(button, {
    push: () => tell(`hold ${number}`),
    release: () => tell(`release ${number}`),
  });
  return button;
}

function makeRow(buttons, captions) {
  const row = make('div', {class: 'row'}, ...buttons.map((button, n) => {
    const cell = make('div', {class: 'cell'}, button);
    if (captions[n]) cell.prepend(make('span', {class: 'caption', 'data-group': button.dataset.group}, captions[n]));
    return cell;
  }));
  if (captions.some((text) => text)) row.classList.add('captioned');
  return row;
}

// `sheets`: the labels of both; captions stand above the first one's alone.
export function makeButtons(parent, sheets) {
  const [labels] = sheets;
  let shown = 0;
  const buttons = labels.map((label, n) => makeButton(label, n + 1));
  const captions = labels.map(({group}, n) => caption(group, labels[n - 1]?.group));
  for (let first = 0; first < buttons.length; first += kColumns)
    parent.append(makeRow(buttons.slice(first, first + kColumns), captions.slice(first, first + kColumns)));
  onState(({lamps, on_stage: now}) => {
    const sheet = now?.sheet === 1 ? 1 : 0;
    if (sheet !== shown) buttons.forEach((button, n) => write(button, sheets[sheet][n], n + 1));
    shown = sheet;
    parent.classList.toggle('second', sheet === 1);
    buttons.forEach((button, n) => {
      const lit = ((lamps >>> n) & 1) === 1;
      button.classList.toggle('lit', lit);
      button.setAttribute('aria-pressed', String(lit));
    });
  });
}
