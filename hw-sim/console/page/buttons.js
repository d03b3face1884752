// The 32 lit buttons of the box: 4 rows of 8, as on the table. A lamp is what the show says, never a guess.
import {make, onHold} from './drag.js';
import {onState, tell} from './wire.js';

function makeButton({text, group}, number) {
  const name = text ? `Button ${number}: ${text}` : `Button ${number}`;
  const button = make('button', {type: 'button', 'aria-label': name, 'aria-pressed': 'false', 'data-group': group},
                      make('span', {class: 'lamp'}), make('span', {class: 'text'}, text || `${number}`));
  if (!text) button.classList.add('blank');
  onHold(button, {
    push: () => tell(`hold ${number}`),
    release: () => tell(`release ${number}`),
  });
  return button;
}

export function makeButtons(parent, labels) {
  const buttons = labels.map((label, n) => makeButton(label, n + 1));
  parent.append(...buttons);
  onState(({lamps}) => buttons.forEach((button, n) => {
    const lit = ((lamps >>> n) & 1) === 1;
    button.classList.toggle('lit', lit);
    button.setAttribute('aria-pressed', String(lit));
  }));
}
