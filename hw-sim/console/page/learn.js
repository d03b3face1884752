// Learn mode: a level or a call is picked, a control is moved, and what the box found is kept or not.
import {make} from './drag.js';
import {call, onState} from './wire.js';

const kEnd = 0, kBegin = 1, kKeep = 2, kTurnRound = 3;  // As board::LearnCall counts.
const kPhases = ['never', 'asking', 'found', 'unfit', 'keeping', 'kept', 'refused', 'ended'];  // As board::LearnPhase counts.
const kService = 2;  // The key switch among the lines.

function makeCall(text, what, choice = () => 0) {
  const button = make('button', {type: 'button'}, text);
  button.addEventListener('click', () => call(`learn ${what} ${choice()}`));
  return button;
}

const isCall = (level) => level.startsWith('Call ');
const isTurn = (level) => level === 'One turn of a dial';

// Of the lesson of a turn, which is no control for a level.
function doingTurn(learn) {
  switch (kPhases[learn.phase]) {
    case 'found': return `${learn.control} went ${learn.counts} counts. Was it one whole turn? Keep it, or turn once more.`;
    case 'keeping': return `${learn.control} is being kept.`;
    case 'kept': return `What one turn of ${learn.control} has is kept, for all dials of its device.`;
    case 'refused': return `What one turn of ${learn.control} has could not be kept; the log says why.`;
    default: return `Turn one dial once around, and let it stand.${hindrance(learn)}`;
  }
}

// What hinders the search, if anything does.
function hindrance(learn) {
  if (learn.restless) return ` ${learn.restless} does not rest, so that it is passed over.`;
  return learn.ambiguous ? ' Two at once: move one alone.' : '';
}

// In words what was found, or what is to be done.
function doing(learn, level, inService) {
  if (!learn) return inService ? 'Pick a level or a call, press Teach, and move the control or push the button that is to play it.' : 'Turn the service key on to teach.';
  if (isTurn(level)) return doingTurn(learn);
  const control = `${learn.control}${learn.inverted ? ', inverted,' : ''}`;
  switch (kPhases[learn.phase]) {
    case 'found': return `${level}: ${control} is to ${isCall(level) ? 'make' : 'play'} it${learn.instead ? ', in place of what it does now' : ''}. Keep it?`;
    case 'unfit': return `${level}: ${control} springs back, and this level rests at an end. Move a slider or a dial.`;
    case 'keeping': return `${level}: ${control} is being kept.`;
    case 'kept': return `${level}: ${control} is kept. Teach another level, or End: the stage then starts again with it.`;
    case 'refused': return `${level}: ${control} could not be kept; the log of the stage says why.`;
    default: return `${level}: ${isCall(level) ? 'push the button that is to make it' : 'move the control that is to play it'}.${hindrance(learn)}`;
  }
}

export function makeLearn(parent, {teachable}) {
  if (teachable.length === 0) return parent.remove();
  const select = make('select', {'aria-label': 'What is to be taught'},
                      ...teachable.map((name, n) => make('option', {value: `${n}`}, name)));
  const begin = makeCall('Teach', kBegin, () => select.value), keep = makeCall('Keep', kKeep);
  const turn = makeCall('Turn round', kTurnRound), end = makeCall('End', kEnd);
  const words = make('p', {class: 'doing', 'aria-live': 'polite'});
  parent.append(make('div', {class: 'calls', role: 'group', 'aria-label': 'Calls of learn mode'}, select, begin, keep, turn, end), words);
  onState(({on_stage: now, lines}) => {
    const learn = now?.learn ?? null;
    const inService = ((lines.closed >>> kService) & 1) === 1;
    const level = teachable[learn?.choice] ?? '';
    const found = ['found', 'refused'].includes(kPhases[learn?.phase]);
    begin.disabled = select.disabled = !inService || !now;
    keep.disabled = !found;
    turn.disabled = !found || isCall(level) || isTurn(level);
    end.disabled = !learn;
    const text = doing(learn, level, inService);
    if (words.textContent !== text) words.textContent = text;
  });
}
