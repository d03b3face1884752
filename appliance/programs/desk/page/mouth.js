// The mouth as it is measured now: drawn, and in numbers.
import {onLanguage, text} from './texts.js';
import {onState} from './wire.js';

const kUnit = 62;  // Half the width of a mouth at rest, in units of the drawing.
const kMost = 2.2;  // A larger mouth is drawn no larger.

const kDrawing = `
  <svg viewBox="-150 -105 300 210" role="img">
    <g class="far"><ellipse class="rest"/><ellipse class="wides"/></g>
    <ellipse class="lips"/><ellipse class="inside"/>
  </svg>
  <dl></dl>`;
const kValues = ['opened', 'wide', 'height', 'width', 'quality', 'age', 'presented'];

function ellipse(element, width, height) {
  element.setAttribute('rx', Math.min(width, kMost) * kUnit);
  element.setAttribute('ry', Math.min(height, kMost) * kUnit);
}

const percent = (part) => `${Math.round(part * 100)} %`;

function valuesOf(state) {
  const {mouth} = state;
  const fresh = state.camera === 'live';
  return {
    opened: percent(mouth.open),
    wide: percent(mouth.wide),
    height: mouth.height.toFixed(2),
    width: mouth.width.toFixed(2),
    quality: percent(fresh ? mouth.quality : 0),
    age: mouth.age_ms < 10000 ? `${mouth.age_ms} ms` : '–',
    presented: state.presented_age_ms === null ? '–' : `${state.presented_age_ms} ms`,
  };
}

export function makeMouth() {
  const live = document.getElementById('live');
  live.innerHTML = kDrawing;
  const svg = live.querySelector('svg');
  const list = live.querySelector('dl');
  const values = {};
  for (const name of kValues) {
    const term = Object.assign(document.createElement('dt'), {className: name});
    const value = Object.assign(document.createElement('dd'), {className: name, textContent: '–'});
    term.dataset.text = name;
    values[name] = value;
    list.append(term, value);
  }
  onState((state) => {
    if (!state?.report) {
      live.classList.add('lost');
      for (const value of Object.values(values)) value.textContent = '–';
      return;
    }
    const {mouth, report: {settings}} = state;
    const learnable = state.camera === 'live' && mouth.learnable;
    live.classList.toggle('lost', !learnable);
    ellipse(svg.querySelector('.rest'), 1, settings['mouth.shut'].value);
    ellipse(svg.querySelector('.wides'), settings['mouth.wide'].value, settings['mouth.open'].value);
    ellipse(svg.querySelector('.lips'), mouth.width, mouth.height);
    ellipse(svg.querySelector('.inside'), mouth.width * 0.72, mouth.opening);
    const [red, green, blue] = ['red', 'green', 'blue'].map((name) => settings[`paint.${name}`].value);
    svg.querySelector('.lips').setAttribute('fill', `rgb(${red} ${green} ${blue})`);
    const numbers = valuesOf(state);
    for (const name of kValues) values[name].textContent = numbers[name];
    values.quality.classList.toggle('bad', !learnable);
  });
  onLanguage(() => svg.setAttribute('aria-label', text('mouthLabel')));
}
