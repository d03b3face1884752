// Sliders of the chroma key, the smoothing and the voice. They follow the box's values while nobody moves them.
import {onLanguage, text} from './texts.js';
import {newGesture, onState, set} from './wire.js';

// The setting, the key of its label, and the slider's ends and step. A value beyond an end is shown at that end.
const kSliders = [
  ['key.similarity', 'similarity', 10, 400, 1],
  ['key.smoothness', 'smoothness', 1, 300, 1],
  ['key.spill', 'spill', 1, 300, 1],
  ['smoothing.least_cutoff_hz', 'still', 0.5, 20, 0.1],
  ['smoothing.cutoff_per_speed', 'quick', 0, 60, 0.5],
  ['voice.opens_db', 'gate', -80, 0, 1],
  ['sound.delay_ms', 'delay', -1, 500, 1],
];
const kLocal_ms = 700;  // How long after a move the box's older value is not shown.

function makeSlider([name, label, low, high, step]) {
  const row = document.createElement('div');
  const id = name.replace('.', '-');
  row.className = 'slider';
  row.innerHTML = `<label for="${id}" data-text="${label}"></label><output for="${id}"></output>` +
      `<input id="${id}" type="range" min="${low}" max="${high}" step="${step}" aria-describedby="${id}-text">` +
      `<small id="${id}-text" data-text="${label}Text"></small>`;
  const input = row.querySelector('input');
  const output = row.querySelector('output');
  let touched_ms = -Infinity;
  const show = (value) => {
    output.textContent = Number(value).toFixed(step < 1 ? 1 : 0);
    const part = (Math.min(Math.max(value, low), high) - low) / (high - low);
    input.style.setProperty('--part', `${part * 100}%`);
  };
  input.addEventListener('pointerdown', newGesture);
  input.addEventListener('change', newGesture);
  input.addEventListener('input', () => {
    touched_ms = performance.now();
    show(input.value);
    set(name, input.value);
  });
  onState((state) => {
    input.disabled = !state?.report;
    if (!state?.report || performance.now() - touched_ms < kLocal_ms) return;
    const {value} = state.report.settings[name];
    input.value = value;
    show(value);
  });
  return row;
}

export function makeTuning() {
  document.getElementById('sliders').append(...kSliders.map(makeSlider));
}
