// Puts the page together, and shows the state of the connection.
import {makeMachine} from './machine.js';
import {makeMouth} from './mouth.js';
import {askForCode, makePairing} from './pair.js';
import {makePicture} from './picture.js';
import {makeSteps} from './steps.js';
import {makeTuning} from './tuning.js';
import {ask, begin, disconnect, onState} from './wire.js';
import {makeLanguages, onLanguage, text} from './texts.js';

const $ = (id) => document.getElementById(id);

function showLink(state) {
  const link = document.body.dataset.link;
  if (link === 'lost') return text('lost');
  if (link === 'waiting') return document.body.dataset.view === 'desk' ? text('waiting') : '';
  if (state && !state.lips) return text('noLips');
  return text('live');
}

async function leave() {
  await fetch('/leave', {method: 'POST'});
  disconnect();
  askForCode();
}

function makeKeeping() {
  const shut = () => $('revert').removeAttribute('open');
  $('undo').addEventListener('click', () => ask('undo', text('reverted')));
  $('save').addEventListener('click', () => ask('save', text('savedNow')));
  for (const name of ['saved', 'before', 'defaults'])
    $(name).addEventListener('click', () => { shut(); ask(name, text('reverted')); });
  $('leave').addEventListener('click', () => { shut(); leave(); });
  document.addEventListener('pointerdown', ({target}) => $('revert').contains(target) || shut());
  document.addEventListener('keydown', ({key}) => key === 'Escape' && shut());
  onState((state) => {
    const report = state?.report;
    $('undo').disabled = !report?.changes;
    $('save').disabled = !report;
    $('save').classList.toggle('unsaved', Boolean(report?.unsaved));
    $('saved').disabled = !report?.saved;
    $('before').disabled = !report?.before;
    $('defaults').disabled = !report;
  });
}

let last = null;
const show = () => {
  const live = document.body.dataset.link === 'live' && (last?.lips ?? true);
  $('link').textContent = showLink(last);
  $('link').classList.toggle('bad', !live && document.body.dataset.view === 'desk');
};

makePairing();
makePicture();
makeMouth();
makeSteps();
makeTuning();
makeMachine();
makeKeeping();
onState((state) => {
  last = state;
  show();
});
makeLanguages($('language'));
onLanguage(show);
begin(askForCode);
