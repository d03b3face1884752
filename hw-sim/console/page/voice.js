// The operator's voice: hold a vowel to say it; a hand before the lens, so that the voice has the mouth; and how loud the
// loudspeaker is.
import {clamp, make, onHold} from './drag.js';
import {onState, tell} from './wire.js';

const kVowels = ['a', 'i', 'u', 'e', 'o'];
const kQuiet_db = -60;

function makeVowel(vowel) {
  const button = make('button', {type: 'button', 'aria-label': `Say ${vowel}`}, vowel);
  onHold(button, {push: () => tell(`voice ${vowel} 1`), release: () => tell('voice off')});
  return button;
}

export function makeVoice(parent) {
  const vowels = kVowels.map(makeVowel);
  const cover = make('button', {type: 'button', class: 'cover', 'aria-pressed': 'false'}, 'Hand on lens');
  let covered = false;
  cover.addEventListener('click', () => tell(covered ? 'lens uncover' : 'lens cover'));
  const level = make('i', {});
  parent.append(make('div', {class: 'voice', role: 'group', 'aria-label': 'Voice'}, ...vowels, cover,
                     make('span', {class: 'level', title: 'How loud the loudspeaker is'}, level)));
  onState((state) => {
    covered = state.covered;
    cover.setAttribute('aria-pressed', String(covered));
    vowels.forEach((button, n) => button.classList.toggle('held', state.voice.loudness > 0 && state.voice.vowel === n));
    level.style.width = `${100 * clamp(1 - state.loudspeaker_db / kQuiet_db, 0, 1)}%`;
  });
}
