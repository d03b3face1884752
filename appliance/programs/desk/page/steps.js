// The steps of the calibration: four poses, or ten seconds of speech.
import {onLanguage, text} from './texts.js';
import {ask, onState} from './wire.js';

// Each pose: the step, the key of its label, and as it is drawn: half the width, the height and the opening.
const kPoses = [['shut', 'shut', 30, 7, 0], ['open', 'open', 27, 24, 17], ['wide', 'wideStep', 41, 9, 2], ['narrow', 'narrow', 16, 13, 6]];

function drawing(width, height, gap) {
  return `<svg viewBox="-46 -28 92 56" aria-hidden="true"><ellipse class="lips" rx="${width}" ry="${height}"/>` +
      `<ellipse class="inside" rx="${width * 0.72}" ry="${gap}"/></svg>`;
}

function makeButton(step, label, picture) {
  const button = document.createElement('button');
  button.type = 'button';
  button.className = `pose ${step}`;
  button.innerHTML = `${picture}<b data-text="${label}"></b><small></small><i></i>`;
  button.dataset.step = step;
  button.addEventListener('click', () => {
    const stops = button.classList.contains('measuring');
    ask(stops ? 'stop' : `begin ${step}`);
  });
  return button;
}

function hintOf(step, state) {
  const {report, mouth} = state;
  if (report.step !== step) return report.done.includes(step) ? text('doneStep') : '';
  if (state.camera !== 'live' || !mouth.learnable) return text('noMouth');
  return step === 'speak' ? text('speaking') : text('hold');
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
      const measuring = last.report.step === step;
      button.classList.toggle('measuring', measuring);
      button.classList.toggle('done', last.report.done.includes(step));
      button.querySelector('small').textContent = hintOf(step, last);
      button.querySelector('i').style.transform = `scaleX(${measuring ? last.report.progress : 0})`;
    }
  };
  onState((state) => {
    if (state) last = state;
    for (const button of buttons) button.disabled = !state?.report;
    show();
  });
  onLanguage(show);
}
