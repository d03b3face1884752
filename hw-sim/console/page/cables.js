// The cable of each device: pull it, plug it in again.
import {make} from './drag.js';
import {onState, tell} from './wire.js';

const kDrawing = `
  <svg viewBox="0 0 24 24" aria-hidden="true">
    <path d="M2 12H7"/><path d="M7 7V17H10A5 5 0 0 0 10 7Z"/><g class="far"><path d="M15 9.5H18.5M15 14.5H18.5"/><path d="M22 12H20"/></g>
  </svg>`;

const kNames = new Map([
  ['dial-box', 'the dial box'], ['stick-left', 'the left stick'], ['stick-right', 'the right stick'],
  ['keyboard', 'the keyboard'], ['camera', 'the lip camera'], ['screen', 'the screen'], ['pointer', 'the mouse'],
  ['lines', 'the switches'],
]);

function say(cable, name, {plugged, connected}) {
  const how = !plugged ? 'Plug in' : 'Unplug';
  const what = `${how} ${name}${plugged && !connected ? ' (no program listens to it)' : ''}`;
  cable.title = what;
  cable.setAttribute('aria-label', what);
  cable.setAttribute('aria-pressed', String(plugged));
}

export function makeCables() {
  for (const panel of document.querySelectorAll('[data-port]')) {
    const port = panel.dataset.port;
    const cable = make('button', {type: 'button', class: 'cable'});
    cable.innerHTML = kDrawing;
    let plugged = true;
    cable.addEventListener('click', () => tell(`${plugged ? 'unplug' : 'plug'} ${port}`));
    cable.addEventListener('pointerdown', (event) => event.preventDefault());
    cable.addEventListener('mousedown', (event) => event.preventDefault());
    panel.append(cable);
    onState(({ports}) => {
      plugged = ports[port].plugged;
      say(cable, kNames.get(port), ports[port]);
      panel.classList.toggle('unplugged', !plugged);
      panel.classList.toggle('unheard', plugged && !ports[port].connected);
    });
  }
}
