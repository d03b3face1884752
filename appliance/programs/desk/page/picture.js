// The live picture: it is shown in three views, and a tap on it samples the paint.
import {onLanguage, text} from './texts.js';
import {ask, onState} from './wire.js';

const $ = (id) => document.getElementById(id);
const kViews = [['viewPlain', '/picture'], ['viewBoth', '/picture/both'], ['viewMask', '/picture/mask']];
let view = 1;
let streams = false;
let exposureFree = false;

function stream(on) {
  streams = on;
  if (on) $('picture').src = `${kViews[view][1]}?${Date.now()}`;  // A new stream each time.
  else $('picture').removeAttribute('src');
}

function choose(next, buttons) {
  view = next;
  buttons.forEach((button, n) => {
    button.setAttribute('aria-checked', String(n === view));
    button.tabIndex = n === view ? 0 : -1;
  });
  if (streams) stream(true);
}

function makeViews() {
  const buttons = kViews.map(([name], n) => {
    const button = document.createElement('button');
    button.type = 'button';
    button.dataset.text = name;
    button.setAttribute('role', 'radio');
    button.addEventListener('click', () => choose(n, buttons));
    button.addEventListener('keydown', ({key}) => {
      const by = {ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1}[key];
      if (!by) return;
      choose((view + by + kViews.length) % kViews.length, buttons);
      buttons[view].focus();
    });
    return button;
  });
  $('views').append(...buttons);
  choose(view, buttons);
}

function sample(event) {
  const {left, top, width, height} = $('picture').getBoundingClientRect();
  const x = (event.clientX - left) / width;
  const y = (event.clientY - top) / height;
  if (!(x >= 0 && x <= 1 && y >= 0 && y <= 1)) return;
  const cross = $('cross');
  cross.style.left = `${x * 100}%`;
  cross.style.top = `${y * 100}%`;
  cross.classList.remove('seen');
  void cross.offsetWidth;  // Forces a layout, so that the animation starts again.
  cross.classList.add('seen');
  ask(`sample ${x.toFixed(4)} ${y.toFixed(4)}`, text('sampled'));
}

function noticeOf(state) {
  if (!state) return text('lost');
  if (!state.lips) return text('noLips');
  if (state.camera === 'absent') return text('noCamera');
  return state.camera === 'stale' ? text('stale') : '';
}

function showBox(box) {
  const rect = $('box');
  rect.classList.toggle('seen', Boolean(box));
  if (!box) return;
  const [left, top, right, bottom] = box;
  for (const [name, value] of Object.entries({x: left, y: top, width: right - left, height: bottom - top}))
    rect.setAttribute(name, value);
}

function showState(state) {
  const live = document.body.dataset.link === 'live';
  if (live !== streams) stream(live);
  if (!state && live) return;
  $('notice').textContent = noticeOf(state);
  $('camera').classList.toggle('old', $('notice').textContent !== '');
  for (const id of ['find', 'exposure']) $(id).disabled = !state?.report;
  const settings = state?.report?.settings;
  showBox(state?.report?.box);
  if (!settings) return;
  const [red, green, blue] = ['red', 'green', 'blue'].map((name) => settings[`paint.${name}`].value);
  $('paint').style.backgroundColor = `rgb(${red} ${green} ${blue})`;
  exposureFree = state.report.exposure_free;
  showExposure();
}

function showExposure() {
  $('exposure').setAttribute('aria-pressed', String(exposureFree));
  $('exposure').textContent = text(exposureFree ? 'holdExposure' : 'freeExposure');
}

export function makePicture() {
  makeViews();
  $('picture').addEventListener('click', sample);
  $('picture').addEventListener('load', () => $('picture').classList.add('seen'));
  $('picture').addEventListener('dragstart', (event) => event.preventDefault());
  $('find').addEventListener('click', () => ask('find', text('found')));
  $('exposure').addEventListener('click', () => exposureFree ? ask('exposure 0', text('held')) : ask('exposure 1', text('freed')));
  onState(showState);
  onLanguage(() => {
    $('picture').alt = text('pictureLabel');
    $('views').setAttribute('aria-label', text('views'));
    $('paint').setAttribute('aria-label', text('paintLabel'));
    showExposure();
  });
}
