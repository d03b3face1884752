// The operator's voice: hold a vowel to say it. A cover on the lens takes the lips from the camera, so that the voice moves
// the mouth. A bar says how loud the loudspeaker is.
import {clamp, make, onHold} from './drag.js';
import {onState, tell} from './wire.js';

const kVowels = ['a', 'i', 'u', 'e', 'o'];
const kQuiet_db = -60;

function makeVowel(vowel) {
  const help = `Hold it to say ${vowel} into the microphone`;
  const button = make('button', {type: 'button', title: help, 'aria-label': `Say ${vowel}: ${help}`}, vowel);
  onHold(button, {push: () => tell(`voice ${vowel} 1`), release: () => tell('voice off')});
  return button;
}

export function makeVoice(parent) {
  const vowels = kVowels.map(makeVowel);
  const cover = make('button', {
    type: 'button', class: 'cover', 'aria-pressed': 'false',
    title: 'The camera sees no lips: the voice moves the mouth',
  }, 'Cover the lens');
  let covered = false;
  cover.addEventListener('click', () => tell(covered ? 'lens uncover' : 'lens cover'));
  const level = make('i', {});
  parent.append(make('h2', {}, 'Voice'), make('div', {class: 'voice', role: 'group', 'aria-label': 'Voice'}, ...vowels),
                make('span', {class: 'name'}, 'Hold a vowel to say it into the microphone'), cover,
                make('span', {class: 'level', title: 'How loud the loudspeaker is'}, level));
  onState((state) => {
    covered = state.covered;
    cover.setAttribute('aria-pressed', String(covered));
    vowels.forEach((button, n) => button.classList.toggle('held', state.voice.loudness > 0 && state.voice.vowel === n));
    level.style.width = `${100 * clamp(1 - state.loudspeaker_db / kQuiet_db, 0, 1)}%`;
  });
}
