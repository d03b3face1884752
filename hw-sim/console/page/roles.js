// Roles and levels: from which device each role is played, and who has which level.
import {make} from './drag.js';
import {call, onState} from './wire.js';

const kNobody = 0, kCue = 1, kRemote = 2, kRole = 3;
const kOwners = new Map([[kCue, 'Cue'], [kRemote, 'This page'], [4, 'Lips'], [5, 'Voice']]);
const kAgain_ms = 400;  // A remote control's word counts for a second: a slider that is held says it again.

function makeRole(name, number, devices) {
  const select = make('select', {'aria-label': `Role ${name} is played from`},
                      ...devices.map((device, n) => make('option', {value: `${n}`}, device)),
                      make('option', {value: `${devices.length}`}, 'nobody'));
  select.addEventListener('change', () => call(`load ${number} ${select.value}`));
  onState(({on_stage: now}) => {
    const device = now?.role_devices?.[number];
    if (device !== undefined && document.activeElement !== select) select.value = `${Math.min(device, devices.length)}`;
  });
  return make('label', {class: 'role', 'data-role': `${number}`}, make('span', {}, name), select);
}

// A slider that shows where the level is, and moves it from afar while it is held.
function makeSlider(level, number) {
  const slider = make('input', {type: 'range', min: `${level.low}`, max: `${level.high}`, 'aria-label': level.text,
                                step: `${(level.high - level.low) / 200}`, value: `${level.rest}`});
  let again = null;
  const say = () => call(`level ${number} ${Number(slider.value).toFixed(4)}`);
  const end = () => {
    clearInterval(again);
    again = null;
  };
  slider.addEventListener('pointerdown', () => { again ??= setInterval(say, kAgain_ms); });
  slider.addEventListener('input', say);
  for (const event of ['pointerup', 'pointercancel', 'blur']) slider.addEventListener(event, end);
  return {slider, held: () => again !== null};
}

function makeLevel(level, number, roles) {
  const {slider, held} = makeSlider(level, number);
  const value = make('span', {class: 'value'});
  const owner = make('button', {type: 'button', class: 'owner', title: 'Let go'});
  owner.addEventListener('click', () => call(`letgo ${number}`));
  const row = make('li', {}, make('span', {class: 'title'}, level.text), slider, value, owner);
  onState(({on_stage: now}) => {
    const [at, who, role] = now?.levels?.[number] ?? [level.rest, kNobody, 0];
    if (!held()) slider.value = `${at}`;
    const digits = Math.abs(level.high - level.low) / level.per_unit < 20 ? 1 : 0;
    const text = `${(at / level.per_unit).toFixed(digits)} ${level.unit}`;
    if (value.textContent !== text) value.textContent = text;
    const name = who === kRole ? roles[role] ?? 'Taught' : kOwners.get(who) ?? '';
    if (owner.textContent !== name) owner.textContent = name;
    owner.setAttribute('aria-label', name ? `${level.text}: ${name} has it; let go` : `${level.text}: nobody has it`);
    row.dataset.owner = who === kRole ? `role-${role}` : `${who}`;
  });
  return row;
}

export function makeRoles(parent, {levels, roles, devices}) {
  if (levels.length === 0) return parent.remove();
  const played = make('div', {class: 'played', role: 'group', 'aria-label': 'Roles'},
                      ...roles.map((name, n) => makeRole(name, n, devices)));
  const list = make('ol', {'aria-label': 'Levels'}, ...levels.map((level, n) => makeLevel(level, n, roles)));
  parent.append(played, list);
}
