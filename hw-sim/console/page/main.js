// Puts the page together from the labels, and keeps its few words true.
import {makeButtons} from './buttons.js';
import {makeCables} from './cables.js';
import {makeDials} from './dials.js';
import {onDrag} from './drag.js';
import {steering} from './face.js';
import {makeKeys} from './keys.js';
import {makeLips} from './lips.js';
import {makeNeedles, needlesAreOpen, pointing} from './needles.js';
import {makeStick} from './sticks.js';
import {makeVoice} from './voice.js';
import {connect, onState} from './wire.js';

const $ = (id) => document.getElementById(id);

// Each part of the hint goes when somebody has done it; who has done two needs no more, here or later.
function showHint() {
  const kSeen = 'kaori-played';
  const kEnough = 2;
  const hint = $('hint');
  if (localStorage.getItem(kSeen)) hint.classList.add('gone');
  const done = (id) => {
    hint.querySelector(`[data-for="${id}"]`)?.classList.add('done');
    if (hint.querySelectorAll('.done').length < kEnough) return;
    localStorage.setItem(kSeen, 'yes');
    hint.classList.add('gone');
  };
  for (const {dataset} of hint.children)
    $(dataset.for).addEventListener('pointerdown', () => done(dataset.for));
  window.addEventListener('keydown', () => done('keyboard'));
}

function notice(state) {
  if (!state.ports.screen.plugged) return 'The screen is unplugged.';
  if (!state.ports.screen.connected) return 'Waiting for the stage.';
  return '';
}

function showState(state) {
  $('fps').textContent = state.fps > 0 ? state.fps : '–';
  $('notice').textContent = notice(state);
  $('mouth').classList.toggle('covered', state.covered);
}

// A hand on the picture drags her face, or is the pointer of the needles.
function makePicture(picture) {
  const steer = steering(picture);
  const point = pointing(picture);
  let hand = steer;
  onDrag(picture, {
    begin: (event) => {
      hand = needlesAreOpen() ? point : steer;
      hand.begin(event);
    },
    move: (event) => hand.move(event),
    end: () => hand.end(),
  });
}

async function begin() {
  const labels = await (await fetch('/labels')).json();
  makeDials($('dials'), labels.dials);
  makeButtons($('buttons'), labels.buttons);
  makeStick($('left'), 'left', labels.sticks[0]);
  makeStick($('right'), 'right', labels.sticks[1]);
  makeLips($('mouth'));
  makeVoice($('mouth'));
  makeKeys($('keys'), labels.keys);
  makeNeedles($('stage'), $('picture'));
  makePicture($('picture'));
  makeCables();
  showHint();
  onState(showState);
  connect($('picture'));
}

begin();
