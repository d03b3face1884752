// Puts the page together from the labels, and keeps its few words true.
import {makeButtons} from './buttons.js';
import {makeCables} from './cables.js';
import {makeCheck} from './check.js';
import {makeCues, makeStandby} from './cues.js';
import {makeDials} from './dials.js';
import {onDrag} from './drag.js';
import {editorIsOpen, makeEditor, pointing} from './editor.js';
import {steering} from './face.js';
import {makeKeys} from './keys.js';
import {makeLearn} from './learn.js';
import {makeLips} from './lips.js';
import {makeMidi} from './midi.js';
import {makeMonitor} from './monitor.js';
import {makeRoles} from './roles.js';
import {makeSound} from './sound.js';
import {makeStick} from './sticks.js';
import {makeSwitches} from './switches.js';
import {makeTakes} from './takes.js';
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

// Which scene and which way of drawing are on, by the names of the labels; nothing while the box does not say.
function onStage({scenes, styles}, now) {
  if (!now) return '';
  return [scenes[now.scene] && `Scene: ${scenes[now.scene]}`, styles[now.style] && `Drawn as: ${styles[now.style]}`]
      .filter(Boolean).join(' \u00b7 ');
}

function showState(state, labels) {
  $('fps').textContent = state.fps > 0 ? state.fps : '–';
  $('notice').textContent = notice(state);
  const now = onStage(labels, state.on_stage);
  if ($('now').textContent !== now) $('now').textContent = now;  // A screen reader speaks of changes only.
  $('mouth').classList.toggle('covered', state.covered);
}

// The mouse on the picture drags the face, or is the pointer of the needles.
function makePicture(picture) {
  const steer = steering(picture);
  const point = pointing(picture);
  let tool = steer;
  onDrag(picture, {
    begin: (event) => {
      tool = editorIsOpen() ? point : steer;
      tool.begin(event);
    },
    move: (event) => tool.move(event),
    end: () => tool.end(),
  });
}

async function begin() {
  const labels = await (await fetch('/labels')).json();
  makeDials($('dials'), labels.dials);
  makeButtons($('buttons'), [labels.buttons, labels.second_buttons]);
  makeStick($('left'), 'left', labels.sticks[0]);
  makeStick($('right'), 'right', labels.sticks[1]);
  makeLips($('mouth'));
  makeVoice($('mouth'));
  makeSwitches($('lines'));
  $('rate').before(makeSound());
  makeKeys($('keys'), labels.keys);
  makeCues($('cues'), labels);
  makeStandby($('lines'), labels);
  makeMonitor($('monitor'));
  makeRoles($('roles'), labels);
  makeCheck($('check'));
  makeLearn($('learn'), labels);
  makeTakes($('takes'), labels);
  makeMidi($('midi'), labels);
  makeEditor($('stage'), $('picture'));
  makePicture($('picture'));
  makeCables();
  showHint();
  onState((state) => showState(state, labels));
  connect($('picture'));
}

begin();
