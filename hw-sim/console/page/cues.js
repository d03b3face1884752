// The cue list: what was played, what comes by itself, and what GO plays next, with the notes of whoever calls the show.
import {make} from './drag.js';
import {tapKey} from './keys.js';
import {call, onState} from './wire.js';

// What the list is doing, in words; nothing while it only stands by.
function doing(now, cues) {
  if (!now) return '';
  const coming = cues[now.pending];
  const comes = coming && (now.waiting ? `${coming.number} waits for a person, ${now.left_s.toFixed(1)} s at most`
                                       : `${coming.number} comes in ${now.left_s.toFixed(1)} s`);
  return [now.lobby && `Lobby: ${now.lobby}`, now.lobby_hours,
          now.locked && 'Locked: only those who play are heard', now.locked && now.locked_out > 0 && `${now.locked_out} refused`,
          now.paused && 'Paused', now.black && 'Blackout', now.panicking && 'Panic', comes,
          now.standby >= cues.length && 'The list is over: GO is refused',
          now.refused > 0 && `${now.refused} GO refused`].filter(Boolean).join(' \u00b7 ');
}

// Its name lets a cue stand by; the button beside it goes there, in the state of a run through the list.
function makeRow(cue) {
  const name = make('button', {type: 'button', class: 'name', title: 'Stand by'},
                    make('span', {class: 'number'}, cue.number), make('span', {class: 'title'}, cue.text));
  name.addEventListener('click', () => call(`standby ${cue.number}`));
  const jump = make('button', {type: 'button', class: 'jump', 'aria-label': `Go to cue ${cue.number}`}, 'Go to');
  jump.addEventListener('click', () => call(`goto ${cue.number}`));
  const row = make('li', {class: cue.by_itself ? 'chained' : ''}, name);
  if (cue.notes) row.append(make('span', {class: 'notes'}, cue.notes));
  row.append(jump);
  if (cue.act) row.dataset.act = cue.act;
  return row;
}

function mark(rows, now) {
  rows.forEach((row, n) => {
    row.classList.toggle('active', n === now?.cue);
    row.classList.toggle('pending', n === now?.pending);
    row.classList.toggle('standby', n === now?.standby);
    if (n === now?.standby) row.setAttribute('aria-current', 'step');
    else row.removeAttribute('aria-current');
  });
}

// The row that stands by is brought into the list's own window; the page itself does not move.
function show(list, row) {
  if (row) list.scrollTop = row.offsetTop - list.offsetTop - list.clientHeight / 3;
}

// Beside GO: what it plays next.
export function makeStandby(parent, {cues}) {
  const words = make('p', {id: 'standby', 'aria-live': 'polite'});
  parent.append(words);
  onState(({on_stage: now}) => {
    const cue = now && cues[now.standby];
    const text = cue ? `Next: ${cue.number} ${cue.text}` : '';
    if (words.textContent !== text) words.textContent = text;
  });
}

export function makeCues(parent, {cues, keys}) {
  if (cues.length === 0) return parent.remove();
  const calls = make('div', {class: 'calls', role: 'group', 'aria-label': 'Calls of the cue list'},
                     ...keys.filter(({group}) => group === 'cue').map(({usage, text}) => {
                       const button = make('button', {type: 'button', class: text === 'GO' ? 'go' : ''}, text);
                       button.addEventListener('mousedown', (event) => event.preventDefault());
                       button.addEventListener('click', () => tapKey(usage));
                       return button;
                     }));
  const words = make('p', {class: 'doing', 'aria-live': 'polite'});
  const rows = cues.map(makeRow);
  const list = make('ol', {'aria-label': 'Cues', tabindex: '0'}, ...rows);
  const lock = make('button', {type: 'button', class: 'lock', 'aria-pressed': 'false',
                              title: 'Only those who play are heard, until the service key is on'}, 'Lock');
  lock.addEventListener('click', () => call('lock 1'));
  calls.append(lock);
  parent.append(calls, words, list);
  let standby = -2;
  onState(({on_stage: now}) => {
    const text = doing(now, cues);
    if (words.textContent !== text) words.textContent = text;
    mark(rows, now);
    lock.setAttribute('aria-pressed', String(now?.locked === true));
    if (now && now.standby !== standby) show(list, rows[Math.min(now.standby, rows.length - 1)]);
    standby = now?.standby ?? -2;
  });
}
