// The box itself: the list that stands on its screen while the service key is on, and its settings.
import {language, listLine, onLanguage, text} from './texts.js';
import {askBox, bring, onBox} from './wire.js';

const $ = (id) => document.getElementById(id);

let last = null;      // The newest state; null while kaori-shows is away.
let shown = null;     // The number of the list that the buttons are of.
let bringing = '';    // How far a backup is that is brought.
let edited = false;   // The visitor has written into the settings: the box's own text does not take their place.

function makeLine(label, line) {
  const button = document.createElement('button');
  button.type = 'button';
  button.dataset.label = label;
  button.addEventListener('click', () => askBox(`take ${line} ${shown}`));
  return button;
}

function showNotes() {
  const more = last?.more ? [text('machineMore').replace('N', last.more)] : [];
  $('machine-notes').replaceChildren(...[...(last?.notes ?? []), ...more].map((note) => {
    const item = document.createElement('li');
    item.textContent = note;
    return item;
  }));
}

// Buttons of one list stay as they are, so that a click meets the line that was there when the finger came down.
function showList() {
  if (shown !== (last?.list ?? null)) {
    shown = last?.list ?? null;
    $('machine-list').replaceChildren(...(last?.choices ?? []).map(makeLine));
  }
  for (const button of $('machine-list').children) {
    button.disabled = last.busy;
    button.textContent = listLine(button.dataset.label);
  }
}

function showSettings() {
  const known = last?.settings;
  if (typeof known === 'string' && !edited && $('machine-text').value !== known) $('machine-text').value = known;
  $('machine-text').disabled = typeof known !== 'string';
  $('machine-compare').disabled = typeof known !== 'string' || last.busy;
  $('machine-again').disabled = !edited;
}

function showBackup() {
  $('machine-backup').disabled = $('machine-bring').disabled = !last || last.busy || bringing !== '';
  $('machine-fetch').hidden = !last?.backup;
  $('machine-fetch').textContent = text('machineFetch').replace('NAME', last?.backup ?? '');
  $('machine-fetch').download = last?.backup ?? '';
}

async function bringFile() {
  const [file] = $('machine-file').files;
  if (!file) return;
  const tell = (part) => { bringing = `${file.name}: ${Math.round(part * 100)} %`; show(); };
  tell(0);
  await bring(file, tell);
  bringing = '';
  $('machine-file').value = '';
  show();
}

// Several boxes may have a page open on one computer.
function showName() {
  const name = last?.box ?? '';
  $('name').textContent = name;
  document.title = name ? `カ・オ・リ ${name}` : 'カ・オ・リ';
}

function show() {
  $('machine-said').textContent = bringing || (last ? last.said[language()] : text('machineGone'));
  $('machine-said').classList.toggle('bad', !last || last.said.refused);
  showName();
  showList();
  showNotes();
  showSettings();
  showBackup();
}

export function makeMachine() {
  $('machine-text').addEventListener('input', () => { edited = true; showSettings(); });
  $('machine-again').addEventListener('click', () => { edited = false; show(); });
  $('machine-compare').addEventListener('click', async () => {
    if (await askBox(`settings\n${$('machine-text').value}`)) $('machine').scrollIntoView({block: 'start'});
  });
  $('machine-backup').addEventListener('click', () => askBox('backup'));
  $('machine-bring').addEventListener('click', () => $('machine-file').click());
  $('machine-file').addEventListener('change', bringFile);
  onBox((state) => {
    // What was written is the box's now: what it has next is shown again.
    if (state && state.settings === $('machine-text').value) edited = false;
    last = state;
    show();
  });
  onLanguage(show);
}
