// Shut, open, wide, narrow, or ten seconds of speech: what the mouth can do is learnt.
import {onLanguage, word} from './words.js';
import {ask, onState} from './wire.js';

const kGood = 0.5;  // Quality from which a picture counts.

// Each pose as the page draws it: half width, half height, half of the opening.
const kPoses = [['shut', 'shut', 30, 7, 0], ['open', 'open', 27, 24, 17], ['wide', 'wideStep', 41, 9, 2], ['narrow', 'narrow', 16, 13, 6]];

function drawing(width, height, gap) {
  return `<svg viewBox="-46 -28 92 56" aria-hidden="true"><ellipse class="lips" rx="${width}" ry="${height}"/>` +
      `<ellipse class="inside" rx="${width * 0.72}" ry="${gap}"/></svg>`;
}

function makeButton(step, label, picture) {
  const button = document.createElement('button');
  button.type = 'button';
  button.className = `pose ${step}`;
  button.innerHTML = `${picture}<b data-word="${label}"></b><small></small><i></i>`;
  button.dataset.step = step;
  button.addEventListener('click', () => {
    const stops = button.classList.contains('taking');
    ask(stops ? 'stop' : `begin ${step}`);
  });
  return button;
}

function hintOf(step, state) {
  const {report, mouth} = state;
  if (report.step !== step) return report.taken.includes(step) ? word('doneStep') : '';
  if (state.camera !== 'live' || mouth.quality < kGood) return word('noMouth');
  return step === 'speak' ? word('speaking') : word('hold');
}

export function makeSteps() {
  const buttons = kPoses.map(([step, label, ...sizes]) => makeButton(step, label, drawing(...sizes)));
  buttons.push(makeButton('speak', 'speak', ''));
  document.getElementById('poses').append(...buttons);
  let last = null;
  const show = () => {
    if (!last?.report) return;
    for (const button of buttons) {
      const {step} = button.dataset;
      const taking = last.report.step === step;
      button.classList.toggle('taking', taking);
      button.classList.toggle('taken', last.report.taken.includes(step));
      button.querySelector('small').textContent = hintOf(step, last);
      button.querySelector('i').style.transform = `scaleX(${taking ? last.report.progress : 0})`;
    }
  };
  onState((state) => {
    if (state) last = state;
    for (const button of buttons) button.disabled = !state?.report;
    show();
  });
  onLanguage(show);
}
