// What plays by itself when it is called: takes, which a person played, and registered motions; which of them play now.
import {make} from './drag.js';
import {call, onState} from './wire.js';

const kBegin = 1, kEnd = 0;  // As board::CallVerb::kMotion has them.

const about = ({take, moves, sound, loops}) =>
  [take ? 'take' : 'motion', moves && `on ${moves}`, sound && 'with sound', loops && 'loops'].filter(Boolean).join(', ');

function makeMotion(motion, number) {
  const button = make('button', {type: 'button'}, 'Start');
  const length = make('span', {class: 'length'});
  const row = make('li', {}, button, make('span', {class: 'title'}, motion.text), length,
                   make('span', {class: 'about'}, about(motion)));
  let playing = false;
  button.addEventListener('mousedown', (event) => event.preventDefault());  // The focus stays where it was.
  button.addEventListener('click', () => call(`motion ${number} ${playing ? kEnd : kBegin}`));
  onState(({on_stage: now}) => {
    const voice = (now?.motions ?? []).find(([which, , ends]) => which === number && !ends);
    playing = voice !== undefined;
    row.classList.toggle('playing', playing);
    const words = playing ? 'Stop' : 'Start';
    if (button.textContent !== words) button.textContent = words;
    button.setAttribute('aria-label', `${words} ${motion.text}`);
    button.disabled = !now;
    const text = playing ? `${voice[1].toFixed(1)} s` : `${motion.length_s.toFixed(1)} s`;
    if (length.textContent !== text) length.textContent = text;
  });
  return row;
}

export function makeTakes(parent, {motions}) {
  if (motions.length === 0) return parent.remove();
  parent.append(make('ol', {'aria-label': 'Takes and motions', tabindex: '0'}, ...motions.map(makeMotion)));
}
